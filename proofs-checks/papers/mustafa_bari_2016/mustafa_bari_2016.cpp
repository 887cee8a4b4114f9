#include "mustafa_bari_2016.hpp"

namespace subcert::statements::mustafa_bari_2016 {

PaperStatements paper() {
  PaperStatements paper{"mustafa-bari-2016",
                        "G. Mustafa, M. Bari: Wide-ranging families of subdivision schemes for fitting data. Punjab "
                        "University Journal of Mathematics 48 (2016), no. 2, 125-134.",
                        {},
                        {}};
  add_univariate(paper);
  add_bivariate(paper);
  return paper;
}

}  // namespace subcert::statements::mustafa_bari_2016
