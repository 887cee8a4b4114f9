#include "recurrence.hpp"

#include <subcert/analysis/symbol/masks/parametric_mask.hpp>
#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/polynomials/real_roots.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace subcert {
namespace {

constexpr int parts = 64;
constexpr int most_hulls = 12;
const Rational widest_value(1, Integer(1) << 100), largest_value(Integer(1) << 256);
constexpr int root_bits = 128, kept_bits = 256;

bool contains(const Interval& whole, const Interval& part) {
  return whole.contains(part.lower) && whole.contains(part.upper);
}

Interval hull(const Interval& a, const Interval& b) { return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)}; }

/// Of the quotient on an interval without zeros of the denominator, by the quotients of Bernstein coefficients.
std::optional<Interval> range_of(const RationalFunction& r, const Interval& w) {
  if (w.lower == w.upper) {
    if (r.denominator()(w.lower) == 0) return std::nullopt;
    return Interval::exactly(r(w.lower));
  }
  const Box box{{w.lower}, {w.upper}};
  const std::vector sizes{std::max(in_powers(r.numerator()).sizes[0], in_powers(r.denominator()).sizes[0])};
  const auto coefficients = [&](const LaurentPolynomial& p) {
    return bernstein(in_powers(p, sizes[0]), box, sizes).entries;
  };
  const Values numerators = coefficients(r.numerator()), denominators = coefficients(r.denominator());
  std::optional<Interval> result;
  for (std::size_t k = 0; k < sizes[0]; ++k) {
    if (denominators[k] == 0 || denominators[k].sign() != denominators[0].sign()) return std::nullopt;
    const Interval value = Interval::exactly(numerators[k] / denominators[k]);
    result = result ? hull(*result, value) : value;
  }
  return result;
}

/// Moved to a multiple of 2^-kept_bits, so that numbers do not grow from level to level.
Rational shortened(const Rational& x, Rounding rounding) {
  const Integer unit = Integer(1) << kept_bits;
  return denominator(x) <= unit ? x : to_multiple(x, Rational(1, unit), rounding);
}

/// The same ends, or if they are long multiples of 2^-20 beyond them.
Interval with_few_digits(const Interval& w) {
  const Integer unit = Integer(1) << 20;
  const auto end = [&](const Rational& x, Rounding rounding) {
    return denominator(x) <= unit ? x : to_multiple(x, Rational(1, unit), rounding);
  };
  return {end(w.lower, Rounding::down), end(w.upper, Rounding::up)};
}

/// Positive for all x >= low > 0.
bool is_positive_from(const LaurentPolynomial& p, const Rational& low) {
  return p(low) > 0 && has_no_real_root_from(p, low);
}

RationalFunction derivative(const RationalFunction& r) {
  const LaurentPolynomial &p = r.numerator(), &q = r.denominator();
  return {p.derivative() * q - p * q.derivative(), q * q};
}

/// That part of so many equal ones.
Interval part_of(const Interval& w, int number, int count) {
  const auto at = [&](int place) { return Rational(w.lower + w.width() * Rational(place, count)); };
  return {at(number), at(number + 1)};
}

int count_of_parts(const Interval& w) { return w.lower == w.upper ? 1 : parts; }

}  // namespace

Recurrence Recurrence::parse(std::string_view written, std::string_view name, char letter) {
  constexpr std::string_view root = "sqrt(";
  std::string without_blanks(written);
  std::erase(without_blanks, ' ');
  const std::string_view text = without_blanks;
  if (!text.starts_with(name) || text.substr(name.size(), 1) != "=")
    throw ParseError("recurrence", text, 1, fmt::format("{}=...", name));
  Recurrence result;
  result.text_ = text.substr(name.size() + 1);
  std::string right = result.text_;
  for (std::size_t at = 0; name.size() > 1 && (at = right.find(name, at)) != std::string::npos; ++at)
    right.replace(at, name.size(), 1, letter);
  result.is_root_ = right.starts_with(root) && right.ends_with(')');
  if (result.is_root_) right = right.substr(root.size(), right.size() - root.size() - 1);
  result.function_ = RationalFunction::parse(right, {&letter, 1});
  return result;
}

std::optional<Interval> Recurrence::image(const Interval& w) const {
  std::optional<Interval> result;
  const int count = count_of_parts(w);
  for (int k = 0; k < count; ++k) {
    auto part = range_of(function_, part_of(w, k, count));
    if (!part || (is_root_ && part->lower < 0)) return std::nullopt;
    if (is_root_)
      part = Interval{*root_enclosure(part->lower, 2, root_bits).lower,
                      *root_enclosure(part->upper, 2, root_bits).upper};
    result = result ? hull(*result, *part) : *part;
  }
  return Interval{shortened(result->lower, Rounding::down), shortened(result->upper, Rounding::up)};
}

