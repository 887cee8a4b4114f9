
#include "refine.hpp"

#include "axis_refinement.hpp"
#include "grid_refinement.hpp"

#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace subcert::data {
namespace {

/// About how many, as 12345 or 10^17.
std::string estimate_text(double decimal_logarithm) {
  if (decimal_logarithm < 15) return std::to_string(std::llround(std::pow(10, decimal_logarithm)));
  return "10^" + std::to_string(std::llround(decimal_logarithm));
}

}  // namespace

std::vector<StepAlong> steps_of_refinement(std::vector<Axis> axes, const LevelMasks& masks,
                                           const RefineOptions& options) {
  std::map<std::size_t, std::vector<AxisRefiner>> refiners;  // by the number of the mask, one for each axis
  std::vector<StepAlong> steps;
  for (int level = 0; level < options.levels; ++level) {
    const std::size_t number = masks.number_at(static_cast<std::size_t>(level));
    std::vector<AxisRefiner>& along = refiners[number];
    if (along.empty())
      for (const Mask& mask : masks.mask(number).factors()) along.emplace_back(mask, options.boundary);
    for (std::size_t k = 0; k < along.size(); ++k) {
      steps.push_back({k, along[k].step(axes[k])});
      axes[k] = steps.back().rows.output;
    }
  }
  return steps;
}

void require_refinable(std::size_t numbers, long growth, long levels, double most) {
  const double logarithm = std::log10(static_cast<double>(numbers)) + static_cast<double>(levels) * std::log10(growth);
  if (logarithm > std::log10(most))
    fail(ErrorKind::size, "{} levels would make about {} numbers of {}; need at most {}", levels,
         estimate_text(logarithm), numbers, estimate_text(std::log10(most)));
}

void require_refinable(const std::vector<Axis>& axes, std::size_t dimension, const LevelMasks& masks, int levels,
                       double most) {
  const LatticeMask& mask = masks.at(0);
  require(static_cast<std::size_t>(mask.dimension()) == axes.size(),
          "refine: need as many axes as variables, got {} for {}", axes.size(), mask.dimension());
  require(levels >= 0, "refine: need levels >= 0, got {}", levels);
  require_refinable(numbers_of_slice(axes, dimension) * axes.back().count, mask.dilation().classes(), levels, most);
}

void require_factors(const LevelMasks& masks) {
  for (const auto* list : {&masks.first, &masks.again})
    for (const LatticeMask& mask : *list)
      require(mask.has_factors() && mask.dilation() == masks.at(0).dilation(),
              "refine: need masks with factors and of one arity for levels that differ");
}

template <class Number>
GridData<Number> refine(const GridData<Number>& data, const LatticeMask& mask, const RefineOptions& options) {
  if (mask.has_factors()) return refine(data, LevelMasks{{}, {mask}}, options);
  require(data.is_canonical(), "refine: need as many values as points times coordinates");
  require_refinable(data.axes, data.dimension, {{}, {mask}}, options.levels, most_refined_numbers);
  return refined_on_grid(data, mask, options);
}

template <class Number>
GridData<Number> refine(const GridData<Number>& data, const LevelMasks& masks, const RefineOptions& options) {
  require(data.is_canonical(), "refine: need as many values as points times coordinates");
  require_refinable(data.axes, data.dimension, masks, options.levels, most_refined_numbers);
  require_factors(masks);
  return refined_along_axes(data, steps_of_refinement(data.axes, masks, options), options.threads);
}

std::vector<std::size_t> fewest_points(const LatticeMask& mask, Boundary boundary) {
  // Periodic data are there at every index, however few they are.
  if (boundary == Boundary::periodic || continues_data(boundary))
    return std::vector<std::size_t>(static_cast<std::size_t>(mask.dimension()), 1);
  if (!mask.has_factors()) return windows(mask);
  std::vector<std::size_t> fewest;
  for (const Mask& factor : mask.factors()) fewest.push_back(AxisRefiner(factor, boundary).window());
  return fewest;
}

template GridData<double> refine<double>(const GridData<double>&, const LatticeMask&, const RefineOptions&);
template GridData<Rational> refine<Rational>(const GridData<Rational>&, const LatticeMask&, const RefineOptions&);
template GridData<double> refine<double>(const GridData<double>&, const LevelMasks&, const RefineOptions&);
template GridData<Rational> refine<Rational>(const GridData<Rational>&, const LevelMasks&, const RefineOptions&);

std::vector<double> interpolate(const GridData<double>& curve, const std::vector<Rational>& parameters) {
  require(curve.is_canonical() && curve.axes.size() == 1 && curve.dimension == 1 && curve.points() >= 2,
          "interpolate: need at least two points of one coordinate");
  const Axis& axis = curve.axes[0];
  const auto count = static_cast<long>(axis.count);
  const auto at = [&](long i) { return curve.values[static_cast<std::size_t>(modulo(i, count))]; };
  std::vector<double> result;
  for (const Rational& parameter : parameters) {
    const Rational place = (parameter - axis.first) / axis.step;
    const long left = floor_index(place);
    const long i = axis.closed ? left : std::clamp(left, 0L, count - 2);
    const double t = nearest_double(place - i);
    result.push_back((1 - t) * at(i) + t * at(i + 1));
  }
  return result;
}

}  // namespace subcert::data
