#pragma once
/// How much differences shrink over some steps of a rule by pieces, with proof.

#include "piecewise_rule.hpp"

#include <subcert/analysis/symbol/budget.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace subcert::piecewise {

/// A window of a level, level 0 being the data.
struct WindowPlace {
  int level;
  long window;
};

/// Factors of the residuals of all windows that a difference depends on. With them the difference at the last level is
/// a form in the data minus the sum of factors * residuals, for whatever fits: each window in turn is replaced by the
/// linear rule of its factors, which reproduces polynomials.
struct ResidualFactors {
  std::vector<Row> of_window;  ///< [window][datum]
  Rational bound;              ///< the sum of moduli of the form in the differences of the data
};

/// Preorder: the node that is split has one child for each piece of a window; a leaf has factors that are zero at
/// windows without a piece, and otherwise have the signs of the pieces: factor * residual >= 0.
struct ProofNode {
  bool split;
  std::uint32_t index;  ///< of the window, or of the factors
};

/// Of the difference with index `start`. Windows of one level follow each other, level after level.
struct ContractionTree {
  long start;
  std::vector<WindowPlace> windows;
  std::vector<ResidualFactors> leaves;  ///< in the order of their first use
  std::vector<ProofNode> nodes;
};

/// |D^order S^steps f| <= bound * |D^order f| in the maximum norm, for every choice of fits. Where data are given, they
/// have |D^order f| <= 1, and some choice of fits has a difference of the size of the bound.
struct Contraction {
  int steps = 1;
  int order = 1;
  Rational bound;
  std::vector<Rational> data;
  std::vector<ContractionTree> trees;  ///< one for each start that no mirror image with a lower one has, if kept
};

struct ContractionOptions {
  int steps = 1;
  int order = 1;
  Deadline deadline = {};
  bool keep_trees = false;
};

/// The least such bound, by a tree of linear programs in which the fits of windows without a piece are free. Nothing
/// past the deadline, or where a program fails. Domain: 1 <= order <= degree + 1, 1 <= steps <= 8; at most 64 points;
/// with each piece the rule has those with all signs turned and with the order of data turned. Errors: throws a domain
/// error. Cost: a program of as many rows as the pieces have for each node that no factors known close.
std::optional<Contraction> contraction(const Rule& rule, const ContractionOptions& options);

}  // namespace subcert::piecewise
