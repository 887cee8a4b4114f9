#include "grid_smoothing.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace subcert::data {
namespace {

/// The factors of `tensor:(A)x(B)`, as they are written.
std::vector<std::string_view> factors_of(std::string_view specification) {
  std::vector<std::string_view> factors;
  std::size_t depth = 0, begin = 0;
  for (std::size_t i = specification.find('('); i < specification.size(); ++i) {
    if (specification[i] == '(' && depth++ == 0) begin = i + 1;
    if (specification[i] == ')' && depth > 0 && --depth == 0) factors.push_back(specification.substr(begin, i - begin));
  }
  return factors;
}

/// What smooths along each axis.
std::vector<SmoothingMethod> methods_along(std::string_view specification, std::size_t axes) {
  if (!specification.starts_with("tensor:"))
    return std::vector<SmoothingMethod>(axes, make_smoothing_method(specification));
  std::vector<SmoothingMethod> methods;
  const std::vector<std::string_view> written = factors_of(specification);
  if (std::ranges::any_of(written, is_local_specification)) {
    for (const std::string_view factor : written) methods.push_back(make_smoothing_method(factor));
  } else {
    const AnyScheme any = make_any_scheme(specification);
    const auto& scheme = std::get<Scheme>(any);
    require(scheme.mask.has_factors(), "{}: need a tensor product", scheme.specification);
    for (const Mask& factor : scheme.mask.factors()) {
      Scheme one = scheme;
      one.mask = LatticeMask(factor);
      one.rules.reset();
      methods.emplace_back(std::move(one));
    }
  }
  require(methods.size() == axes, "{}: need a factor for each of {} axes", specification, axes);
  return methods;
}

/// What the answer calls them.
std::string text_of(const std::vector<SmoothingMethod>& methods) {
  std::string text = to_text(methods.front());
  if (std::ranges::all_of(methods, [&](const SmoothingMethod& one) { return to_text(one) == text; })) return text;
  text.clear();
  for (const SmoothingMethod& one : methods) text += (text.empty() ? "tensor:(" : "x(") + to_text(one) + ")";
  return text;
}

/// A grid that is smoothed along some of its axes.
struct SmoothedAlong {
  GridData<double> data;
  std::vector<double> variances{1};  // of its points along these axes, for noise of variance 1
  double trace = 1;                  // of the map along these, where values stand at the data
  std::vector<double> paths = {};    // SmoothedData::path along each
};

void add_outside(GridData<double>& data, std::size_t k, const std::vector<RoundedRow>& rows, double constant) {
  std::size_t inner = data.dimension;
  for (std::size_t l = 0; l < k; ++l) inner *= data.axes[l].count;
  for (std::size_t i = 0; i < data.values.size(); ++i)
    data.values[i] += rows[i / inner % rows.size()].outside * constant;
}

/// Smooths along axis k, and multiplies variances and trace by those of the rows.
void smooth_along(SmoothedAlong& grid, std::size_t k, const SmoothingMethod& method, const SmoothingOptions& options,
                  int threads) {
  const Axis axis = grid.data.axes[k];
  const std::unique_ptr<LinearSmoother> smoother = make_smoother(Samples{{std::vector<double>(axis.count)}}, method,
                                                                 options);
  if (options.path) grid.paths.push_back(smoother->apply(std::vector<double>(axis.count)).path);
  const std::vector<RoundedRow> rows = smoother->rounded_rows();
  AxisRefinement<double> step{axis, axis, {}, {}, 0, {}};
  step.output.count = rows.size();
  step.output.step = axis.step / Rational(smoother->scale());
  double trace = 0;
  for (std::size_t o = 0; o < rows.size(); ++o) {
    const RoundedRow& row = rows[o];
    WeightRow<double>& one = step.head.emplace_back(WeightRow<double>{{}, row.weights});
    for (std::size_t i = 0; i < row.weights.size(); ++i) {
      one.at.push_back(row.first + i);
      if (row.first + i == o) trace += row.weights[i];
    }
  }
  grid.trace *= trace;
  grid.data = apply_along(grid.data, k, step, threads);
  if (options.boundary == Boundary::constant) add_outside(grid.data, k, rows, options.constant);
  std::vector<double> products;
  products.reserve(grid.variances.size() * rows.size());
  for (const RoundedRow& row : rows)
    for (const double variance : grid.variances) products.push_back(variance * row.variance);
  grid.variances = std::move(products);
}

SmoothedAlong smoothed_along_all(const GridData<double>& grid, const std::vector<SmoothingMethod>& methods,
                                 const SmoothingOptions& options, int threads) {
  SmoothedAlong result{grid};
  for (std::size_t k = 0; k < grid.axes.size(); ++k) smooth_along(result, k, methods[k], options, threads);
  return result;
}

/// The length of a path through all outputs that goes along one axis after another, to and fro: along this axis it
/// turns as the rows of the axis do. The shortest over the orders of the axes.
double path_through(const std::vector<Axis>& axes, const std::vector<double>& paths) {
  std::vector<std::size_t> order(axes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  double least = std::numeric_limits<double>::infinity();
  do {
    double length = 0;
    for (const std::size_t k : order) length = length * static_cast<double>(axes[k].count) + paths[k];
    least = std::min(least, length);
  } while (std::ranges::next_permutation(order).found);
  return least;
}

}  // namespace

std::vector<NoiseEstimate> estimate_noise(const GridData<double>& grid) {
  GridData<double> residuals = grid;
  double degrees = 1;
  bool differences = false;
  for (std::size_t k = 0; k < grid.axes.size(); ++k) {
    const std::size_t count = grid.axes[k].count;
    if (count < 3) {  // residuals at its data are independent
      degrees *= static_cast<double>(count);
      continue;
    }
    differences = true;
    degrees *= estimate_noise(std::vector<double>(count)).degrees_of_freedom;
    AxisRefinement<double> step{grid.axes[k], grid.axes[k], {}, {}, 0, {}};
    step.output.count = count - 2;
    const double norm = 1 / std::sqrt(1.5);
    for (std::size_t i = 0; i + 2 < count; ++i)
      step.head.push_back({{i, i + 1, i + 2}, {0.5 * norm, -norm, 0.5 * norm}});
    residuals = apply_along(residuals, k, step);
  }
  std::vector<NoiseEstimate> noise(grid.dimension);
  if (!differences) return noise;
  const std::size_t terms = residuals.points();
  for (std::size_t i = 0; i < residuals.values.size(); ++i)
    noise[i % grid.dimension].variance += residuals.values[i] * residuals.values[i] / static_cast<double>(terms);
  for (NoiseEstimate& one : noise) one = {one.variance, degrees, terms};
  return noise;
}

namespace {

constexpr std::size_t widest_window = 64;  // of the choice
constexpr double far_from_best = 4;        // where wider windows are not tried any more

/// Tries local polynomials on a grid.
class GridChoice {
 public:
  GridChoice(const GridData<double>& grid, const SmoothingOptions& options, const std::vector<NoiseEstimate>& noise,
             int threads)
      : grid_(grid),
        options_{options.boundary, 0, 0, options.constant, true, false},
        noise_(noise),
        threads_(threads) {}

