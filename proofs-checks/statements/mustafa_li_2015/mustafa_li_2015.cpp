#include "mustafa_li_2015.hpp"

namespace subcert::statements {

PaperStatements mustafa_li_2015() {
  PaperStatements paper{"mustafa-li-2015",
                        "G. Mustafa, H. Li, J. Zhang, J. Deng: l1-regression based subdivision schemes for noisy data. "
                        "Computer-Aided Design 58 (2015), 189-199.",
                        {},
                        {}};
  add_mustafa_li_2015_problem(paper);
  add_mustafa_li_2015_support(paper);
  add_mustafa_li_2015_curves(paper);
  add_mustafa_li_2015_surfaces(paper);
  add_mustafa_li_2015_surface_variants(paper);
  return paper;
}

}  // namespace subcert::statements
