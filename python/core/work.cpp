#include "work.hpp"

namespace subcert::python {
namespace {

constexpr auto look = std::chrono::milliseconds(100);

}  // namespace

void wait_for(const py::object& progress, const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  StopFlag stop;
  std::exception_ptr failure, interrupt;
  std::mutex ending;
  std::condition_variable ended;
  bool done = false;
  // Calls into the interpreter; once one has thrown, no more.
  const auto report = [&] {
    const py::gil_scoped_acquire lock;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (!progress.is_none())
        progress(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    } catch (...) {
      interrupt = std::current_exception();
      stop.set();
    }
  };
  {
    const py::gil_scoped_release unlocked;
    const StopScope scope(&stop);
    const std::jthread worker = on_own_thread([&] {
      try {
        work();
      } catch (...) {
        failure = std::current_exception();
      }
      const std::lock_guard lock(ending);
      done = true;
      ended.notify_one();
    });
    std::unique_lock lock(ending);
    while (!ended.wait_for(lock, look, [&] { return done; })) {
      if (interrupt) continue;
      lock.unlock();
      report();
      lock.lock();
    }
  }
  if (interrupt) std::rethrow_exception(interrupt);
  if (failure) std::rethrow_exception(failure);
}

}  // namespace subcert::python