  void try_degree(int degree) {
    std::vector<std::size_t> best;
    double least = std::numeric_limits<double>::infinity();
    const std::size_t first = static_cast<std::size_t>(degree) + 3;  // the farthest data do not count
    for (std::size_t points = first;; points = next_points(points)) {
      std::vector<std::size_t> sizes;
      for (std::size_t k = 0; k < grid_.axes.size(); ++k) sizes.push_back(std::min(points, widest(k)));
      const double error = error_of(degree, sizes);
      if (error < least) best = sizes;
      least = std::min(least, error);
      if (points >= widest_along_any() || (least > 0 && error > far_from_best * least)) break;
    }
    for (bool better = true; better;) {
      better = false;
      for (std::size_t k = 0; k < best.size(); ++k)
        for (const std::size_t other : {smaller(best[k]), next_points(best[k])}) {
          std::vector<std::size_t> sizes = best;
          sizes[k] = std::min(std::max(other, std::min(first, widest(k))), widest(k));
          const double error = error_of(degree, sizes);
          if (!(error < least)) continue;
          best = sizes;
          least = error;
          better = true;
        }
    }
  }

  std::vector<SmoothingCandidate> candidates() const {
    std::vector<SmoothingCandidate> result;
    for (const auto& [text, candidate] : tried_) result.push_back(candidate);
    return result;
  }

 private:
  std::size_t widest(std::size_t k) const { return std::min(widest_window, grid_.axes[k].count); }
  std::size_t widest_along_any() const {
    std::size_t result = 0;
    for (std::size_t k = 0; k < grid_.axes.size(); ++k) result = std::max(result, widest(k));
    return result;
  }
  /// The number before this one.
  static std::size_t smaller(std::size_t points) {
    std::size_t before = points - 1;
    while (before > 1 && next_points(before) > points) --before;
    return before;
  }

