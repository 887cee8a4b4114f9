#pragma once
/// How long a proof may take, and who watches it.

#include "check.hpp"

#include <subcert/analysis/symbol/support/budget.hpp>

#include <functional>
#include <string>
#include <vector>

namespace subcert::theorems {

/// A proof goes on from step to step until the deadline; each step is told before it is taken.
struct Patience {
  Deadline deadline = {};
  std::function<void(const std::string& step)> progress = {};
};

/// What ends a proof that takes longer: the step that was not taken, and the inequalities before it.
struct OutOfTime {
  std::string step;
  std::vector<Check> checks = {};
};

/// Steps on this thread are under that patience as long as the scope lives; null: without end, and unwatched.
class PatienceScope {
 public:
  explicit PatienceScope(const Patience* patience) : before_(innermost) { innermost = patience; }
  PatienceScope(const PatienceScope&) = delete;
  PatienceScope& operator=(const PatienceScope&) = delete;
  ~PatienceScope() { innermost = before_; }

  /// That of this thread, or null.
  static const Patience* current() { return innermost; }

 private:
  const Patience* before_;
  static inline thread_local const Patience* innermost = nullptr;
};

/// Before a step. Errors: throws OutOfTime after the deadline.
inline void next_step(const std::string& name) {
  const Patience* patience = PatienceScope::current();
  if (!patience) return;
  if (patience->deadline.expired()) throw OutOfTime{name};
  if (patience->progress) patience->progress(name);
}

}  // namespace subcert::theorems
