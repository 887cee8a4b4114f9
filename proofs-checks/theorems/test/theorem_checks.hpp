#pragma once
/// What holds for every theorem.

#include <subcert/cmake/catch.hpp>
#include <subcert/proofs-checks/theorems/theorem.hpp>

#include <set>
#include <string>

namespace subcert::theorems {

/// Every inequality holds, and each constant, moved to its wrong side, fails the inequality that bounds it.
inline void check_theorem(const std::string& id, int degree, const std::string& family = "primal") {
  const Theorem& theorem = proved(id, degree, family, 2);
  const Constants& stated = theorem.constants;
  for (const Check& check : theorem.checks) {
    CAPTURE(id, family, degree, check.id, check.claim, check.left.upper_text(), check.right.lower_text());
    CHECK(check.decision.is_yes());
    CHECK(check.left.is_canonical());
    CHECK(check.right.is_canonical());
  }
  CHECK(theorem.decision.is_yes());
  CHECK_FALSE(theorem.statement.empty());
  CHECK_FALSE(theorem.text.empty());

  std::set<std::string> names;
  for (const Constant& constant : stated.all()) {
    CAPTURE(id, family, degree, constant.name, constant.check);
    CHECK(constant.value > 0);
    CHECK(names.insert(constant.name).second);
    const Theorem broken = prove(id, degree, stated.broken(constant.name), 1, family);
    CHECK(broken.decision.is_no());
    bool its_own = false;
    for (const Check& check : broken.checks)
      its_own = its_own || (check.id == constant.check && check.decision.is_no());
    CHECK(its_own);
  }
}

}  // namespace subcert::theorems
