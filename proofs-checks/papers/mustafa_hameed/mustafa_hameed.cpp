#include "mustafa_hameed.hpp"

namespace subcert::statements::mustafa_hameed {

PaperStatements paper() {
  PaperStatements paper{"mustafa-hameed",
                        "G. Mustafa, R. Hameed: Families of non-linear subdivision schemes for scattered data fitting "
                        "and their non-tensor product extensions. Preprint, arXiv:1709.04282.",
                        {},
                        {}};
  add_claims(paper);
  add_iteration(paper);
  add_starting_values(paper);
  return paper;
}

}  // namespace subcert::statements::mustafa_hameed
