#include "extended_refinement.hpp"

#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <optional>

namespace subcert::data {
namespace {

/// Output i of an axis is read at i + first: continues data, or leaves points out.
class PlaceStep : public SliceStep {
 public:
  /// `first` for each axis; `beyond` stands outside the data, without it the nearest of them.
  PlaceStep(std::vector<Axis> input, std::vector<Axis> output, std::size_t dimension, std::vector<long> first,
            std::optional<double> beyond)
      : SliceStep(std::move(output)),
        input_(std::move(input)),
        dimension_(dimension),
        first_(std::move(first)),
        beyond_(beyond) {}

  void append(std::size_t begin, std::size_t end, const SliceSource& source,
              std::vector<double>& values) const override {
    const std::size_t last = input_.size() - 1, slice = numbers_of_slice(input_, dimension_);
    const std::size_t low = nearest(begin, last);
    std::vector<double> in;
    source(low, nearest(end - 1, last) + 1, in);
    values.reserve(values.size() + (end - begin) * numbers_of_slice(output(), dimension_));
    for (std::size_t o = begin; o < end; ++o)
      append_points(outside(o, last) ? nullptr : in.data() + (nearest(o, last) - low) * slice, slice, last, values);
  }

 private:
  long place(std::size_t output, std::size_t axis) const { return static_cast<long>(output) + first_[axis]; }
  std::size_t nearest(std::size_t output, std::size_t axis) const {
    return static_cast<std::size_t>(std::clamp(place(output, axis), 0L, static_cast<long>(input_[axis].count) - 1));
  }
  bool outside(std::size_t output, std::size_t axis) const {
    return beyond_ && place(output, axis) != static_cast<long>(nearest(output, axis));
  }

  /// The points of the first `axes` axes, from `numbers` numbers, or from none.
  void append_points(const double* from, std::size_t numbers, std::size_t axes, std::vector<double>& values) const {
    if (axes == 0) {
      for (std::size_t c = 0; c < dimension_; ++c) values.push_back(from ? from[c] : *beyond_);
      return;
    }
    const std::size_t k = axes - 1, inner = numbers / input_[k].count;
    for (std::size_t o = 0; o < output()[k].count; ++o)
      append_points(from && !outside(o, k) ? from + nearest(o, k) * inner : nullptr, inner, k, values);
  }

  std::vector<Axis> input_;
  std::size_t dimension_;
  std::vector<long> first_;
  std::optional<double> beyond_;
};

/// With so many points more at both ends.
Axis lengthened(const Axis& axis, std::size_t more) { return axis.closed ? axis : Axis::of(axis.count + 2 * more); }

/// The points of an axis in the domain of data with `more` points in front.
struct PartInDomain {
  std::size_t first;
  Axis axis;
};

/// Nothing where the axis does not reach both ends of the domain.
std::optional<PartInDomain> part_in_domain(const Axis& made, std::size_t more, const Rational& length) {
  if (made.closed) return PartInDomain{0, made};
  const Rational begin = made.first - Rational(more);
  const long first = ceil_index(-begin / made.step), end = floor_index((length - begin) / made.step) + 1;
  if (first < 0 || end > static_cast<long>(made.count) || begin > 0 ||
      begin + made.step * Rational(made.count) < length)
    return std::nullopt;
  return PartInDomain{
      static_cast<std::size_t>(first),
      {static_cast<std::size_t>(end - first), false, length, begin + made.step * Rational(first), made.step}};
}

/// How many points more make the steps reach the ends of short data.
std::size_t points_more(const std::vector<Axis>& axes, const std::vector<std::size_t>& fewest,
                        const RefineOptions& options, const StepMaker& make) {
  const std::size_t longest = *std::ranges::max_element(fewest);
  for (std::size_t more = longest;; ++more) {
    std::vector<Axis> shorter;
    for (const Axis& axis : axes) shorter.push_back(lengthened(Axis::of(longest, axis.closed), more));
    const SliceSteps steps = make(shorter, options);
    const std::vector<Axis>& made = steps.empty() ? shorter : steps.back()->output();
    if (std::ranges::all_of(
            made, [&](const Axis& axis) { return part_in_domain(axis, more, Rational(longest) - 1).has_value(); }))
      return more;
  }
}

}  // namespace

SliceSteps steps_at_boundary(const std::vector<Axis>& axes, std::size_t dimension,
                             const std::vector<std::size_t>& fewest, const RefineOptions& options,
                             const StepMaker& make) {
  if (!continues_data(options.boundary)) return make(axes, options);
  RefineOptions inside = options;
  inside.boundary = Boundary::shrink;
  const std::size_t more = points_more(axes, fewest, inside, make);
  std::vector<Axis> longer;
  std::vector<long> first;
  for (const Axis& axis : axes) {
    longer.push_back(lengthened(axis, more));
    first.push_back(axis.closed ? 0 : -static_cast<long>(more));
  }
  const auto beyond = options.boundary == Boundary::constant ? std::optional(options.constant) : std::nullopt;
  SliceSteps steps;
  steps.push_back(std::make_unique<PlaceStep>(axes, longer, dimension, first, beyond));
  for (auto& step : make(longer, inside)) steps.push_back(std::move(step));
  const std::vector<Axis> made = steps.back()->output();
  std::vector<Axis> output;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const PartInDomain part = *part_in_domain(made[k], more, axes[k].length);
    require(part.axis.count > 0, "refine: need more points for one output, got {}", axes[k].count);
    output.push_back(part.axis);
    first[k] = static_cast<long>(part.first);
  }
  steps.push_back(std::make_unique<PlaceStep>(made, output, dimension, std::move(first), std::nullopt));
  return steps;
}

}  // namespace subcert::data
