#pragma once
/// How long work may take and how much memory it may hold.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <limits>

namespace subcert {

/// Lets another thread end what is computed. A flag that is made within the scope of another one is set with it.
class StopFlag {
 public:
  StopFlag() : outer_(innermost) {}
  StopFlag(const StopFlag&) = delete;
  StopFlag& operator=(const StopFlag&) = delete;

  void set() { set_.store(true, std::memory_order_relaxed); }
  bool is_set() const { return set_.load(std::memory_order_relaxed) || (outer_ != nullptr && outer_->is_set()); }

 private:
  friend class StopScope;
  std::atomic<bool> set_ = false;
  const StopFlag* outer_;
  static inline thread_local const StopFlag* innermost = nullptr;
};

/// Deadlines that are made on this thread as long as the scope lives expire once the flag is set. Scopes may be nested;
/// the innermost counts. Domain: the flag outlives those deadlines.
class StopScope {
 public:
  explicit StopScope(const StopFlag* flag) : outer_(StopFlag::innermost) { StopFlag::innermost = flag; }
  StopScope(const StopScope&) = delete;
  StopScope& operator=(const StopScope&) = delete;
  ~StopScope() { StopFlag::innermost = outer_; }

  /// The flag of the innermost scope of this thread, or null.
  static const StopFlag* current() { return StopFlag::innermost; }

 private:
  const StopFlag* outer_;
};

/// The moment at which work ends with what it has. Seconds are of wall clock.
class Deadline {
 public:
  /// Work without end of its own.
  Deadline() : end_(Clock::time_point::max()), stop_(StopScope::current()) {}
  /// Domain: seconds >= 0; more than 10^9 is as good as no end.
  static Deadline in(double seconds) {
    Deadline result;
    if (seconds < 1e9) result.end_ = Clock::now() + duration(seconds);
    return result;
  }

  bool expired() const { return is_stopped() || (end_ != Clock::time_point::max() && Clock::now() >= end_); }
  /// Seconds left: 0 once expired, infinite without an end.
  double remaining() const {
    if (is_stopped()) return 0;
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
  bool is_stopped() const { return stop_ != nullptr && stop_->is_set(); }

  Clock::time_point end_;
  const StopFlag* stop_;
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
