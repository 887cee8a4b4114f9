#pragma once
// A team of threads for one pass over an array.

#include <algorithm>
#include <cstddef>
#include <thread>
#include <vector>

namespace subcert::data {

/// Calls work(begin, end) on disjoint ranges that cover 0, ..., count - 1, on at most `threads` threads, each with at
/// least some 65,000 of the `numbers` that are written.
template <class Work>
void in_ranges(std::size_t count, std::size_t numbers, int threads, const Work& work) {
  constexpr std::size_t least_numbers = 1 << 16;
  const std::size_t team = std::clamp<std::size_t>(std::min(numbers / least_numbers, count), 1,
                                                   static_cast<std::size_t>(std::max(threads, 1)));
  std::vector<std::jthread> helpers;
  for (std::size_t t = 1; t < team; ++t)
    helpers.emplace_back([&work, count, team, t] { work(count * t / team, count * (t + 1) / team); });
  work(0, count / team);
}

}  // namespace subcert::data
