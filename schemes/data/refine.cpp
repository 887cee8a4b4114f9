#include "refine.hpp"

#include "axis_refinement.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace subcert {
namespace {

/// About how many, as 12345 or 10^17.
std::string estimate_text(double decimal_logarithm) {
  if (decimal_logarithm < 15) return std::to_string(std::llround(std::pow(10, decimal_logarithm)));
  return "10^" + std::to_string(std::llround(decimal_logarithm));
}

}  // namespace

void require_refinable(std::size_t numbers, long growth, long levels) {
  const double logarithm = std::log10(static_cast<double>(numbers)) + static_cast<double>(levels) * std::log10(growth);
  if (logarithm > std::log10(most_refined_numbers))
    throw std::length_error(std::to_string(levels) + " levels would make about " + estimate_text(logarithm) +
                            " numbers of " + std::to_string(numbers) + "; need at most " +
                            estimate_text(std::log10(most_refined_numbers)));
}

template <class Number>
GridData<Number> refine(const GridData<Number>& data, const std::vector<Mask>& masks, const RefineOptions& options) {
  if (!data.is_canonical()) throw std::invalid_argument("refine: need as many values as points times coordinates");
  if (masks.size() != data.axes.size())
    throw std::invalid_argument("refine: need one mask for each axis, got " + std::to_string(masks.size()) + " for " +
                                std::to_string(data.axes.size()));
  if (options.levels < 0)
    throw std::invalid_argument("refine: need levels >= 0, got " + std::to_string(options.levels));
  std::vector<AxisRefiner> refiners;
  long growth = 1;
  for (const Mask& mask : masks) {
    refiners.emplace_back(mask, options.boundary);
    growth *= mask.arity();
  }
  require_refinable(data.values.size(), growth, options.levels);
  GridData<Number> result = data;
  for (int level = 0; level < options.levels; ++level)
    for (std::size_t k = 0; k < masks.size(); ++k)
      result = apply_along(result, k, refiners[k].step(result.axes[k]), options.threads);
  return result;
}

template GridData<double> refine<double>(const GridData<double>&, const std::vector<Mask>&, const RefineOptions&);
template GridData<Rational> refine<Rational>(const GridData<Rational>&, const std::vector<Mask>&, const RefineOptions&);

}  // namespace subcert
