#pragma once
/// Independent pieces of work on several threads. Everything parallel goes through here: what FLINT keeps for a thread
/// is given back when the thread ends.

#include <cstddef>
#include <functional>
#include <thread>
#include <utility>
#include <vector>

namespace subcert {

/// As many as the machine runs at a time, at least 1.
int all_cores();

/// Runs the work on a thread of its own, within the StopScope and for the task of this one. Domain: work that does not
/// throw.
std::jthread on_own_thread(std::function<void()> work);

/// Calls work(0), ..., work(count - 1) on at most `jobs` threads, begun in this order. Domain: jobs >= 1. Errors: the
/// first exception of a call is thrown again after the calls under way have ended; no others are begun then.
void parallel_for_each(std::size_t count, int jobs, const std::function<void(std::size_t)>& work);

/// The same with each call as a task of its own: for questions with deadlines of their own, which do not add up.
void parallel_tasks(std::size_t count, int jobs, const std::function<void(std::size_t)>& work);

/// Calls work(begin, end) on at most `ranges` disjoint ranges that cover 0, ..., count - 1, each on a thread of its own
/// and on at most `jobs` of them. Domain and errors: as parallel_for_each.
void parallel_ranges(std::size_t count, std::size_t ranges, int jobs,
                     const std::function<void(std::size_t, std::size_t)>& work);

/// Decides things on several threads, round by round, until `next`, which is given them and their answers, has no more.
template <class Thing, class Decide, class Next>
void in_rounds(std::vector<Thing> open, int jobs, Decide decide, Next next) {
  while (!open.empty()) {
    std::vector<decltype(decide(open.front()))> decided(open.size());
    parallel_tasks(open.size(), jobs, [&](std::size_t k) { decided[k] = decide(open[k]); });
    open = next(open, std::move(decided));
  }
}

}  // namespace subcert
