#pragma once
/// How much differences shrink over some steps of a rule by pieces, with proof.

#include "piecewise_rule.hpp"

#include <subcert/analysis/symbol/support/budget.hpp>

#include <cstdint>
#include <optional>
#include <utility>
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
  std::vector<std::pair<std::size_t, Rational>> factors;  ///< window * points + datum, factor: those that are not 0
  Rational bound;                                         ///< sum of moduli of the form in the differences of the data
};

/// Preorder. A node splits the pieces that are possible for a window: its first child has those whose sign at one datum
/// is among `signs`, its second one the others. A leaf has factors with the signs of all pieces that are possible:
/// factor * residual >= 0.
struct ProofNode {
  enum Sign : std::uint8_t { positive = 1, negative = 2, none = 4 };
  bool split;
  std::uint8_t signs;   ///< a set of Sign
  std::uint16_t datum;  ///< of the window
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
  Rational enough = 0;  ///< a lower bound than this is not looked for
  Deadline deadline = {};
  bool keep_trees = false;
};

/// The largest number of steps that is treated: arity^steps <= 256.
int most_steps(long arity);

/// What was found of the bound before time was up or a program failed, if it was.
struct ContractionSearch {
  std::optional<Contraction> proved;
  Rational attained;             ///< some data with |D^order f| <= 1 have a difference of this size: no bound is lower
  std::vector<Rational> data;    ///< these data, where there are such
  int starts = 0, finished = 0;  ///< differences to be bounded, and those that were
};

/// The least such bound, or `enough`, by branch and bound: a tree of linear programs, each begun where the one above it
/// ended, in which the fit of a window is held by those residuals alone whose signs all its possible pieces share.
/// Domain: 1 <= order <= degree + 1, 1 <= steps <= most_steps(arity); 2 to 64 points; the fits are polynomials of the
/// degree of the rule, data at distance 1, with each place of an output its opposite is one; with each piece the rule
/// has those with all signs turned and with the order of data turned. Errors: throws a domain error. Cost: some
/// programs, of points * windows rows, for each node that no factors known close.
ContractionSearch contraction(const Rule& rule, const ContractionOptions& options);

/// Whether data with D^order f >= 0 have D^order S f >= 0, for every choice of fits: of order 1 monotone data stay
/// monotone, of order 2 convex ones convex.
struct SignOfDifferences {
  Decision kept;
  std::vector<Rational> data;  ///< where it is not kept: data that show it, with some choice of fits
};

/// By the same tree of programs, for one step. Domain: as contraction(). Unknown past the deadline, where a program
/// fails, and where no data show exactly what the programs found. Errors: throws a domain error.
SignOfDifferences keeps_sign(const Rule& rule, int order, const Deadline& deadline = {});

}  // namespace subcert::piecewise
