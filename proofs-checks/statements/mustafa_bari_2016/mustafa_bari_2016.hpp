#pragma once
/// Mustafa & Bari 2016 [MB16], statement by statement.

#include "../registry.hpp"

namespace subcert::statements {

PaperStatements mustafa_bari_2016();

/// One part of the paper each; `to` grows.
void add_mustafa_bari_2016_univariate(PaperStatements& to);
void add_mustafa_bari_2016_bivariate(PaperStatements& to);

}  // namespace subcert::statements
