#pragma once
/// For which values of its parameter a scheme has a property, with proof.

#include "interval_proof.hpp"

#include <subcert/analysis/symbol/masks/parametric_mask.hpp>
#include <subcert/analysis/symbol/numbers/interval.hpp>

namespace subcert {

/// What is asked of the scheme at each value of the parameter.
struct RangeProperty {
  enum class Kind {
    convergent,  ///< the scheme converges
    smooth,      ///< its limits have `order` continuous derivatives
    hermite,     ///< the same, and the other components of a Hermite scheme converge to derivatives of the first
    holder,      ///< their Hoelder exponent is at least `order`
    sobolev,     ///< their Sobolev exponent is at least `order`
    stable,      ///< the integer shifts of the basic limit function are stable
    preserving   ///< each step keeps differences of this order non-negative: data that are positive, monotone, convex
  };
  Kind kind = Kind::convergent;
  Rational order = 0;
};

/// `convergent`, `C2`, `HC2`, `holder>=3/2`, `sobolev>=1`, `stable`, `positive`, `monotone` or `convex`; nothing for
/// another text. Domain of the numbers: 0 ... 100.
std::optional<RangeProperty> parse_range_property(std::string_view text);

/// Values of w, and whether the property holds for all of them (yes), for none (no), or is not
/// decided.
struct RangePiece {
  Rational low, high;
  Truth holds = Truth::unknown;
  bool low_included = true, high_included = true;
  std::string reason = {};  ///< why it is not decided
};

/// An end of a piece: between a proved and a refuted one the radius of the product of `word` crosses the threshold
/// once, at a zero of the polynomial.
struct RangeEnd {
  Rational low, high;
  LaurentPolynomial polynomial;  ///< irreducible, in w, with one zero between them
  std::vector<int> word;         ///< empty where a spectral radius is meant that is not one of a product
  Truth holds;                   ///< at the zero itself
};

/// A single value, or one that is enclosed, which is looked at on its own.
struct SpecialValue {
  enum class Why {
    sum_rules,  ///< the scheme has more sum rules than at others
    unstable,   ///< the shifts may be unstable there, or are
    sign,       ///< a coefficient of the difference scheme vanishes
    threshold   ///< the radius of a product meets the threshold
  };
  Enclosure value;
  LaurentPolynomial polynomial;  ///< irreducible, in w
  Why why = Why::sum_rules;
  Truth holds = Truth::unknown;  ///< irrational values in a gap are not decided
};

/// The values between low and high, in order, at which the shifts may be unstable or more sum rules hold than for all
/// w; enclosed with this width where they are irrational. `holds` is not decided. Domain: `unstable` of
/// unstable_values.
std::vector<SpecialValue> single_values(const ParametricMask& mask, const LaurentPolynomial& unstable,
                                        const Rational& low, const Rational& high, const Rational& width);

/// Errors: throws Error unless low < high, a sum rule holds for all w, the denominator has no zero from low to high,
/// and arity * (degree in w + 1) is at most 64.
void require_family(const ParametricMask& mask, const Rational& low, const Rational& high);

struct PropertyRange {
  int sum_rules = 0;               ///< that hold for all w
  std::vector<RangePiece> pieces;  ///< one after another, from the first to the last value asked for
  std::vector<RangeEnd> ends;
  std::vector<SpecialValue> special;
  /// The intervals of which the decided pieces consist, in order: those with an upper bound of the radius belong to
  /// proved pieces, those with a lower bound to refuted ones. None for `stable`, and for smoothness beyond the sum
  /// rules.
  std::vector<IntervalProof> proofs;
  bool complete = true;  ///< no undecided piece is longer than the width asked for
};

struct RangeOptions {
  Rational width = power(Rational(10), -9);  ///< of the undecided pieces about an end
  int jobs = 1;
  Budget budget{Deadline::in(60)};
};

/// Decides a property over low <= w <= high by intervals that are halved. With m sum rules for all w and the transition
/// matrices T_t(w) of the scheme for divided differences of order m: the property is proved on an interval by an upper
/// bound of the joint spectral radius of the control matrices of the T_t, and refuted by a real eigenvalue of one
/// product that is too large all over the interval, which Sturm's theorem decides, and by the stability of the shifts.
/// An interval on which a search fails is not decided, and says why. Where all coefficients between the first and the
/// last one are positive, up to zeros of theirs, the scheme converges; that decides what a search leaves open.
/// `sobolev` is decided between the zeros of one polynomial, at which the spectral radius may meet the threshold.
/// `preserving` is decided by the signs of the coefficients of the divided difference scheme of that order, between
/// their zeros. Domain: as require_family; `preserving` with an order up to the number of sum rules; of matrices
/// `convergent`, and `smooth`, `hermite` or `holder` with an order below that number. Errors: throws Error. Error:
/// none; what is not decided within width and budget is left `unknown`. Cost: one joint spectral radius for each
/// interval. Ref: docs/families.md.
PropertyRange property_range(const ParametricMask& mask, const RangeProperty& property, const Rational& low,
                             const Rational& high, const RangeOptions& options);

}  // namespace subcert
