#include "letter_polynomials.hpp"

#include <subcert/analysis/symbol/polynomials/complex_roots.hpp>

namespace subcert::vertex {

LetterRing::Number LetterRing::number(const LaurentPolynomial& weight) const {
  if (weight.is_zero()) return Number(letters_);
  std::vector<Monomial> terms;
  for (long k = weight.lowest(); k <= weight.highest(); ++k) {
    if (weight.coefficient(k) == 0) continue;
    std::vector<long> exponents = letter_exponents(k, static_cast<std::size_t>(letters_ - letter_share));
    exponents.insert(exponents.begin() + letter_w, 0);
    terms.push_back({weight.coefficient(k), exponents});
  }
  return {letters_, terms};
}

LetterPolynomial::LetterPolynomial(std::vector<MultivariatePolynomial> coefficients)
    : coefficients_(std::move(coefficients)), terms_(terms_of(coefficients_)) {
  for (int letter = 0; letter < coefficients_.front().variables(); ++letter) {
    std::vector<MultivariatePolynomial> derivative;
    for (const MultivariatePolynomial& p : coefficients_) derivative.push_back(p.derivative(letter));
    derivatives_.push_back(terms_of(derivative));
  }
}

LetterPolynomial::Terms LetterPolynomial::terms_of(const std::vector<MultivariatePolynomial>& coefficients) {
  Terms result;
  for (const MultivariatePolynomial& p : coefficients) result.push_back(p.terms());
  return result;
}

std::vector<Ball> LetterPolynomial::values(const Terms& terms, const Letters& at) {
  const slong bits = at[0].bits();
  std::vector<Ball> result;
  for (const std::vector<Monomial>& coefficient : terms) {
    Ball sum(0, bits);
    for (const Monomial& term : coefficient) {
      Ball product(term.coefficient, bits);
      for (std::size_t v = 0; v < at.size(); ++v)
        if (term.exponents[v] != 0) product *= at[v].pow(term.exponents[v]);
      sum += product;
    }
    result.push_back(std::move(sum));
  }
  return result;
}

std::vector<Ball> LetterPolynomial::at(const Letters& at) const { return values(terms_, at); }

std::vector<Ball> LetterPolynomial::derivative_at(const Letters& at, Letter by) const {
  return values(derivatives_[by], at);
}

bool LetterPolynomial::equals_with_w_as_c(const LetterPolynomial& other) const {
  std::vector<MultivariatePolynomial> result;
  for (const std::vector<Monomial>& coefficient : terms_) {
    std::vector<Monomial> moved = coefficient;
    for (Monomial& term : moved) {
      term.exponents[letter_c] += term.exponents[letter_w];
      term.exponents[letter_w] = 0;
    }
    result.emplace_back(coefficients_.front().variables(), moved);
  }
  return result == other.coefficients_;
}

LaurentPolynomial LetterPolynomial::limit() const {
  std::vector<Rational> values;
  for (const std::vector<Monomial>& coefficient : terms_) {
    Rational& sum = values.emplace_back(0);
    for (const Monomial& term : coefficient)
      if (term.exponents[letter_share] == 0) sum += term.coefficient;
  }
  return {values, 0};
}

std::optional<LetterPolynomial> LetterPolynomial::without_one() const {
  MultivariatePolynomial carry(coefficients_.front().variables());
  std::vector<MultivariatePolynomial> quotient(degree(), carry);
  for (std::size_t i = degree() + 1; i-- > 0;) {
    carry += coefficients_[i];
    if (i > 0) quotient[i - 1] = carry;
  }
  return carry.is_zero() ? std::optional(LetterPolynomial(std::move(quotient))) : std::nullopt;
}

Ball value_at(const std::vector<Ball>& p, const Ball& x) {
  Ball value(0, x.bits());
  for (std::size_t i = p.size(); i-- > 0;) value = value * x + p[i];
  return value;
}

Ball derivative_at(const std::vector<Ball>& p, const Ball& x) {
  Ball value(0, x.bits());
  for (std::size_t i = p.size(); i-- > 1;) value = value * x + p[i] * static_cast<long>(i);
  return value;
}

std::optional<Ball> zero_near(const std::vector<Ball>& p, const Ball& start) {
  const slong bits = start.bits();
  const Ball step = value_at(p, start) / derivative_at(p, start);
  Ball radius = abs(step).upper_end() + Ball(Rational(1) / power(Rational(2), static_cast<int>(bits / 2)), bits);
  for (int attempt = 0; attempt < 4 && radius.is_finite(); ++attempt) {
    radius = radius * 2;
    const Ball inside = start.widened(radius);
    const Ball next = start - value_at(p, start) / derivative_at(p, inside);
    if (next.is_finite() && arb_contains(inside.get(), next.get())) return next;
  }
  return std::nullopt;
}

std::optional<Ball> leading_zero(const std::vector<Ball>& p) {
  const auto zeros = complex_roots(p);
  if (!zeros || zeros->empty()) return std::nullopt;
  const ComplexBall* best = &zeros->front();
  for (const ComplexBall& zero : *zeros)
    if (abs(*best).is_less(abs(zero))) best = &zero;
  const Ball result(Rational(best->real().middle()), best->bits());
  return Ball(0, best->bits()).is_less(result) ? std::optional(result) : std::nullopt;
}

std::vector<Ball> deflated(const std::vector<Ball>& p, const Ball& zero) {
  std::vector<Ball> quotient(p.size() - 1, Ball(0, zero.bits()));
  Ball carry(0, zero.bits());
  for (std::size_t i = p.size(); i-- > 1;) quotient[i - 1] = carry = carry * zero + p[i];
  return quotient;
}

bool has_zeros_below(std::vector<Ball> p, const Ball& radius) {
  Ball scale(1, radius.bits());
  for (Ball& coefficient : p) {
    coefficient *= scale;
    scale *= radius;
  }
  // In the unit disc: |p_0| < |p_d|, and (p_d p - p_0 p*)/x, p* with the coefficients in reverse, has its zeros there.
  while (p.size() > 1) {
    const Ball &first = p.front(), &last = p.back();
    if (!abs(first).is_less(abs(last))) return false;
    std::vector<Ball> next;
    const Ball ratio = first / last;
    for (std::size_t i = 1; i < p.size(); ++i) next.push_back(p[i] - ratio * p[p.size() - 1 - i]);
    p = std::move(next);
  }
  return true;
}

}  // namespace subcert::vertex
