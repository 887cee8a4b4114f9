#pragma once
/// Mustafa & Bari 2016 [MB16], statement by statement.

#include "../registry.hpp"

namespace subcert::statements {

PaperStatements mustafa_bari_2016();

}  // namespace subcert::statements
