#pragma once
/// Mustafa, Li, Zhang & Deng 2015 [MLZD15], statement by statement.

#include <subcert/proofs-checks/statements/reweighting.hpp>
#include <subcert/proofs-checks/statements/statement.hpp>

namespace subcert::statements::mustafa_li_2015 {

/// The four rules of a scheme for surfaces, as their ids and witnesses name them.
inline const std::vector<std::string> rule_names{"00", "10", "01", "11"};

/// The polynomials of degree 1 that they fit.
inline const std::vector<Formula> plane{f("1"), f("r"), f("s")};

/// What the problem of the line is a function of, with delta and with e = delta^(1/2).
inline const std::vector<Variable> line_names{{"f", 1}, {"beta1", 2}, {"beta2", 3}, {"r", 5}, {"delta", 7}};
inline const std::vector<Variable> root_names{{"f", 1}, {"beta1", 2}, {"beta2", 3}, {"r", 5}, {"e", 7}};

/// tau, lambda, kappa and chi of (11) to (14) and (19) for a window.
Values sums_of_surface(const Context& context, const WeightedWindow& window, long first, long last);

/// Of one part of the paper each.
Checks problem();
Checks robustness();
Checks support();
Checks curves();
Checks surfaces();
Checks surface_variants();

/// All of them.
inline Checks checks() {
  return joined({problem(), robustness(), support(), curves(), surfaces(), surface_variants()});
}

}  // namespace subcert::statements::mustafa_li_2015
