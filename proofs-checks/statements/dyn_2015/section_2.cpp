// Sections 1, 2 and 2.1: the primal schemes of degree 1, their convergence and smoothness.

#include "../identities.hpp"
#include "dyn_2015.hpp"

#include <subcert/schemes/local_regression.hpp>

namespace subcert::statements {
namespace {

Formula constant(const char* text) { return Formula::parse(text); }

Outcome equation_2(const Context& context) {
  const Fit even{context.formula("dyn-2015/eq-2-even"), "j", {-1, 1}, {1, -1}, {1, 0}, constant("0"), 1, 1, {}};
  const Fit odd{context.formula("dyn-2015/eq-2-odd"), "j", {-1, 1}, {1, 0}, {1, 0}, constant("1/2"), 1, 1, {}};
  const int most = context.reach(8, 40);
  Trial trial = fit(even, most);
  trial.follow(fit(odd, most));
  return trial.outcome();
}

}  // namespace

void add_dyn_2015_section_2(PaperStatements& to) {
  to.transcriptions.insert(to.transcriptions.end(), {
    {"dyn-2015/eq-2-even", "1/(2*n - 1)"},
    {"dyn-2015/eq-2-odd", "1/(2*n)"},
  });
  to.statements.push_back(
      {"dyn-2015/eq-2", "section 2, equation (2)", "The refinement rules of S_n are averages of 2n-1 and of 2n data.",
       "the weights against the local linear least squares fits",
       R"(f_{2i}^{k+1} = <<dyn-2015/eq-2-even>> \sum_{j=-n+1}^{n-1} f_{i+j}^k, \quad
f_{2i+1}^{k+1} = <<dyn-2015/eq-2-odd>> \sum_{j=-n+1}^{n} f_{i+j}^k)",
       "", Verdict::holds_for_all, equation_2});
}

}  // namespace subcert::statements
