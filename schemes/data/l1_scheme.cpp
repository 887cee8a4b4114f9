#include "l1_scheme.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <thread>

namespace subcert {
namespace {

void require_sizes(const L1Scheme& scheme) {
  if (scheme.points.empty() || scheme.points.size() > 2)
    throw std::invalid_argument("l1 scheme: need one or two numbers of points, got " +
                                std::to_string(scheme.points.size()));
  for (const int points : scheme.points)
    if (points < 2 || points <= scheme.degree)
      throw std::invalid_argument("l1 scheme: need points >= 2 and points > degree = " +
                                  std::to_string(scheme.degree) + ", got " + std::to_string(points));
}

/// The first datum of a window about 0.
int first_node(int points) { return points % 2 == 0 ? 1 - points / 2 : -(points / 2); }

Rational first_output(int points) { return points % 2 == 0 ? Rational(1, 4) : Rational(-1, 4); }

std::vector<Rational> axis_nodes(int points) {
  std::vector<Rational> nodes;
  for (int i = 0; i < points; ++i) nodes.emplace_back(first_node(points) + i);
  return nodes;
}

std::vector<LatticePoint> product(const std::vector<Rational>& xs, const std::vector<Rational>& ys) {
  std::vector<LatticePoint> points;
  for (const Rational& y : ys)
    for (const Rational& x : xs) points.push_back({x, y});
  return points;
}

/// Where the parts of a window lie in a grid of values.
struct Layout {
  std::size_t windows_x;
  std::size_t windows;
  std::size_t columns;      ///< of the data
  std::size_t out_columns;
  std::vector<std::size_t> node_offsets;
  std::vector<std::size_t> output_offsets;
};

Layout make_layout(const L1Scheme& scheme, const DataGrid& data) {
  const auto p = static_cast<std::size_t>(scheme.points[0]);
  const bool grid = scheme.points.size() == 2;
  const auto q = grid ? static_cast<std::size_t>(scheme.points[1]) : 1;
  Layout layout{data.columns - p + 1, (data.columns - p + 1) * (data.rows - q + 1), data.columns, 2 * (data.columns - p + 1), {}, {}};
  for (std::size_t j = 0; j < q; ++j)
    for (std::size_t i = 0; i < p; ++i) layout.node_offsets.push_back(j * data.columns + i);
  for (std::size_t j = 0; j < (grid ? 2u : 1u); ++j)
    for (std::size_t i = 0; i < 2; ++i) layout.output_offsets.push_back(j * layout.out_columns + i);
  return layout;
}

/// Fits the windows begin, ..., end - 1.
void refine_range(const L1Fitter& fitter, const Layout& layout, const DataGrid& data, std::size_t begin, std::size_t end,
                  std::vector<double>& out) {
  constexpr std::size_t lanes = L1Fitter::lanes;
  const std::size_t dimension = data.dimension;
  const std::size_t joint = fitter.options().joint_residuals ? dimension : 1;  // coordinates fitted in one call
  const std::size_t nodes = layout.node_offsets.size(), outputs = layout.output_offsets.size();
  const bool grid = outputs == 4;
  std::vector<double> in(nodes * joint * lanes), fits(outputs * joint * lanes);
  L1Fitter::Workspace workspace;
  for (std::size_t window = begin; window < end; window += lanes) {
    const std::size_t used = std::min(lanes, end - window);
    std::size_t from[lanes], to[lanes];
    for (std::size_t l = 0; l < lanes; ++l) {
      const std::size_t w = window + std::min(l, used - 1);
      const std::size_t x = w % layout.windows_x, y = w / layout.windows_x;
      from[l] = (y * layout.columns + x) * dimension;
      to[l] = ((grid ? 2 * y : y) * layout.out_columns + 2 * x) * dimension;
    }
    for (std::size_t first = 0; first < dimension; first += joint) {
      for (std::size_t c = 0; c < joint; ++c)
        for (std::size_t i = 0; i < nodes; ++i)
          for (std::size_t l = 0; l < lanes; ++l)
            in[(c * nodes + i) * lanes + l] = data.values[from[l] + layout.node_offsets[i] * dimension + first + c];
      fitter.fit(in.data(), joint, fits.data(), workspace);
      for (std::size_t c = 0; c < joint; ++c)
        for (std::size_t o = 0; o < outputs; ++o)
          for (std::size_t l = 0; l < used; ++l)
            out[to[l] + layout.output_offsets[o] * dimension + first + c] = fits[(c * outputs + o) * lanes + l];
    }
  }
}

/// The parameter of the first output, from the parameter of the first datum.
Rational refined_first(const Rational& first, const Rational& step, int points) {
  return first + step * (first_output(points) - first_node(points));
}

}  // namespace

RegressionWindow l1_window(const L1Scheme& scheme) {
  require_sizes(scheme);
  const auto outputs = [](int points) {
    return std::vector<Rational>{first_output(points), first_output(points) + Rational(1, 2)};
  };
  const int p = scheme.points[0];
  if (scheme.points.size() == 1)
    return {product(axis_nodes(p), {Rational(0)}), scheme.degree, product(outputs(p), {Rational(0)})};
  const int q = scheme.points[1];
  return {product(axis_nodes(p), axis_nodes(q)), scheme.degree, product(outputs(p), outputs(q))};
}

LocalRegression l1_linear_part(const L1Scheme& scheme) {
  require_sizes(scheme);
  if (scheme.points.size() != 1) throw std::invalid_argument("l1_linear_part: need a scheme for curves");
  const int n = scheme.points[0] / 2;
  return scheme.points[0] % 2 == 0 ? dual(n, scheme.degree) : dual_odd(n, scheme.degree);
}

DataGrid l1_refine_complete(const L1Scheme& scheme, const DataGrid& data, int threads) {
  const L1Fitter fitter(l1_window(scheme), scheme.options);
  const bool grid = scheme.points.size() == 2;
  const auto p = static_cast<std::size_t>(scheme.points[0]);
  const auto q = grid ? static_cast<std::size_t>(scheme.points[1]) : 1;
  if (data.columns < p || data.rows < q || (!grid && data.rows != 1))
    throw std::invalid_argument("l1 scheme: need at least " + std::to_string(p) + (grid ? " x " + std::to_string(q) : "") +
                                " data, got " + std::to_string(data.columns) + " x " + std::to_string(data.rows));
  if (data.dimension == 0 || data.values.size() != data.columns * data.rows * data.dimension)
    throw std::invalid_argument("l1 scheme: need columns * rows * dimension values, got " +
                                std::to_string(data.values.size()));
  const Layout layout = make_layout(scheme, data);
  DataGrid result;
  result.columns = layout.out_columns;
  result.rows = grid ? 2 * (data.rows - q + 1) : 1;
  result.dimension = data.dimension;
  result.step = data.step / 2;
  result.first_x = refined_first(data.first_x, data.step, scheme.points[0]);
  result.first_y = grid ? refined_first(data.first_y, data.step, scheme.points[1]) : data.first_y;
  result.values.resize(result.columns * result.rows * result.dimension);

  const auto workers = std::clamp<std::size_t>(static_cast<std::size_t>(std::max(threads, 1)), 1, layout.windows / 4096 + 1);
  const std::size_t share = (layout.windows / workers / L1Fitter::lanes + 1) * L1Fitter::lanes;
  std::vector<std::jthread> team;
  for (std::size_t begin = share; begin < layout.windows; begin += share)
    team.emplace_back([&, begin] {
      refine_range(fitter, layout, data, begin, std::min(begin + share, layout.windows), result.values);
    });
  refine_range(fitter, layout, data, 0, std::min(share, layout.windows), result.values);
  team.clear();  // joins
  return result;
}

DataGrid l1_impulse_response(const L1Scheme& scheme, int level) {
  require_sizes(scheme);
  if (scheme.points.size() != 1) throw std::invalid_argument("l1_impulse_response: need a scheme for curves");
  if (level < 0 || level > 16)
    throw std::invalid_argument("l1_impulse_response: need 0 <= level <= 16, got " + std::to_string(level));
  // The support has width 2 points - 1; the complete windows shrink the data by less than `points` at either end in all.
  const int reach = 2 * scheme.points[0];
  DataGrid data;
  data.columns = static_cast<std::size_t>(2 * reach + 1);
  data.values.assign(data.columns, 0);
  data.values[static_cast<std::size_t>(reach)] = 1;
  data.first_x = -reach;
  for (int k = 0; k < level; ++k) data = l1_refine_complete(scheme, data);
  return data;
}

}  // namespace subcert
