#include "checks.hpp"

namespace subcert::statements::mustafa_li_2015 {

Checks checks() { return joined({problem(), support(), curves(), surfaces(), surface_variants()}); }

}  // namespace subcert::statements::mustafa_li_2015
