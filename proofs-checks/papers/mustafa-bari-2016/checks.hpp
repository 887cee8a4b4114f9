#pragma once
/// Mustafa & Bari 2016 [MB16], statement by statement.

#include <subcert/proofs-checks/statements/statement.hpp>

namespace subcert::statements::mustafa_bari_2016 {

/// Of one part of the paper each.
Checks univariate();
Checks bivariate();

/// All of them.
inline Checks checks() { return joined({univariate(), bivariate()}); }

}  // namespace subcert::statements::mustafa_bari_2016
