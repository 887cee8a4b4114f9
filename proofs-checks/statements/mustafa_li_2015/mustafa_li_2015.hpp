#pragma once
/// Mustafa, Li, Zhang & Deng 2015 [MLZD15], statement by statement.

#include "../registry.hpp"

namespace subcert::statements {

/// What the ids of its statements begin with.
inline const std::string mustafa_li_key = "mustafa-li-2015/";

PaperStatements mustafa_li_2015();

/// One part of the paper each; `to` grows.
void add_mustafa_li_2015_problem(PaperStatements& to);
void add_mustafa_li_2015_support(PaperStatements& to);
void add_mustafa_li_2015_curves(PaperStatements& to);
void add_mustafa_li_2015_surfaces(PaperStatements& to);
void add_mustafa_li_2015_surface_variants(PaperStatements& to);

}  // namespace subcert::statements
