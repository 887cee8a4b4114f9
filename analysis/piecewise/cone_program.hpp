#pragma once
/// The largest value of a linear form on a cone within a box: searched in double precision, bounded exactly. Inner
/// header.

#include "piecewise_rule.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace subcert::piecewise {

/// objective + sum of multipliers[i] * row[i] = c, the multipliers >= 0 and c without the free coordinates: so the
/// objective is at most `bound`, the sum of |c_j|, where the rows are >= 0 and |x_j| <= 1.
struct ConeBound {
  Rational bound;
  std::vector<std::pair<std::size_t, Rational>> multipliers;  ///< those that are not zero, in the order of the rows
};

/// Maximises a form subject to row.x >= 0 for all rows and |x_j| <= 1 for the first `boxed` coordinates, the others
/// free, by a dual simplex method: each of its bases gives multipliers. Nothing is believed of a basis: its multipliers
/// are solved for in rationals, and what they prove is what is returned.
class ConeProgram {
 public:
  /// Domain: boxed <= dimension.
  ConeProgram(std::size_t dimension, std::size_t boxed) : dimension_(dimension), boxed_(boxed) {}

  /// Domain: at most `dimension` coordinates; the row outlives the program.
  void add(const Row& row);

  /// A bound, the least one up to rounding of the search, or one that is at most `enough`; nothing where the search
  /// fails. Domain: at most `dimension` coordinates. Cost: dimension^2 + rows * dimension operations in double
  /// precision a pivot, then an exact linear system of as many rows as the basis has.
  std::optional<ConeBound> bound(const Row& objective, double enough);

  /// The free coordinate on which the last bound of the search leans most; nothing where it leans on none.
  std::optional<std::size_t> unbounded_coordinate() const;

  /// A point at which the last bound is attained, exactly feasible; nothing where it is not attained there.
  std::optional<std::vector<Rational>> maximiser() const;

 private:
  struct Constraint {
    bool is_row = false;
    std::size_t index = 0;  // of a row, or of a coordinate
    int sign = 1;           // of a coordinate: sign * x <= width
  };

  void start(const Row& objective);
  bool run(double enough);
  std::optional<std::size_t> leaving(const std::vector<double>& entering, std::size_t salt) const;
  std::optional<std::pair<Constraint, double>> violated() const;
  double width(std::size_t coordinate) const { return coordinate < boxed_ ? 1 : free_width; }
  std::optional<ConeBound> exact_bound(const Row& objective) const;

  static constexpr double free_width = 1e5;  // in the search alone; a bound never rests on it

  std::size_t dimension_, boxed_;
  std::vector<const Row*> rows_;
  std::vector<double> entries_;  // rows divided by their largest moduli, one after the other
  std::vector<Constraint> basis_;
  std::vector<double> inverse_;  // [basis constraint][coordinate]: column of the inverse
  std::vector<double> x_, y_;
};

}  // namespace subcert::piecewise
