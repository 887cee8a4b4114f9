#include "checks.hpp"

namespace subcert::statements::mustafa_bari_2016 {

Checks checks() { return joined({univariate(), bivariate()}); }

}  // namespace subcert::statements::mustafa_bari_2016