  /// Of windows of these sizes, infinite where they leave no fit; along axes of one or two data these are
  /// interpolated.
  double error_of(int degree, const std::vector<std::size_t>& sizes) {
    std::vector<SmoothingMethod> methods;
    for (const std::size_t size : sizes)
      if (size < 3)
        methods.push_back(make_smoothing_method("primal:n=1"));
      else
        methods.emplace_back(LocalPolynomial{std::min(degree, static_cast<int>(size) - 3), LocalWeight::tricube, size});
    const std::string text = text_of(methods);
    if (const auto before = tried_.find(text); before != tried_.end()) return before->second.risk.total();
    std::vector<SmoothingCandidate> one;
    if (!add_candidate(one, {std::ranges::max(sizes), degree, text, {}}, [&] { return risk_of(methods); }))
      return std::numeric_limits<double>::infinity();
    return tried_.emplace(text, std::move(one.front())).first->second.risk.total();
  }

  RiskEstimate risk_of(const std::vector<SmoothingMethod>& methods) const {
    const SmoothedAlong smoothed = smoothed_along_all(grid_, methods, options_, threads_);
    double residuals = 0, variances = 0, noise = 0;
    for (std::size_t i = 0; i < grid_.values.size(); ++i) {
      const double residual = grid_.values[i] - smoothed.data.values[i];
      residuals += residual * residual;
    }
    for (const double variance : smoothed.variances) variances += variance;
    for (const NoiseEstimate& one : noise_) noise += one.variance;
    // As in estimate_risk(): E sum r^2 = sum bias^2 + sigma^2 (count - 2 trace + sum of variances).
    const auto count = static_cast<double>(grid_.points());
    return {(residuals - noise * (count - 2 * smoothed.trace + variances)) / count, noise * variances / count};
  }

  const GridData<double>& grid_;
  SmoothingOptions options_;
  const std::vector<NoiseEstimate>& noise_;
  int threads_;
  std::map<std::string, SmoothingCandidate> tried_;
};

}  // namespace

MethodChoice choose_grid_method(const GridData<double>& grid, const SmoothingOptions& options,
                                const std::vector<NoiseEstimate>& noise, int threads) {
  require(noise.size() == grid.dimension, "choose_grid_method: need {} estimates of noise, got {}", grid.dimension,
          noise.size());
  for (const NoiseEstimate& one : noise)
    if (!one.exists())
      fail(ErrorKind::data, "expected three data along an axis to choose a scheme; found fewer; name a scheme");
  GridChoice choice(grid, options, noise, threads);
  for (const int degree : {1, 3}) choice.try_degree(degree);
  std::vector<SmoothingCandidate> candidates = ranked(choice.candidates());
  raise_biases(candidates);
  std::size_t longest = 0;
  for (const Axis& axis : grid.axes) longest = std::max(longest, axis.count);
  SmoothingMethod along_first = methods_along(candidates.front().specification, grid.axes.size()).front();
  return {std::move(along_first), std::move(candidates), longest};
}

SmoothedGrid smooth_grid(const GridData<double>& grid, std::string_view specification, const SmoothingOptions& options,
                         const std::optional<double>& noise, int threads) {
  require(grid.is_canonical(), "smooth_grid: need as many values as points times numbers");
  require(options.derivative == 0, "smooth_grid: need derivative 0, got {}", options.derivative);
  const std::vector<NoiseEstimate> estimates = noise ? std::vector(grid.dimension, known_noise(*noise))
                                                     : estimate_noise(grid);
  SmoothedGrid result;
  if (specification.empty()) result.choice = choose_grid_method(grid, options, estimates, threads);
  const std::string_view chosen = result.choice ? result.choice->candidates.front().specification : specification;
  const std::vector<SmoothingMethod> methods = methods_along(chosen, grid.axes.size());
  const SmoothedAlong smoothed = smoothed_along_all(grid, methods, options, threads);
  result.method = specification.starts_with("tensor:") ? std::string(specification) : text_of(methods);
  result.axes = smoothed.data.axes;
  for (std::size_t c = 0; c < grid.dimension; ++c) {
    SmoothedColumn& column = result.columns.emplace_back(SmoothedColumn{{}, estimates[c]});
    for (std::size_t i = 0; i < smoothed.variances.size(); ++i) {
      column.values.push_back(smoothed.data.values[i * grid.dimension + c]);
      if (estimates[c].exists()) column.deviations.push_back(std::sqrt(estimates[c].variance * smoothed.variances[i]));
    }
    if (options.path) column.path = path_through(result.axes, smoothed.paths);
  }
  return result;
}

}  // namespace subcert::data
