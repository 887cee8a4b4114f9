#pragma once
/// Mustafa & Bari 2016 [MB16], statement by statement.

#include <subcert/proofs-checks/statements/paper.hpp>

namespace subcert::statements::mustafa_bari_2016 {

/// All of them.
Checks checks();

/// Of one part of the paper each.
Checks univariate();
Checks bivariate();

}  // namespace subcert::statements::mustafa_bari_2016
