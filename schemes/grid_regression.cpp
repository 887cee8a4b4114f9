
#include "grid_regression.hpp"

#include "local_regression.hpp"

#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>
#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <map>
#include <set>

namespace subcert {
namespace {

/// The weights of the variables from `axis` on, by the remaining degree.
class Products {
 public:
  explicit Products(std::vector<std::vector<std::vector<Rational>>> terms) : terms_(std::move(terms)) {}

  const std::vector<Rational>& from(std::size_t axis, int degree) {
    auto found = known_.find({axis, degree});
    if (found == known_.end()) found = known_.emplace(std::pair(axis, degree), make(axis, degree)).first;
    return found->second;
  }

 private:
  std::vector<Rational> make(std::size_t axis, int degree) {
    const auto& terms = terms_[axis];
    const int last = std::min(degree, static_cast<int>(terms.size()) - 1);
    std::vector<Rational> result;
    for (int k = 0; k <= last; ++k) {
      const std::vector<Rational>& term = terms[static_cast<std::size_t>(k)];
      if (std::all_of(term.begin(), term.end(), [](const Rational& c) { return c == 0; })) continue;
      const std::vector<Rational> one{1};
      const std::vector<Rational>& rest = axis + 1 < terms_.size() ? from(axis + 1, degree - k) : one;
      result.resize(term.size() * rest.size(), 0);
      for (std::size_t j = 0; j < rest.size(); ++j)
        for (std::size_t i = 0; i < term.size(); ++i) result[j * term.size() + i] += term[i] * rest[j];
    }
    return result;
  }

  std::vector<std::vector<std::vector<Rational>>> terms_;
  std::map<std::pair<std::size_t, int>, std::vector<Rational>> known_;
};

}  // namespace

std::vector<Rational> grid_regression_weights(const std::vector<std::vector<Rational>>& nodes, int degree,
                                              const std::vector<Rational>& x) {
  if (nodes.empty() || nodes.size() > 3 || nodes.size() != x.size())
    fail(ErrorKind::domain, "grid_regression_weights: need one to three variables and one coordinate of x for each");
  std::vector<std::vector<std::vector<Rational>>> terms;
  for (std::size_t v = 0; v < nodes.size(); ++v) terms.push_back(regression_terms(nodes[v], {}, degree, x[v]));
  return Products(std::move(terms)).from(0, degree);
}

LatticeMask grid_regression_mask(const GridRegression& scheme) {
  const std::size_t variables = scheme.points.size();
  if (variables < 2 || variables > 3)
    fail(ErrorKind::domain, "grid_regression_mask: need 2 or 3 numbers of points, got {}", variables);
  std::vector<LocalRegression> axes;
  std::vector<std::vector<Rational>> nodes;
  std::size_t outputs = 1, points = 1;
  for (const int count : scheme.points) {
    axes.push_back(ary(scheme.arity, count, scheme.degree));
    nodes.emplace_back();
    for (long l = axes.back().rules[0].first; l <= axes.back().rules[0].last; ++l) nodes.back().emplace_back(l);
    outputs *= static_cast<std::size_t>(scheme.arity);
    points *= static_cast<std::size_t>(count);
  }
  std::vector<MultivariatePolynomial::Monomial> terms;
  for (std::size_t output = 0; output < outputs; ++output) {
    std::vector<Rational> position;
    std::vector<long> first;
    for (std::size_t v = 0, rest = output; v < variables; ++v, rest /= static_cast<std::size_t>(scheme.arity)) {
      const std::size_t rule = rest % static_cast<std::size_t>(scheme.arity);
      position.push_back(axes[v].rules[rule].position);
      first.push_back(axes[v].first_output + static_cast<long>(rule) - scheme.arity * axes[v].rules[rule].first);
    }
    const std::vector<Rational> weights = grid_regression_weights(nodes, scheme.degree, position);
    for (std::size_t point = 0; point < points; ++point) {
      MultivariatePolynomial::Exponents exponents;
      std::size_t rest = point;
      for (std::size_t v = 0; v < variables; ++v) {
        exponents.push_back(first[v] - scheme.arity * static_cast<long>(rest % nodes[v].size()));
        rest /= nodes[v].size();
      }
      terms.push_back({weights[point], std::move(exponents)});
    }
  }
  return {MultivariatePolynomial(static_cast<int>(variables), terms), scheme.arity};
}

namespace {

/// A new point at new_point / 2, and the data around it: their squared distances, and twice where they lie from it.
struct Neighbours {
  std::vector<LatticePoint> points;
  std::vector<Rational> distances;
};

Neighbours neighbours_around(const LatticePoint& new_point, const BallRegression& scheme) {
  Neighbours ball;
  const long reach = ceil_index(2 * scheme.radius) + 1, mixed = scheme.lattice == Lattice::equilateral ? 1 : 0;
  for (long i = -reach; i <= reach; ++i)
    for (long j = -reach; j <= reach; ++j) {
      const long x = 2 * i - new_point[0], y = 2 * j - new_point[1];
      const Rational distance(x * x + mixed * x * y + y * y, 4);
      if (distance >= scheme.radius * scheme.radius) continue;
      ball.points.push_back({x, y});
      ball.distances.push_back(distance);
    }
  return ball;
}

std::vector<Neighbours> balls_of(const BallRegression& scheme) {
  require(scheme.radius > Rational(1, 2) && scheme.radius <= 10, "ball regression: need 1/2 < L <= 10, got {}",
          scheme.radius);
  std::vector<Neighbours> balls;
  for (const LatticePoint& new_point : {LatticePoint{0, 0}, {1, 0}, {0, 1}, {1, 1}})
    balls.push_back(neighbours_around(new_point, scheme));
  return balls;
}

/// The weights c with p(0) = sum of c[i] y[i], where p has total degree at most `degree` and minimises the sum of
/// weights[i] (p(points[i]) - y[i])^2, by the normal equations.
std::vector<Rational> weights_at_origin(const std::vector<LatticePoint>& points, const std::vector<Rational>& weights,
                                        int degree) {
  std::vector<LatticePoint> exponents;
  for (long a = 0; a <= degree; ++a)
    for (long b = 0; a + b <= degree; ++b) exponents.push_back({a, b});
  const auto monomial = [](const LatticePoint& point, const LatticePoint& exponent) {
    Integer product = 1;
    for (std::size_t v = 0; v < 2; ++v)
      for (long k = 0; k < exponent[v]; ++k) product *= point[v];
    return product;
  };
  RationalMatrix gram(exponents.size(), exponents.size()), right(exponents.size(), 1);
  right(0, 0) = 1;
  std::map<LatticePoint, Rational> moments;
  for (std::size_t k = 0; k < exponents.size(); ++k)
    for (std::size_t l = 0; l < exponents.size(); ++l) {
      const auto [moment, inserted] = moments.emplace(exponents[k] + exponents[l], 0);
      if (inserted)
        for (std::size_t i = 0; i < points.size(); ++i)
          moment->second += weights[i] * Rational(monomial(points[i], moment->first));
      gram(k, l) = moment->second;
    }
  require(pivot_columns(gram).size() == exponents.size(),
          "ball regression: need data that determine polynomials of degree {}, got {} around a new point", degree,
          points.size());
  const RationalMatrix solution = solve(gram, right);
  std::vector<Rational> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Rational value = 0;
    for (std::size_t k = 0; k < exponents.size(); ++k)
      value += solution(k, 0) * Rational(monomial(points[i], exponents[k]));
    result.push_back(weights[i] * value);
  }
  return result;
}

}  // namespace

