#pragma once
/// Independent pieces of work on several threads.

#include <cstddef>
#include <functional>

namespace subcert::runtime {

/// Calls work(0), ..., work(count - 1) on at most `jobs` threads, in any order. Domain: jobs >= 1. Errors: the first
/// exception of a call is thrown again after the calls under way have ended.
void parallel_for_each(std::size_t count, int jobs, const std::function<void(std::size_t)>& work);

}  // namespace subcert::runtime
