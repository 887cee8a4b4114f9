#include "parallel.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace subcert {

void parallel_for_each(std::size_t count, int jobs, const std::function<void(std::size_t)>& work) {
  tbb::task_arena arena(std::max(1, jobs));
  arena.execute([&] {
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) { work(i); }, tbb::simple_partitioner());
  });
}

}  // namespace subcert
