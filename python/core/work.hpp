#pragma once
// Long work: without the interpreter's lock, ended by an interrupt, with reports on its way.

#include "casters.hpp"

#include <subcert/analysis/symbol/support/budget.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>

namespace subcert::python {

/// Runs the work on a thread of its own and waits; meanwhile other threads of the interpreter run, signals are obeyed,
/// and `progress` (None, or called with the seconds that have passed) is called ten times a second. An interrupt, or an
/// exception of `progress`, ends all deadlines of the work; once that has come back, the exception is thrown. Domain:
/// work that touches no Python object. Errors: those of the work.
void wait_for(const py::object& progress, const std::function<void()>& work);

/// The same for work with a result. Its arguments are the caller's.
template <class Work>
auto interruptible(const py::object& progress, const Work& work) {
  std::optional<decltype(work())> result;
  wait_for(progress, [&] { result.emplace(work()); });
  return std::move(*result);
}

}  // namespace subcert::python
