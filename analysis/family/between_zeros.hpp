#pragma once
/// Properties that change only at zeros of polynomials in the parameter. Inner header.

#include "property_range.hpp"

namespace subcert::family {

/// The real zeros of a polynomial in w from low to high, each with its irreducible factor, in order. None for
/// polynomials that are constant.
std::vector<SpecialValue> zeros_of(const LaurentPolynomial& polynomial, const Rational& low, const Rational& high,
                                   const Rational& width, SpecialValue::Why why);

/// Puts a value among others, in the place of the same one for another reason.
void replace_equal(std::vector<SpecialValue>& values, SpecialValue value);
/// In increasing order.
void sort_values(std::vector<SpecialValue>& values);

/// Whether the scheme has the property at one value; unknown where a search fails.
Truth holds_at(const Mask& mask, const RangeProperty& property, const Deadline& deadline);

/// A reason for what is not decided.
inline const std::string spent = "the budget ran out";
/// Adds one that is not there yet.
void add_reason(std::string& reasons, const std::string& reason);
/// The one where unstable_values is 0.
std::string why_stability_is_open(const Deadline& deadline);

/// Neighbours with one verdict as one piece, with all their reasons.
std::vector<RangePiece> merged(const std::vector<RangePiece>& pieces);

/// No undecided piece is longer.
bool is_complete(const std::vector<RangePiece>& pieces, const Rational& width);

/// Whether the property is known to change at zeros of polynomials only: stability, signs, Sobolev exponents, and
/// smoothness that stable shifts have with more sum rules only.
bool changes_at_zeros(const RangeProperty& property, int rules);

/// Decides such a property. Domain: as property_range.
PropertyRange property_between_zeros(const ParametricMask& mask, int rules, const RangeProperty& property,
                                     const Rational& low, const Rational& high, const RangeOptions& options);

}  // namespace subcert::family
