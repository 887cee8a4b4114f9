#include "parametric_mask.hpp"

#include "matrix_masks.hpp"
#include "polynomial_data.hpp"

#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>
#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/polynomials/real_roots.hpp>
#include <subcert/analysis/symbol/polynomials/root_cycles.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <set>

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

std::size_t place_of(const std::vector<long>& exponents, const std::vector<std::size_t>& sizes) {
  std::size_t place = 0;
  for (std::size_t v = sizes.size(); v-- > 0;) place = place * sizes[v] + static_cast<std::size_t>(exponents[v]);
  return place;
}

std::vector<long> exponents_at(std::size_t place, const std::vector<std::size_t>& sizes) {
  std::vector<long> exponents;
  for (const std::size_t size : sizes) {
    exponents.push_back(static_cast<long>(place % size));
    place /= size;
  }
  return exponents;
}

void raise(std::vector<std::size_t>& sizes, const std::vector<long>& exponents) {
  for (std::size_t v = 0; v < sizes.size(); ++v)
    sizes[v] = std::max(sizes[v], static_cast<std::size_t>(exponents[v] + 1));
}

/// Zeros.
template <class T>
Powers<T> powers_for(const std::vector<std::size_t>& sizes) {
  std::size_t count = 1;
  for (const std::size_t size : sizes) count *= size;
  return {sizes, std::vector<T>(count)};
}

/// Without the highest powers of a letter that are zero for all others. Errors: throws Error where all are zero.
Powers<LaurentPolynomial> without_zeros(const Powers<LaurentPolynomial>& powers) {
  std::vector<std::size_t> sizes(powers.sizes.size(), 0);
  for (std::size_t at = 0; at < powers.entries.size(); ++at)
    if (!powers.entries[at].is_zero()) raise(sizes, exponents_at(at, powers.sizes));
  require(!sizes.empty() && sizes.front() > 0, "mask: need a symbol that is not zero, got zero");
  auto result = powers_for<LaurentPolynomial>(sizes);
  for (std::size_t at = 0; at < result.entries.size(); ++at)
    result.entries[at] = powers.entries[place_of(exponents_at(at, sizes), powers.sizes)];
  return result;
}

std::vector<Monomial> terms_of(const MultivariatePolynomial& p) { return p.terms(); }
std::vector<Monomial> terms_of(const LaurentPolynomial& p) {
  std::vector<Monomial> terms;
  for (const Rational& c : p.coefficients()) terms.push_back({c, {p.lowest() + static_cast<long>(terms.size())}});
  return terms;
}

