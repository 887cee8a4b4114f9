#pragma once
/// What holds for every sequence of values of the letters, one for each level.

#include "mask_list.hpp"
#include "property_range.hpp"

#include <subcert/analysis/symbol/polynomials/box.hpp>

namespace subcert {

/// Whether all limits have the property; no where some have not. `exponent`: no lower end where no convergence is
/// proved; the upper one is that of some. Domain: `convergent`, `smooth` or `holder`.
Truth holds(const Enclosure& exponent, const RangeProperty& property);

/// The same of a list; of a Hermite list also `hermite`, of an order from one less than its components on.
Truth holds(const ExponentOfList& found, const RangeProperty& property);
/// The largest HC^k that all sequences of a Hermite list have, and whether they have one more. Nothing where no
/// derivatives are kept.
std::optional<HermiteOrder> hermite_order_of(const ExponentOfList& found);
/// Errors: throws Error for a property that is not one of lists, or HC^k of a list that has no derivatives, or more.
void require_property(const MaskList& list, const RangeProperty& property);

/// Of f_{k+1} = S_{w_k} f_k with w_0, w_1, ... in a box: the limits of all these sequences have the property, uniformly
/// (yes), or those of one sequence do not (no).
struct PropertyOfLevels {
  int sum_rules = 0;  ///< that hold for all values
  Truth holds = Truth::unknown;
  std::string reason = {};          ///< why it is not decided
  std::vector<Values> period = {};  ///< of a sequence without the property: these values again and again
  /// An upper bound of the joint spectral radius of the control matrices of the box, where it is below the threshold.
  std::optional<JointSpectralRadius> above = {};
};

/// By one bound for the whole box: pieces of a box prove nothing of sequences that change from one to the other. It is
/// refuted by one value for all levels, a corner or the middle, or, of numbers, by two corners in turn. Domain: as
/// property_map, one letter or more; `convergent`, `smooth`, `holder` or, of matrices, `hermite`. Errors: throws Error.
/// Error: none; what is not decided is left `unknown`. Cost: a joint spectral radius, and the exponents of a few masks.
/// Ref: docs/levels.md.
PropertyOfLevels property_of_levels(const ParametricMask& mask, const RangeProperty& property, const Box& box,
                                    const Budget& budget);

/// The least upper end of the exponents of one value for all levels, at the corners of the box: no larger number holds
/// for all sequences. Nothing where none is proved. Domain: as above. Cost: an exponent for each corner.
std::optional<Rational> upper_end_of_levels(const ParametricMask& mask, const Box& box, const Budget& budget);

/// Errors: throws Error unless property_map takes the box.
void require_levels(const ParametricMask& mask, const Box& box);

/// Of all sequences of values in a box.
struct ExponentOfLevels {
  Box box;
  /// The limits of each sequence have at least the lower end, where that is positive; those of one value for all levels
  /// no more than the upper one.
  Enclosure exponent;
};

struct LevelsCurveOptions {
  int boxes = 24;
  int jobs = 1;
  Budget budget{Deadline::in(60)};
};

/// Over boxes that grow from a point to the box in equal steps. Domain: as above, the point in the box; 1 <= boxes <=
/// 1000. Errors: throws Error. Cost: a joint spectral radius for each, and the exponents of the masks at all corners.
std::vector<ExponentOfLevels> exponents_of_levels(const ParametricMask& mask, const Box& box, const Values& about,
                                                  const LevelsCurveOptions& options);

}  // namespace subcert
