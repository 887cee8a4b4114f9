#pragma once
/// Bounds: what the polynomials on the cells leave out, in doubles with proved errors, rounded outward
/// (docs/limit-enclosures.md, sections 3, 5 and 6).
///   setup   cell_setup   the scheme that contracts, phi in balls, its interpolating polynomials, the sources
///   bounds  cell_bounds  the remainders, in doubles with proved errors
///   walk    limit_cells  forms on cells, their children, the ranges they prove

#include "cell_setup.hpp"

#include <subcert/analysis/outward_rounding/outward.hpp>
#include <subcert/analysis/transition/transition.hpp>

#include <limits>
#include <vector>

namespace subcert::cells {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Bounds for epsilon = v minus its interpolating polynomial, all 0 where v is a polynomial.
struct Remainder {
  double value = 0;    // sup of the 1-norm of epsilon
  double slope = 0;    // and of epsilon'
  int word_level = 0;  // words[w]: eta on the w-th cell of this level, but for P_w eta
  std::vector<outward::VectorPolynomial> words;
};

/// Rows that stand in a form, one after the other, with what each step lost by rounding, for each row.
struct RowSpan {
  const std::vector<double>& rows;
  const std::vector<double>& losses;
  double factor;
  int level;
};

/// Bounds of the rows' part of a form and of its derivative by x, for each power of u.
struct RowBounds {
  double value[most_nodes] = {};
  double slope[most_nodes] = {};
};

/// Domain: lives no longer than the setup.
class CellBounds {
 public:
  /// `exact`: v is a polynomial, so that there is no remainder to bound.
  CellBounds(const CellSetup& setup, bool exact);

  /// Of S_[m], on rows.
  const Transition<double>& transition() const { return transition_; }
  const outward::Recentring& recentring(int digit) const { return recentring_[static_cast<std::size_t>(digit)]; }
  /// Above ||S_[m]||.
  double norm_of_step() const { return setup_.contraction.norms[1]; }

  /// What the words of one length contribute, and the rest by the norm of the power of that length.
  Remainder remainder(const std::vector<outward::VectorPolynomial>& sources) const;
  RowBounds row_bounds(const RowSpan& span, const Remainder& rest, bool slopes) const;
  /// The errors of the rows: what each step lost, carried on by the steps after it.
  std::vector<double> row_errors(const std::vector<double>& losses, std::size_t count) const;
  /// Bounds for the square of the remainder of all cells of one level, and for its derivative by x.
  std::pair<double, double> square_bounds(const Remainder& rest, int level, bool slopes) const;

 private:
  void set_fit(std::size_t count);
  double remove_polynomial(double* x) const;
  void set_contraction();
  double worst_row(const std::vector<double>& coefficients, std::size_t count) const;
  double difference_bound(int level) const;
  double contraction_bound(int level) const;
  double geometric(double top, int level, int growth) const;
  std::vector<outward::VectorPolynomial> recentred(const std::vector<outward::VectorPolynomial>& pieces) const;
  std::vector<outward::VectorPolynomial> longer(const std::vector<outward::VectorPolynomial>& words,
                                                std::vector<outward::VectorPolynomial> pieces) const;
  std::pair<double, double> largest_differences(const std::vector<outward::VectorPolynomial>& words) const;
  double pairing(const double* row, double error) const;

  const CellSetup& setup_;
  std::size_t length_;  // of rows
  Transition<double> transition_;
  std::vector<outward::Recentring> recentring_;  // one for each digit
  std::size_t moments_ = 0;                      // epsilon is orthogonal to the polynomials of lower degree
  std::vector<double> position_;                 // of the integers of the window in [-1, 1]
  std::vector<double> fit_;                      // moments x width: coefficients of a fitted polynomial in position_[k]
  std::vector<double> contraction_;              // contraction_[j] >= sup of ||P epsilon|| / ||epsilon||, P of j steps
};

}  // namespace subcert::cells
