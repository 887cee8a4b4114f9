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

/// Preorder: a split has one child for each piece of the next window.
struct ProofNode {
  enum class Kind {
    split,
    leaf,  ///< factors have the signs of the cell: factor * residual >= 0
    thin   ///< the same, and the difference is replaced by zero: the residuals with a factor vanish on the cell
  };
  Kind kind;
  std::size_t index = 0;  ///< of the window that is split, or of the factors
};

/// Of the difference with index `start`. Windows of one level follow each other, level after level.
struct ContractionTree {
  long start;
  std::vector<WindowPlace> windows;
  std::vector<ResidualFactors> leaves;  ///< in the order of their first use
  std::vector<ResidualFactors> thin;
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

/// The least such bound, by a tree of linear programs. Nothing past the deadline, or where a program fails. Domain:
/// 1 <= order <= degree + 1, 1 <= steps <= 8; at most 64 points; with each piece the rule has those with all signs
/// turned and with the order of data turned. Errors: throws a domain error. Cost: a comparison of signs for each piece
/// of a window in each combination of pieces before it that has an interior, and a program where no factors known fit.
std::optional<Contraction> contraction(const Rule& rule, const ContractionOptions& options);

}  // namespace subcert::piecewise
