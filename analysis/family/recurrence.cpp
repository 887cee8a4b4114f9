#include "recurrence.hpp"

#include <subcert/analysis/symbol/masks/parametric_mask.hpp>

#include <algorithm>

namespace subcert {
namespace {

constexpr int parts = 64;
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
  return denominator(x) <= unit ? x : Rational(to_integer(x * unit, rounding), unit);
}

}  // namespace

Recurrence Recurrence::parse(std::string_view text, char letter) {
  constexpr std::string_view root = "sqrt(";
  Recurrence result;
  result.is_root_ = text.starts_with(root) && text.ends_with(')');
  if (result.is_root_) text = text.substr(root.size(), text.size() - root.size() - 1);
  result.function_ = RationalFunction::parse(text, {&letter, 1});
  return result;
}

std::optional<Interval> Recurrence::image(const Interval& w) const {
  std::optional<Interval> result;
  const int count = w.lower == w.upper ? 1 : parts;
  for (int k = 0; k < count; ++k) {
    const auto at = [&](int place) { return Rational(w.lower + w.width() * Rational(place, count)); };
    auto part = range_of(function_, {at(k), at(k + 1)});
    if (!part || (is_root_ && part->lower < 0)) return std::nullopt;
    if (is_root_)
      part = Interval{*root_enclosure(part->lower, 2, root_bits).lower,
                      *root_enclosure(part->upper, 2, root_bits).upper};
    result = result ? hull(*result, *part) : *part;
  }
  return Interval{shortened(result->lower, Rounding::down), shortened(result->upper, Rounding::up)};
}

std::optional<int> Recurrence::first_level_in(const Interval& kept, const Interval& start, int most) const {
  const auto next = image(kept);
  if (!next || !contains(kept, *next)) return std::nullopt;
  Interval values = start;
  for (int level = 0; level <= most; ++level) {
    if (contains(kept, values)) return level;
    const auto image_of_values = image(values);
    if (!image_of_values) return std::nullopt;
    values = *image_of_values;
  }
  return std::nullopt;
}

}  // namespace subcert
