#pragma once
/// What decides whether a value that was found is one that is expected. Inner header.

#include "properties.hpp"

#include <subcert/analysis/regularity/multivariate_regularity.hpp>

namespace subcert::properties {

/// `value RELATION number`.
bool compare(const Rational& value, const std::string& relation, const Rational& number);

/// yes where the comparison holds for all numbers of the enclosure, no where it holds for none, else unknown; an absent
/// end is beyond all numbers. `what` names the value in the reason.
Decision compare(const Enclosure& value, const Expectation& expectation, const std::string& what);

/// `WHAT lies in [2, 3]`, with the digits that tell the ends from the threshold.
std::string lies_in(const std::string& what, const Enclosure& value, const Rational& threshold);

/// The answer of two.
Decision decided(bool yes, const std::string& found);

/// What is asked of ranges and levels. C^0 limits are those of a scheme that converges. Domain: property.of_ranges.
RangeProperty asked_of(const Property& property, const Expectation& expectation);

/// `3..12` or `3,5,8..10`, up to 1000. Errors: throws ParseError.
std::vector<int> valences_of(const std::string& text);
/// Whether limits are C1 at vertices of all valences of the word. Errors: throws a domain error for schemes without
/// rules there. Cost: as vertex_smoothness().
Decision smooth_at_vertices(const Scheme& scheme, const Expectation& expectation, const SearchLimits& limits);

/// Of masks that change from level to level, or from point to point. Domain: property.of_levels().
Decision property_of(const SchemeLevels& levels, const Property& property, const Expectation& expectation,
                     const SearchLimits& limits);
Decision property_of(const SchemePoints& points, const Property& property, const Expectation& expectation,
                     const SearchLimits& limits);
Decision property_of(const SchemeList& list, const Property& property, const Expectation& expectation,
                     const SearchLimits& limits);

/// Whether limits of surfaces are C^k. An exponent above k says yes and one below it no; one that is k says neither.
Decision smoothness(const MultivariateRegularity& regularity, const Expectation& expectation);

}  // namespace subcert::properties