std::vector<Interval> Recurrence::values(const Rational& start, std::size_t count) const {
  std::vector<Interval> result;
  std::optional<Interval> next = Interval::exactly(start);
  while (result.size() < count) {
    if (!next)
      fail(ErrorKind::domain, "recurrence: need a value for each level, got none after {}",
           to_decimal(result.back().upper, 12, Rounding::nearest));
    // What is known so badly, or has so many digits, only grows from level to level.
    if (next->width() > widest_value || abs(next->lower) > largest_value || abs(next->upper) > largest_value)
      fail(ErrorKind::undecided,
           "recurrence: need values below 2^256 that are known within 2^-100, got others at level {}", result.size());
    result.push_back(*next);
    next = image(*next);
  }
  return result;
}

std::optional<Interval> Recurrence::all_from(const Interval& w) const {
  const auto next = image(w);
  if (!next) return std::nullopt;
  Interval values = hull(w, *next);
  // To a limit from one side or from both; farther, if the values come nearer to it slowly.
  for (int round = 0; round < most_hulls; ++round) {
    const auto after = image(values);
    if (!after) return std::nullopt;
    if (contains(values, *after)) return values;
    const Rational more = round == 0 ? Rational(0) : values.width();
    const Interval wider = hull(values, *after);
    values = {wider.lower == values.lower ? values.lower : wider.lower - more,
              wider.upper == values.upper ? values.upper : wider.upper + more};
  }
  return std::nullopt;
}

std::optional<std::vector<Interval>> Recurrence::way_into(const Interval& kept, const FirstValues& start,
                                                          int most) const {
  const auto next = image(kept);
  if (!next || !contains(kept, *next)) return std::nullopt;
  Interval values = start.values;
  if (start.unbounded) {
    if (values.lower > kept.upper || !descends_to(kept)) return std::nullopt;
    values.upper = kept.upper;
  }
  std::vector<Interval> way;
  for (int level = 0; level <= most; ++level) {
    if (contains(kept, values)) return way;
    const auto image_of_values = image(values);
    if (!image_of_values) return std::nullopt;
    values = with_few_digits(*image_of_values);
    way.push_back(values);
  }
  return std::nullopt;
}

bool Recurrence::descends_to(const Interval& w) const {
  if (w.upper <= 0) return false;
  const Rational least = !is_root_     ? w.lower
                         : w.lower > 0 ? Rational(w.lower * w.lower)
                                       : Rational(0),
                 share(9, 10), sign = function_.denominator()(w.upper).sign();
  const LaurentPolynomial p = LaurentPolynomial(sign) * function_.numerator(),
                          q = LaurentPolynomial(sign) * function_.denominator(),
                          most = LaurentPolynomial::monomial(share, 1);
  return is_positive_from(q, w.upper) && is_positive_from(p - LaurentPolynomial(least) * q, w.upper) &&
         is_positive_from((is_root_ ? most * most : most) * q - p, w.upper);
}

std::string Recurrence::to_text(char letter) const {
  const LaurentPolynomial& q = function_.denominator();
  std::string text = fmt::format("{}[{}]", is_root_ ? "sqrt" : "",
                                 RationalFunction(function_.numerator()).to_text(letter));
  if (!(q == LaurentPolynomial(1))) text += fmt::format("/({})", RationalFunction(q).to_text(letter));
  return text;
}

bool Recurrence::contracts(const Interval& w) const {
  const RationalFunction slope = derivative(function_);
  const int count = count_of_parts(w);
  for (int k = 0; k < count; ++k) {
    const Interval part = part_of(w, k, count);
    const auto slopes = range_of(slope, part);
    if (!slopes) return false;
    const Rational steepest = std::max(abs(slopes->lower), abs(slopes->upper));
    // |sqrt(r)'| = |r'| / (2 sqrt(r))
    Rational least = 1;
    if (is_root_) {
      const auto values = range_of(function_, part);
      if (!values || values->lower <= 0) return false;
      least = 2 * *root_enclosure(values->lower, 2, root_bits).lower;
    }
    if (steepest >= least) return false;
  }
  return true;
}

std::optional<Rational> Recurrence::fixed_point_in(const Interval& w) const {
  const LaurentPolynomial &p = function_.numerator(), &q = function_.denominator(),
                          letter = LaurentPolynomial::monomial(1, 1);
  for (const PolynomialFactor& factor : irreducible_factors(p - (is_root_ ? letter * letter : letter) * q)) {
    const LaurentPolynomial& f = factor.polynomial;
    if (f.highest() != 1) continue;
    const Rational zero = -f.coefficient(0) / f.coefficient(1);
    if (w.contains(zero) && (!is_root_ || zero >= 0)) return zero;
  }
  return std::nullopt;
}

std::optional<LimitOfValues> Recurrence::limit_in(const Interval& kept) const {
  constexpr std::size_t most_steps = 64;
  Interval values = kept;
  std::vector<Interval> way;
  while (way.size() < most_steps) {
    const auto next = image(values);
    if (!next || !contains(values, *next)) return std::nullopt;
    if (contracts(values)) {
      const auto value = fixed_point_in(values);
      return value ? std::optional(LimitOfValues{*value, std::move(way)}) : std::nullopt;
    }
    values = *next;
    way.push_back(values);
  }
  return std::nullopt;
}

bool Recurrence::halves_angles() const {
  return is_root_ && function_ == RationalFunction({{Rational(1, 2), Rational(1, 2)}, 0});
}

}  // namespace subcert
