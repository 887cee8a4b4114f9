#include "mustafa_li_2015.hpp"

namespace subcert::statements::mustafa_li_2015 {

PaperStatements paper() {
  PaperStatements paper{"mustafa-li-2015",
                        "G. Mustafa, H. Li, J. Zhang, J. Deng: l1-regression based subdivision schemes for noisy data. "
                        "Computer-Aided Design 58 (2015), 189-199.",
                        {},
                        {}};
  add_problem(paper);
  add_support(paper);
  add_curves(paper);
  add_surfaces(paper);
  add_surface_variants(paper);
  return paper;
}

}  // namespace subcert::statements::mustafa_li_2015
