#pragma once
/// The Hoelder exponent as a function of a parameter, between certified envelopes.

#include "property_range.hpp"

namespace subcert {

/// Values of w from proof.low to proof.high. For all of them the exponent is at least the lower end, where that is
/// positive: then the scheme converges; and below the upper end, or the scheme does not converge. A scheme whose upper
/// end is not positive does not converge. The upper end is absent where shifts may be unstable for a value. Without a
/// product that leads it is the number of sum rules, or the exponent at a single value that has more of them. Of
/// matrices the exponent is that of the limits, and the upper end is absent unless the scheme is proved not to
/// converge, or to interpolate a function and its derivatives, one less than components.
struct CurvePiece {
  Enclosure exponent;
  /// proof.below names the product that leads, if one does; proof.reason says why an end is absent.
  IntervalProof proof;
};

/// A single value, with the exponent that the scheme has there.
struct CurvePoint {
  SpecialValue at;
  std::optional<Enclosure> exponent;  ///< of rational values
};

struct ExponentCurve {
  int sum_rules = 0;               ///< that hold for all w
  std::vector<CurvePiece> pieces;  ///< one after another, from the first to the last value asked for
  std::vector<CurvePoint> special;
};

struct CurveOptions {
  int pieces = 200;
  int jobs = 1;
  Budget budget{Deadline::in(60)};
};

/// Encloses s(w) on intervals that cover low <= w <= high, more of them where the envelopes are far apart. With m sum
/// rules for all w: the lower end is m - log_a of an upper bound of the joint spectral radius of the control matrices,
/// the upper end comes from an eigenvalue of one product that is bounded on the whole interval by Sturm's theorem.
/// Domain: as property_range; 1 <= pieces <= 10^5. Errors: throws Error. Error: none, both ends are proved; their
/// distance is about the change of s on the interval. Cost: a joint spectral radius and a few characteristic
/// polynomials for each interval. Ref: docs/families.md.
ExponentCurve exponent_curve(const ParametricMask& mask, const Rational& low, const Rational& high,
                             const CurveOptions& options);

}  // namespace subcert
