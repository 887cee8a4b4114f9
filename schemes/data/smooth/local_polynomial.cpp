#include "local_polynomial.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>
#include <subcert/schemes/data/formats/table.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>
#include <subcert/schemes/local_regression.hpp>
#include <subcert/schemes/regression_fit.hpp>
#include <subcert/schemes/specification_text.hpp>

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace subcert::data {
namespace {

using specification_text::fail;
using specification_text::Fields;
using specification_text::read_integer;

constexpr std::string_view family_name = "local";
constexpr long most_points = 10'000'000;
constexpr double most_exact_window = 2048, most_exact_robust_window = 128;
constexpr double most_exact_terms = 1e6;  // of all windows of the data
constexpr std::size_t vertices_in_window = 128, robust_vertices_in_window = 64;
constexpr std::size_t outputs_per_thread = 512;
constexpr long most_robust_steps = 100;

const std::vector<std::string>& weight_names() {
  static const std::vector<std::string> names{"box", "triangle", "epanechnikov", "biweight", "tricube"};
  return names;
}

std::string usage() {
  return fmt::format(
      "local:points=21,d=1,weight=tricube; or width=0.5 in place of points, or neither; weight is {}; robust=3 for "
      "bisquare steps",
      fmt::join(weight_names(), ", "));
}

/// The data that windows about 0 <= position < 1 may reach on uniform data: no fewer than they do.
std::pair<long, long> reach_of(const LocalPolynomial& method) {
  const double radius = method.points > 0 ? static_cast<double>(method.points) / 2 : method.width;
  const auto reach = static_cast<long>(std::min(radius, static_cast<double>(most_smoothed_values))) + 2;
  return {-reach, reach + 1};
}

}  // namespace

std::string to_text(const LocalPolynomial& method) {
  std::string text(family_name);
  text += ":";
  if (method.points > 0) text += fmt::format("points={},", method.points);
  if (method.width > 0) text += "width=" + shortest_text(method.width) + ",";
  text += fmt::format("d={},weight={}", method.degree, weight_names()[static_cast<std::size_t>(method.weight)]);
  return method.robust > 0 ? text + fmt::format(",robust={}", method.robust) : text;
}

bool is_robust_specification(std::string_view specification) {
  return is_local_specification(specification) && make_local_polynomial(specification).robust > 0;
}

bool is_local_specification(std::string_view specification) {
  return specification.substr(0, specification.find(':')) == family_name;
}

LocalPolynomial make_local_polynomial(std::string_view specification) {
  const std::size_t colon = std::min(specification.find(':'), specification.size());
  const specification_text::Piece family{specification.substr(0, colon), 0};
  if (family.text != family_name) fail(family, "the family local, as in " + usage());
  const std::size_t body = std::min(colon + 1, specification.size());
  Fields fields(family, {specification.substr(body), body}, usage());
  LocalPolynomial method;
  if (const auto piece = fields.optional("d")) method.degree = static_cast<int>(read_integer(*piece, "d", 0, 20));
  if (const auto piece = fields.optional("points"))
    method.points = static_cast<std::size_t>(read_integer(*piece, "points", method.degree / 2 + 1, most_points));
  if (const auto piece = fields.optional("width")) {
    if (method.points > 0) fail(*piece, "points or width, not both");
    const Rational width = specification_text::read_rational(*piece);
    method.width = nearest_double(width);
    if (!(width > 0) || !(method.width < 1e150) || method.width == 0) fail(*piece, "a width > 0");
  }
  if (const auto piece = fields.optional("weight")) {
    const auto found = std::find(weight_names().begin(), weight_names().end(), piece->text);
    if (found == weight_names().end()) fail(*piece, fmt::format("one of {}", fmt::join(weight_names(), ", ")));
    method.weight = static_cast<LocalWeight>(found - weight_names().begin());
  }
  if (const auto piece = fields.optional("robust"))
    method.robust = static_cast<int>(read_integer(*piece, "robust", 0, most_robust_steps));
  fields.finish();
  return method;
}

LocalSmoother::LocalSmoother(const LocalPolynomial& method, DataSites sites, const SmoothingOptions& options)
    : LinearSmoother({options.boundary, 1, 0}, std::move(sites), options, std::size_t{1} << options.level,
                     reach_of(method)),
      method_(method),
      windows_(data(), options.boundary, method) {
  require(options.derivative <= method.degree, "derivative {}: polynomials of degree {} have none", options.derivative,
          method.degree);
  if (method.points > 0 && method.points * data().kinds() <= static_cast<std::size_t>(method.degree))
    subcert::fail(ErrorKind::usage, "{}: expected points as an integer from {}{}", to_text(method), method.degree + 1,
                  data().kinds() == 1 ? "; half as many need values with slopes" : "");
  std::size_t present = 0;
  for (std::size_t i = 0; i < data().count(); i += data().kinds())
    present += data().is_present(static_cast<long>(i)) ? 1 : 0;
  if (method.points > present)
    fail(ErrorKind::data, "expected at least {} data for {}; found {}", method.points, to_text(method), present);
}

std::size_t LocalSmoother::stride() const {
  if (options().path || !options().sparse || !options().places.empty() || method_.weight == LocalWeight::box) return 1;
  if (options().as_observed && data().kinds() > 1) return 1;  // neighbours differ in kind
  double points = static_cast<double>(method_.points * data().kinds());
  if (points == 0 && data().uniform()) points = std::min(2 * method_.width, static_cast<double>(most_points));
  const bool robust = method_.robust > 0;
  const bool few = points * static_cast<double>(data().count()) <= most_exact_terms;
  if (few || !(points > (robust ? most_exact_robust_window : most_exact_window))) return 1;
  return static_cast<std::size_t>(points) / (robust ? robust_vertices_in_window : vertices_in_window);
}

void LocalSmoother::require_fit(const LocalWindows::Window& window) const {
  if (windows_.determines(window)) return;
  std::size_t counted = 0;
  for (std::size_t k = window.first; k < window.end; ++k) counted += windows_.factor(window, k) > 0 ? 1 : 0;
  const auto needed = static_cast<std::size_t>(method_.degree) + 1;
  fail(ErrorKind::data, "smoothing: {}{} at {} spacings from the first, a fit of degree {} needs {}; take {}{}",
       counted == 1 ? "1 datum counts" : fmt::format("{} data count", counted),
       counted >= needed ? " at too few positions" : "", window.position + static_cast<double>(data().sites().before),
       method_.degree, needed, method_.points > 0 ? "more points" : "a larger width",
       method_.weight == LocalWeight::box ? "" : " (the farthest have weight 0)");
}

template <class Number>
class LocalSmoother::Rows : public RowMaker<Number> {
 public:
  explicit Rows(const LocalSmoother& smoother) : smoother_(smoother) {}

  RowOf<Number> row(std::size_t output) override {
    window_ = smoother_.windows_.at(smoother_.rounded_position(output), window_);
    smoother_.require_fit(window_);
    set_nodes();
    const int derivative = smoother_.derivative(output);
    std::vector<Number> fit = weights_of_fit(derivative);
    for (int k = 0; k < derivative; ++k)
      for (Number& weight : fit) weight /= unit_;
    if (smoother_.data().is_inside(indices_.front()) && smoother_.data().is_inside(indices_.back()))
      return inner_row(fit);
    Combination<Number> sum;
    for (std::size_t k = 0; k < fit.size(); ++k) sum.add(smoother_.data(), indices_[k], fit[k]);
    return smoother_.template to_row<Number>({{&sum, 1}});
  }

 private:
  std::vector<Number> weights_of_fit(int derivative) const {
    const int degree = smoother_.method_.degree;
    if (orders_.empty()) return regression_weights(nodes_, weights_, degree, Number(0), derivative);
    std::vector<Number> fit(nodes_.size(), Number(0));
    regression_fit::for_hermite_terms(nodes_, orders_, weights_, degree, Number(0), derivative,
                                      [&](const Number& scale, const std::vector<Number>& values) {
                                        for (std::size_t i = 0; i < fit.size(); ++i)
                                          fit[i] += scale * values[i] * weights_[i];
                                      });
    for (std::size_t i = 0; i < fit.size(); ++i)
      for (int r = 0; r < orders_[i]; ++r) fit[i] *= unit_;
    return fit;
  }

  RowOf<Number> inner_row(std::vector<Number>& fit) const {
    RowOf<Number> row;
    row.first = static_cast<std::size_t>(indices_.front());
    const auto length = static_cast<std::size_t>(indices_.back() - indices_.front()) + 1;
    row.variance = regression_fit::sum_of<Number>(fit.size(), [&](std::size_t k) {
      Number square = fit[k] * fit[k];
      return smoother_.data().weighted() ? Number(square / smoother_.prior_weight<Number>(indices_[k])) : square;
    });
    if (length == fit.size()) {
      row.weights = std::move(fit);
      return row;
    }
    row.weights.assign(length, Number(0));
    for (std::size_t k = 0; k < fit.size(); ++k)
      row.weights[static_cast<std::size_t>(indices_[k]) - row.first] = fit[k];
    return row;
  }

  /// In units of the radius, so that no power leaves the doubles.
  void set_nodes() {
    const LocalWindows& windows = smoother_.windows_;
    unit_ = Number(window_.radius > 0 ? window_.radius : 1.0);
    set_those_of_values(windows);
    if (smoother_.data().kinds() == 1) return;
    orders_.clear();
    for (std::size_t i = 0; i < indices_.size(); ++i) {
      orders_.push_back(smoother_.data().order(indices_[i]));
      for (int r = 0; r < orders_.back(); ++r) weights_[i] /= unit_ * unit_;
    }
  }

  /// As if all data were values.
  void set_those_of_values(const LocalWindows& windows) {
    indices_.clear();
    if constexpr (std::is_same_v<Number, double>) {
      windows.nodes_and_factors(window_, nodes_, weights_);
      for (std::size_t k = window_.first; k < window_.end; ++k) {
        indices_.push_back(windows.index(k));
        weights_[k - window_.first] *= smoother_.prior_weight<double>(indices_.back());
      }
      return;
    }
    nodes_.clear();
    weights_.clear();
    for (std::size_t k = window_.first; k < window_.end; ++k) {
      const Number node = (Number(windows.positions()[k]) - Number(window_.position)) / unit_;
      Number weight = smoother_.prior_weight<Number>(windows.index(k));
      if (window_.radius > 0 && smoother_.method_.weight != LocalWeight::box) {
        const Number u = node < 0 ? Number(-node) : node;
        if (!(u < 1)) continue;
        weight *= distance_factor(smoother_.method_.weight, u);
      }
      nodes_.push_back(node);
      weights_.push_back(std::move(weight));
      indices_.push_back(windows.index(k));
    }
  }

  const LocalSmoother& smoother_;
  LocalWindows::Window window_;
  Number unit_ = 1;
  std::vector<Number> nodes_, weights_;
  std::vector<long> indices_;
  std::vector<int> orders_;  // none: all 0
};

SmoothingRow LocalSmoother::row(std::size_t output) const { return Rows<Rational>(*this).row(output); }

std::vector<LocalBasis> LocalSmoother::bases() const {
  std::vector<LocalBasis> result;
  LocalWindows::Window window;
  std::vector<double> nodes, weights;
  for (std::size_t o = 0; o < outputs(); ++o) {
    window = windows_.at(rounded_position(o), window);
    require_fit(window);
    windows_.nodes_and_factors(window, nodes, weights);
    LocalBasis& basis = result.emplace_back();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const long index = windows_.index(window.first + i);
      const double weight = weights[i] * prior_weight<double>(index);
      if (!(weight > 0)) continue;
      const Combination<double> datum = data().at<double>(index);
      basis.data.push_back(datum.terms.empty() ? LocalBasis::outside : datum.terms.front().first);
      basis.roots.push_back(std::sqrt(weight));
      nodes[kept] = nodes[i];
      weights[kept++] = weight;
    }
    nodes.resize(kept);
    weights.resize(kept);
    regression_fit::for_terms(nodes, weights, method_.degree, 0.0, 0,
                              [&](double scale, const std::vector<double>& polynomial) {
                                double norm = 0;
                                std::vector<double>& values = basis.values.emplace_back(polynomial);
                                for (std::size_t i = 0; i < kept; ++i) {
                                  values[i] *= basis.roots[i];
                                  norm += values[i] * values[i];
                                }
                                norm = std::sqrt(norm);
                                for (double& value : values) value /= norm;
                                basis.at.push_back(scale * norm);
                              });
  }
  return result;
}

