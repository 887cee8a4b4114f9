#include "checks.hpp"

namespace subcert::statements::mustafa_hameed {

Checks checks() { return joined({claims(), iteration(), starting_values()}); }

}  // namespace subcert::statements::mustafa_hameed
