#pragma once
/// Exponents by the algebraic number that is behind them.

#include "mask_list.hpp"

#include <subcert/analysis/regularity/regularity.hpp>
#include <subcert/analysis/symbol/masks/parametric_mask.hpp>

namespace subcert {

/// The exponent rules - dimension log radius / log base.
struct NamedExponent {
  int rules = 0;
  long base = 2;
  std::size_t dimension = 1;
  AttainedNumber radius;
};

/// The largest degree of a polynomial whose zero names a radius.
constexpr long largest_named_degree = 10;

/// Nothing where the radius is not proved to be attained, the exponent is rational or not known from above, or the
/// number has a larger degree or was not told from others. Domain: `found` is of this mask, with rounded coefficients
/// only if these are `meant`; of a vector all functions were asked for. Cost: as named_radius.
std::optional<NamedExponent> named_exponent(const LatticeMask& mask, const Regularity& found,
                                            const std::optional<AlgebraicMask>& meant = std::nullopt);

/// The same of a list of masks, where both ends are proved.
std::optional<NamedExponent> named_exponent(const ExponentOfList& found);

}  // namespace subcert
