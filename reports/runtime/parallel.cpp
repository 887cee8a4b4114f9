#include "parallel.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace subcert::runtime {

void parallel_for_each(std::size_t count, int jobs, const std::function<void(std::size_t)>& work) {
  const int threads = std::max(1, jobs);
  const tbb::global_control also_beyond_the_cores(tbb::global_control::max_allowed_parallelism,
                                                  static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  arena.execute([&] {
    tbb::parallel_for(
        std::size_t{0}, count, [&](std::size_t i) { work(i); }, tbb::simple_partitioner());
  });
}

}  // namespace subcert::runtime
