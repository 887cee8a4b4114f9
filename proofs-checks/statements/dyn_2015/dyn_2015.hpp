#pragma once
/// Dyn, Heard, Hormann & Sharon 2015 [DHHS15], statement by statement.

#include "../registry.hpp"

namespace subcert::statements {

PaperStatements dyn_2015();

/// One part of the paper each; `to` grows.
void add_dyn_2015_section_2(PaperStatements& to);
void add_dyn_2015_section_2_2(PaperStatements& to);
void add_dyn_2015_section_3(PaperStatements& to);
void add_dyn_2015_section_4(PaperStatements& to);
void add_dyn_2015_section_4_3(PaperStatements& to);
void add_dyn_2015_section_5(PaperStatements& to);
void add_dyn_2015_appendix(PaperStatements& to);

}  // namespace subcert::statements
