#include <subcert/analysis/symbol/support/budget.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>
#include <subcert/cmake/catch.hpp>

#include <signal.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>
#include <vector>

using namespace subcert;

namespace {

constexpr double margin = 0.05;  // seconds: many times what is allowed

double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Works until the deadline, which it asks all the time; seconds of this thread.
double work_until(const Deadline& deadline) {
  const double start = processor_seconds();
  while (!deadline.expired()) continue;
  return processor_seconds() - start;
}

/// Works without asking anything.
void work_for(double seconds) {
  const double start = processor_seconds();
  while (processor_seconds() - start < seconds) continue;
}

/// Processes and threads of other tasks that are busy as long as it lives.
class Load {
 public:
  Load() {
    for (int k = 0; k < 2; ++k) {
      children_.push_back(fork());
      if (children_.back() == 0)
        for (;;) continue;
      threads_.emplace_back([this] {
        while (!end_) continue;
      });
    }
  }
  ~Load() {
    end_ = true;
    for (const pid_t child : children_) {
      kill(child, SIGKILL);
      waitpid(child, nullptr, 0);
    }
  }

 private:
  std::atomic<bool> end_ = false;
  std::vector<pid_t> children_;
  std::vector<std::jthread> threads_;
};

bool is_near(double seconds, double right) { return right - 0.005 <= seconds && seconds <= right + margin; }

}  // namespace

TEST_CASE("a deadline allows the same work on a busy machine") {
  CHECK(is_near(work_until(Deadline::in(0.2)), 0.2));
  const Load load;
  const Stopwatch watch;
  CHECK(is_near(work_until(Deadline::in(0.2)), 0.2));
  CHECK(is_near(watch.seconds(), 0.2));
}

TEST_CASE("waiting uses nothing up") {
  const Deadline deadline = Deadline::in(0.1);
  const Stopwatch watch;
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  CHECK_FALSE(deadline.expired());
  CHECK(deadline.remaining() > 0.05);
  CHECK(watch.seconds() < 0.05);
}

TEST_CASE("deadlines without time, and without end") {
  CHECK(Deadline::in(0).expired());
  CHECK(Deadline::in(0).remaining() == 0);
  for (const Deadline& endless : {Deadline(), Deadline::in(1e9), Deadline::in(1e300), Deadline().after(0.5),
                                  Deadline().after(0), Deadline().at_most(1e10)}) {
    CHECK_FALSE(endless.expired());
    CHECK(endless.remaining() == std::numeric_limits<double>::infinity());
  }
  CHECK(Deadline().at_most(0).expired());
  CHECK(Deadline::in(0).at_most(1000).expired());
  CHECK(is_near(Deadline::in(100).after(0.25).remaining(), 24.99));
  CHECK(is_near(Deadline::in(100).at_most(7).remaining(), 6.99));
  CHECK(is_near(Deadline::in(7).at_most(100).remaining(), 6.99));
}

TEST_CASE("later deadlines end together, however many there are") {
  CHECK(Deadline().later(1).remaining() == std::numeric_limits<double>::infinity());
  CHECK(is_near(Deadline::in(100).later(7).remaining(), 106.99));
  CHECK(is_near(Deadline::in(100).after(0.25).later(7).remaining(), 31.99));
  CHECK(is_near(Deadline::in(100).later(1000).remaining(), 110.49));
  CHECK(is_near(Deadline::in(100).later(8).later(8).remaining(), 110.49));
  const Deadline whole = Deadline::in(0.1);
  const Stopwatch watch;
  for (int k = 0; k < 8; ++k) work_until(whole.after(0.5).later(0.2));
  CHECK(is_near(watch.seconds(), 0.61));
  CHECK(whole.later(1e300).expired());
  CHECK(whole.at_most(5).later(5).expired());

  const Deadline outside = Deadline::in(0.1);
  parallel_tasks(2, 2, [&](std::size_t) {
    const Deadline own = outside.at_most(50);
    for (int k = 0; k < 4; ++k) work_until(own.later(0.2));
    CHECK(own.later(1).expired());
  });
  CHECK(outside.later(1).expired());

  StopFlag flag;
  const StopScope scope(&flag);
  const Deadline stopped = Deadline::in(10);
  flag.set();
  CHECK(stopped.later(1).expired());
}

TEST_CASE("threads that work for one task use its time up together") {
  const Deadline deadline = Deadline::in(0.3);
  const Stopwatch watch;
  std::vector<double> used(2);
  parallel_for_each(2, 2, [&](std::size_t i) { used[i] = work_until(deadline); });
  CHECK(is_near(used[0] + used[1], 0.3));
  CHECK(is_near(watch.seconds(), 0.3));
  CHECK(deadline.expired());

  const Deadline silent = Deadline::in(0.15);
  parallel_for_each(3, 3, [](std::size_t) { work_for(0.06); });
  CHECK(silent.expired());  // also by what the others did without asking
}

TEST_CASE("questions that are tasks have their time each, and the whole of it counts outside") {
  const Deadline outside = Deadline::in(0.35);
  const Stopwatch watch;
  std::vector<double> used(4), inside(4);
  parallel_tasks(4, 2, [&](std::size_t i) {
    const Stopwatch own;
    used[i] = work_until(Deadline::in(0.1));
    inside[i] = own.seconds();
  });
  for (std::size_t i = 0; i < 4; ++i) {
    CAPTURE(i, used[i], inside[i]);
    CHECK(is_near(used[i], 0.1));
    CHECK(is_near(inside[i], 0.1));
  }
  CHECK(is_near(watch.seconds(), 0.4));
  CHECK(outside.expired());
}

TEST_CASE("a deadline of the task outside ends the work inside") {
  const Deadline outside = Deadline::in(0.1);
  std::vector<double> used(2);
  parallel_tasks(2, 2, [&](std::size_t i) {
    const Deadline own = outside.at_most(50);
    used[i] = work_until(own);
    CHECK(own.at_most(20).expired());
    CHECK(own.remaining() == 0);
  });
  CHECK(is_near(used[0] + used[1], 0.1));
  {
    const TaskScope task;
    const Deadline later = Deadline::in(0.1);
    work_for(0.05);
    {
      const TaskScope inner;
      CHECK(is_near(work_until(later), 0.05));
    }
    CHECK(later.expired());
  }
  CHECK(is_near(work_until(Deadline::in(0.05)), 0.05));  // the tasks that ended left no trace
}