/// Over their common denominator.
template <class Polynomial>
ParametricMask mask_of(const std::vector<QuotientOf<Polynomial>>& coefficients, long first, int arity,
                       std::size_t components = 1) {
  Polynomial common = constant_like(coefficients.front().numerator(), 1);
  for (const auto& c : coefficients) common *= QuotientOf<Polynomial>(common, c.denominator()).denominator();
  const std::vector<Monomial> below = terms_of(common);
  std::vector<std::vector<Monomial>> numerators;
  std::vector<std::size_t> sizes(below.front().exponents.size(), 1), sizes_below = sizes;
  for (const auto& c : coefficients) {
    numerators.push_back(terms_of((c * common).numerator()));
    for (const Monomial& term : numerators.back()) raise(sizes, term.exponents);
  }
  auto powers = powers_for<LaurentPolynomial>(sizes);
  first *= static_cast<long>(components * components);
  for (const std::vector<Monomial>& terms : numerators) {
    for (const Monomial& term : terms)
      powers.entries[place_of(term.exponents, sizes)] += LaurentPolynomial::monomial(term.coefficient, first);
    ++first;
  }
  for (const Monomial& term : below) raise(sizes_below, term.exponents);
  auto denominator = powers_for<Rational>(sizes_below);
  for (const Monomial& term : below) denominator.entries[place_of(term.exponents, sizes_below)] = term.coefficient;
  return {std::move(powers), arity, std::move(denominator), components};
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

Powers<Rational> in_powers(const LaurentPolynomial& p, std::size_t least) {
  Powers<Rational> result{{p.is_zero() ? least : std::max(least, static_cast<std::size_t>(p.highest()) + 1)}, {}};
  for (std::size_t k = 0; k < result.sizes.front(); ++k) result.entries.push_back(p.coefficient(static_cast<long>(k)));
  return result;
}

LaurentPolynomial in_one_letter(const Powers<Rational>& powers) {
  require(powers.sizes.size() == 1, "need a polynomial in one letter, got {} letters", powers.sizes.size());
  return {powers.entries, 0};
}

ParametricMask::ParametricMask(Powers<LaurentPolynomial> powers, int arity, Powers<Rational> denominator,
                               std::size_t components)
    : powers_(without_zeros(powers)), denominator_(std::move(denominator)), arity_(arity), components_(components) {
  require(arity >= 2, "mask: need arity >= 2, got {}", arity);
}

ParametricMask::ParametricMask(const std::vector<LaurentPolynomial>& powers, int arity,
                               const LaurentPolynomial& denominator)
    : ParametricMask({{powers.size()}, powers}, arity, in_powers(denominator)) {}

ParametricMask::ParametricMask(const std::vector<RationalFunction>& coefficients, long first, int arity)
    : ParametricMask(mask_of(coefficients, first, arity)) {}

ParametricMask::ParametricMask(const std::vector<LetterFunction>& coefficients, long first, int arity,
                               std::size_t components)
    : ParametricMask(mask_of(coefficients, first, arity, components)) {}

std::vector<std::size_t> ParametricMask::sizes() const {
  std::vector<std::size_t> result;
  for (std::size_t v = 0; v < letters(); ++v) result.push_back(std::max(powers_.sizes[v], denominator_.sizes[v]));
  return result;
}

int ParametricMask::degree() const { return static_cast<int>(sizes().front()) - 1; }

IndexRange ParametricMask::support() const {
  const auto [first, last] = range_of(powers());
  const auto block = static_cast<long>(components_ * components_);
  return {floor_divide(first, block), floor_divide(last, block)};
}

LaurentPolynomial ParametricMask::coefficient(long index) const {
  require(letters() == 1, "mask: need one letter, got {}", letters());
  return in_parameter(powers(), index);
}

LaurentPolynomial ParametricMask::entries_at(const Values& values) const {
  const Rational below = value_at(denominator_, values);
  require(below != 0, "mask: need a value where the denominator is not zero, got {}", fmt::join(values, ", "));
  return LaurentPolynomial(1 / below) * numerator_at(values);
}

Mask ParametricMask::at(const Values& values) const {
  require(components_ == 1, "mask: need coefficients that are numbers, got matrices");
  return {entries_at(values), arity_};
}

std::vector<LatticeMask::Term> ParametricMask::terms_of(const LaurentPolynomial& entries) const {
  const auto rows = static_cast<long>(components_);
  std::vector<LatticeMask::Term> terms;
  for (long k = 0; k < entries.length(); ++k) {
    const long at = entries.lowest() + k;
    terms.push_back({{floor_divide(at, rows * rows)},
                     static_cast<std::size_t>(modulo(at, rows * rows) / rows),
                     static_cast<std::size_t>(modulo(at, rows)),
                     entries.coefficient(at)});
  }
  return terms;
}

LatticeMask ParametricMask::lattice_mask_at(const Values& values) const {
  if (components_ == 1) return at(values);
  return matrix_mask(terms_of(entries_at(values)), components_, Dilation::multiple(1, arity_));
}

std::optional<std::vector<LaurentPolynomial>> ParametricMask::controls(const Box& box) const {
  const Powers<Rational> below = bernstein(denominator_, box, sizes());
  const Rational& first = below.entries.front();
  if (std::ranges::any_of(below.entries, [&](const Rational& q) { return q * first <= 0; })) return std::nullopt;
  std::vector<LaurentPolynomial> result = bernstein(powers_, box, sizes()).entries;
  for (std::size_t i = 0; i < result.size(); ++i) result[i] *= LaurentPolynomial(1 / below.entries[i]);
  return result;
}

std::string ParametricMask::to_text(char letter) const {
  const IndexRange range = support();
  const auto rows = static_cast<long>(components_), block = rows * rows;
  const auto list = [](long count, const auto& entry) {
    std::string text;
    for (long i = 0; i < count; ++i) text += (i > 0 ? "," : "[") + entry(i);
    return text + "]";
  };
  const auto entry = [&](long power) { return RationalFunction(in_parameter(powers(), power)).to_text(letter); };
  std::string text = list(range.last - range.first + 1, [&](long k) {
    const long at = block * (range.first + k);
    if (rows == 1) return entry(at);
    return list(rows, [&](long i) { return list(rows, [&](long j) { return entry(at + rows * i + j); }); });
  });
  if (const LaurentPolynomial q = denominator(); !(q == LaurentPolynomial(1)))
    text += "/(" + RationalFunction(q).to_text(letter) + ")";
  return fmt::format("{}@{}", text, range.first);
}

ParametricMask transposed(const ParametricMask& mask) {
  const auto rows = static_cast<long>(mask.components()), block = rows * rows;
  return mask.mapped([=](const LaurentPolynomial& power) {
    LaurentPolynomial result;
    for (long k = 0; k < power.length(); ++k) {
      const long at = power.lowest() + k, inside = modulo(at, block);
      result += LaurentPolynomial::monomial(power.coefficient(at),
                                            at - inside + rows * (inside % rows) + inside / rows);
    }
    return result;
  });
}

ParametricMask without_letters(const LatticeMask& mask) {
  const auto rows = static_cast<long>(mask.components());
  LaurentPolynomial entries;
  for (const LatticeMask::Term& term : mask.terms())
    entries += LaurentPolynomial::monomial(
        term.coefficient,
        (term.exponents[0] * rows + static_cast<long>(term.row)) * rows + static_cast<long>(term.column));
  return {Powers<LaurentPolynomial>{{1}, {std::move(entries)}}, mask.arity(), Powers<Rational>{{1}, {1}},
          mask.components()};
}

int sum_rules(const ParametricMask& mask) {
  if (mask.components() > 1) return static_cast<int>(kept_polynomials(mask).data.size());
  int rules = std::numeric_limits<int>::max();
  for (const LaurentPolynomial& power : mask.powers())
    if (!power.is_zero()) rules = std::min(rules, power.multiplicity(LaurentPolynomial::all_ones(mask.arity())));
  return rules;
}

ParametricMask divided_difference_scheme(const ParametricMask& mask, int order) {
  const LaurentPolynomial sums = LaurentPolynomial::all_ones(mask.arity()).pow(order);
  return mask.mapped([&](const LaurentPolynomial& power) {
    const auto quotient = power.is_zero() ? power : power.exact_quotient(sums);
    require(quotient.has_value(), "divided_difference_scheme: need an order up to the number of sum rules, got {}",
            order);
    return LaurentPolynomial(subcert::power(Rational(mask.arity()), order)) * *quotient;
  });
}

LaurentPolynomial special_values(const ParametricMask& mask) {
  if (mask.components() > 1) return 1;
  return values_of_divisibility(divided_difference_scheme(mask, sum_rules(mask)),
                                LaurentPolynomial::all_ones(mask.arity()));
}

namespace {

/// A polynomial that is 0 where the mask is 0 on a cycle of so many roots of unity of this order, times those of order
/// `arity`: as many factors of the resultant vanish there.
LaurentPolynomial values_of_cycle(const ParametricMask& mask, long order, long size, const Deadline& deadline) {
  LaurentPolynomial result = resultant_in_z({cyclotomic(mask.arity() * order)}, mask.powers(), deadline);
  for (long factors = size * totient(mask.arity()); factors > 1 && result.length() > 1 && !deadline.expired();
       --factors)
    result = gcd(result, result.derivative());
  return result;
}

/// Where the mask is 0 on a cycle of roots of unity, but perhaps not at all of their order, as it may be for irrational
/// values: zero where none was found.
LaurentPolynomial values_of_cycles(const ParametricMask& mask, const Deadline& deadline) {
  const long zeros = mask.support().last - mask.support().first - sum_rules(mask) * (mask.arity() - 1);
  const auto cycles = root_cycles(mask.arity(), zeros / (mask.arity() - 1));
  if (!cycles) return {};
  LaurentPolynomial result = 1;
  std::set<long> seen;
  for (const RootCycle& cycle : *cycles)
    if (cycle.size < totient(cycle.order) && seen.insert(cycle.order).second && !result.is_zero())
      result *= values_of_cycle(mask, cycle.order, cycle.size, deadline);
  return result;
}

}  // namespace

LaurentPolynomial unstable_values(const ParametricMask& mask, const Deadline& deadline) {
  if (mask.components() > 1) return {};
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
  if (!result.is_zero()) result *= values_of_cycles(mask, deadline);
  return result;
}

}  // namespace subcert
