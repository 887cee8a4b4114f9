#pragma once
/// The largest value of a linear form on cones within a box that differ in the signs of their rows alone: searched in
/// double precision, bounded exactly. Inner header.

#include "piecewise_rule.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace subcert::piecewise {

/// What is known of the sign of a row. Values are sets of allowed signs of its multiplier, 1 for + and 2 for -.
enum class Side : unsigned char { any = 0, nonnegative = 1, nonpositive = 2, zero = 3 };

/// objective + sum of multipliers[i] * row[i] = c, c without the free coordinates; each multiplier > 0 where the row is
/// >= 0, < 0 where it is <= 0, any where it is 0: so the objective is at most `bound`, the sum of |c_j|, if |x_j| <= 1.
struct ConeBound {
  Rational bound;
  std::vector<std::pair<std::size_t, Rational>> multipliers;  ///< those that are not zero, in the order of the rows
};

/// Maximises a form where the rows have the signs of their sides and |x_j| <= 1 for the first `boxed` coordinates, the
/// others free, by a dual simplex method: each of its bases gives multipliers. Nothing is believed of a basis: its
/// multipliers are solved for in rationals, and what they prove is what is returned.
class ConeProgram {
 public:
  /// A basis of constraints and what belongs to it; one that is best for some sides starts the search for others that
  /// are stricter.
  class Corner {
    friend class ConeProgram;
    struct Constraint {
      bool is_row = false;
      std::size_t index = 0;  // of a row, or of a coordinate
      int sign = 1;           // sign * row >= 0; of a coordinate: sign * x <= width
    };
    std::vector<Constraint> basis;
    std::vector<double> inverse;  // [basis constraint][coordinate]: column of the inverse
    std::vector<double> x, y;
  };

  /// Domain: boxed <= dimension; at most `dimension` coordinates in each row and in the objective.
  ConeProgram(std::size_t dimension, std::size_t boxed, std::vector<Row> rows, Row objective);

  std::size_t rows() const { return rows_.size(); }
  /// The corner of the box at which the objective is largest: best where all sides are `any`.
  Corner corner_of_box() const;
  /// Goes on from a corner that was best for sides that are not stricter, to one that is best, or whose value is below
  /// `enough` and rests on rows and the box alone. False where the search fails. Cost: dimension * (dimension + rows)
  /// operations a pivot.
  bool improve(Corner& corner, const std::vector<Side>& sides, double enough) const;
  /// The value of the objective, in double precision; where free coordinates are not held it is large.
  double value(const Corner& corner) const;
  /// Of the rows there, in double precision.
  std::vector<double> row_values(const Corner& corner) const;
  /// What the multipliers of the corner prove; nothing where free coordinates are not held, or the search was wrong.
  /// Cost: an exact linear system of as many rows as the basis has.
  std::optional<ConeBound> bound(const Corner& corner, const std::vector<Side>& sides) const;
  /// The point itself if it has the signs of the sides and is in the box, exactly; else nothing.
  std::optional<std::vector<Rational>> point(const Corner& corner, const std::vector<Side>& sides) const;

 private:
  using Constraint = Corner::Constraint;
  std::optional<std::pair<Constraint, double>> violated(const Corner& corner, const std::vector<Side>& sides) const;
  std::optional<std::size_t> leaving(const Corner& corner, const std::vector<double>& entering,
                                     const std::vector<Side>& sides, std::size_t salt) const;
  std::vector<double> in_basis(const Corner& corner, const Constraint& constraint) const;
  void replace(Corner& corner, std::size_t out, const Constraint& next, double by, const std::vector<double>& entering,
               const std::vector<Side>& sides) const;
  bool leans_on_free(const Corner& corner) const;
  double product(std::size_t row, const double* x) const;
  double width(std::size_t coordinate) const { return coordinate < boxed_ ? 1 : free_width; }

  static constexpr double free_width = 1e4;  // in the search alone; a bound never rests on it

  std::size_t dimension_, boxed_;
  std::vector<Row> rows_;
  Row objective_;
  std::vector<double> entries_;  // rows divided by their largest moduli, one after the other
};

}  // namespace subcert::piecewise
