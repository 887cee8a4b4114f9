#pragma once
/// Rules that fit polynomials and are linear on polyhedral cells of their data, also with several fits to one
/// datum.

#include <subcert/analysis/symbol/masks/mask.hpp>
#include <subcert/analysis/symbol/numbers/numbers.hpp>
#include <subcert/analysis/symbol/support/budget.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace subcert::piecewise {

/// A linear form; coordinates beyond its end are zero.
using Row = std::vector<Rational>;

/// Domain: at least as many coordinates as the form has.
Rational value_at(const Row& form, const std::vector<Rational>& x);

/// One piece. Its variables are the data of the window and `own` further ones, which are free within the cell.
/// Residual r is datum r minus the value of the fit there; signs[r] = 1: it is >= 0, -1: <= 0, 0: it is zero on the
/// whole piece.
struct Piece {
  std::vector<int> signs;
  std::size_t own = 0;
  std::vector<Row> cell;     ///< signs[r] times residual r, >= 0; one for each sign that is not 0, in their order
  std::vector<Row> outputs;  ///< of the window: values of the fit, in the order of their places
};

/// Window i reads the data i, ..., i + points - 1, fits a polynomial of degree `degree` at most and gives its values at
/// `places` from the centre of the window, a of them, as a*i, ..., a*i + a - 1 of the next level. Whatever fit is taken
/// for whatever data lies in a piece, and all pieces whose signs are those of its residuals, but for places where a
/// residual or a sign is zero, have it too.
struct Rule {
  std::size_t points = 0;
  int degree = 0;
  std::vector<Piece> pieces;
  std::vector<Rational> places{Rational(-1, 4), Rational(1, 4)};

  int arity() const { return static_cast<int>(places.size()); }
  /// Whether each datum has one answer: no piece has variables of its own. Such a rule is continuous.
  bool is_function() const;
};

/// The largest sum of moduli of an output: the least Lipschitz constant of one step in the maximum norm. Domain: a
/// function with at least one piece.
Rational lipschitz_constant(const Rule& rule);

/// The largest modulus of an output where no datum exceeds 1, for whatever fits. Nothing past the deadline, or where a
/// program fails. Cost: two small linear programs for each piece.
std::optional<Rational> largest_output(const Rule& rule, const Deadline& deadline = {});

/// The mask of a rule whose pieces all have the same outputs. Indices as of `first`, the index of the first datum of
/// window 0: f'_i = sum of a_(i - arity j) f_j.
std::optional<Mask> linear_mask(const Rule& rule, long first);

}  // namespace subcert::piecewise
