#include "fan_regression.hpp"

#include "regression_rules.hpp"
#include "vertex_rules.hpp"

#include <subcert/analysis/symbol/polynomials/cosine_field.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/specification_text.hpp>

#include <optional>

namespace subcert {
namespace {

using Number = CosineField::Number;

/// y is counted in sin(2 pi / turn), so that all numbers lie in the field.
struct Place {
  Number x, y;
};

class FanPlaces {
 public:
  explicit FanPlaces(const MeshFan& fan) : field_(fan.turn), c_(field_.cosine(1)) {
    const Number one = field_.number(1), zero = field_.number(0), two = field_.number(2);
    places_.push_back({zero, zero});
    // cos(kt) and sin(kt) / sin(t) follow the same recursion.
    Place before{c_, -one}, here{one, zero};
    for (long k = 0; k > fan.first; --k) back(before, here);
    for (long k = fan.first; k <= fan.last; ++k) {
      places_.push_back(here);
      const Place next{two * c_ * here.x - before.x, two * c_ * here.y - before.y};
      before = std::exchange(here, next);
    }
    if (fan.left) places_.push_back({one + c_, one});
    if (fan.straight) places_.push_back({two, zero});
    if (fan.right) places_.push_back({one + c_, -one});
  }

  const std::vector<Place>& places() const { return places_; }
  const CosineField& field() const { return field_; }
  Number squared_distance(const Place& place, const Number& x) const {
    const Number along = place.x - x;
    return along * along + place.y * place.y * (field_.number(1) - c_ * c_);
  }

 private:
  void back(Place& before, Place& here) const {
    const Number twice = field_.number(2) * c_;
    const Place earlier{twice * before.x - here.x, twice * before.y - here.y};
    here = std::exchange(before, earlier);
  }

  CosineField field_;
  Number c_;
  std::vector<Place> places_;
};

Number raised(const Number& base, int exponent, const CosineField& field) {
  Number result = field.number(1);
  for (int k = 0; k < exponent; ++k) result = result * base;
  return result;
}

std::vector<Number> monomials(const Place& place, int degree, const CosineField& field) {
  std::vector<Number> values;
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; i + j <= degree; ++j) values.push_back(raised(place.x, i, field) * raised(place.y, j, field));
  return values;
}

/// The weights of a fit at (x, 0); none where the data do not determine its value.
std::optional<std::vector<Number>> fitted(const FanPlaces& fan, const std::vector<Number>& weights, int degree,
                                          const Number& x) {
  const CosineField& field = fan.field();
  const std::vector<Number> wanted = monomials({x, field.number(0)}, degree, field);
  const std::size_t size = wanted.size();
  std::vector<std::vector<Number>> values, system;
  for (const Place& place : fan.places()) values.push_back(monomials(place, degree, field));
  for (std::size_t a = 0; a < size; ++a) {
    system.emplace_back(size, field.number(0)).push_back(wanted[a]);
    for (std::size_t i = 0; i < values.size(); ++i)
      for (std::size_t b = 0; b < size; ++b)
        system[a][b] = system[a][b] + weights[i] * values[i][a] * values[i][b];
  }
  const std::vector<std::size_t> pivots = reduce(system);
  if (pivots.back() == size) return std::nullopt;
  std::vector<Number> result;
  for (std::size_t i = 0; i < values.size(); ++i) {
    Number sum = field.number(0);
    for (std::size_t row = 0; row < pivots.size(); ++row) sum = sum + system[row].back() * values[i][pivots[row]];
    result.push_back(weights[i] * sum);
  }
  return result;
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
  const FanPlaces places(fan);
  const CosineField& field = places.field();
  const Number x = field.number(LaurentPolynomial(at_middle ? Rational(1, 2) : Rational(0)));
  const Number inverse = field.number(LaurentPolynomial(Rational(1 / (scheme->radius * scheme->radius))));
  std::vector<Number> weights;
  for (const Place& place : places.places())
    weights.push_back(raised(field.number(1) - inverse * places.squared_distance(place, x), scheme->power, field));
  for (int degree = scheme->degree;; --degree) {
    const auto solution = fitted(places, weights, degree, x);
    if (!solution) continue;  // constants are always determined
    SectorRule rule;
    for (std::size_t i = 0; i < solution->size(); ++i)
      rule.terms.push_back({{{static_cast<long>(i), 0}, 0}, (*solution)[i].polynomial()});
    std::vector<Enclosure> result;
    for (const auto& [at, weight] : weights_at(rule, SectorLattice::dual, fan.turn)) result.push_back(weight);
    return result;
  }
}

}  // namespace subcert
