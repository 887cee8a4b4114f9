#include "variance_ends.hpp"

#include "curve_bounds.hpp"
#include "kept_by_scheme.hpp"
#include "scheme_family.hpp"

#include <subcert/analysis/variance/variance.hpp>
#include <subcert/schemes/specification.hpp>

#include <algorithm>

namespace subcert::theorems {
namespace {

constexpr int cells_per_shell = 32;

std::string primal_scheme(int n, int degree) { return scheme_family("primal").scheme(n, degree); }

/// Between grid points psi differs from the nearer of their values by at most half a step times the slope.
void narrow_by_grid(VarianceEnds& ends, const Mask& mask) {
  const int level = mask.symbol().highest() - mask.symbol().lowest() < 24 ? 10 : 6;
  const VarianceGrid grid = variance_grid(mask, level, false);
  const Rational reach = *ends.slope.upper * grid.step() / 2;
  ends.maximum = {std::max(*ends.maximum.lower, grid.largest()),
                  std::min(*ends.maximum.upper, Rational(grid.largest() + reach))};
  ends.minimum = {std::max(*ends.minimum.lower, Rational(grid.smallest() - reach)),
                  std::min(*ends.minimum.upper, grid.smallest())};
}

VarianceEnds compute_ends(const std::string& scheme) {
  const Mask mask = make_scheme(scheme).mask.curve();
  const CurveBounds bounds = curve_bounds(mask, cells_per_shell);
  VarianceEnds ends{bounds.mean, bounds.mean, bounds.slope};
  if (!bounds.ripple.upper) return {Enclosure::at_least(0), Enclosure::at_least(0), bounds.slope};
  *ends.maximum.upper += *bounds.ripple.upper;
  *ends.minimum.lower -= *bounds.ripple.upper;
  if (bounds.slope.upper && *bounds.ripple.upper * 256 > *bounds.mean.lower) narrow_by_grid(ends, mask);
  return ends;
}

KeptByScheme<VarianceEnds>& known_ends() {
  static KeptByScheme<VarianceEnds> result(compute_ends);
  return result;
}

}  // namespace

const VarianceEnds& variance_ends(const std::string& scheme) { return known_ends()(scheme); }

const VarianceEnds& variance_ends(int n, int degree) { return variance_ends(primal_scheme(n, degree)); }

void prepare_variance_ends(const std::vector<std::string>& schemes, int threads) {
  known_ends().prepare(schemes, threads);
}

void prepare_variance_ends(int first, int last, const std::vector<int>& degrees, int threads) {
  std::vector<std::string> schemes;
  for (int n = first; n <= last; ++n)
    for (int degree : degrees) schemes.push_back(primal_scheme(n, degree));
  prepare_variance_ends(schemes, threads);
}

}  // namespace subcert::theorems
