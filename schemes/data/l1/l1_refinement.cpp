#include "l1_refinement.hpp"

#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>
#include <subcert/schemes/data/refine/axis_stencils.hpp>
#include <subcert/schemes/data/refine/extended_refinement.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>

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

/// Of all outputs, or of those with numbers `first` to before `last`.
AxisPlan plan_axis(const L1Scheme& scheme, const Axis& data, std::size_t k, Boundary boundary, std::size_t first = 0,
                   std::optional<std::size_t> last = {}) {
  const int points = scheme.points[k];
  const long arity = scheme.arity;
  const OutputRange range = stencils_of(points, scheme.degree, scheme.arity).outputs(data, boundary);
  const Axis& axis = range.input;
  const long begin = range.begin + static_cast<long>(first);
  const long end = last ? range.begin + static_cast<long>(*last) : range.end;
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
  const long low = plan.classes.front().start, high = back.start + static_cast<long>(back.windows) - 1;
  for (long j = low; j < high + points; ++j) plan.sources.push_back(source(j, axis, boundary));
  for (WindowClass& c : plan.classes) c.start -= low;
  return plan;
}

/// One for each of three axes.
template <class T>
using PerAxis = std::array<T, most_axes>;

/// Fitters of one scheme by where the outputs of their windows stand, made once.
class Fitters {
 public:
  explicit Fitters(const L1Scheme& scheme) : scheme_(scheme) {}
  const L1Scheme& scheme() const { return scheme_; }
  const L1Fitter& of(const PerAxis<const WindowClass*>& classes);

 private:
  L1Scheme scheme_;
  std::map<PerAxis<std::pair<long, std::size_t>>, L1Fitter> known_;
};

