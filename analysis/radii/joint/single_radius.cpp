#include "single_radius.hpp"

#include <subcert/analysis/symbol/polynomials/real_roots.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/transition/transition.hpp>

#include <algorithm>

namespace subcert {
namespace {

constexpr int radius_bits = 192;
constexpr long most_central = 401;    // coefficients about the centre
constexpr long most_for_sturm = 100;  // degree of the cosine polynomial

/// Whether p(matrix) is 0 on the first unit vector.
bool annihilates(const LaurentPolynomial& p, const RationalMatrix& matrix) {
  std::vector<Rational> value(matrix.rows());
  for (long k = p.highest(); k >= 0; --k) {
    value = matrix * value;
    value[0] += p.coefficient(k);
  }
  return std::all_of(value.begin(), value.end(), [](const Rational& x) { return x == 0; });
}

}  // namespace

CoefficientGrowth central_growth(const LaurentPolynomial& symbol, int arity) {
  require(!symbol.is_zero() && symbol.reversed() == symbol, "central_growth: need b(z) = b(1/z), not zero, got {}",
          symbol.to_text());
  if (symbol.highest() / (arity - 1) >= most_central)
    fail(ErrorKind::size, "central_growth: need at most {} central coefficients", most_central);
  const RationalMatrix matrix = central_matrix(symbol, arity);
  RationalMatrix minor(matrix.rows() - 1, matrix.columns() - 1);
  for (std::size_t i = 0; i < minor.rows(); ++i)
    for (std::size_t j = 0; j < minor.columns(); ++j) minor(i, j) = matrix(i + 1, j + 1);
  // The generating function of the (C^n)_{00} is det(x - minor) / det(x - C) at x = 1/z, times x.
  const LaurentPolynomial denominator = characteristic_polynomial(matrix);
  const LaurentPolynomial common = minor.rows() == 0 ? LaurentPolynomial(1)
                                                     : gcd(denominator, characteristic_polynomial(minor));
  const LaurentPolynomial poles = denominator.divided_by(common).quotient;
  const auto pole = largest_real_root(poles, radius_bits);
  require(pole && *pole->value.lower > 0, "central_growth: need a symbol that is non-negative on the unit circle");
  const LaurentPolynomial recurrence = annihilates(poles, matrix) ? poles : denominator;
  return {pole->value, pole->multiplicity - 1, recurrence * LaurentPolynomial(Rational(recurrence.denominator()))};
}

SingleRadius single_spectral_radius(const Mask& mask) {
  const SymmetryReport report = symmetry(mask);
  if (report.kind == Symmetry::none) return {{Truth::no, "the difference mask is not symmetric"}, {}, 0};
  if (report.kind == Symmetry::even)
    return {{Truth::no, "the difference mask has an even number of coefficients"}, {}, 0};
  const LaurentPolynomial centred = mask.symbol().shifted(-(mask.symbol().lowest() + mask.symbol().highest()) / 2);
  if (centred.highest() > most_for_sturm) return {{Truth::unknown, "the difference mask is too long"}, {}, 0};
  if (!(centred(1) > 0) || !is_nonnegative_on_unit_circle(centred))
    return {{Truth::no, "the cosine polynomial of the difference mask takes negative values"}, {}, 0};
  const int letter = static_cast<int>(centred.highest() % (mask.arity() - 1));
  return {{Truth::yes, "the cosine polynomial of the difference mask is non-negative"},
          central_growth(centred, mask.arity()),
          letter,
          centred};
}

}  // namespace subcert
