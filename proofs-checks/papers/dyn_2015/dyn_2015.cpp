#include "dyn_2015.hpp"

#include <subcert/proofs-checks/statements/trial.hpp>
#include <subcert/schemes/local_regression.hpp>

namespace subcert::statements::dyn_2015 {

PaperStatements paper() {
  PaperStatements paper{"dyn-2015",
                        "N. Dyn, A. Heard, K. Hormann, N. Sharon: Univariate subdivision schemes for noisy data with "
                        "geometric applications. Computer Aided Geometric Design 37 (2015), 85-104.",
                        {},
                        {}};
  add_section_2(paper);
  add_section_2_2(paper);
  add_section_3(paper);
  add_section_4(paper);
  add_section_4_3(paper);
  add_section_5(paper);
  add_appendix(paper);
  return paper;
}

Mask s_n(long n) { return regression_mask(primal(static_cast<int>(n), 1)); }

std::string range(int first, int last) {
  return "n = " + std::to_string(first) + (first == last ? "" : ".." + std::to_string(last));
}

std::string at_n_d(int n, int d) { return at("n", n) + ", " + at("d", d); }

}  // namespace subcert::statements::dyn_2015
