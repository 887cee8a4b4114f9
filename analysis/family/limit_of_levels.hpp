#pragma once
/// The exponent of a level-dependent scheme whose masks tend to one.

#include "mask_list.hpp"
#include "property_of_levels.hpp"
#include "recurrence.hpp"

#include <subcert/analysis/symbol/masks/parametric_mask.hpp>

namespace subcert {

/// Factors that the symbols of a mask with one letter v have for all v, with T_j(cos t) = cos(j t): such a scheme
/// generates x^i for i < sum_rules and, where v is cos(t h) at the level with distances h, x^i e^(+-i j t x) for i <
/// exponentials[j - 1].
struct ExponentialSumRules {
  int sum_rules = 0;                   ///< the power of 1 + z
  std::vector<int> exponentials = {};  ///< [j - 1]: the power of 1 + 2 T_j(v) z + z^2; without zeros at the end

  /// The degree of all these factors.
  int order() const;
  bool operator==(const ExponentialSumRules& other) const = default;
};

/// What is generated: `1, x, e^(+-tx), x e^(+-tx)`.
std::string to_text(const ExponentialSumRules& rules);

/// Domain: one letter, numbers, arity 2. Error: none; j is up to 8. Cost: divisions of polynomials.
ExponentialSumRules exponential_sum_rules(const ParametricMask& mask);

/// Of f_{k+1} = S_{w_k} f_k with w_{k+1} = r(w_k).
struct LimitOfLevels {
  Rational value;             ///< to which w_k tends
  std::vector<Interval> way;  ///< as LimitOfValues has it
  ExponentialSumRules rules;  ///< without exponentials, unless r(w) = sqrt((1+w)/2)
  /// All limits have at least the lower end, if there is one; limits of some data at late levels at most the upper one.
  ExponentOfList exponent;
};

/// The exponent of the mask at the value to which all w_k tend, of differences of an order no larger than that of the
/// rules that hold for all w; nothing where it is not proved that w_k tends to a rational value, for all w_0 in `kept`.
/// Domain: one letter, numbers, coset sums 1. Errors: throws Error. Cost: a joint spectral radius. Proof:
/// docs/levels.md.
std::optional<LimitOfLevels> limit_of_levels(const ParametricMask& mask, const Recurrence& recurrence,
                                             const Interval& kept, const Budget& budget);

/// Values of which each follows from the one before, and the level from which on they are in an interval.
struct FollowedLevels {
  FirstValues start;
  Recurrence recurrence;
  /// Of the values at levels 1, 2, ... until they are there, as Recurrence::way_into; nothing where that is not proved.
  std::optional<std::vector<Interval>> way = {};
  bool masks_exist = true;                  ///< before they are there, for all of `start`
  std::optional<LimitOfLevels> limit = {};  ///< where they come there; of numbers

  /// From which on they are there; nothing where no one level is that for all of `start`.
  std::optional<int> first_level() const;

  /// Whether the masks of these levels have a property that all sequences in the interval have, or not; yes or unknown.
  Truth have(const RangeProperty& property, Truth all_sequences) const;
};

/// For all w_0 in `start`, until they are in `kept` for good. Domain: as limit_of_levels, or matrices. Cost: the same.
FollowedLevels follow(const ParametricMask& mask, const Recurrence& recurrence, const FirstValues& start,
                      const Interval& kept, const Budget& budget);

/// Whether the masks at so many levels exist for all w_0 in `start`; no where some do not, or may not. Domain: as
/// above.
bool masks_exist(const ParametricMask& mask, const Recurrence& recurrence, const Interval& start, int levels);

}  // namespace subcert
