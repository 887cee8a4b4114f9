#include "scheme_family.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

namespace subcert::theorems {

const std::vector<SchemeFamily>& scheme_families() {
  static const std::vector<SchemeFamily> list{
      {"primal", "primal 2n-point", Evaluation::primal, Rational(-1, 2), false},
      {"primal-odd", "primal (2n+1)-point", Evaluation::primal, Rational(1, 2), true},
      {"dual", "dual 2n-point", Evaluation::dual, 0, false},
      {"dual-odd", "dual (2n+1)-point", Evaluation::dual, 1, true}};
  return list;
}

const SchemeFamily& scheme_family(const std::string& id) {
  for (const SchemeFamily& family : scheme_families())
    if (family.id == id) return family;
  fail(ErrorKind::domain, "unknown family of least squares schemes '{}'", id);
}

}  // namespace subcert::theorems
