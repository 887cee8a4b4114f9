#include "recurrence.hpp"

#include <subcert/analysis/symbol/polynomials/box.hpp>

#include <algorithm>

namespace subcert {
namespace {

constexpr int parts = 64;
constexpr int root_bits = 128, kept_bits = 256;

/// Of the quotient on an interval without zeros of the denominator, by the quotients of Bernstein coefficients.
std::optional<ClosedInterval> range_of(const RationalFunction& r, const ClosedInterval& w) {
  if (w.low == w.high) {
    if (r.denominator()(w.low) == 0) return std::nullopt;
    return ClosedInterval{r(w.low), r(w.low)};
  }
  const long degree = std::max<long>({0, r.numerator().highest(), r.denominator().highest()});
  std::optional<ClosedInterval> result;
  int sign = 0;
  for (const Values& factors : bernstein_factors(degree, w.low, w.high)) {
    Rational p = 0, q = 0;
    for (long k = 0; k <= degree; ++k) {
      p += factors[static_cast<std::size_t>(k)] * r.numerator().coefficient(k);
      q += factors[static_cast<std::size_t>(k)] * r.denominator().coefficient(k);
    }
    if (q == 0 || q.sign() == -sign) return std::nullopt;
    sign = q.sign();
    const Rational value = p / q;
    result = result ? ClosedInterval{std::min(result->low, value), std::max(result->high, value)}
                    : ClosedInterval{value, value};
  }
  return result;
}

/// The multiple of 2^-kept_bits that is next below, where the number is a long one.
Rational shortened(const Rational& x) {
  const Integer unit = Integer(1) << kept_bits;
  if (denominator(x) <= unit) return x;
  const Integer scaled = numerator(x) * unit;
  Integer below = scaled / denominator(x);
  if (scaled < 0) --below;
  return Rational(below, unit);
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

std::optional<ClosedInterval> Recurrence::image(const ClosedInterval& w) const {
  std::optional<ClosedInterval> result;
  const int count = w.low == w.high ? 1 : parts;
  for (int k = 0; k < count; ++k) {
    const auto at = [&](int place) { return Rational(w.low + (w.high - w.low) * Rational(place, count)); };
    auto part = range_of(function_, {at(k), at(k + 1)});
    if (!part || (is_root_ && part->low < 0)) return std::nullopt;
    if (is_root_)
      part = ClosedInterval{*root_enclosure(part->low, 2, root_bits).lower,
                            *root_enclosure(part->high, 2, root_bits).upper};
    result = result ? ClosedInterval{std::min(result->low, part->low), std::max(result->high, part->high)} : *part;
  }
  return ClosedInterval{shortened(result->low), -shortened(-result->high)};
}

std::optional<int> Recurrence::first_level_in(const ClosedInterval& kept, const ClosedInterval& start, int most) const {
  const auto next = image(kept);
  if (!next || !kept.contains(*next)) return std::nullopt;
  ClosedInterval values = start;
  for (int level = 0; level <= most; ++level) {
    if (kept.contains(values)) return level;
    const auto image_of_values = image(values);
    if (!image_of_values) return std::nullopt;
    values = *image_of_values;
  }
  return std::nullopt;
}

}  // namespace subcert
