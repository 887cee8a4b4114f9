#include "parallel.hpp"

#include "budget.hpp"

#include <flint/flint.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <utility>
#include <vector>

namespace subcert {

int all_cores() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

std::jthread on_own_thread(std::function<void()> work) {
  return std::jthread([work = std::move(work), flag = StopScope::current(), task = TaskScope::current()] {
    const StopScope scope(flag);
    const TaskScope time(task);
    work();
    flint_cleanup();  // FLINT keeps numbers for each thread and gives them back on request only
  });
}

void parallel_for_each(std::size_t count, int jobs, const std::function<void(std::size_t)>& work) {
  const std::size_t team_size = std::min(count, static_cast<std::size_t>(std::max(1, jobs)));
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex failing;
  const auto share = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) work(i);
    } catch (...) {
      const std::lock_guard lock(failing);
      if (!failure) failure = std::current_exception();
      next = count;
    }
  };
  {
    std::vector<std::jthread> helpers;  // joined at the end of the block
    for (std::size_t helper = 1; helper < team_size; ++helper) helpers.push_back(on_own_thread(share));
    share();
  }
  if (failure) std::rethrow_exception(failure);
}

void parallel_tasks(std::size_t count, int jobs, const std::function<void(std::size_t)>& work) {
  parallel_for_each(count, jobs, [&](std::size_t i) {
    const TaskScope task;
    work(i);
  });
}

void parallel_ranges(std::size_t count, std::size_t ranges, int jobs,
                     const std::function<void(std::size_t, std::size_t)>& work) {
  const std::size_t most = std::min({count, ranges, static_cast<std::size_t>(std::max(1, jobs))});
  const std::size_t team = std::max<std::size_t>(1, most);
  parallel_for_each(team, jobs, [&](std::size_t i) { work(count * i / team, count * (i + 1) / team); });
}

}  // namespace subcert
