#include "regression_rules.hpp"

#include "vertex_rules.hpp"

#include <subcert/analysis/symbol/polynomials/cosine_field.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>

namespace subcert {
namespace {

using Number = CosineField::Number;

/// A function on the ring, as a polynomial in cos(t), becomes one in exp(it).
LaurentPolynomial in_exponentials(const LaurentPolynomial& p) {
  const LaurentPolynomial cosine({Rational(1, 2), 0, Rational(1, 2)}, -1);
  LaurentPolynomial value;
  for (long k = p.is_zero() ? -1 : p.highest(); k >= 0; --k)
    value = value * cosine + LaurentPolynomial(p.coefficient(k));
  return value;
}

/// A fit in the fan, of polynomials that are even across the edge: the data come in pairs.
class FanFit {
 public:
  FanFit(const BallRegression& scheme, long valence) : scheme_(scheme), valence_(valence), field_(valence) {
    for (int i = 0; i <= scheme.degree; ++i)
      for (int k = 0; i + 2 * k <= scheme.degree; ++k) basis_.push_back({i, k});
  }

  /// At the middle of the edge to 1.
  SectorRule edge_rule() const {
    // x, the square of y and the squared distance from 1/2 are polynomials in the cosine of the datum.
    const LaurentPolynomial t = LaurentPolynomial::monomial(1, 1), one = 1, quarter = Rational(1, 4);
    const std::vector<Datum> data{{{0, 0}, 1, 0, 0, quarter},
                                  {{2, 0}, 1, 2, 0, Rational(9, 4)},
                                  {{1, 1}, 2, one + t, one - t * t, Rational(5, 4) + t}};
    const Datum ring{{1, 0}, 1, t, one - t * t, Rational(5, 4) - t};
    const std::size_t size = basis_.size();
    std::vector<std::vector<Number>> system(size, std::vector<Number>(size + 1, field_.number(0)));
    for (std::size_t a = 0; a < size; ++a) {
      for (std::size_t b = 0; b < size; ++b) {
        for (const Datum& datum : data)
          system[a][b] = system[a][b] +
                         field_.number(Rational(datum.count) * weight(datum) * value(datum, a) * value(datum, b));
        system[a][b] = system[a][b] + field_.number(ring_sum(weight(ring) * value(ring, a) * value(ring, b)));
      }
      if (basis_[a].y == 0) system[a][size] = field_.number(LaurentPolynomial(power(Rational(1, 2), basis_[a].x)));
    }
    const std::vector<Number> solution = solved(std::move(system));
    SectorRule rule;
    for (const Datum& datum : data) {
      Number sum = field_.number(0);
      for (std::size_t a = 0; a < size; ++a) sum = sum + solution[a] * field_.number(weight(datum) * value(datum, a));
      for (long turn = 0; turn < datum.count; ++turn) {
        const SectorPoint at{datum.point, turn == 0 ? 0 : valence_ - 1};
        rule.terms.push_back({at, sum.polynomial()});
      }
    }
    std::map<long, Number> frequencies;
    for (std::size_t a = 0; a < size; ++a) {
      const LaurentPolynomial part = in_exponentials(weight(ring) * value(ring, a));
      for (long m = part.lowest(); m <= part.highest(); ++m) {
        const long turned = ((m % valence_) + valence_) % valence_, frequency = std::min(turned, valence_ - turned);
        const Number more = field_.number(LaurentPolynomial(part.coefficient(m))) * solution[a];
        const auto [sum, is_new] = frequencies.try_emplace(frequency, more);
        if (!is_new) sum->second = sum->second + more;
      }
    }
    for (const auto& [frequency, sum] : frequencies) {
      const long multiple = frequency == 0 || 2 * frequency == valence_ ? 1 : 2;
      if (!sum.is_zero())
        rule.rings.push_back({ring.point, frequency, Rational(valence_, multiple) * sum.polynomial()});
    }
    return rule;
  }

  /// At 0, where polynomials of degree 2 take the value of the vertex: |x|^2 tells it from its neighbours.
  SectorRule vertex_rule() const {
    const Rational ring = power(1 - 1 / (scheme_.radius * scheme_.radius), scheme_.power) * Rational(valence_),
                   part = scheme_.degree < 2 ? Rational(ring / (1 + ring)) : Rational(0);
    SectorRule rule;
    const SectorPoint vertex{LatticePoint{0, 0}, 0};
    rule.terms.push_back({vertex, LaurentPolynomial(Rational(1 - part))});
    if (part != 0) rule.rings.push_back({{1, 0}, 0, LaurentPolynomial(part)});
    return rule;
  }

 private:
  struct Powers {
    int x, y;  ///< of x, and of the square of y
  };
  /// `count` points that are equal but for the sign of y.
  struct Datum {
    LatticePoint point;
    int count;
    LaurentPolynomial x, squared_y, squared_distance;
  };

  LaurentPolynomial weight(const Datum& datum) const {
    const Rational inverse = 1 / (scheme_.radius * scheme_.radius);
    return (LaurentPolynomial(1) - inverse * datum.squared_distance).pow(scheme_.power);
  }

  LaurentPolynomial value(const Datum& datum, std::size_t a) const {
    return datum.x.pow(basis_[a].x) * datum.squared_y.pow(basis_[a].y);
  }

  /// The sum over all neighbours.
  LaurentPolynomial ring_sum(const LaurentPolynomial& of_cosine) const {
    const LaurentPolynomial p = in_exponentials(of_cosine);
    Rational sum = 0;
    for (long m = p.lowest(); m <= p.highest(); ++m)
      if (m % valence_ == 0) sum += p.coefficient(m);
    return Rational(valence_) * LaurentPolynomial(sum);
  }

  std::vector<Number> solved(std::vector<std::vector<Number>> system) const {
    require(reduce(system).back() < system.size(),
            "rules at a vertex: the data do not determine polynomials of degree {} at valence {}", scheme_.degree,
            valence_);
    std::vector<Number> solution;
    for (const std::vector<Number>& row : system) solution.push_back(row.back());
    return solution;
  }

  BallRegression scheme_;
  long valence_;
  CosineField field_;
  std::vector<Powers> basis_;
};

}  // namespace

void require_fan(const BallRegression& scheme) {
  const Rational squared = scheme.radius * scheme.radius;
  require(
      scheme.lattice == Lattice::equilateral && scheme.weights.empty() && scheme.degree <= 2 &&
          squared > Rational(9, 4) && squared <= 3,
      "rules at a vertex: need triangular: with 3/2 < L < 1.732, d <= 2 and a power, not weights, on the equilateral "
      "grid, got L = {}, d = {}",
      scheme.radius, scheme.degree);
}

std::map<LatticePoint, SectorRule> regression_rules_at(const BallRegression& scheme, long valence) {
  require_fan(scheme);
  require(valence >= smallest_valence && valence <= largest_valence,
          "rules at a vertex: need {} <= valence <= {}, got {}", smallest_valence, largest_valence, valence);
  const FanFit fit(scheme, valence);
  return {{{0, 0}, fit.vertex_rule()}, {{1, 0}, fit.edge_rule()}};
}

}  // namespace subcert
