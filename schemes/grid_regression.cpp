#include "grid_regression.hpp"

#include "local_regression.hpp"

#include <subcert/analysis/symbol/error.hpp>

#include <algorithm>
#include <map>

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

}  // namespace subcert
