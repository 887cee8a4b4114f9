#include "parametric_mask.hpp"

#include "error.hpp"
#include "rational_matrix.hpp"
#include "real_roots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace subcert {
namespace {

/// The polynomial whose zeros are the common ones; zero where all are zero.
LaurentPolynomial with_leading_factors(const std::vector<LaurentPolynomial>& polynomials) {
  LaurentPolynomial result;
  long power = std::numeric_limits<long>::max();
  for (const LaurentPolynomial& p : polynomials) {
    if (p.is_zero()) continue;
    power = std::min(power, p.lowest());
    result = gcd(result, p);
  }
  return result.is_zero() ? result : result.shifted(power);
}

/// sum over k of w^k p_k(exponent)
LaurentPolynomial in_parameter(const std::vector<LaurentPolynomial>& powers, long exponent) {
  std::vector<Rational> coefficients;
  for (const LaurentPolynomial& p : powers) coefficients.push_back(p.coefficient(exponent));
  return {coefficients, 0};
}

/// The polynomial in w that vanishes where the divisor divides the symbol. Domain: at least two terms, the lowest
/// exponent 0.
LaurentPolynomial values_of_divisibility(const ParametricMask& mask, const LaurentPolynomial& divisor) {
  const LaurentPolynomial first = LaurentPolynomial::monomial(1, mask.support().first);
  std::vector<LaurentPolynomial> remainders;
  for (const LaurentPolynomial& power : mask.powers()) {
    // Division begins at the lowest exponent: with z^first that is the same for all.
    const bool begins = power.coefficient(first.lowest()) != 0;
    LaurentPolynomial remainder = (begins ? power : power + first).divided_by(divisor).remainder;
    remainders.push_back(begins ? remainder : remainder - first);
  }
  std::vector<LaurentPolynomial> coefficients;
  for (long i = 0; i < divisor.highest(); ++i) coefficients.push_back(in_parameter(remainders, first.lowest() + i));
  return with_leading_factors(coefficients);
}

LaurentPolynomial at_parameter(const std::vector<LaurentPolynomial>& powers, const Rational& w) {
  LaurentPolynomial sum;
  Rational factor = 1;
  for (const LaurentPolynomial& p : powers) {
    sum += LaurentPolynomial(factor) * p;
    factor *= w;
  }
  return sum;
}

LaurentPolynomial common_denominator(const std::vector<RationalFunction>& coefficients) {
  LaurentPolynomial result = 1;
  for (const RationalFunction& c : coefficients) result *= RationalFunction(result, c.denominator()).denominator();
  return result;
}

std::vector<LaurentPolynomial> powers_of(const std::vector<RationalFunction>& coefficients,
                                         const LaurentPolynomial& denominator, long first) {
  std::vector<LaurentPolynomial> result;
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    const LaurentPolynomial c = (coefficients[k] * denominator).numerator();
    for (long i = 0; !c.is_zero() && i <= c.highest(); ++i) {
      const auto at = static_cast<std::size_t>(i);
      if (at >= result.size()) result.resize(at + 1);
      result[at] += LaurentPolynomial::monomial(c.coefficient(i), first + static_cast<long>(k));
    }
  }
  return result;
}

/// The range of exponents of all powers.
IndexRange range_of(const std::vector<LaurentPolynomial>& powers) {
  IndexRange range{std::numeric_limits<long>::max(), std::numeric_limits<long>::min()};
  for (const LaurentPolynomial& p : powers) {
    if (p.is_zero()) continue;
    range = {std::min(range.first, p.lowest()), std::max(range.last, p.highest())};
  }
  return range;
}

/// The resultant in z of two polynomials over Q[w], as a polynomial in w; a sign and powers of leading coefficients
/// apart, its zeros are the values of w at which they have a common zero, or lose degree together. Domain: neither
/// zero.
LaurentPolynomial resultant_in_z(const std::vector<LaurentPolynomial>& p, const std::vector<LaurentPolynomial>& q,
                                 const Deadline& deadline) {
  const IndexRange p_range = range_of(p), q_range = range_of(q);
  const long p_degree = p_range.last - p_range.first, q_degree = q_range.last - q_range.first;
  const auto in_w = static_cast<long>(std::max(p.size(), q.size())) - 1;
  const auto rows = static_cast<std::size_t>(p_degree + q_degree);
  const auto sylvester = [&](const Rational& w) {
    const LaurentPolynomial p_at = at_parameter(p, w), q_at = at_parameter(q, w);
    RationalMatrix result(rows, rows);
    for (long i = 0; i < q_degree; ++i)
      for (long j = 0; j <= p_degree; ++j)
        result(static_cast<std::size_t>(i), static_cast<std::size_t>(i + j)) = p_at.coefficient(p_range.last - j);
    for (long i = 0; i < p_degree; ++i)
      for (long j = 0; j <= q_degree; ++j)
        result(static_cast<std::size_t>(q_degree + i),
               static_cast<std::size_t>(i + j)) = q_at.coefficient(q_range.last - j);
    return result;
  };
  return determinant(sylvester, in_w * (p_degree + q_degree), deadline).value_or(LaurentPolynomial());
}

}  // namespace

