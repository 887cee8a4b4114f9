#include "local_polynomial.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/data/formats/table.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>
#include <subcert/schemes/local_regression.hpp>
#include <subcert/schemes/specification_text.hpp>

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace subcert::data {
namespace {

using specification_text::fail;
using specification_text::Fields;
using specification_text::Piece;
using specification_text::read_integer;

constexpr std::string_view family_name = "local";
constexpr long most_points = 10'000;

const std::vector<std::string>& weight_names() {
  static const std::vector<std::string> names{"box", "triangle", "epanechnikov", "biweight", "tricube"};
  return names;
}

std::string usage() {
  return fmt::format("local:points=21,d=1,weight=tricube; or width=0.5 in place of points, or neither; weight is {}",
                     fmt::join(weight_names(), ", "));
}

template <class Number>
Number weight_at(LocalWeight weight, const Number& u) {
  Number one = 1;
  switch (weight) {
    case LocalWeight::box: return one;
    case LocalWeight::triangle: return one - u;
    case LocalWeight::epanechnikov: return one - u * u;
    case LocalWeight::biweight: {
      const Number root = one - u * u;
      return root * root;
    }
    case LocalWeight::tricube: break;
  }
  const Number root = one - u * u * u;
  return root * root * root;
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
  return text + fmt::format("d={},weight={}", method.degree, weight_names()[static_cast<std::size_t>(method.weight)]);
}

bool is_local_specification(std::string_view specification) {
  return specification.substr(0, specification.find(':')) == family_name;
}

LocalPolynomial make_local_polynomial(std::string_view specification) {
  const std::size_t colon = std::min(specification.find(':'), specification.size());
  const Piece family{specification.substr(0, colon), 0};
  if (family.text != family_name) fail(family, "the family local, as in " + usage());
  const std::size_t body = std::min(colon + 1, specification.size());
  Fields fields(family, {specification.substr(body), body}, usage());
  LocalPolynomial method;
  if (const auto piece = fields.optional("d")) method.degree = static_cast<int>(read_integer(*piece, "d", 0, 20));
  if (const auto piece = fields.optional("points"))
    method.points = static_cast<std::size_t>(read_integer(*piece, "points", method.degree + 1, most_points));
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
  fields.finish();
  return method;
}

LocalSmoother::LocalSmoother(const LocalPolynomial& method, DataSites sites, const SmoothingOptions& options)
    : LinearSmoother({options.boundary, 1, 0}, std::move(sites), options, std::size_t{1} << options.level,
                     reach_of(method)),
      method_(method) {
  require(method.is_complete(), "smoothing: need points or a width for local polynomials");
  require(options.derivative <= method.degree, "derivative {}: polynomials of degree {} have none", options.derivative,
          method.degree);
  repeated_ = std::ranges::adjacent_find(data().sites().positions) != data().sites().positions.end();
  std::size_t present = 0;
  for (std::size_t i = 0; i < data().count(); ++i) present += data().is_present(static_cast<long>(i)) ? 1 : 0;
  if (method.points > present)
    fail(ErrorKind::data, "expected at least {} data for {}; found {}", method.points, to_text(method), present);
}

LocalSmoother::Window LocalSmoother::window_at(double position) const {
  const bool ends = options().boundary == Boundary::regression;
  constexpr double none = std::numeric_limits<double>::infinity();
  const auto distance = [&](long index) {
    return ends && !data().is_inside(index) ? none : std::abs(data().position(index) - position);
  };
  const auto start = static_cast<long>(std::floor(data().index_at(position)));
  Window window{position, start + 1, start, method_.width};  // empty
  double left = distance(window.first - 1), right = distance(window.last + 1);
  const auto take_nearer = [&] {
    const bool before = left <= right;
    const long taken = before ? --window.first : ++window.last;
    (before ? left : right) = distance(before ? taken - 1 : taken + 1);
    return taken;
  };
  if (method_.points > 0) {
    window.radius = 0;
    for (std::size_t found = 0; found < method_.points;) {
      const double nearer = std::min(left, right);
      if (data().is_present(take_nearer())) {
        ++found;
        window.radius = nearer;
      }
    }
  }
  while (std::min(left, right) <= window.radius) take_nearer();
  // Data at one position are one condition on the polynomial: then the window grows until it has enough others.
  while (repeated_ && method_.points > 0 && !determines(window) && std::min(left, right) < none) {
    window.radius = std::min(left, right);
    while (std::min(left, right) <= window.radius) take_nearer();
  }
  return window;
}

bool LocalSmoother::determines(const Window& window) const {
  int different = 0;
  double last = std::numeric_limits<double>::quiet_NaN();
  for (long index = window.first; index <= window.last && different <= method_.degree; ++index)
    if (const double at = data().position(index); at != last && weight_of<double>(window, index) > 0) {
      last = at;
      ++different;
    }
  return different > method_.degree;
}

template <class Number>
Number LocalSmoother::weight_of(const Window& window, long index) const {
  Number prior = prior_weight<Number>(index);
  if (prior == 0 || window.radius == 0 || method_.weight == LocalWeight::box) return prior;
  const Number apart = Number(data().position(index)) - Number(window.position);
  Number u = (apart < 0 ? Number(-apart) : apart) / Number(window.radius);
  return u < 1 ? Number(prior * weight_at(method_.weight, u)) : Number(0);
}

template <class Number>
std::pair<std::vector<long>, std::vector<Number>> LocalSmoother::fitted_data(const Window& window) const {
  std::pair<std::vector<long>, std::vector<Number>> result;
  for (long index = window.first; index <= window.last; ++index)
    if (Number weight = weight_of<Number>(window, index); weight > 0) {
      result.first.push_back(index);
      result.second.push_back(std::move(weight));
    }
  const auto needed = static_cast<std::size_t>(method_.degree) + 1;
  if (result.first.size() < needed || (repeated_ && !determines(window)))
    fail(ErrorKind::data, "smoothing: {} data{} count at {} spacings from the first, a fit of degree {} needs {}",
         result.first.size(), repeated_ ? " at too few positions" : "",
         window.position + static_cast<double>(data().sites().before), method_.degree, needed);
  return result;
}

template <class Number>
class LocalSmoother::Rows : public RowMaker<Number> {
 public:
  explicit Rows(const LocalSmoother& smoother) : smoother_(smoother) {}

  RowOf<Number> row(std::size_t output) override {
    const ExtendedData& data = smoother_.data();
    const Rational at = smoother_.position(output);
    const Window window = smoother_.window_at(static_cast<double>(at));
    const auto [indices, weights] = smoother_.fitted_data<Number>(window);
    // In units of the radius, so that no power leaves the doubles.
    const Number origin = static_cast<Number>(at), unit(window.radius > 0 ? window.radius : 1);
    std::vector<Number> nodes;
    for (const long index : indices) nodes.push_back((Number(data.position(index)) - origin) / unit);
    const int derivative = smoother_.options().derivative;
    const std::vector<Number> fit = regression_weights(nodes, weights, smoother_.method_.degree, 0, derivative);
    Number scale = 1;
    for (int k = 0; k < derivative; ++k) scale /= unit;
    Combination<Number> sum;
    for (std::size_t k = 0; k < fit.size(); ++k) sum.add(data, indices[k], scale * fit[k]);
    return smoother_.to_row<Number>({{&sum, 1}});
  }

 private:
  const LocalSmoother& smoother_;
};

SmoothingRow LocalSmoother::row(std::size_t output) const { return Rows<Rational>(*this).row(output); }

std::unique_ptr<LinearSmoother::RowMaker<double>> LocalSmoother::row_maker() const {
  return std::make_unique<Rows<double>>(*this);
}

}  // namespace subcert::data
