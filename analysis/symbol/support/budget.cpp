#include "budget.hpp"

#include <time.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace subcert {
namespace {

using Nanoseconds = Meter::Nanoseconds;

constexpr double per_second = 1e9;
constexpr double endless = 1e9;                         // seconds
constexpr double overtime = 0.5, overtime_share = 0.1;  // seconds, and of the time
constexpr auto look = std::chrono::milliseconds(1);

Nanoseconds processor_time() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return Nanoseconds{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

/// The time of one thread, and the task that it works for.
class ThreadTime {
 public:
  /// Enters the time since the last entry.
  void enter() { enter(std::chrono::steady_clock::now()); }

  /// As `enter`, unless the last entry was just now: a thread has no more processor time than the clock shows.
  void enter_if_due() {
    const auto now = std::chrono::steady_clock::now();
    if (now - entered_ >= look) enter(now);
  }

  std::shared_ptr<Meter> task = std::make_shared<Meter>();

 private:
  void enter(std::chrono::steady_clock::time_point now) {
    const Nanoseconds time = processor_time();
    task->add(time - time_);
    time_ = time;
    entered_ = now;
  }

  Nanoseconds time_ = processor_time();
  std::chrono::steady_clock::time_point entered_ = std::chrono::steady_clock::now();
};

ThreadTime& this_thread() {
  thread_local ThreadTime time;
  return time;
}

}  // namespace

void Meter::add(Nanoseconds time) {
  for (Meter* meter = this; meter != nullptr; meter = meter->outer_.get())
    meter->time_.fetch_add(time, std::memory_order_relaxed);
}

TaskScope::TaskScope(std::shared_ptr<Meter> task) : before_(std::move(task)) {
  this_thread().enter();
  std::swap(this_thread().task, before_);
}

TaskScope::~TaskScope() {
  this_thread().enter();
  std::swap(this_thread().task, before_);
}

const std::shared_ptr<Meter>& TaskScope::current() { return this_thread().task; }

Deadline Deadline::in(double seconds) { return Deadline().at_most(seconds); }

bool Deadline::expired() const {
  if (is_stopped()) return true;
  if (!task_) return false;
  this_thread().enter_if_due();
  return task_->time() >= end_ || (outer_ && outer_->expired());
}

double Deadline::remaining() const {
  if (is_stopped()) return 0;
  if (!task_) return std::numeric_limits<double>::infinity();
  this_thread().enter();
  const double own = std::max(0.0, static_cast<double>(end_ - task_->time()) / per_second);
  return outer_ ? std::min(own, outer_->remaining()) : own;
}

Deadline Deadline::at_most(double seconds) const {
  Deadline result;
  const double left = std::min(remaining(), seconds);
  if (!(left < endless)) return result;
  this_thread().enter();
  result.task_ = TaskScope::current();
  result.end_ = result.task_->time() + std::llround(left * per_second);
  result.last_ = result.end_ + std::llround((overtime + overtime_share * left) * per_second);
  if (!task_) return result;
  result.last_ = result.task_->time() + last_ - task_->time();
  result.outer_ = task_ == result.task_ ? outer_ : std::make_shared<Deadline>(*this);
  return result;
}

Deadline Deadline::later(double seconds) const {
  if (!task_) return *this;
  this_thread().enter();
  Deadline result = *this;
  const double most = static_cast<double>(last_ - end_) / per_second;
  const Nanoseconds more = std::llround(std::min(seconds, most) * per_second);
  result.end_ = std::min(last_, std::max(end_, task_->time()) + more);
  if (outer_) result.outer_ = std::make_shared<Deadline>(outer_->later(seconds));
  return result;
}

Stopwatch::Stopwatch() : task_(TaskScope::current()) {
  this_thread().enter();
  start_ = task_->time();
}

double Stopwatch::seconds() const {
  this_thread().enter();
  return static_cast<double>(task_->time() - start_) / per_second;
}

}  // namespace subcert
