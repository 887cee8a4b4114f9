#include "limit_of_levels.hpp"

#include <subcert/analysis/symbol/polynomials/real_roots.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <fmt/ranges.h>

namespace subcert {
namespace {

constexpr int most_multiples = 8;
constexpr int most_levels = 1000;  // until a recurrence is to be in the range

/// Coefficients of a polynomial in z, which are polynomials in v.
using InTwoLetters = std::vector<LaurentPolynomial>;

InTwoLetters coefficients_of(const ParametricMask& mask) {
  const IndexRange range = mask.support();
  InTwoLetters result;
  for (long k = range.first; k <= range.last; ++k) result.push_back(mask.coefficient(k));
  return result;
}

/// By 1 + middle z + z^2; nothing where it leaves a remainder.
std::optional<InTwoLetters> quotient(const InTwoLetters& p, const LaurentPolynomial& middle) {
  if (p.size() < 3) return std::nullopt;
  InTwoLetters result;
  for (std::size_t k = 0; k < p.size(); ++k) {
    LaurentPolynomial next = p[k];
    if (k >= 1) next -= middle * result[k - 1];
    if (k >= 2) next -= result[k - 2];
    result.push_back(std::move(next));
  }
  for (int last = 0; last < 2; ++last) {
    if (!result.back().is_zero()) return std::nullopt;
    result.pop_back();
  }
  return result;
}

bool has_no_zero(const LaurentPolynomial& p, const Interval& values) {
  return values.lower < values.upper ? has_no_real_root(p, values.lower, values.upper) : p(values.lower) != 0;
}

}  // namespace

int ExponentialSumRules::order() const {
  int result = sum_rules;
  for (const int power : exponentials) result += 2 * power;
  return result;
}

std::string to_text(const ExponentialSumRules& rules) {
  std::vector<std::string> parts;
  for (int i = 0; i < rules.sum_rules; ++i) parts.push_back(i == 0 ? "1" : i == 1 ? "x" : fmt::format("x^{}", i));
  for (std::size_t j = 0; j < rules.exponentials.size(); ++j)
    for (int i = 0; i < rules.exponentials[j]; ++i)
      parts.push_back(fmt::format("{}e^(+-{}tx)",
                                  i == 0   ? ""
                                  : i == 1 ? "x "
                                           : fmt::format("x^{} ", i),
                                  j == 0 ? "" : std::to_string(j + 1)));
  return fmt::format("{}", fmt::join(parts, ", "));
}

ExponentialSumRules exponential_sum_rules(const ParametricMask& mask) {
  require(mask.letters() == 1 && mask.components() == 1 && mask.arity() == 2,
          "exponential_sum_rules: need numbers with one letter, arity 2");
  ExponentialSumRules result{sum_rules(mask)};
  InTwoLetters rest = coefficients_of(divided_difference_scheme(mask, result.sum_rules));
  const LaurentPolynomial twice = LaurentPolynomial::monomial(2, 1);
  LaurentPolynomial before = 1, chebyshev = LaurentPolynomial::monomial(1, 1);
  for (int j = 1; j <= most_multiples; ++j) {
    result.exponentials.push_back(0);
    while (auto next = quotient(rest, LaurentPolynomial(2) * chebyshev)) {
      rest = std::move(*next);
      ++result.exponentials.back();
    }
    before = std::exchange(chebyshev, twice * chebyshev - before);
  }
  while (!result.exponentials.empty() && result.exponentials.back() == 0) result.exponentials.pop_back();
  return result;
}

std::optional<LimitOfLevels> limit_of_levels(const ParametricMask& mask, const Recurrence& recurrence,
                                             const Interval& kept, const Budget& budget) {
  auto limit = recurrence.limit_in(kept);
  if (!limit || !has_no_zero(mask.denominator(), kept)) return std::nullopt;
  ExponentialSumRules rules{sum_rules(mask)};
  if (mask.arity() == 2 && recurrence.halves_angles()) rules = exponential_sum_rules(mask);
  MaskList one{{mask.at(limit->value)}};
  one.most_rules = rules.order();
  return LimitOfLevels{std::move(limit->value), std::move(limit->way), std::move(rules), exponent_of(one, budget)};
}

Truth FollowedLevels::have(const RangeProperty& property, Truth all_sequences) const {
  if (!way) return Truth::unknown;
  const bool in_limit = limit && holds(limit->exponent.exponent, property) == Truth::yes;
  return all_sequences == Truth::yes || in_limit ? Truth::yes : Truth::unknown;
}

std::optional<int> FollowedLevels::first_level() const {
  return way && !start.unbounded ? std::optional(static_cast<int>(way->size())) : std::nullopt;
}

FollowedLevels follow(const ParametricMask& mask, const Recurrence& recurrence, const FirstValues& start,
                      const Interval& kept, const Budget& budget) {
  FollowedLevels result{start, recurrence};
  result.way = recurrence.way_into(kept, start, most_levels);
  if (!result.way) return result;
  const Interval first{start.values.lower, start.unbounded ? kept.upper : start.values.upper};
  result.masks_exist = masks_exist(mask, recurrence, first, static_cast<int>(result.way->size())) &&
                       (!start.unbounded || has_no_real_root_from(mask.denominator(), kept.upper));
  if (mask.components() == 1) result.limit = limit_of_levels(mask, recurrence, kept, budget);
  return result;
}

bool masks_exist(const ParametricMask& mask, const Recurrence& recurrence, const Interval& start, int levels) {
  const LaurentPolynomial below = mask.denominator();
  std::optional<Interval> values = start;
  for (int level = 0; level < levels; ++level) {
    if (!values || !has_no_zero(below, *values)) return false;
    values = recurrence.image(*values);
  }
  return true;
}

}  // namespace subcert
