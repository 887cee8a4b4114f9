#pragma once
/// How long work may take and how much memory it may hold.

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <limits>

namespace subcert {

/// The moment at which work ends with what it has. Seconds are of wall clock.
class Deadline {
 public:
  /// Work without end of its own.
  Deadline() : end_(Clock::time_point::max()) {}
  /// Domain: seconds >= 0; more than 10^9 is as good as no end.
  static Deadline in(double seconds) {
    Deadline result;
    if (seconds < 1e9) result.end_ = Clock::now() + duration(seconds);
    return result;
  }

  bool expired() const { return end_ != Clock::time_point::max() && Clock::now() >= end_; }
  /// Seconds left: 0 once expired, infinite without an end.
  double remaining() const {
    if (end_ == Clock::time_point::max()) return std::numeric_limits<double>::infinity();
    return std::max(0.0, std::chrono::duration<double>(end_ - Clock::now()).count());
  }
  /// After that share of the time that is left. Domain: 0 <= share <= 1.
  Deadline after(double share) const { return in(share * remaining()); }
  /// The earlier of this and `seconds` from now.
  Deadline at_most(double seconds) const { return in(std::min(seconds, remaining())); }

 private:
  using Clock = std::chrono::steady_clock;
  static Clock::duration duration(double seconds) {
    return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  }
  Clock::time_point end_;
};

/// Seconds of wall clock since it was made.
class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Limits of a search. Near either of them it ends with what is proved so far.
struct Budget {
  Deadline deadline;
  std::size_t memory = std::size_t{1} << 30;  ///< bytes that the search may hold
};

}  // namespace subcert
