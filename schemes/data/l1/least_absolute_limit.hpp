#pragma once
/// What is true of the schemes of least absolute deviations: pieces, convergence and exponents, with proof.

#include "least_absolute.hpp"

#include <subcert/analysis/piecewise/contraction.hpp>
#include <subcert/analysis/piecewise/edge_orbit.hpp>
#include <subcert/analysis/symbol/masks/mask.hpp>

#include <optional>

namespace subcert::data {

/// `steps`, `order`: of the contraction; 0: the fewest steps that contract, and of the orders up to D + 1 the one that
/// proves most. `enough`: a lower bound than this is not looked for.
struct LimitOptions {
  int steps = 0;
  int order = 0;
  Rational enough = 0;
  Deadline deadline = {};
  bool keep_trees = false;
};

/// A contraction that time did not suffice for.
struct UnfinishedContraction {
  int steps, order;
  piecewise::ContractionSearch search;
};

struct LeastAbsoluteLimit {
  int points = 0;
  int degree = 0;
  int arity = 2;
  std::optional<std::size_t> pieces;       ///< nothing: too many
  Decision unique;                         ///< whether each datum has one minimiser
  Decision range;                          ///< whether no value of one step leaves the range of the data
  std::optional<Rational> largest_output;  ///< of one step on data of modulus 1 at most, where range is not yes
  /// Whether data whose differences of order 1, 2 are not negative keep this: monotone, convex data. Of degree 1 and
  /// more.
  std::vector<piecewise::SignOfDifferences> keeps;
  std::optional<Rational> lipschitz;  ///< of one step in the maximum norm, where minimisers are unique
  std::optional<Mask> mask;           ///< of a rule that is linear
  /// Of the steps and the order asked for, or the best of those tried; nothing where none was finished.
  std::optional<piecewise::Contraction> contraction;
  std::optional<UnfinishedContraction> unfinished;  ///< the last that was tried, if it was not finished
  /// For all data and all choices of minimisers, from window to window and from level to level.
  Decision converges;
  std::optional<piecewise::EdgeOrbit> edge;  ///< of degree 1 and arity 2, where minimisers are unique
  /// Of all limits: the lower end by the contraction, the upper one by the orbit; for linear rules as
  /// holder_regularity; no ends where convergence is not proved.
  Enclosure exponent;
};

/// Domain: 0 <= degree <= 3, degree < points <= 64; arity >= 2, 0 <= steps <= piecewise::most_steps(arity), 0 <= order
/// <= degree + 1. Errors: throws a domain
/// error. Cost: as contraction(), until the deadline. Ref: docs/l1.md, section 8.
LeastAbsoluteLimit least_absolute_limit(int points, int degree, const LimitOptions& options, int arity = 2);

/// -log(bound) / (steps log(arity)): the exponent that a contraction proves, where it is positive.
std::optional<Enclosure> proved_exponent(const piecewise::Contraction& contraction, int arity = 2);

}  // namespace subcert::data
