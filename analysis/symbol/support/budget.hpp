#pragma once
/// How long work may take and how much memory it may hold.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

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

/// Processor time of all threads that work for a task and for the tasks within it: it does not depend on what else the
/// machine does, and threads that wait need none. Each thread enters its own time about every millisecond in which it
/// asks for a meter, and when it ends its work.
class Meter {
 public:
  using Nanoseconds = std::int64_t;

  explicit Meter(std::shared_ptr<Meter> outer = nullptr) : outer_(std::move(outer)) {}
  void add(Nanoseconds time);
  Nanoseconds time() const { return time_.load(std::memory_order_relaxed); }

 private:
  std::atomic<Nanoseconds> time_ = 0;
  std::shared_ptr<Meter> outer_;
};

/// As long as it lives, the time of this thread is that of a task of its own within the task before, or of one that is
/// handed over. Questions that are answered side by side are tasks, so that their deadlines do not add up; threads that
/// help with a question work for its task. A thread without a scope has a task of its own.
class TaskScope {
 public:
  TaskScope() : TaskScope(std::make_shared<Meter>(current())) {}
  explicit TaskScope(std::shared_ptr<Meter> task);
  TaskScope(const TaskScope&) = delete;
  TaskScope& operator=(const TaskScope&) = delete;
  ~TaskScope();

  /// The task of this thread.
  static const std::shared_ptr<Meter>& current();

 private:
  std::shared_ptr<Meter> before_;
};

/// The moment at which work ends with what it has. Seconds are of processor time of the task that makes the deadline,
/// whoever asks. Error: some milliseconds for each thread of the task, and what a thread does without asking.
class Deadline {
 public:
  /// Work without end of its own.
  Deadline() : stop_(StopScope::current()) {}
  /// Without an end, whatever is stopped: for work of which a result is needed.
  static Deadline never() {
    Deadline result;
    result.stop_ = nullptr;
    return result;
  }
  /// Domain: seconds >= 0; more than 10^9 is as good as no end.
  static Deadline in(double seconds);

  /// Cost: a look at the clock of the machine, which is not asked of the system.
  bool expired() const;
  /// Seconds left: 0 once expired, infinite without an end.
  double remaining() const;
  /// After that share of the time that is left. Domain: 0 <= share <= 1.
  Deadline after(double share) const { return at_most(share * remaining()); }
  /// The earlier of this and `seconds` from now, of the task that asks.
  Deadline at_most(double seconds) const;
  /// `seconds` after this one, or after now where it has expired, to prove what was found. However often and by however
  /// many steps of the same work that is asked, all end half a second and a tenth of its time after the whole of it.
  Deadline later(double seconds) const;

 private:
  bool is_stopped() const { return stop_ != nullptr && stop_->is_set(); }

  std::shared_ptr<const Meter> task_;  ///< none: no end
  Meter::Nanoseconds end_ = 0;
  Meter::Nanoseconds last_ = 0;            ///< for later ones
  std::shared_ptr<const Deadline> outer_;  ///< of another task, which ends this one as well
  const StopFlag* stop_;
};

/// Seconds of processor time since it was made, of the task that made it.
class Stopwatch {
 public:
  Stopwatch();
  double seconds() const;

 private:
  std::shared_ptr<const Meter> task_;
  Meter::Nanoseconds start_;
};

/// Limits of a search. Near either of them it ends with what is proved so far.
struct Budget {
  Deadline deadline;
  std::size_t memory = std::size_t{1} << 30;  ///< bytes that the search may hold
};

}  // namespace subcert
