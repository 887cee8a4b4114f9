#pragma once
/// Mustafa & Bari 2016 [MB16], statement by statement.

#include <subcert/proofs-checks/statements/paper.hpp>

namespace subcert::statements::mustafa_bari_2016 {

PaperStatements paper();

/// One part of the paper each; `to` grows.
void add_univariate(PaperStatements& to);
void add_bivariate(PaperStatements& to);

}  // namespace subcert::statements::mustafa_bari_2016
