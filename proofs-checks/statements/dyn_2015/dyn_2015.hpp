#pragma once
/// Dyn, Heard, Hormann & Sharon 2015 [DHHS15], statement by statement.

#include "../registry.hpp"

namespace subcert::statements {

PaperStatements dyn_2015();

/// One part of the paper each; `to` grows.
void add_dyn_2015_section_2(PaperStatements& to);

}  // namespace subcert::statements