std::unique_ptr<LinearSmoother::RowMaker<double>> LocalSmoother::row_maker() const {
  return std::make_unique<Rows<double>>(*this);
}

namespace {

/// Data and weights continued past the ends, as windows hold them.
struct ContinuedData {
  std::vector<double> values;
  std::vector<double> weights;
  std::vector<double> unchanged;  // weights without the factors
};

/// At 0, of the fit to these data; orders: none where all are values.
double regression_value(const std::vector<double>& nodes, const std::vector<int>& orders,
                        const std::vector<double>& weights, const double* data, int degree, int derivative) {
  double value = 0;
  const auto add = [&](double scale, const std::vector<double>& polynomial) {
    const auto moment = regression_fit::sum_of<double>(
        nodes.size(), [&](std::size_t i) { return weights[i] * polynomial[i] * data[i]; });
    value += scale * moment;
  };
  if (orders.empty())
    regression_fit::for_terms(nodes, weights, degree, 0.0, derivative, add);
  else
    regression_fit::for_hermite_terms(nodes, orders, weights, degree, 0.0, derivative, add);
  return value;
}

}  // namespace

std::vector<double> LocalSmoother::values(const std::vector<double>& data, const std::vector<double>& factors,
                                          int threads) const {
  const ExtendedData& sites = this->data();
  require(data.size() == sites.count() && factors.size() == sites.count(),
          "smoothing: need {} data and factors, got {} and {}", sites.count(), data.size(), factors.size());
  ContinuedData all;
  for (std::size_t k = 0; k < windows_.count(); ++k) {
    const Combination<double> datum = sites.at<double>(windows_.index(k));
    const bool outside = datum.terms.empty();
    all.values.push_back(outside ? options().constant : data[datum.terms.front().first]);
    all.unchanged.push_back(prior_weight<double>(windows_.index(k)));
    all.weights.push_back(all.unchanged.back() * (outside ? 1 : factors[datum.terms.front().first]));
  }
  const std::vector<std::size_t> made = vertices();
  std::vector<double> result(made.size());
  parallel_ranges(made.size(), made.size() / outputs_per_thread, threads, [&](std::size_t begin, std::size_t end) {
    LocalWindows::Window window;
    std::vector<double> nodes, weights, own;
    std::vector<int> orders;
    for (std::size_t o = begin; o < end; ++o) {
      if (o > begin && repeats(made[o]) && made[o - 1] + 1 == made[o]) {
        result[o] = result[o - 1];
        continue;
      }
      window = windows_.at(rounded_position(made[o]), window);
      require_fit(window);
      const bool weighted = windows_.determines(
          window, [&](std::size_t k) { return all.weights[k] > 0 && windows_.factor(window, k) > 0; });
      windows_.nodes_and_factors(window, nodes, weights);
      const double* const prior = (weighted ? all.weights : all.unchanged).data() + window.first;
      for (std::size_t k = 0; k < weights.size(); ++k) weights[k] *= prior[k];
      const double unit = window.radius > 0 ? window.radius : 1;
      const double* observed = all.values.data() + window.first;
      if (sites.kinds() > 1) {
        own.assign(observed, observed + weights.size());
        orders.resize(weights.size());
        for (std::size_t k = 0; k < weights.size(); ++k) {
          orders[k] = windows_.order(window.first + k);
          own[k] *= std::pow(unit, orders[k]);
          weights[k] /= std::pow(unit, 2 * orders[k]);
        }
        observed = own.data();
      }
      const int order = derivative(made[o]);
      result[o] = regression_value(nodes, orders, weights, observed, method_.degree, order) / std::pow(unit, order);
    }
  });
  return between(made, result);
}

}  // namespace subcert::data