ParametricMask::ParametricMask(std::vector<LaurentPolynomial> powers, int arity, LaurentPolynomial denominator)
    : powers_(std::move(powers)), denominator_(std::move(denominator)), arity_(arity) {
  while (!powers_.empty() && powers_.back().is_zero()) powers_.pop_back();
  require(!powers_.empty(), "mask: need a symbol that is not zero, got zero");
  require(arity >= 2, "mask: need arity >= 2, got {}", arity);
}

ParametricMask::ParametricMask(const std::vector<RationalFunction>& coefficients, long first, int arity)
    : ParametricMask(powers_of(coefficients, common_denominator(coefficients), first), arity,
                     common_denominator(coefficients)) {}

int ParametricMask::degree() const {
  return static_cast<int>(std::max(static_cast<long>(powers_.size()) - 1, denominator_.highest()));
}

IndexRange ParametricMask::support() const { return range_of(powers_); }

LaurentPolynomial ParametricMask::coefficient(long index) const { return in_parameter(powers_, index); }

Mask ParametricMask::at(const Rational& w) const {
  const Rational below = denominator_(w);
  require(below != 0, "mask: need a value where the denominator is not zero, got {}", w);
  return {LaurentPolynomial(1 / below) * at_parameter(powers_, w), arity_};
}

std::string ParametricMask::to_text(char letter) const {
  std::string text;
  const IndexRange range = support();
  for (long i = range.first; i <= range.last; ++i) {
    text += (text.empty() ? "[" : ",") + RationalFunction(coefficient(i)).to_text(letter);
  }
  text += ']';
  if (!(denominator_ == LaurentPolynomial(1))) text += "/(" + RationalFunction(denominator_).to_text(letter) + ")";
  return fmt::format("{}@{}", text, range.first);
}

Mask BiparametricMask::at(const Rational& v, const Rational& w) const {
  LaurentPolynomial sum;
  const std::vector<LaurentPolynomial>& powers = flat.powers();
  for (std::size_t k = 0; k < powers.size(); ++k) {
    const auto place = static_cast<long>(k);
    sum += LaurentPolynomial(power(v, place % columns) * power(w, place / columns)) * powers[k];
  }
  return {sum, flat.arity()};
}

int sum_rules(const ParametricMask& mask) {
  int rules = std::numeric_limits<int>::max();
  for (const LaurentPolynomial& power : mask.powers())
    if (!power.is_zero()) rules = std::min(rules, power.multiplicity(LaurentPolynomial::all_ones(mask.arity())));
  return rules;
}

ParametricMask divided_difference_scheme(const ParametricMask& mask, int order) {
  const LaurentPolynomial sums = LaurentPolynomial::all_ones(mask.arity()).pow(order);
  std::vector<LaurentPolynomial> powers;
  for (const LaurentPolynomial& power : mask.powers()) {
    const auto quotient = power.is_zero() ? power : power.exact_quotient(sums);
    require(quotient.has_value(), "divided_difference_scheme: need an order up to the number of sum rules, got {}",
            order);
    powers.push_back(LaurentPolynomial(subcert::power(Rational(mask.arity()), order)) * *quotient);
  }
  return {std::move(powers), mask.arity(), mask.denominator()};
}

LaurentPolynomial special_values(const ParametricMask& mask) {
  return values_of_divisibility(divided_difference_scheme(mask, sum_rules(mask)),
                                LaurentPolynomial::all_ones(mask.arity()));
}

LaurentPolynomial unstable_values(const ParametricMask& mask, const Deadline& deadline) {
  const int arity = mask.arity();
  // All parts share the zeros that they all have with any sum of them.
  std::vector<std::vector<LaurentPolynomial>> parts;
  for (long residue = 0; residue < arity; ++residue) {
    std::vector<LaurentPolynomial> part;
    for (const LaurentPolynomial& power : mask.powers()) part.push_back(power.coset(arity, residue));
    if (range_of(part).last < range_of(part).first) continue;
    parts.push_back(std::move(part));
  }
  std::sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) {
    const IndexRange x = range_of(a), y = range_of(b);
    return x.last - x.first < y.last - y.first;
  });
  LaurentPolynomial result;
  if (parts.size() == 1) {
    const IndexRange range = range_of(parts[0]);
    if (range.first == range.last) result = in_parameter(parts[0], range.first);
  } else {
    std::vector<LaurentPolynomial> sum(mask.powers().size());
    for (std::size_t j = 1; j < parts.size(); ++j)
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += LaurentPolynomial(static_cast<int>(j * j)) * parts[j][k];
    if (range_of(sum).first <= range_of(sum).last) result = resultant_in_z(parts[0], sum, deadline);
  }
  const long degree = mask.support().last - mask.support().first;
  for (long k = 2; !result.is_zero() && arity * k <= 7 * degree; ++k) {
    if (std::gcd(k, static_cast<long>(arity)) != 1 || totient(arity * k) > degree) continue;
    const LaurentPolynomial values = values_of_divisibility(mask, cyclotomic(arity * k));
    result *= values;
  }
  return result;
}

}  // namespace subcert
