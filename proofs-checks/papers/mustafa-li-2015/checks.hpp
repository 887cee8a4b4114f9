#pragma once
/// Mustafa, Li, Zhang & Deng 2015 [MLZD15], statement by statement.

#include <subcert/proofs-checks/statements/reweighting.hpp>
#include <subcert/proofs-checks/statements/statement.hpp>

namespace subcert::statements::mustafa_li_2015 {

/// The four rules of a scheme for surfaces, as their ids and witnesses name them.
inline const std::vector<std::string> rule_names{"00", "10", "01", "11"};

/// The polynomials of degree 1 that they fit.
inline const std::vector<Formula> plane{f("1"), f("r"), f("s")};

/// tau, lambda, kappa and chi of (11) to (14) and (19) for a window.
Values sums_of_surface(const Context& context, const WeightedWindow& window, long first, long last);

/// Of one part of the paper each.
Checks problem();
Checks support();
Checks curves();
Checks surfaces();
Checks surface_variants();

/// All of them.
inline Checks checks() { return joined({problem(), support(), curves(), surfaces(), surface_variants()}); }

}  // namespace subcert::statements::mustafa_li_2015
