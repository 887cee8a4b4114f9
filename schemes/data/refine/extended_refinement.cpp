#include "extended_refinement.hpp"

#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>

namespace subcert::data {
namespace {

/// Where a point of the result is read, or beyond the data.
struct Origin {
  std::size_t at;
  bool outside;
};

/// Reads the points of its output at places of its input: continues data, or leaves points out.
class PlaceStep : public SliceStep {
 public:
  /// A list of places for each axis; `value` stands outside.
  PlaceStep(std::vector<Axis> input, std::vector<Axis> output, std::size_t dimension,
            std::vector<std::vector<Origin>> places, double value)
      : SliceStep(std::move(output)),
        input_(std::move(input)),
        dimension_(dimension),
        places_(std::move(places)),
        value_(value) {}

  void append(std::size_t begin, std::size_t end, const SliceSource& source,
              std::vector<double>& values) const override {
    const std::vector<Origin>& last = places_.back();
    std::vector<std::size_t> wanted;
    for (std::size_t o = begin; o < end; ++o)
      if (!last[o].outside) wanted.push_back(last[o].at);
    const SliceBuffer in(wanted, source);
    const std::size_t slice = numbers_of_slice(input_, dimension_);
    for (std::size_t o = begin; o < end; ++o) {
      const double* const from = last[o].outside ? nullptr : in.values().data() + in.place(last[o].at) * slice;
      append_points(from, input_.size() - 1, values);
    }
  }

 private:
  /// The points of the first `axes` axes.
  void append_points(const double* from, std::size_t axes, std::vector<double>& values) const {
    if (axes == 0) {
      for (std::size_t c = 0; c < dimension_; ++c) values.push_back(from ? from[c] : value_);
      return;
    }
    std::size_t inner = dimension_;
    for (std::size_t k = 0; k + 1 < axes; ++k) inner *= input_[k].count;
    for (const Origin& place : places_[axes - 1])
      append_points(from && !place.outside ? from + place.at * inner : nullptr, axes - 1, values);
  }

  std::vector<Axis> input_;
  std::size_t dimension_;
  std::vector<std::vector<Origin>> places_;
  double value_;
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

SliceSteps extended_steps(const std::vector<Axis>& axes, std::size_t dimension, const std::vector<std::size_t>& fewest,
                          const RefineOptions& options, const StepMaker& make) {
  require(continues_data(options.boundary), "extended_steps: need nearest or constant, got {}",
          to_text(options.boundary));
  RefineOptions inside = options;
  inside.boundary = Boundary::shrink;
  const std::size_t more = points_more(axes, fewest, inside, make);
  std::vector<Axis> longer;
  std::vector<std::vector<Origin>> places;
  for (const Axis& axis : axes) {
    longer.push_back(lengthened(axis, more));
    std::vector<Origin>& along = places.emplace_back();
    for (std::size_t i = 0; i < longer.back().count; ++i) {
      const std::size_t before = axis.closed ? 0 : more;
      const std::size_t at = std::min(std::max(i, before) - before, axis.count - 1);
      along.push_back({at, options.boundary == Boundary::constant && at + before != i});
    }
  }
  SliceSteps steps;
  steps.push_back(std::make_unique<PlaceStep>(axes, longer, dimension, std::move(places), options.constant));
  for (auto& step : make(longer, inside)) steps.push_back(std::move(step));
  const std::vector<Axis> made = steps.back()->output();
  std::vector<Axis> output;
  places.clear();
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const PartInDomain part = *part_in_domain(made[k], more, axes[k].length);
    require(part.axis.count > 0, "refine: need more points for one output, got {}", axes[k].count);
    output.push_back(part.axis);
    std::vector<Origin>& along = places.emplace_back();
    for (std::size_t i = 0; i < part.axis.count; ++i) along.push_back({part.first + i, false});
  }
  steps.push_back(std::make_unique<PlaceStep>(made, output, dimension, std::move(places), 0));
  return steps;
}

}  // namespace subcert::data