/// One window class along each axis, and where its parts lie in the padded data and in the output.
struct Job {
  const L1Fitter& fitter;
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

const L1Fitter& Fitters::of(const PerAxis<const WindowClass*>& classes) {
  PerAxis<std::pair<long, std::size_t>> key{};
  std::vector<std::vector<Rational>> nodes, outputs;
  for (std::size_t k = 0; k < scheme_.points.size(); ++k) {
    key[k] = {classes[k]->first_output, classes[k]->outputs};
    nodes.push_back(integers(static_cast<std::size_t>(scheme_.points[k])));
    outputs.push_back(positions(*classes[k], scheme_.points[k], scheme_.arity));
  }
  if (const auto found = known_.find(key); found != known_.end()) return found->second;
  const RegressionWindow window(product(nodes), scheme_.degree, product(outputs));
  return known_.emplace(key, L1Fitter(window, scheme_.options)).first->second;
}

Job make_job(Fitters& fitters, const PerAxis<const WindowClass*>& classes, const Strides& strides) {
  const L1Scheme& scheme = fitters.scheme();
  PerAxis<std::size_t> node_counts{1, 1, 1}, output_counts{1, 1, 1};
  std::size_t windows = 1;
  for (std::size_t k = 0; k < scheme.points.size(); ++k) {
    node_counts[k] = static_cast<std::size_t>(scheme.points[k]);
    output_counts[k] = classes[k]->outputs;
    windows *= classes[k]->windows;
  }
  return {fitters.of(classes), classes, offsets(node_counts, strides.source), offsets(output_counts, strides.out),
          windows};
}

/// Fits the windows begin, ..., end - 1 of a job.
void fit_range(const Job& job, const Strides& strides, const std::vector<double>& data, std::size_t begin,
               std::size_t end, double* out) {
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

void run_job(const Job& job, const Strides& strides, const std::vector<double>& data, int threads, double* out) {
  constexpr std::size_t lanes = L1Fitter::lanes;
  parallel_ranges((job.windows + lanes - 1) / lanes, job.windows / windows_per_thread, threads,
                  [&](std::size_t begin, std::size_t end) {
                    fit_range(job, strides, data, begin * lanes, std::min(end * lanes, job.windows), out);
                  });
}

/// A curve is a grid with one row, and a grid a volume with one layer, that no window passes.
const AxisPlan single_row{Axis::of(1), {0}, {{0, 1, 0, 1, 0}}};

PerAxis<AxisPlan> plan_axes(const L1Scheme& scheme, const std::vector<Axis>& axes, Boundary boundary) {
  PerAxis<AxisPlan> plans{single_row, single_row, single_row};
  for (std::size_t k = 0; k < axes.size(); ++k) plans[k] = plan_axis(scheme, axes[k], k, boundary);
  return plans;
}

std::vector<Axis> outputs_of(const PerAxis<AxisPlan>& plans, std::size_t count) {
  std::vector<Axis> axes;
  for (std::size_t k = 0; k < count; ++k) axes.push_back(plans[k].output);
  return axes;
}

class L1Step : public SliceStep {
 public:
  L1Step(std::vector<Axis> axes, std::size_t dimension, std::shared_ptr<Fitters> fitters, const RefineOptions& options)
      : L1Step(plan_axes(fitters->scheme(), axes, options.boundary), axes, dimension, fitters, options) {}

  void append(std::size_t begin, std::size_t end, const SliceSource& source,
              std::vector<double>& values) const override {
    const std::size_t last = input_.size() - 1;
    PerAxis<AxisPlan> plans = plans_;
    plans[last] = plan_axis(fitters_->scheme(), input_[last], last, options_.boundary, begin, end);
    const SliceBuffer in(plans[last].sources, source);
    for (std::size_t& slice : plans[last].sources) slice = in.place(slice);
    PerAxis<std::size_t> made{1, 1, 1};
    for (std::size_t k = 0; k < last; ++k) made[k] = output()[k].count;
    made[last] = end - begin;
    const std::size_t old = values.size();
    values.resize(old + (end - begin) * numbers_of_slice(output(), dimension_));
    fit(plans, padded(in.values(), plans), made, values.data() + old);
  }

 private:
  L1Step(PerAxis<AxisPlan> plans, std::vector<Axis> axes, std::size_t dimension, std::shared_ptr<Fitters> fitters,
         const RefineOptions& options)
      : SliceStep(outputs_of(plans, axes.size())),
        plans_(std::move(plans)),
        input_(std::move(axes)),
        dimension_(dimension),
        fitters_(std::move(fitters)),
        options_(options) {}

  /// The data with the places that windows read beyond the ends.
  std::vector<double> padded(const std::vector<double>& data, const PerAxis<AxisPlan>& plans) const {
    const std::size_t columns = input_[0].count, rows = input_.size() > 1 ? input_[1].count : 1;
    std::vector<double> result;
    result.reserve(plans[0].sources.size() * plans[1].sources.size() * plans[2].sources.size() * dimension_);
    for (const std::size_t k : plans[2].sources)
      for (const std::size_t j : plans[1].sources)
        for (const std::size_t i : plans[0].sources) {
          const double* point = data.data() + ((k * rows + j) * columns + i) * dimension_;
          result.insert(result.end(), point, point + dimension_);
        }
    return result;
  }

  void fit(const PerAxis<AxisPlan>& plans, const std::vector<double>& source, const PerAxis<std::size_t>& made,
           double* out) const {
    Strides strides{{dimension_}, {dimension_}, dimension_};
    for (std::size_t k = 0; k + 1 < most_axes; ++k) {
      strides.source[k + 1] = strides.source[k] * plans[k].sources.size();
      strides.out[k + 1] = strides.out[k] * made[k];
    }
    for (const WindowClass& cz : plans[2].classes)
      for (const WindowClass& cy : plans[1].classes)
        for (const WindowClass& cx : plans[0].classes)
          run_job(make_job(*fitters_, {&cx, &cy, &cz}, strides), strides, source, options_.threads, out);
  }

  PerAxis<AxisPlan> plans_;  // of whole axes
  std::vector<Axis> input_;
  std::size_t dimension_;
  std::shared_ptr<Fitters> fitters_;
  RefineOptions options_;
};

SliceSteps l1_steps(std::vector<Axis> axes, std::size_t dimension, const L1Scheme& scheme, const RefineOptions& options,
                    double most) {
  require_sizes(scheme);
  require(axes.size() == scheme.points.size(), "refine: need one number of points for each axis, got {} for {}",
          scheme.points.size(), axes.size());
  require(options.levels >= 0, "refine: need levels >= 0, got {}", options.levels);
  long growth = 1;
  for (std::size_t k = 0; k < scheme.points.size(); ++k) growth *= scheme.arity;
  require_refinable(numbers_of_slice(axes, dimension) * axes.back().count, growth, options.levels, most);
  const auto fitters = std::make_shared<Fitters>(scheme);
  SliceSteps steps;
  for (int level = 0; level < options.levels; ++level) {
    steps.push_back(std::make_unique<L1Step>(std::move(axes), dimension, fitters, options));
    axes = steps.back()->output();
  }
  return steps;
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

SliceSteps refinement_steps(const std::vector<Axis>& axes, std::size_t dimension, const L1Scheme& scheme,
                            const RefineOptions& options) {
  return steps_at_boundary(axes, dimension, {scheme.points.begin(), scheme.points.end()}, options,
                           [&](const std::vector<Axis>& on, const RefineOptions& how) {
                             return l1_steps(on, dimension, scheme, how, most_streamed_numbers);
                           });
}

GridData<double> refine(const GridData<double>& data, const L1Scheme& scheme, const RefineOptions& options) {
  require(data.is_canonical(), "refine: need points * dimension values");
  GridData<double> result = data;
  for (const auto& step : l1_steps(data.axes, data.dimension, scheme, options, most_refined_numbers)) {
    std::vector<double> values;
    const std::size_t slice = numbers_of_slice(result.axes, result.dimension);
    step->append(
        0, step->output().back().count,
        [&](std::size_t begin, std::size_t end, std::vector<double>& in) {
          in.insert(in.end(), result.values.data() + begin * slice, result.values.data() + end * slice);
        },
        values);
    result = {std::move(values), result.dimension, step->output()};
  }
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
