#pragma once
/// Mustafa, Li, Zhang & Deng 2015 [MLZD15], statement by statement.

#include <subcert/proofs-checks/statements/paper.hpp>

namespace subcert::statements::mustafa_li_2015 {

/// What the ids of its statements begin with.
inline const std::string key_prefix = "mustafa-li-2015/";

/// The four rules of a scheme for surfaces, as their ids and witnesses name them.
inline const std::vector<std::string> rule_names{"00", "10", "01", "11"};

/// The polynomials of degree 1 that they fit.
inline const std::vector<Formula> plane{f("1"), f("r"), f("s")};

PaperStatements paper();

/// One part of the paper each; `to` grows.
void add_problem(PaperStatements& to);
void add_support(PaperStatements& to);
void add_curves(PaperStatements& to);
void add_surfaces(PaperStatements& to);
void add_surface_variants(PaperStatements& to);

}  // namespace subcert::statements::mustafa_li_2015
