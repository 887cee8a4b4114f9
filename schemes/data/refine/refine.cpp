#include "refine.hpp"

#include "axis_refinement.hpp"

#include <subcert/analysis/symbol/error.hpp>

#include <cmath>
#include <string>

namespace subcert::data {
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
    fail(ErrorKind::size, "{} levels would make about {} numbers of {}; need at most {}", levels,
         estimate_text(logarithm), numbers, estimate_text(std::log10(most_refined_numbers)));
}

template <class Number>
GridData<Number> refine(const GridData<Number>& data, const std::vector<Mask>& masks, const RefineOptions& options) {
  require(data.is_canonical(), "refine: need as many values as points times coordinates");
  require(masks.size() == data.axes.size(), "refine: need one mask for each axis, got {} for {}", masks.size(),
          data.axes.size());
  require(options.levels >= 0, "refine: need levels >= 0, got {}", options.levels);
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

}  // namespace subcert::data
