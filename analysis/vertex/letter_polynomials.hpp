#pragma once
/// Polynomials whose coefficients depend on the valence and on the frequency. Inner header.

#include <subcert/analysis/symbol/numbers/balls.hpp>
#include <subcert/analysis/symbol/polynomials/multivariate_polynomial.hpp>
#include "cosine_field.hpp"

#include <optional>
#include <vector>

namespace subcert::vertex {

/// The letters are c = cos(2 pi/n), w = cos(2 pi k/n), and 1/n or those of the weights.
enum Letter { letter_c, letter_w, letter_share };
using Letters = std::vector<Ball>;

/// Polynomials in the letters; in weights those from the third one on are powers of c, see letter_stride. One
/// frequency, `general`, has the cosine w: it stands for all that no rule names. Negative: none.
class LetterRing {
 public:
  using Number = MultivariatePolynomial;
  explicit LetterRing(long general, std::size_t of_weights = 1)
      : general_(general), letters_(static_cast<int>(of_weights) + letter_share) {}

  /// Domain: a polynomial, of degree below letter_stride in c.
  Number number(const LaurentPolynomial& weight) const;
  Number number(long value) const { return {letters_, Rational(value)}; }
  Number letter(Letter which) const { return Number::in_variable(letters_, which, LaurentPolynomial::monomial(1, 1)); }
  Number cosine(long k) const {
    return k == general_ ? letter(letter_w) : Number::in_variable(letters_, letter_c, chebyshev(k));
  }

 private:
  long general_;
  int letters_;
};

/// A polynomial in x, monic, with such coefficients, the lowest first.
class LetterPolynomial {
 public:
  explicit LetterPolynomial(std::vector<MultivariatePolynomial> coefficients);

  const std::vector<MultivariatePolynomial>& coefficients() const { return coefficients_; }
  std::size_t degree() const { return coefficients_.size() - 1; }
  /// Its coefficients for all letters in balls.
  std::vector<Ball> at(const Letters& at) const;
  /// Those of its derivative by a letter.
  std::vector<Ball> derivative_at(const Letters& at, Letter by) const;
  /// With c in the place of w.
  bool equals_with_w_as_c(const LetterPolynomial& other) const;
  /// In the limit n -> infinity of a polynomial without w: c = 1, 1/n = 0.
  LaurentPolynomial limit() const;
  /// Without the factor x - 1, where it has it for all letters.
  std::optional<LetterPolynomial> without_one() const;

 private:
  using Terms = std::vector<std::vector<Monomial>>;
  static Terms terms_of(const std::vector<MultivariatePolynomial>& coefficients);
  static std::vector<Ball> values(const Terms& terms, const Letters& at);

  std::vector<MultivariatePolynomial> coefficients_;
  Terms terms_;
  std::vector<Terms> derivatives_;
};

/// Of a polynomial with coefficients in balls, the lowest first.
Ball value_at(const std::vector<Ball>& p, const Ball& x);
Ball derivative_at(const std::vector<Ball>& p, const Ball& x);
/// A ball with one zero, real and simple, for all coefficients; nothing where Newton's operator proves none about the
/// start.
std::optional<Ball> zero_near(const std::vector<Ball>& p, const Ball& start);
/// An approximation of the real positive zero of largest modulus, where no zero has a larger one.
std::optional<Ball> leading_zero(const std::vector<Ball>& p);
/// p/(x - zero), of the zero that belongs to the coefficients.
std::vector<Ball> deflated(const std::vector<Ball>& p, const Ball& zero);
/// Whether all zeros are proved to have moduli below each radius in the ball. Domain: the last coefficient is not 0.
/// Cost: quadratic. Ref: [Sch18].
bool has_zeros_below(std::vector<Ball> p, const Ball& radius);

}  // namespace subcert::vertex
