#include "fan_regression.hpp"

#include "regression_rules.hpp"
#include "vertex_rules.hpp"

#include <subcert/analysis/symbol/matrices/ball_solvers.hpp>
#include <subcert/analysis/symbol/numbers/balls.hpp>
#include <subcert/analysis/symbol/polynomials/cosine_field.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/specification_text.hpp>

#include <cstdlib>
#include <optional>
#include <utility>

namespace subcert {
namespace {

/// Numbers of Q(cos(2 pi / turn)). Of few data, where a fit may not be determined.
struct ExactNumbers {
  using Number = CosineField::Number;

  explicit ExactNumbers(long turn) : field(turn) {}
  Number number(const Rational& value) const { return field.number(LaurentPolynomial(value)); }
  Number cosine(long k) const { return field.cosine(std::abs(k)); }
  /// sin(kt) / sin(t): y is counted in sin(t), so that all numbers lie in the field.
  Number height(long k) const {
    if (k < 0) return -height(-k);
    Number before = number(-1), here = number(0);
    for (; k > 0; --k) before = std::exchange(here, number(2) * cosine(1) * here - before);
    return here;
  }
  Number squared_unit() const { return number(1) - cosine(1) * cosine(1); }
  /// Some x with matrix x = right, where there is one.
  std::optional<std::vector<Number>> solved(std::vector<std::vector<Number>> system,
                                            const std::vector<Number>& right) const {
    for (std::size_t row = 0; row < right.size(); ++row) system[row].push_back(right[row]);
    const std::vector<std::size_t> pivots = reduce(system);
    if (pivots.back() == right.size()) return std::nullopt;
    std::vector<Number> solution(right.size(), number(0));
    for (std::size_t row = 0; row < pivots.size(); ++row) solution[pivots[row]] = system[row].back();
    return solution;
  }

  CosineField field;
};

/// Balls. Of five neighbours and more: a conic through them is the circle, which the end is not on, so that the data
/// determine fits of degree 2.
struct BallNumbers {
  using Number = Ball;
  static constexpr slong bits = 160;

  explicit BallNumbers(long turns) : turn(turns) {}
  Number number(const Rational& value) const { return Ball(value, bits); }
  Number cosine(long k) const { return cos(angle(k)); }
  Number height(long k) const { return sin(angle(k)); }
  Number squared_unit() const { return number(1); }
  Ball angle(long k) const { return Ball::pi(bits) * Ball(Rational(Integer(2 * k), Integer(turn)), bits); }
  std::optional<std::vector<Number>> solved(const std::vector<std::vector<Number>>& system,
                                            const std::vector<Number>& right) const {
    auto solution = solve(system, right, bits);
    require(solution.has_value(), "fit in a fan: its system of {} equations was not proved to be regular",
            right.size());
    return solution;
  }

  long turn;
};

template <class Number>
struct Place {
  Number x, y;
};

/// The fits of one fan.
template <class Numbers>
class FanFits {
 public:
  using Number = typename Numbers::Number;

  FanFits(const BallRegression& scheme, const MeshFan& fan, const Rational& at)
      : numbers_(fan.turn), at_(numbers_.number(at)) {
    const Number one = numbers_.number(1), zero = numbers_.number(0);
    places_.push_back({zero, zero});
    for (long k = fan.first; k <= fan.last; ++k) places_.push_back({numbers_.cosine(k), numbers_.height(k)});
    if (fan.left) places_.push_back({one + numbers_.cosine(1), numbers_.height(1)});
    if (fan.straight) places_.push_back({numbers_.number(2), zero});
    if (fan.right) places_.push_back({one + numbers_.cosine(1), numbers_.height(-1)});
    const Number inverse = numbers_.number(1 / (scheme.radius * scheme.radius));
    for (const Place<Number>& place : places_) {
      const Number along = place.x - at_;
      const Number squared = along * along + place.y * place.y * numbers_.squared_unit();
      weights_.push_back(raised(one - inverse * squared, scheme.power));
    }
  }

  /// Of the data, for the value at (at, 0); none where they do not determine it.
  std::optional<std::vector<Number>> of_degree(int degree) const {
    const std::vector<Number> wanted = monomials({at_, numbers_.number(0)}, degree);
    const std::size_t size = wanted.size();
    std::vector<std::vector<Number>> values, system(size, std::vector<Number>(size, numbers_.number(0)));
    for (const Place<Number>& place : places_) values.push_back(monomials(place, degree));
    for (std::size_t i = 0; i < values.size(); ++i)
      for (std::size_t a = 0; a < size; ++a)
        for (std::size_t b = 0; b < size; ++b) system[a][b] = system[a][b] + weights_[i] * values[i][a] * values[i][b];
    const auto solution = numbers_.solved(std::move(system), wanted);
    if (!solution) return std::nullopt;
    std::vector<Number> result;
    for (std::size_t i = 0; i < values.size(); ++i) {
      Number sum = numbers_.number(0);
      for (std::size_t a = 0; a < size; ++a) sum = sum + (*solution)[a] * values[i][a];
      result.push_back(weights_[i] * sum);
    }
    return result;
  }

 private:
  Number raised(const Number& base, int exponent) const {
    Number result = numbers_.number(1);
    for (int k = 0; k < exponent; ++k) result = result * base;
    return result;
  }

  std::vector<Number> monomials(const Place<Number>& place, int degree) const {
    std::vector<Number> values;
    for (int i = 0; i <= degree; ++i)
      for (int j = 0; i + j <= degree; ++j) values.push_back(raised(place.x, i) * raised(place.y, j));
    return values;
  }

  Numbers numbers_;
  Number at_;
  std::vector<Place<Number>> places_;
  std::vector<Number> weights_;
};

/// Constants are always determined.
template <class Numbers>
std::vector<typename Numbers::Number> fitted(const FanFits<Numbers>& fits, int degree) {
  for (;; --degree)
    if (auto weights = fits.of_degree(degree)) return *std::move(weights);
}

}  // namespace

std::vector<Enclosure> fan_weights(std::string_view specification, const MeshFan& fan, bool at_middle) {
  const auto scheme = specification_text::ball_regression_of(specification);
  require(scheme.has_value(), "fit in a fan: need triangular:, got {}", specification);
  require_fan(*scheme);
  require(fan.turn >= smallest_valence && fan.turn <= 2 * largest_valence && fan.first <= 0 && fan.last >= 0 &&
              fan.last - fan.first < fan.turn,
          "fit in a fan: need 3 <= turn <= {}, first <= 0 <= last, less than turn apart, got {}, {}, {}",
          2 * largest_valence, fan.turn, fan.first, fan.last);
  const Rational at = at_middle ? Rational(1, 2) : Rational(0);
  std::vector<Enclosure> result;
  if (fan.last - fan.first + 1 >= 5) {
    for (const Ball& weight : fitted(FanFits<BallNumbers>(*scheme, fan, at), scheme->degree))
      result.push_back(weight.enclosure(64));
    return result;
  }
  SectorRule rule;
  for (const CosineField::Number& weight : fitted(FanFits<ExactNumbers>(*scheme, fan, at), scheme->degree))
    rule.terms.push_back({{{static_cast<long>(rule.terms.size()), 0}, 0}, weight.polynomial()});
  for (const auto& [place, weight] : weights_at(rule, SectorLattice::dual, fan.turn)) result.push_back(weight);
  return result;
}

}  // namespace subcert
