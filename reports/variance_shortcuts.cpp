#include "variance_shortcuts.hpp"

#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/symbol/laurent_polynomial.hpp>

#include <algorithm>
#include <cstdlib>

namespace subcert {
namespace {

constexpr int first_level = 5, last_level = 10;
constexpr int farthest = 2;  // windows end at n - farthest, ..., n + farthest

/// The samples f(i / 2^level) as the coefficients of z^i.
LaurentPolynomial samples(const SampledVariance& curve, const Mask& mask) {
  if (!curve.refined_pulse) {
    const LimitValues values = limit_values(mask, curve.level);
    return LaurentPolynomial(values.values, values.first_index);
  }
  LaurentPolynomial data(1);
  for (int k = 0; k < curve.level; ++k) data = data.dilated(2) * mask.symbol();
  return data;
}

/// Squares of the samples over one denominator.
struct Squares {
  long first;
  std::vector<Integer> values;
  Integer denominator;
  int level;

  Squares(const LaurentPolynomial& f, int of_level)
      : first(f.lowest()), values(f.numerators()), denominator(f.denominator() * f.denominator()), level(of_level) {
    for (Integer& value : values) value *= value;
  }

  std::size_t steps() const { return std::size_t{1} << level; }
  long shifts() const { return static_cast<long>(values.size() / steps()) + std::abs(first) / static_cast<long>(steps()) + 2; }

  /// Adds f(x - j)^2 to a curve.
  void add(std::vector<Integer>& curve, long j) const {
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const long index = static_cast<long>(i) - j * static_cast<long>(steps()) - first;
      if (index >= 0 && index < static_cast<long>(values.size())) curve[i] += values[static_cast<std::size_t>(index)];
    }
  }

  std::vector<Integer> curve(const std::optional<SampledVariance::Window>& window, int n) const {
    const long low = window ? -(n + window->beyond) : -shifts();
    const long high = window ? n + window->beyond + (window->one_more ? 1 : 0) : shifts();
    std::vector<Integer> result(steps() + 1, 0);
    for (long j = low; j <= high; ++j) add(result, j);
    return result;
  }

  ShortcutValues of(const std::vector<Integer>& curve, bool two_steps) const {
    const std::size_t apart = two_steps ? 2 : 1;
    Integer most = 0;
    for (std::size_t i = apart; i < curve.size(); ++i) most = std::max(most, Integer(abs(curve[i] - curve[i - apart])));
    const Rational unit = Rational(1) / Rational(denominator);
    return {Rational(*std::max_element(curve.begin(), curve.end())) * unit,
            Rational(most) * unit * power(Rational(2), level) / Rational(static_cast<long>(apart))};
  }
};

std::vector<std::optional<SampledVariance::Window>> windows() {
  std::vector<std::optional<SampledVariance::Window>> result{std::nullopt};
  for (int beyond = -farthest; beyond <= farthest; ++beyond)
    for (bool one_more : {false, true}) result.push_back(SampledVariance::Window{beyond, one_more});
  return result;
}

std::string bound_text(int beyond) {
  if (beyond == 0) return "n";
  return beyond > 0 ? "n+" + std::to_string(beyond) : "n-" + std::to_string(-beyond);
}

}  // namespace

std::string Shortcut::text() const {
  std::string text = curve.window ? "the sum over j = -" +
                                        (curve.window->beyond == 0 ? "n" : "(" + bound_text(curve.window->beyond) + ")") +
                                        ", ..., " + bound_text(curve.window->beyond + (curve.window->one_more ? 1 : 0)) +
                                        " alone"
                                  : "the whole sum";
  text += curve.refined_pulse ? ", the pulse after " + std::to_string(curve.level) + " refinements in place of phi"
                              : ", phi at the multiples of 2^-" + std::to_string(curve.level);
  return text + ", slopes as divided differences of step 2^-" + std::to_string(curve.level - (two_steps ? 1 : 0));
}

const std::vector<Shortcut>& variance_shortcuts() {
  static const std::vector<Shortcut> all = [] {
    std::vector<Shortcut> list;
    for (const auto& window : windows())
      for (bool refined : {false, true})
        for (int level = first_level; level <= last_level; ++level)
          for (bool two_steps : {false, true}) list.push_back({{refined, level, window}, two_steps});
    return list;
  }();
  return all;
}

ShortcutValues evaluate_shortcut(const Shortcut& shortcut, const Mask& mask, int n) {
  const Squares squares(samples(shortcut.curve, mask), shortcut.curve.level);
  return squares.of(squares.curve(shortcut.curve.window, n), shortcut.two_steps);
}

std::vector<ShortcutValues> evaluate_shortcuts(const Mask& mask, int n) {
  std::vector<Squares> squares;
  for (bool refined : {false, true})
    for (int level = first_level; level <= last_level; ++level)
      squares.emplace_back(samples({refined, level, std::nullopt}, mask), level);
  std::vector<ShortcutValues> result;
  for (const auto& window : windows())
    for (const Squares& one : squares) {
      const std::vector<Integer> curve = one.curve(window, n);
      for (bool two_steps : {false, true}) result.push_back(one.of(curve, two_steps));
    }
  return result;
}

bool gives_digits(const Rational& value, const std::string& printed) {
  const std::size_t point = printed.find('.');
  const int places = point == std::string::npos ? 0 : static_cast<int>(printed.size() - point - 1);
  return to_fixed(value, places, Rounding::nearest) == printed || to_fixed(value, places, Rounding::down) == printed;
}

}  // namespace subcert
