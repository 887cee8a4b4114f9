#pragma once
/// Positions read as decimal numbers, and the uniform grid they stand for.

#include "extension.hpp"

#include <subcert/analysis/symbol/numbers/numbers.hpp>

#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace subcert::data {

/// The shortest decimal number that reads as this double, exactly. Domain: finite.
Rational decimal_value(double value);

/// The grid through the first and the last of some positions, and how they fit it.
struct UniformGrid {
  Rational origin;
  Rational spacing = 1;   ///< the mean one
  bool uniform = true;    ///< each position is within one unit of the finest decimal place among them, and within a
                          ///< twentieth of the spacing, of its place
  std::size_t worst = 0;  ///< where not: positions[worst + 1] - positions[worst] is farthest from the mean
};

/// Domain: finite positions that increase, one or more. The answer is that of exact arithmetic on the shortest decimal
/// numbers; double precision decides where it certainly can. Cost: one pass.
UniformGrid uniform_grid(const std::vector<double>& positions);

/// Of a grid with gaps: the distance that half of the neighbours or more have, where its multiples from the first to
/// the last position are at most twice as many as positions; nothing where there is none. Domain: as uniform_grid().
/// Cost: linear.
std::optional<Rational> common_spacing(const std::vector<double>& positions);

/// Whether positions that come one after another stand on a grid that is known before.
class GridCheck {
 public:
  GridCheck(Rational origin, Rational spacing);

  /// Whether the next position is within one unit of the finest decimal place so far, and within a twentieth of the
  /// spacing, of its place. Domain: finite.
  bool accepts(double position);
  /// Where the position asked for last should be.
  Rational expected() const { return origin_ + spacing_ * Rational(count_ - 1); }

 private:
  Rational origin_;
  Rational spacing_;
  double rounded_origin_;
  double rounded_spacing_;
  std::size_t count_ = 0;
  long place_ = std::numeric_limits<long>::max();  // of the finest decimal
  Rational allowed_ = 0;                           // with that, but for a few units of the last bit
};

/// nearest_double(origin + spacing * index / scale) for many indices.
class GridPositions {
 public:
  /// Domain: scale >= 1. Errors: throws Error.
  GridPositions(Rational origin, const Rational& spacing, std::size_t scale);
  double at(std::size_t index) const;

 private:
  Rational origin_;
  Rational step_;
  long double rounded_origin_;
  long double rounded_step_;
};

/// columns[c][i] is the datum of function c at positions[i] or, where there are none, at origin + i * spacing.
/// Canonical: one column or more, all of one size; as many weights as data, or none; positions likewise. With
/// derivatives (hermite_samples.hpp) i counts the values alone: columns and weights are longer, positions are not.
struct Samples {
  std::vector<std::vector<double>> columns;
  std::vector<Rational> weights = {};  ///< prior, inverse to the variance of the noise; 0: missing; none: all 1
  Rational origin = 0;                 ///< of the outputs
  Rational spacing = 1;                ///< likewise
  std::vector<double> positions = {};  ///< from `origin` on, in order; several data may have one
  std::optional<double> noise = {};    ///< standard deviation for weight 1, where it is known
  std::vector<double> given = {};      ///< of uniform data: the positions as they were read, which answers at the data
                                       ///< have; none: those of the grid
  bool slopes = false;  ///< the columns of the second half are the slopes, by position, of those of the first
  std::optional<double> slope_noise = {};  ///< standard deviation of their noise for weight 1, where it is known
  int derivatives = 0;  ///< so many data after each value are derivatives there, by the spacing, with weights of theirs
  double derivative_weight = 1;  ///< that of a derivative of weight 1

  /// Positions, of which several may be equal.
  std::size_t rows() const { return count() / (static_cast<std::size_t>(derivatives) + 1); }
  std::size_t count() const { return columns.empty() ? 0 : columns.front().size(); }
  bool uniform() const { return positions.empty(); }
  /// Whether several data have one position.
  bool repeated() const;
  /// Puts the data at these positions: on their uniform grid, or one by one, with origin and spacing of that grid,
  /// which is the answer, or their common_spacing(). Domain: as many as data, in order, not all of several equal.
  UniformGrid put_at(std::vector<double> x);
  /// With positions in spacings, rounded.
  DataSites sites() const;
  std::vector<double> rounded_weights() const;
  /// Leaves out the data of weight 0, which are not needed where positions are given. Domain: not all of them.
  void drop_missing();
};

/// Data from `first` to before `end` have one position.
struct PositionGroup {
  std::size_t first, end;
};

/// Domain: positions in order.
std::vector<PositionGroup> groups_of_positions(const std::vector<double>& positions);

/// The mean of the data of a group by their weights, none being 1 each; 0 where all are 0. `sum`: of the weights.
double mean_of(const std::vector<double>& data, const std::vector<double>& weights, const PositionGroup& group,
               double sum);

/// One datum for each position: the mean by weights, with their sum as its weight.
Samples merged(const Samples& samples);

/// How positions come.
struct PositionOrder {
  std::vector<std::size_t> rows;  ///< in the order of their positions, equal ones as they come; those without are left
                                  ///< out
  bool rising = true;             ///< they come in this order
  bool falling = false;           ///< they come in the opposite one
  std::optional<std::size_t> repeated = {};  ///< a row with the position of the one before it, in `rows`
};

/// Domain: NaN for a missing position, else finite. Cost: one pass, or a sort.
PositionOrder order_of(const std::vector<double>& positions);

}  // namespace subcert::data
