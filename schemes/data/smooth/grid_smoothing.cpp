#include "grid_smoothing.hpp"

#include "grid_holes.hpp"

#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>

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
  std::vector<double> leverages{1};  // likewise, where values stand at the data
  std::vector<double> paths = {};    // SmoothedData::path along each
};

/// Where a number of a point is missing.
GridHoles holes_of(const GridData<double>& grid) {
  GridHoles holes;
  for (std::size_t k = 0; k < grid.axes.size(); ++k) holes.counts[k] = grid.axes[k].count;
  for (std::size_t i = 0; i < grid.values.size(); ++i) {
    if (!std::isnan(grid.values[i])) continue;
    holes.missing.resize(grid.points());
    holes.missing[i / grid.dimension] = true;
  }
  return holes;
}

/// This value for all numbers of missing points.
GridData<double> with_missing(GridData<double> grid, const GridHoles& holes, double value) {
  if (holes.any())
    for (std::size_t i = 0; i < grid.values.size(); ++i)
      if (holes.missing[i / grid.dimension]) grid.values[i] = value;
  return grid;
}

/// [b * first.size() + a] = first[a] * second[b].
std::vector<double> products(const std::vector<double>& first, const std::vector<double>& second) {
  std::vector<double> result;
  result.reserve(first.size() * second.size());
  for (const double b : second)
    for (const double a : first) result.push_back(a * b);
  return result;
}

void add_outside(GridData<double>& data, std::size_t k, const std::vector<RoundedRow>& rows, double constant) {
  std::size_t inner = data.dimension;
  for (std::size_t l = 0; l < k; ++l) inner *= data.axes[l].count;
  for (std::size_t i = 0; i < data.values.size(); ++i)
    data.values[i] += rows[i / inner % rows.size()].outside * constant;
}

/// Smooths along axis k, and multiplies variances and leverages by those of the rows.
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
  std::vector<double> variances, leverages(rows.size());
  for (std::size_t o = 0; o < rows.size(); ++o) {
    const RoundedRow& row = rows[o];
    WeightRow<double>& one = step.head.emplace_back(WeightRow<double>{{}, row.weights});
    for (std::size_t i = 0; i < row.weights.size(); ++i) {
      one.at.push_back(row.first + i);
      if (row.first + i == o) leverages[o] = row.weights[i];
    }
    variances.push_back(row.variance);
  }
  grid.data = apply_along(grid.data, k, step, threads);
  if (options.boundary == Boundary::constant) add_outside(grid.data, k, rows, options.constant);
  grid.variances = products(grid.variances, variances);
  if (options.at_data) grid.leverages = products(grid.leverages, leverages);
}

/// Makes the outputs anew whose windows hold missing data: NaN where those that are left determine no fit.
void fit_holes(SmoothedAlong& result, const GridData<double>& grid, const GridHoles& holes,
               const std::vector<SmoothingMethod>& methods, const SmoothingOptions& options, int threads) {
  std::array<std::vector<LocalBasis>, 3> along;
  along.fill({trivial_basis()});
  for (std::size_t k = 0; k < methods.size(); ++k) {
    const auto* local = std::get_if<LocalPolynomial>(&methods[k]);
    if (!local)
      fail(ErrorKind::domain, "missing data need local polynomials, as local:points=7,d=1; {} is a scheme",
           to_text(methods[k]));
    along[k] = LocalSmoother(*local, grid.axes[k].count, options).bases();
  }
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  fit_around_holes(holes, along, threads, [&](const GridRow& row) {
    result.variances[row.output] = row.known ? row.variance : unknown;
    for (std::size_t c = 0; c < grid.dimension; ++c) {
      double value = row.known ? row.outside * options.constant : unknown;
      for (const auto& [point, weight] : row.terms) value += weight * grid.values[point * grid.dimension + c];
      result.data.values[row.output * grid.dimension + c] = value;
    }
    if (!options.at_data) return;
    double& leverage = result.leverages[row.output] = 0;
    for (const auto& [point, weight] : row.terms) leverage += point == row.output ? weight : 0;
  });
}

/// Takes out the outputs of the cells, or of the sides of these, that a missing point ends.
void keep_holes(SmoothedAlong& result, const GridHoles& holes) {
  std::array<std::vector<std::pair<std::size_t, std::size_t>>, 3> between;  // the data about an output
  between.fill({{0, 0}});
  for (std::size_t k = 0; k < result.data.axes.size(); ++k) {
    between[k].clear();
    for (std::size_t i = 0; i < result.data.axes[k].count; ++i) {
      const Rational at = result.data.axes[k].parameter(i);
      between[k].emplace_back(static_cast<std::size_t>(floor_index(at)), static_cast<std::size_t>(ceil_index(at)));
    }
  }
  std::size_t output = 0;
  for (const auto& z : between[2])
    for (const auto& y : between[1])
      for (const auto& x : between[0]) {
        bool missing = false;
        for (const std::size_t k : {z.first, z.second})
          for (const std::size_t j : {y.first, y.second})
            for (const std::size_t i : {x.first, x.second}) missing = missing || holes.at(i, j, k);
        if (missing) {
          result.variances[output] = std::numeric_limits<double>::quiet_NaN();
          std::fill_n(result.data.values.begin() + static_cast<std::ptrdiff_t>(output * result.data.dimension),
                      result.data.dimension, result.variances[output]);
        }
        ++output;
      }
}

