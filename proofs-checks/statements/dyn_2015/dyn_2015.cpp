#include "dyn_2015.hpp"

namespace subcert::statements {

PaperStatements dyn_2015() {
  PaperStatements paper{"dyn-2015",
                        "N. Dyn, A. Heard, K. Hormann, N. Sharon: Univariate subdivision schemes for noisy data with "
                        "geometric applications. Computer Aided Geometric Design 37 (2015), 85-104.",
                        {},
                        {}};
  add_dyn_2015_section_2(paper);
  return paper;
}

}  // namespace subcert::statements
