#include "l1_refinement.hpp"

#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>
#include <subcert/schemes/data/refine/axis_stencils.hpp>

#include <algorithm>
#include <array>

namespace subcert::data {
namespace {

constexpr std::size_t most_axes = 3;

void require_sizes(const L1Scheme& scheme) {
  require(scheme.arity >= 2, "l1 scheme: need arity >= 2, got {}", scheme.arity);
  require(!scheme.points.empty() && scheme.points.size() <= most_axes,
          "l1 scheme: need one to three numbers of points, got {}", scheme.points.size());
  for (const int points : scheme.points)
    if (points < 2 || points <= scheme.degree)
      fail(ErrorKind::domain, "l1 scheme: need points >= 2 and points > degree = {}, got {}", scheme.degree, points);
}

/// The first datum of a window about 0.
long first_node(int points) { return points % 2 == 0 ? 1 - points / 2 : -(points / 2); }

/// Where output `phase` of a window about 0 stands.
Rational output_at(int points, int arity, int phase) {
  return (points % 2 == 0 ? Rational(1, 2) : Rational(0)) + output_place(arity, phase);
}

/// All points with these coordinates, the first running fastest.
std::vector<Position> product(const std::vector<std::vector<Rational>>& coordinates) {
  std::vector<Position> points{{}};
  for (std::size_t k = coordinates.size(); k-- > 0;) {
    std::vector<Position> longer;
    for (const Position& rest : points)
      for (const Rational& x : coordinates[k]) {
        Position& point = longer.emplace_back(Position{x});
        point.insert(point.end(), rest.begin(), rest.end());
      }
    points = std::move(longer);
  }
  return points;
}

/// Consecutive windows whose outputs stand alike: window k begins at datum start + k and makes the outputs
/// out + k * outputs, ..., the first of them at (first_output + o) / arity + output_at(0) from the datum at which it
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

/// All rules read the whole window; output a*w + phase stands at w + output_at(phase) of the data.
AxisStencils stencils_of(int points, int degree, int arity) {
  const long highest = -arity * first_node(points), lowest = highest - arity * (points - 1);
  std::vector<AxisStencils::Class> classes;
  for (long phase = 0; phase < arity; ++phase) classes.push_back({lowest + phase, highest + phase});
  return {classes, -arity * output_at(points, arity, 0), degree};
}

AxisPlan plan_axis(const Axis& data, int points, int degree, long arity, Boundary boundary) {
  const OutputRange range = stencils_of(points, degree, static_cast<int>(arity)).outputs(data, boundary);
  const Axis& axis = range.input;
  const long begin = range.begin, end = range.end;
  const long last_start = static_cast<long>(axis.count) - points;
  const bool clamp = !axis.closed && boundary == Boundary::regression;
  AxisPlan plan{range.output, {}, {}};
  const auto start_of = [&](long output) {
    const long natural = floor_divide(output, arity) + first_node(points);
    return clamp ? std::clamp(natural, 0L, last_start) : natural;
  };
  for (long o = begin; o < end;) {
    const long start = start_of(o);
    long next = o + 1;
    while (next < end && start_of(next) == start) ++next;
    plan.classes.push_back(
        {start, 1, static_cast<std::size_t>(o - begin), static_cast<std::size_t>(next - o), o - arity * start});
    // Whole windows like this one follow each other, up to the last that is not clamped.
    if (next - o == arity && o - arity * start == -arity * first_node(points)) {
      const long more = std::min((end - next) / arity, clamp ? last_start - 1 - start : end);
      if (more > 0) {
        plan.classes.back().windows += static_cast<std::size_t>(more);
        next += arity * more;
      }
    }
    o = next;
  }
  const WindowClass& back = plan.classes.back();
  const long low = std::min(0L, plan.classes.front().start);
  const long high = std::max(last_start, back.start + static_cast<long>(back.windows) - 1);
  for (long j = low; j < high + points; ++j) plan.sources.push_back(source(j, axis, boundary));
  for (WindowClass& c : plan.classes) c.start -= low;
  return plan;
}

/// One for each of three axes.
template <class T>
using PerAxis = std::array<T, most_axes>;

/// One window class along each axis, and where its parts lie in the padded data and in the output.
struct Job {
  L1Fitter fitter;
  PerAxis<const WindowClass*> classes;
  std::vector<std::size_t> node_offsets;
  std::vector<std::size_t> output_offsets;
  std::size_t windows;
};

/// How far apart neighbours along an axis are, in the padded data and in the output.
struct Strides {
  PerAxis<std::size_t> source;
  PerAxis<std::size_t> out;
  std::size_t dimension;
};

/// Where the points of a box lie, the first axis running fastest.
std::vector<std::size_t> offsets(const PerAxis<std::size_t>& counts, const PerAxis<std::size_t>& strides) {
  std::vector<std::size_t> result;
  for (std::size_t k = 0; k < counts[2]; ++k)
    for (std::size_t j = 0; j < counts[1]; ++j)
      for (std::size_t i = 0; i < counts[0]; ++i) result.push_back(k * strides[2] + j * strides[1] + i * strides[0]);
  return result;
}

std::vector<Rational> integers(std::size_t count) {
  std::vector<Rational> result;
  for (std::size_t i = 0; i < count; ++i) result.emplace_back(i);
  return result;
}

/// The outputs of a class, from the datum at which a window begins.
std::vector<Rational> positions(const WindowClass& windows, int points, int arity) {
  std::vector<Rational> result;
  for (std::size_t o = 0; o < windows.outputs; ++o)
    result.push_back(Rational(windows.first_output + static_cast<long>(o)) / arity + output_at(points, arity, 0));
  return result;
}

Job make_job(const L1Scheme& scheme, const PerAxis<const WindowClass*>& classes, const Strides& strides) {
  std::vector<std::vector<Rational>> nodes, outputs;
  PerAxis<std::size_t> node_counts{1, 1, 1}, output_counts{1, 1, 1};
  std::size_t windows = 1;
  for (std::size_t k = 0; k < scheme.points.size(); ++k) {
    node_counts[k] = static_cast<std::size_t>(scheme.points[k]);
    output_counts[k] = classes[k]->outputs;
    windows *= classes[k]->windows;
    nodes.push_back(integers(node_counts[k]));
    outputs.push_back(positions(*classes[k], scheme.points[k], scheme.arity));
  }
  const RegressionWindow window(product(nodes), scheme.degree, product(outputs));
  return {L1Fitter(window, scheme.options), classes, offsets(node_counts, strides.source),
          offsets(output_counts, strides.out), windows};
}

/// Fits the windows begin, ..., end - 1 of a job.
void fit_range(const Job& job, const Strides& strides, const std::vector<double>& data, std::size_t begin,
               std::size_t end, std::vector<double>& out) {
  constexpr std::size_t lanes = L1Fitter::lanes;
  const std::size_t joint = job.fitter.options().joint_residuals ? strides.dimension : 1;  // coordinates in one call
  const std::size_t nodes = job.node_offsets.size(), outputs = job.output_offsets.size();
  std::vector<double> in(nodes * joint * lanes), fits(outputs * joint * lanes);
  L1Fitter::Workspace workspace;
  for (std::size_t window = begin; window < end; window += lanes) {
    const std::size_t used = std::min(lanes, end - window);
    std::size_t from[lanes], to[lanes];
    for (std::size_t l = 0; l < lanes; ++l) {
      std::size_t w = window + std::min(l, used - 1);
      from[l] = to[l] = 0;
      for (std::size_t k = 0; k < most_axes; ++k) {
        const WindowClass& along = *job.classes[k];
        const std::size_t step = w % along.windows;
        w /= along.windows;
        from[l] += (static_cast<std::size_t>(along.start) + step) * strides.source[k];
        to[l] += (along.out + step * along.outputs) * strides.out[k];
      }
    }
    for (std::size_t first = 0; first < strides.dimension; first += joint) {
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

void run_job(const Job& job, const Strides& strides, const std::vector<double>& data, int threads,
             std::vector<double>& out) {
  constexpr std::size_t lanes = L1Fitter::lanes;
  parallel_ranges((job.windows + lanes - 1) / lanes, job.windows / windows_per_thread, threads,
                  [&](std::size_t begin, std::size_t end) {
                    fit_range(job, strides, data, begin * lanes, std::min(end * lanes, job.windows), out);
                  });
}

/// The data with the places that windows read beyond the ends.
std::vector<double> padded(const GridData<double>& data, const PerAxis<AxisPlan>& plans) {
  const std::size_t columns = data.axes[0].count, rows = data.axes.size() > 1 ? data.axes[1].count : 1;
  std::vector<double> result;
  result.reserve(plans[0].sources.size() * plans[1].sources.size() * plans[2].sources.size() * data.dimension);
  for (const std::size_t k : plans[2].sources)
    for (const std::size_t j : plans[1].sources)
      for (const std::size_t i : plans[0].sources) {
        const double* point = data.values.data() + ((k * rows + j) * columns + i) * data.dimension;
        result.insert(result.end(), point, point + data.dimension);
      }
  return result;
}

/// A curve is a grid with one row, and a grid a volume with one layer, that no window passes.
const AxisPlan single_row{Axis::of(1), {0}, {{0, 1, 0, 1, 0}}};

GridData<double> refine_once(const GridData<double>& data, const L1Scheme& scheme, const RefineOptions& options) {
  PerAxis<AxisPlan> plans{single_row, single_row, single_row};
  GridData<double> result{{}, data.dimension, {}};
  Strides strides{{data.dimension}, {data.dimension}, data.dimension};
  for (std::size_t k = 0; k < most_axes; ++k) {
    if (k < scheme.points.size()) {
      plans[k] = plan_axis(data.axes[k], scheme.points[k], scheme.degree, scheme.arity, options.boundary);
      result.axes.push_back(plans[k].output);
    }
    if (k + 1 == most_axes) break;
    strides.source[k + 1] = strides.source[k] * plans[k].sources.size();
    strides.out[k + 1] = strides.out[k] * plans[k].output.count;
  }
  result.values.resize(result.points() * result.dimension);
  const std::vector<double> source = padded(data, plans);
  for (const WindowClass& cz : plans[2].classes)
    for (const WindowClass& cy : plans[1].classes)
      for (const WindowClass& cx : plans[0].classes)
        run_job(make_job(scheme, {&cx, &cy, &cz}, strides), strides, source, options.threads, result.values);
  return result;
}

}  // namespace

RegressionWindow l1_window(const L1Scheme& scheme) {
  require_sizes(scheme);
  std::vector<std::vector<Rational>> nodes, outputs;
  for (const int points : scheme.points) {
    std::vector<Rational>& along = nodes.emplace_back();
    for (int i = 0; i < points; ++i) along.emplace_back(first_node(points) + i);
    std::vector<Rational>& over = outputs.emplace_back();
    for (int phase = 0; phase < scheme.arity; ++phase) over.push_back(output_at(points, scheme.arity, phase));
  }
  return {product(nodes), scheme.degree, product(outputs)};
}

LocalRegression l1_linear_part(const L1Scheme& scheme) {
  require_sizes(scheme);
  require(scheme.points.size() == 1, "l1_linear_part: need a scheme for curves");
  return ary(scheme.arity, scheme.points[0], scheme.degree);
}

GridData<double> refine(const GridData<double>& data, const L1Scheme& scheme, const RefineOptions& options) {
  require_sizes(scheme);
  require(data.axes.size() == scheme.points.size(), "refine: need one number of points for each axis, got {} for {}",
          scheme.points.size(), data.axes.size());
  require(data.is_canonical(), "refine: need points * dimension values");
  require(options.levels >= 0, "refine: need levels >= 0, got {}", options.levels);
  long growth = 1;
  for (std::size_t k = 0; k < scheme.points.size(); ++k) growth *= scheme.arity;
  require_refinable(data.values.size(), growth, options.levels);
  GridData<double> result = data;
  for (int level = 0; level < options.levels; ++level) result = refine_once(result, scheme, options);
  return result;
}

GridData<double> l1_impulse_response(const L1Scheme& scheme, int level) {
  require_sizes(scheme);
  require(scheme.points.size() == 1, "l1_impulse_response: need a scheme for curves");
  if (level < 0 || level > 16) fail(ErrorKind::domain, "l1_impulse_response: need 0 <= level <= 16, got {}", level);
  // The support has width 2 points - 1 at most; complete windows take less than `points` away from either end in all.
  const int reach = 2 * scheme.points[0];
  std::vector<double> impulse(static_cast<std::size_t>(2 * reach + 1), 0);
  impulse[static_cast<std::size_t>(reach)] = 1;
  GridData<double> data = refine(curve_data(std::move(impulse)), scheme, {level, Boundary::shrink});
  data.axes[0].first -= reach;
  return data;
}

}  // namespace subcert::data