SmoothedAlong smoothed_along_all(const GridData<double>& grid, const GridHoles& holes,
                                 const std::vector<SmoothingMethod>& methods, const SmoothingOptions& options,
                                 int threads) {
  SmoothedAlong result{with_missing(grid, holes, 0)};
  for (std::size_t k = 0; k < grid.axes.size(); ++k) smooth_along(result, k, methods[k], options, threads);
  if (holes.any()) fit_holes(result, grid, holes, methods, options, threads);
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

/// How many residuals of second differences along the axes there are, and their degrees of freedom: the square of that
/// number over the sum of the squares of all correlations, products of 1, -2/3 and 1/6 along an axis of three data.
std::pair<std::size_t, double> terms_between_holes(const GridData<double>& residuals, const GridData<double>& grid) {
  const GridHoles holes = holes_of(residuals);
  const auto& counts = holes.counts;
  const auto is_there = [&](std::size_t i, std::size_t j, std::size_t k) { return !holes.any() || !holes.at(i, j, k); };
  std::array<std::size_t, 3> lags{1, 1, 1};
  for (std::size_t axis = 0; axis < grid.axes.size(); ++axis)
    if (grid.axes[axis].count >= 3) lags[axis] = 3;
  constexpr std::array<double, 3> squares{1, 4.0 / 9, 1.0 / 36};
  std::size_t terms = 0;
  double correlations = 0;
  const auto along = [&](std::size_t axis, std::size_t at, const auto& take) {
    for (std::size_t lag = 0; lag < lags[axis]; ++lag) {
      if (at + lag < counts[axis]) take(at + lag, squares[lag]);
      if (lag > 0 && at >= lag) take(at - lag, squares[lag]);
    }
  };
  for (std::size_t k = 0; k < counts[2]; ++k)
    for (std::size_t j = 0; j < counts[1]; ++j)
      for (std::size_t i = 0; i < counts[0]; ++i) {
        if (!is_there(i, j, k)) continue;
        ++terms;
        along(2, k, [&](std::size_t c, double z) {
          along(1, j, [&](std::size_t b, double y) {
            along(0, i, [&](std::size_t a, double x) { correlations += is_there(a, b, c) ? x * y * z : 0; });
          });
        });
      }
  const auto number = static_cast<double>(terms);
  return {terms, terms == 0 ? 0 : number * number / correlations};
}

}  // namespace

std::vector<NoiseEstimate> estimate_noise(const GridData<double>& grid) {
  const GridHoles holes = holes_of(grid);
  GridData<double> residuals = with_missing(grid, holes, std::numeric_limits<double>::quiet_NaN());
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
  std::size_t terms = residuals.points();
  if (holes.any()) std::tie(terms, degrees) = terms_between_holes(residuals, grid);
  if (terms == 0) return noise;
  for (std::size_t i = 0; i < residuals.values.size(); ++i)
    if (!std::isnan(residuals.values[i]))
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
        holes_(holes_of(grid)),
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
      if (size < 3 && holes_.any())
        methods.emplace_back(LocalPolynomial{static_cast<int>(size) - 1, LocalWeight::box, size});
      else if (size < 3)
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
    const SmoothedAlong smoothed = smoothed_along_all(grid_, holes_, methods, options_, threads_);
    const auto is_there = [&](std::size_t point) { return !holes_.any() || !holes_.missing[point]; };
    double residuals = 0, variances = 0, noise = 0, trace = 0, count = 0;
    for (std::size_t i = 0; i < grid_.values.size(); ++i) {
      if (!is_there(i / grid_.dimension)) continue;
      const double residual = grid_.values[i] - smoothed.data.values[i];
      residuals += residual * residual;
    }
    for (std::size_t i = 0; i < smoothed.variances.size(); ++i) {
      if (!is_there(i)) continue;
      variances += smoothed.variances[i];
      trace += smoothed.leverages[i];
      ++count;
    }
    if (!std::isfinite(residuals)) fail(ErrorKind::data, "smoothing: too few data about a missing one");
    for (const NoiseEstimate& one : noise_) noise += one.variance;
    // As in estimate_risk(): E sum r^2 = sum bias^2 + sigma^2 (count - 2 trace + sum of variances).
    return {(residuals - noise * (count - 2 * trace + variances)) / count, noise * variances / count};
  }

  const GridData<double>& grid_;
  GridHoles holes_;
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
  require(options.derivative == 0 && options.places.empty(), "smooth_grid: need derivative 0, and no places");
  const GridHoles holes = holes_of(grid);
  require(!holes.any() || !options.path, "smoothing: bands at all positions at once need a grid without missing data");
  if (holes.any() && std::ranges::count(holes.missing, false) == 0)
    fail(ErrorKind::data, "expected a point that is not missing; found none");
  const std::vector<NoiseEstimate> estimates = noise ? std::vector(grid.dimension, known_noise(*noise))
                                                     : estimate_noise(grid);
  SmoothedGrid result;
  if (specification.empty()) result.choice = choose_grid_method(grid, options, estimates, threads);
  const std::string_view chosen = result.choice ? result.choice->candidates.front().specification : specification;
  const std::vector<SmoothingMethod> methods = methods_along(chosen, grid.axes.size());
  SmoothedAlong smoothed = smoothed_along_all(grid, holes, methods, options, threads);
  result.missing = static_cast<std::size_t>(std::ranges::count(holes.missing, true));
  result.unknown = static_cast<std::size_t>(
      std::ranges::count_if(smoothed.variances, [](double variance) { return std::isnan(variance); }));
  if (holes.any() && options.keep_holes) keep_holes(smoothed, holes);
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
