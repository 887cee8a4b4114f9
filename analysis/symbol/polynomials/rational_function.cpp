#include "rational_function.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include "expression.hpp"
#include "term_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace subcert {
namespace {

constexpr long max_degree = 64, max_degree_of_several = 24;

/// What has to be multiplied to both, so that there are no negative powers, nor a letter in all terms.
long shift_of(const LaurentPolynomial& p, const LaurentPolynomial& q) { return -std::min(p.lowest(), q.lowest()); }
MultivariatePolynomial::Exponents shift_of(const MultivariatePolynomial& p, const MultivariatePolynomial& q) {
  MultivariatePolynomial::Exponents shift = p.lowest();
  for (std::size_t v = 0; v < shift.size(); ++v) shift[v] = -std::min(shift[v], q.lowest()[v]);
  return shift;
}

std::vector<Rational> coefficients_of(const LaurentPolynomial& p) { return p.coefficients(); }
std::vector<Rational> coefficients_of(const MultivariatePolynomial& p) {
  std::vector<Rational> result;
  for (const Monomial& term : p.terms()) result.push_back(term.coefficient);
  std::ranges::reverse(result);
  return result;
}

/// What makes a denominator canonical.
Rational unit_of(const std::vector<Rational>& coefficients) {
  Integer content = 0, common = 1;
  for (const Rational& c : coefficients) common = lcm(common, denominator(c));
  for (const Rational& c : coefficients) content = gcd(content, numerator(Rational(c * common)));
  const Rational unit(common, content);
  return coefficients.front() < 0 ? Rational(-unit) : unit;
}

/// p and q without what both have in common.
template <class Polynomial>
std::pair<Polynomial, Polynomial> reduced(Polynomial p, Polynomial q) {
  if (p.is_zero()) {
    Polynomial one = constant_like(p, 1);
    return {std::move(p), std::move(one)};
  }
  // The gcd leaves out powers of letters.
  const auto shift = shift_of(p, q);
  p = p.shifted(shift);
  q = q.shifted(shift);
  if (coefficients_of(q).size() > 1) {
    const Polynomial common = gcd(p, q);
    p = *p.exact_quotient(common);
    q = *q.exact_quotient(common);
  }
  const Polynomial unit = constant_like(q, unit_of(coefficients_of(q)));
  return {std::move(p) * unit, std::move(q) * unit};
}

std::string printed(const LaurentPolynomial& p, std::string_view letters) { return to_text(p, letters.front()); }
std::string printed(const MultivariatePolynomial& p, std::string_view letters) {
  std::vector<std::string> names;
  for (const char letter : letters) names.emplace_back(1, letter);
  return text::print_terms(p.terms(), text::Style::plain, names);
}

}  // namespace

template <class Polynomial>
QuotientOf<Polynomial>::QuotientOf(Polynomial numerator, Polynomial denominator)
    : numerator_(std::move(numerator)), denominator_(std::move(denominator)) {
  require(!denominator_.is_zero(), "rational function: need a denominator that is not zero, got zero");
  std::tie(numerator_, denominator_) = reduced(std::move(numerator_), std::move(denominator_));
}

template <>
LetterFunction LetterFunction::parse(std::string_view text, std::string_view letters) {
  return read_expression(text, letters, letters.size() == 1 ? max_degree : max_degree_of_several);
}
template <>
RationalFunction RationalFunction::parse(std::string_view text, std::string_view letters) {
  const LetterFunction function = LetterFunction::parse(text, letters);
  return {in_one_letter(function.numerator()), in_one_letter(function.denominator())};
}

template <class Polynomial>
Rational QuotientOf<Polynomial>::operator()(
    const Rational& w) const requires std::same_as<Polynomial, LaurentPolynomial> {
  const Rational below = denominator_(w);
  require(below != 0, "rational function: need a value where the denominator is not zero, got {}", w);
  return numerator_(w) / below;
}

template <class Polynomial>
std::string QuotientOf<Polynomial>::to_text(std::string_view letters) const {
  std::string above = printed(numerator_, letters), below = printed(denominator_, letters);
  std::erase(above, ' ');
  std::erase(below, ' ');
  if (is_polynomial()) return above;
  return fmt::format("{}/({})", coefficients_of(numerator_).size() > 1 ? "(" + above + ")" : above, below);
}

template class QuotientOf<LaurentPolynomial>;
template class QuotientOf<MultivariatePolynomial>;

std::string to_text(const LaurentPolynomial& polynomial, char letter) {
  std::string text = polynomial.to_text();
  std::replace(text.begin(), text.end(), 'z', letter);
  return text;
}

}  // namespace subcert
