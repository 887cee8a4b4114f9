#include "l1_refinement.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/symbol/index_arithmetic.hpp>
#include <subcert/analysis/symbol/parallel.hpp>

#include <algorithm>

namespace subcert::data {
namespace {

void require_sizes(const L1Scheme& scheme) {
  if (scheme.points.empty() || scheme.points.size() > 2)
    fail(ErrorKind::domain, "l1 scheme: need one or two numbers of points, got {}", scheme.points.size());
  for (const int points : scheme.points)
    if (points < 2 || points <= scheme.degree)
      fail(ErrorKind::domain, "l1 scheme: need points >= 2 and points > degree = {}, got {}", scheme.degree, points);
}

/// The first datum of a window about 0.
long first_node(int points) { return points % 2 == 0 ? 1 - points / 2 : -(points / 2); }

/// Where output `phase` of a window about 0 stands.
Rational output_at(int points, long phase) {
  return (points % 2 == 0 ? Rational(1, 4) : Rational(-1, 4)) + Rational(phase, 2);
}

std::vector<LatticePoint> product(const std::vector<Rational>& xs, const std::vector<Rational>& ys) {
  std::vector<LatticePoint> points;
  for (const Rational& y : ys)
    for (const Rational& x : xs) points.push_back({x, y});
  return points;
}

/// Consecutive windows whose outputs stand alike: window k begins at datum start + k and makes the outputs
/// out + k * outputs, ..., the first of them at (first_output + o) / 2 + output_at(0) from the datum at which it
/// begins.
struct WindowClass {
  long start;
  std::size_t windows;
  std::size_t out;
  std::size_t outputs;
  long first_output;
};

/// One axis of a refinement: which data are read, which windows are fitted, what they make.
struct AxisPlan {
  Axis output;
  std::vector<std::size_t> sources;  ///< the datum that each place of the padded data repeats
  std::vector<WindowClass> classes;  ///< with starts in the padded data
};

/// The outputs begin, ..., end - 1 of an axis; output 2w + phase stands at w + output_at(phase) of the data.
std::pair<long, long> output_range(const Axis& axis, int points, Boundary boundary) {
  const auto count = static_cast<long>(axis.count);
  if (!axis.closed && boundary == Boundary::shrink)
    return {-2 * first_node(points), 2 * (count - points - first_node(points) + 1)};
  const Rational origin = output_at(points, 0);
  const long begin = ceil_index(2 * (-axis.first / axis.step - origin));
  if (axis.closed) return {begin, begin + 2 * count};
  return {begin, floor_index(2 * ((axis.length - axis.first) / axis.step - origin)) + 1};
}

/// The datum at index j, inside or outside of open or closed data.
std::size_t source_of(long j, const Axis& axis) {
  const auto count = static_cast<long>(axis.count);
  if (j >= 0 && j < count) return static_cast<std::size_t>(j);
  if (axis.closed) return static_cast<std::size_t>(modulo(j, count));
  const long twice_low = floor_index(-2 * axis.first / axis.step);
  const long twice_high = floor_index(2 * (axis.length - axis.first) / axis.step);
  while (j < 0 || j >= count) j = (j < 0 ? twice_low : twice_high) - j;
  return static_cast<std::size_t>(j);
}

AxisPlan plan_axis(Axis axis, int points, Boundary boundary) {
  require_refinement_boundary(boundary);
  if (boundary == Boundary::periodic) axis.close();
  require(axis.count >= static_cast<std::size_t>(points), "refine: need at least {} points, got {}", points,
          axis.count);
  const auto [begin, end] = output_range(axis, points, boundary);
  const long last_start = static_cast<long>(axis.count) - points;
  const bool clamp = !axis.closed && boundary == Boundary::regression;
  AxisPlan plan{axis, {}, {}};
  const auto start_of = [&](long output) {
    const long natural = floor_divide(output, 2) + first_node(points);
    return clamp ? std::clamp(natural, 0L, last_start) : natural;
  };
  for (long o = begin; o < end;) {
    const long start = start_of(o);
    long next = o + 1;
    while (next < end && start_of(next) == start) ++next;
    plan.classes.push_back(
        {start, 1, static_cast<std::size_t>(o - begin), static_cast<std::size_t>(next - o), o - 2 * start});
    // Whole windows like this one follow each other, up to the last that is not clamped.
    if (next - o == 2 && o - 2 * start == -2 * first_node(points)) {
      const long more = std::min((end - next) / 2, clamp ? last_start - 1 - start : end);
      if (more > 0) {
        plan.classes.back().windows += static_cast<std::size_t>(more);
        next += 2 * more;
      }
    }
    o = next;
  }
  const WindowClass& back = plan.classes.back();
  const long low = std::min(0L, plan.classes.front().start);
  const long high = std::max(last_start, back.start + static_cast<long>(back.windows) - 1);
  for (long j = low; j < high + points; ++j) plan.sources.push_back(source_of(j, axis));
  for (WindowClass& c : plan.classes) c.start -= low;
  plan.output.count = static_cast<std::size_t>(end - begin);
  plan.output.first = axis.first + axis.step * (Rational(begin) / 2 + output_at(points, 0));
  plan.output.step = axis.step / 2;
  return plan;
}

/// One window class along each axis, and where its parts lie in the padded data and in the output.
struct Job {
  L1Fitter fitter;
  const WindowClass* x;
  const WindowClass* y;
  std::vector<std::size_t> node_offsets;
  std::vector<std::size_t> output_offsets;
};

struct Sizes {
  std::size_t columns;  ///< of the padded data
  std::size_t out_columns;
  std::size_t dimension;
};

std::vector<Rational> integers(std::size_t count) {
  std::vector<Rational> result;
  for (std::size_t i = 0; i < count; ++i) result.emplace_back(i);
  return result;
}

/// The outputs of a class, from the datum at which a window begins.
std::vector<Rational> positions(const WindowClass& windows, int points) {
  std::vector<Rational> result;
  for (std::size_t o = 0; o < windows.outputs; ++o)
    result.push_back(Rational(windows.first_output + static_cast<long>(o)) / 2 + output_at(points, 0));
  return result;
}

Job make_job(const L1Scheme& scheme, const WindowClass& x, const WindowClass& y, const Sizes& sizes) {
  const bool grid = scheme.points.size() == 2;
  const auto p = static_cast<std::size_t>(scheme.points[0]), q = grid ? static_cast<std::size_t>(scheme.points[1]) : 1;
  const RegressionWindow window(
      product(integers(p), integers(q)), scheme.degree,
      product(positions(x, scheme.points[0]), grid ? positions(y, scheme.points[1]) : integers(1)));
  Job job{L1Fitter(window, scheme.options), &x, &y, {}, {}};
  for (std::size_t j = 0; j < q; ++j)
    for (std::size_t i = 0; i < p; ++i) job.node_offsets.push_back((j * sizes.columns + i) * sizes.dimension);
  for (std::size_t j = 0; j < y.outputs; ++j)
    for (std::size_t i = 0; i < x.outputs; ++i)
      job.output_offsets.push_back((j * sizes.out_columns + i) * sizes.dimension);
  return job;
}

/// Fits the windows begin, ..., end - 1 of a job.
void fit_range(const Job& job, const Sizes& sizes, const std::vector<double>& data, std::size_t begin, std::size_t end,
               std::vector<double>& out) {
  constexpr std::size_t lanes = L1Fitter::lanes;
  const std::size_t joint = job.fitter.options().joint_residuals ? sizes.dimension : 1;  // coordinates in one call
  const std::size_t nodes = job.node_offsets.size(), outputs = job.output_offsets.size();
  std::vector<double> in(nodes * joint * lanes), fits(outputs * joint * lanes);
  L1Fitter::Workspace workspace;
  for (std::size_t window = begin; window < end; window += lanes) {
    const std::size_t used = std::min(lanes, end - window);
    std::size_t from[lanes], to[lanes];
    for (std::size_t l = 0; l < lanes; ++l) {
      const std::size_t w = window + std::min(l, used - 1);
      const std::size_t x = w % job.x->windows, y = w / job.x->windows;
      from[l] = ((static_cast<std::size_t>(job.y->start) + y) * sizes.columns + static_cast<std::size_t>(job.x->start) +
                 x) *
                sizes.dimension;
      to[l] = ((job.y->out + y * job.y->outputs) * sizes.out_columns + job.x->out + x * job.x->outputs) *
              sizes.dimension;
    }
    for (std::size_t first = 0; first < sizes.dimension; first += joint) {
      for (std::size_t c = 0; c < joint; ++c)
        for (std::size_t i = 0; i < nodes; ++i)
          for (std::size_t l = 0; l < lanes; ++l)
            in[(c * nodes + i) * lanes + l] = data[from[l] + job.node_offsets[i] + first + c];
      job.fitter.fit(in.data(), joint, fits.data(), workspace);
      for (std::size_t c = 0; c < joint; ++c)
        for (std::size_t o = 0; o < outputs; ++o)
          for (std::size_t l = 0; l < used; ++l)
            out[to[l] + job.output_offsets[o] + first + c] = fits[(c * outputs + o) * lanes + l];
    }
  }
}

constexpr std::size_t windows_per_thread = 4096;

void run_job(const Job& job, const Sizes& sizes, const std::vector<double>& data, int threads,
             std::vector<double>& out) {
  const std::size_t windows = job.x->windows * job.y->windows;
  constexpr std::size_t lanes = L1Fitter::lanes;
  parallel_ranges((windows + lanes - 1) / lanes, windows / windows_per_thread, threads,
                  [&](std::size_t begin, std::size_t end) {
                    fit_range(job, sizes, data, begin * lanes, std::min(end * lanes, windows), out);
                  });
}

/// The data with the places that windows read beyond the ends.
std::vector<double> padded(const GridData<double>& data, const AxisPlan& x, const AxisPlan& y) {
  std::vector<double> result;
  result.reserve(x.sources.size() * y.sources.size() * data.dimension);
  for (const std::size_t j : y.sources)
    for (const std::size_t i : x.sources) {
      const double* point = data.values.data() + (j * data.axes[0].count + i) * data.dimension;
      result.insert(result.end(), point, point + data.dimension);
    }
  return result;
}

/// A curve is a grid with one row that no window passes.
const AxisPlan single_row{Axis::of(1), {0}, {{0, 1, 0, 1, 0}}};

GridData<double> refine_once(const GridData<double>& data, const L1Scheme& scheme, const RefineOptions& options) {
  const AxisPlan x = plan_axis(data.axes[0], scheme.points[0], options.boundary);
  const bool grid = scheme.points.size() == 2;
  const AxisPlan y = grid ? plan_axis(data.axes[1], scheme.points[1], options.boundary) : single_row;
  GridData<double> result{{}, data.dimension, {x.output}};
  if (grid) result.axes.push_back(y.output);
  result.values.resize(result.points() * result.dimension);
  const std::vector<double> source = padded(data, x, y);
  const Sizes sizes{x.sources.size(), x.output.count, data.dimension};
  for (const WindowClass& cy : y.classes)
    for (const WindowClass& cx : x.classes)
      run_job(make_job(scheme, cx, cy, sizes), sizes, source, options.threads, result.values);
  return result;
}

}  // namespace

RegressionWindow l1_window(const L1Scheme& scheme) {
  require_sizes(scheme);
  const auto nodes = [](int points) {
    std::vector<Rational> result;
    for (int i = 0; i < points; ++i) result.emplace_back(first_node(points) + i);
    return result;
  };
  const auto outputs = [](int points) { return std::vector<Rational>{output_at(points, 0), output_at(points, 1)}; };
  const std::vector<Rational> zero{0};
  const int p = scheme.points[0];
  if (scheme.points.size() == 1) return {product(nodes(p), zero), scheme.degree, product(outputs(p), zero)};
  const int q = scheme.points[1];
  return {product(nodes(p), nodes(q)), scheme.degree, product(outputs(p), outputs(q))};
}

LocalRegression l1_linear_part(const L1Scheme& scheme) {
  require_sizes(scheme);
  require(scheme.points.size() == 1, "l1_linear_part: need a scheme for curves");
  const int n = scheme.points[0] / 2;
  return scheme.points[0] % 2 == 0 ? dual(n, scheme.degree) : dual_odd(n, scheme.degree);
}

GridData<double> refine(const GridData<double>& data, const L1Scheme& scheme, const RefineOptions& options) {
  require_sizes(scheme);
  require(data.axes.size() == scheme.points.size(), "refine: need one number of points for each axis, got {} for {}",
          scheme.points.size(), data.axes.size());
  require(data.is_canonical(), "refine: need points * dimension values");
  require(options.levels >= 0, "refine: need levels >= 0, got {}", options.levels);
  require_refinable(data.values.size(), scheme.points.size() == 2 ? 4 : 2, options.levels);
  GridData<double> result = data;
  for (int level = 0; level < options.levels; ++level) result = refine_once(result, scheme, options);
  return result;
}

GridData<double> l1_impulse_response(const L1Scheme& scheme, int level) {
  require_sizes(scheme);
  require(scheme.points.size() == 1, "l1_impulse_response: need a scheme for curves");
  if (level < 0 || level > 16) fail(ErrorKind::domain, "l1_impulse_response: need 0 <= level <= 16, got {}", level);
  // The support has width 2 points - 1; complete windows take less than `points` away from either end in all.
  const int reach = 2 * scheme.points[0];
  std::vector<double> impulse(static_cast<std::size_t>(2 * reach + 1), 0);
  impulse[static_cast<std::size_t>(reach)] = 1;
  GridData<double> data = refine(curve_data(std::move(impulse)), scheme, {level, Boundary::shrink});
  data.axes[0].first -= reach;
  return data;
}

}  // namespace subcert::data
