#pragma once
/// Masks that change from level to level, and values of their basic limit function, the limit from the unit datum at
/// level 0.

#include "recurrence.hpp"

#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/symbol/masks/level_masks.hpp>
#include <subcert/analysis/symbol/masks/parametric_mask.hpp>

namespace subcert {

/// Those of so many levels of f_{k+1} = S_{w_k} f_k with w_{k+1} = r(w_k). Domain: one letter. Errors: throws
/// Error of kind domain where a level has no value or no mask, or may have none. Error: the w_k are exact where they
/// are rational and short, else within 2^-100 of the true ones.
LevelMasks masks_of_levels(const ParametricMask& mask, const Recurrence& recurrence, const Rational& start,
                           std::size_t levels);

/// Exact, at the points i / arity^level of the closed support. Domain: one variable, one arity; masks that come again,
/// which make a scheme that converges; at most 10^6 values. Errors and cost: as limit_values of these masks as one, and
/// those of the level. Proof: docs/levels.md.
LimitValues limit_values(const LevelMasks& masks, int level, const Deadline& deadline = {});

/// The same of masks of matrices: the values of all functions at i / arity^level, by i and the component, where they
/// are not 0. Those of the first level are the solution of the equation of the masks that come again, as one, that has
/// these values at integers; there are none before it: phi^(k)(x) = sum over j of A^(k)_j phi^(k+1)(arity x - j).
/// Domain: one variable, one arity, one size; masks that come again; values of a continuous solution; at most 10^6
/// values. Errors: throws Error. Cost: coefficients times values. Proof: docs/levels.md.
LatticeSequence limit_values(const LevelMasks& masks, const LatticeSequence& at_integers, int level);

/// values[i] lies around the one at (first_index + i) / arity^level.
struct EnclosedLimitValues {
  int arity;
  int level;
  long first_index;
  std::vector<Interval> values;
  int order;   ///< of the differences by whose contraction the limit is bounded
  int levels;  ///< that were looked at one by one, the others together
};

/// Of f_{k+1} = S_{w_k} f_k with w_{k+1} = r(w_k). Domain: one letter, numbers, coset sums 1; at most 10^6 values.
/// Errors: throws Error of kind domain where a level has no value or no mask, of kind undecided where differences are
/// not proved to contract. Error: widths of some 2^-80, or what 320 levels after that of the points leave. Proof:
/// docs/levels.md.
EnclosedLimitValues limit_values(const ParametricMask& mask, const Recurrence& recurrence, const Rational& start,
                                 int level);

}  // namespace subcert