std::vector<Rational> ball_distances(const BallRegression& scheme) {
  std::set<Rational> distances;
  for (const Neighbours& ball : balls_of(scheme)) distances.insert(ball.distances.begin(), ball.distances.end());
  return {distances.begin(), distances.end()};
}

LatticeMask ball_regression_mask(const BallRegression& scheme) {
  require(scheme.degree >= 0 && scheme.degree <= 6, "ball regression: need 0 <= d <= 6, got {}", scheme.degree);
  require(scheme.power >= 0 && scheme.power <= 8, "ball regression: need 0 <= power <= 8, got {}", scheme.power);
  const std::vector<Rational> distances = ball_distances(scheme);
  require(scheme.weights.empty() || scheme.weights.size() == distances.size(),
          "ball regression: need {} weights, one for each distance, got {}", distances.size(), scheme.weights.size());
  require(std::all_of(scheme.weights.begin(), scheme.weights.end(), [](const Rational& w) { return w > 0; }),
          "ball regression: need weights > 0");
  std::vector<Monomial> terms;
  for (const Neighbours& ball : balls_of(scheme)) {
    std::vector<Rational> weights;
    for (const Rational& distance : ball.distances) {
      const auto ring = std::lower_bound(distances.begin(), distances.end(), distance) - distances.begin();
      weights.push_back(scheme.weights.empty() ? power(1 - distance / (scheme.radius * scheme.radius), scheme.power)
                                               : scheme.weights[static_cast<std::size_t>(ring)]);
    }
    // Data j and the new point m / 2 meet in a_{m - 2j}.
    const std::vector<Rational> rule = weights_at_origin(ball.points, weights, scheme.degree);
    for (std::size_t i = 0; i < rule.size(); ++i) terms.push_back({rule[i], LatticePoint{0, 0} - ball.points[i]});
  }
  return {MultivariatePolynomial(2, terms), 2};
}

}  // namespace subcert
