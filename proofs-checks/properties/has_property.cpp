#include "deciding.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/regularity/component_support.hpp>
#include <subcert/analysis/regularity/regularity.hpp>
#include <subcert/analysis/regularity/sobolev.hpp>
#include <subcert/analysis/regularity/stability.hpp>
#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/masks/matrix_masks.hpp>
#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/variance/variance_range.hpp>
#include <subcert/proofs-checks/certificates/scheme_regularity.hpp>
#include <subcert/schemes/data/refine/vector_refinement.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace subcert::properties {
namespace {

constexpr int levels = 16;

/// The answer to a question that has a yes or no of its own.
Decision matches(const Decision& found, bool expected) {
  if (found.truth == Truth::unknown) return found;
  return decided(found.is_yes() == expected,
                 std::string(found.is_yes() ? "yes" : "no") + (found.reason.empty() ? "" : ": " + found.reason));
}

/// What follows for other properties from convergence that is not proved.
Decision without_convergence(const Decision& converges) {
  return converges.is_no() ? decided(false, "not convergent: " + converges.reason)
                           : Decision{Truth::unknown, "convergence is not proved"};
}

/// By contraction, or by the exponent.
Decision convergence_of(const Mask& mask, const SearchLimits& limits) {
  Decision decision = converges(mask, {levels, limits.budget().deadline});
  if (decision.truth != Truth::unknown) return decision;
  return holder_regularity(mask, levels, limits.budget()).converges;
}

Decision rounded_coefficients() { return {Truth::unknown, "the coefficients are rounded"}; }

/// For all masks that are meant.
Regularity regularity_of(const Scheme& scheme, const SearchLimits& limits) {
  return subcert::regularity_of(scheme.mask, limits.budget(), of_scheme(scheme, {.levels = levels}));
}

Decision convergence_of(const Scheme& scheme, const SearchLimits& limits) {
  return scheme.rounding ? regularity_of(scheme, limits).converges() : convergence_of(scheme.mask.curve(), limits);
}

Decision convergent(const Scheme& scheme, const Expectation& expectation, const SearchLimits& limits) {
  return matches(convergence_of(scheme, limits), expectation.yes);
}

Decision smoothness(const Scheme& scheme, const Expectation& expectation, const SearchLimits& limits) {
  const Mask& mask = scheme.mask.curve();
  if (scheme.rounding) {
    const HolderRegularity regularity = *regularity_of(scheme, limits).curve;
    if (!regularity.converges.is_yes()) return without_convergence(regularity.converges);
    return {has_derivatives(regularity, expectation.number),
            lies_in("the Hoelder exponent", regularity.exponent, expectation.number)};
  }
  const Decision convergence = converges(mask, {levels, limits.budget().deadline});
  if (convergence.is_no()) return without_convergence(convergence);
  const SmoothnessProof proof = proved_smoothness(mask, {levels, limits.budget().deadline});
  if (proof.order >= expectation.number)
    return decided(true, "C^" + std::to_string(proof.order) + ": " + proof.evidence);
  if (!is_affine(mask)) return {Truth::unknown, proof.obstacle};
  const HolderRegularity regularity = *regularity_of(scheme, limits).curve;
  const std::string found = lies_in("the Hoelder exponent", regularity.exponent, expectation.number);
  const Truth smooth = has_derivatives(regularity, expectation.number);
  if (smooth != Truth::unknown) return {smooth, found};
  return {Truth::unknown, "C^" + std::to_string(proof.order) + " is proved; " + found};
}

Decision holder(const Scheme& scheme, const Expectation& expectation, const SearchLimits& limits) {
  if (!scheme.rounding && !is_affine(scheme.mask.curve()))
    return decided(false, "a coset sum is not 1, so the scheme does not converge");
  const HolderRegularity regularity = *regularity_of(scheme, limits).curve;
  Enclosure exponent = regularity.exponent;
  if (scheme.rounding && !regularity.converges.is_yes()) return without_convergence(regularity.converges);
  // Otherwise the lower end proves nothing.
  if (exponent.lower && *exponent.lower <= 0) exponent.lower = regularity.proved_exponent().lower;
  return compare(exponent, expectation, "the exponent");
}

Decision sobolev(const Scheme& scheme, const Expectation& expectation, const SearchLimits& limits) {
  if (scheme.rounding) return rounded_coefficients();
  const Mask& mask = scheme.mask.curve();
  const Decision convergence = convergence_of(mask, limits);
  if (!convergence.is_yes()) return {Truth::unknown, "convergence is not proved: " + convergence.reason};
  const auto found = sobolev_regularity(mask, limits.budget().deadline);
  if (!found) return {Truth::unknown, "the spectral radius was not computed in time"};
  return compare(found->exponent, expectation, "the exponent");
}

Decision variance(const Scheme& scheme, const Expectation& expectation, const SearchLimits& limits) {
  if (scheme.rounding) return rounded_coefficients();
  const Mask& mask = scheme.mask.curve();
  const Decision convergence = convergence_of(mask, limits);
  if (!convergence.is_yes()) return {Truth::unknown, "convergence is not proved: " + convergence.reason};
  try {
    VarianceOptions options;
    options.budget = limits.budget();
    return compare(variance_range(mask, options).maximum, expectation, "the maximum");
  } catch (const Error& error) {  // beyond what the library can enclose
    return {Truth::unknown, error.what()};
  }
}

std::string word_of(Symmetry kind) { return kind == Symmetry::odd ? "odd" : kind == Symmetry::even ? "even" : "none"; }

Decision whole_number(long value, const Expectation& expectation) {
  return decided(compare(Rational(value), expectation.relation, expectation.number), "it is " + std::to_string(value));
}

/// Whether the data are kept at the old places, derivatives per unit of the finer spacing.
Decision interpolatory(const Scheme& scheme, const Expectation& expectation, const SearchLimits&) {
  const LatticeMask& mask = scheme.mask;
  const bool kept = keeps_data(mask.terms(), mask.components(), mask.dilation(), scheme.form == VectorForm::hermite);
  return matches({kept ? Truth::yes : Truth::no, ""}, expectation.yes);
}

Decision stable(const Scheme& scheme, const Expectation& expectation, const SearchLimits& limits) {
  const Decision convergence = convergence_of(scheme, limits);
  if (!convergence.is_yes()) return {Truth::unknown, "convergence is not proved: " + convergence.reason};
  const Mask& mask = scheme.mask.curve();
  return matches(scheme.rounding ? has_stable_shifts(mask, scheme.rounding->distance, scheme.rounding->sum_rules)
                                 : has_stable_shifts(mask),
                 expectation.yes);
}

Decision symmetry_of(const Scheme& scheme, const Expectation& expectation, const SearchLimits&) {
  const std::string found = word_of(symmetry(scheme.mask.curve()).kind);
  return decided(found == expectation.word, "it is " + found);
}

std::string interval_text(const Interval& of) {
  return "[" + subcert::to_text(of.lower) + ", " + subcert::to_text(of.upper) + "]";
}

Decision support_of(const Scheme& scheme, const Expectation& expectation, const SearchLimits&) {
  const Interval found = limit_support(scheme.mask.curve());
  return decided(found == *expectation.ends, "it is " + interval_text(found));
}

Decision holder_of_surface(const Scheme& scheme, const Expectation& expectation, const SearchLimits& limits) {
  const Regularity regularity = regularity_of(scheme, limits);
  if (regularity.converges().is_no()) return decided(false, "not convergent: " + regularity.converges().reason);
  return compare(regularity.exponent(), expectation, "the exponent");
}

Decision sobolev_of_surface(const Scheme& scheme, const Expectation& expectation, const SearchLimits& limits) {
  const auto found = regularity_of(scheme, limits).surface->sobolev;
  if (!found) return {Truth::unknown, "the spectral radius was not computed in time"};
  return compare(*found, expectation, "the exponent");
}

/// What is known of a vector of functions. Exponents are those of the worst function and solution.
const FunctionVector& vector_of(const Regularity& regularity) { return *regularity.surface->vector; }

Decision smoothness_of_vector(const Scheme& scheme, const Expectation& expectation, const SearchLimits& limits) {
  const Regularity regularity = regularity_of(scheme, limits);
  const FunctionVector& vector = vector_of(regularity);
  if (!vector.continuous.is_yes() || expectation.number == 0) return vector.continuous;
  const Enclosure exponent = regularity.exponent();
  const std::string found = lies_in("the Hoelder exponent", exponent, expectation.number);
  if (*exponent.lower > expectation.number) return decided(true, found);
  // docs/vectors.md, theorem 3
  if (exponent.upper && *exponent.upper <= expectation.number) return decided(false, found);
  return {Truth::unknown, found};
}

Decision holder_of_vector(const Scheme& scheme, const Expectation& expectation, const SearchLimits& limits) {
  const Regularity regularity = regularity_of(scheme, limits);
  const FunctionVector& vector = vector_of(regularity);
  if (vector.continuous.is_no()) return decided(false, "no continuous solution: " + vector.continuous.reason);
  return compare(regularity.exponent(), expectation, "the exponent");
}

/// Of the smallest interval that holds the supports of all functions.
Decision support_of_vector(const Scheme& scheme, const Expectation& expectation, const SearchLimits& limits) {
  const Regularity regularity = regularity_of(scheme, limits);
  const FunctionVector& vector = vector_of(regularity);
  if (!vector.continuous.is_yes()) return {vector.continuous.truth, "no continuous solution is proved"};
  if (!vector.values || vector.root > 0)
    return {Truth::unknown, "it is computed of one solution alone, and of rational matrices"};
  try {
    std::optional<Interval> whole;
    std::string each;
    const auto supports = component_supports(scheme.mask, *vector.values);
    for (std::size_t c = 0; c < supports.size(); ++c) {
      each += fmt::format(", phi_{} {}", c + 1, supports[c] ? interval_text(*supports[c]) : "is 0");
      if (!supports[c]) continue;
      whole = whole ? Interval{std::min(whole->lower, supports[c]->lower), std::max(whole->upper, supports[c]->upper)}
                    : *supports[c];
    }
    return decided(*whole == *expectation.ends, "it is " + interval_text(*whole) + ":" + each.substr(1));
  } catch (const Error& error) {
    return {Truth::unknown, error.what()};
  }
}

Decision sobolev_of_vector(const Scheme& scheme, const Expectation& expectation, const SearchLimits& limits) {
  const auto found = regularity_of(scheme, limits).surface->sobolev;
  return found ? compare(*found, expectation, "the exponent")
               : Decision{Truth::unknown, "the exponent was not computed"};
}

Decision hermite(const Scheme& scheme, const Expectation& expectation, const SearchLimits& limits) {
  const Regularity regularity = regularity_of(scheme, limits);
  const auto& known = vector_of(regularity).hermite;
  if (known->order < 0) return {known->next.truth, known->next.reason};
  const std::string found = fmt::format("HC^{} is proved", known->order);
  if (expectation.number <= known->order) return decided(true, found);
  if (known->next.is_no()) return decided(false, fmt::format("{}, HC^{} refuted", found, known->order + 1));
  return {Truth::unknown, found};
}

/// Of polynomials whose values and derivatives are kept; -1 where not even those of constants are.
Decision reproduces_hermite(const Scheme& scheme, const Expectation& expectation, const SearchLimits&) {
  return whole_number(data::hermite_reproduction(scheme.mask, scheme.quadratic).degree, expectation);
}

}  // namespace

const std::vector<Property>& known_properties() {
  using Kind = RangeProperty::Kind;
  using E = const Expectation&;
  using L = const SearchLimits&;
  using S = const Scheme&;
  const char* answer = "true or false";
  const char* whole = "an integer or a comparison";
  const char* comparison = "\">= X\", \"<= X\", \"> X\", \"< X\" or \"= X\"";
  constexpr auto rules = [](S s, E e, L) { return whole_number(polynomial_reproduction(s.mask).sum_rules, e); };
  constexpr auto generates = [](S s, E e, L) {
    return whole_number(polynomial_reproduction(s.mask).generation_degree(), e);
  };
  constexpr auto reproduces = [](S s, E e, L) {
    return s.rounding ? rounded_coefficients() : whole_number(polynomial_reproduction(s.mask).reproduction_degree, e);
  };
  static const std::vector<Property> all{
      {"convergent", answer, "uniform convergence for all bounded data", Expects::answer, convergent,
       [](S s, E e, L limits) { return matches(regularity_of(s, limits).converges(), e.yes); }, Kind::convergent,
       [](S s, E e, L limits) { return matches(regularity_of(s, limits).converges(), e.yes); }},
      {"smoothness", "\">= K\"", "C^K limits", Expects::order, smoothness,
       [](S s, E e, L limits) { return smoothness(*regularity_of(s, limits).surface, e); }, Kind::smooth,
       smoothness_of_vector},
      {"holder", comparison, "the Hoelder exponent", Expects::comparison, holder, holder_of_surface, Kind::holder,
       holder_of_vector},
      {"sobolev", comparison, "the Sobolev exponent", Expects::comparison, sobolev, sobolev_of_surface, Kind::sobolev,
       sobolev_of_vector},
      {"HC", "\">= K\"", "HC^K: data of a Hermite scheme converge to a C^K function and its derivatives",
       Expects::order, nullptr, nullptr, Kind::hermite, hermite, true},
      {"sum_rules", whole, "the number of sum rules", Expects::whole_number, rules, rules},
      {"generates", whole, "the largest degree of polynomials that are limits", Expects::whole_number, generates,
       generates},
      {"reproduces",
       whole,
       "the largest degree of polynomials that are reproduced",
       Expects::whole_number,
       reproduces,
       reproduces,
       {},
       reproduces_hermite,
       true},
      {"support",
       "[first, last]",
       "the ends of the support of the basic limit function",
       Expects::ends,
       support_of,
       nullptr,
       {},
       support_of_vector},
      {"symmetry", "\"odd\", \"even\" or \"none\"", "of the mask", Expects::word, symmetry_of, nullptr},
      {"stable", answer, "stability of the integer shifts", Expects::answer, stable,
       [](S s, E e, L limits) { return matches(regularity_of(s, limits).stable(), e.yes); }, Kind::stable},
      {"interpolatory",
       answer,
       "whether old values are kept",
       Expects::answer,
       interpolatory,
       interpolatory,
       {},
       interpolatory},
      {"variance", comparison, "the maximum of the variance curve", Expects::comparison, variance, nullptr},
      {"vertices", "valences, as \"3..12\" or 7", "C1 limits at vertices of these valences", Expects::valences, nullptr,
       smooth_at_vertices}};
  return all;
}

Property::Decides Property::decides(const Scheme& of) const {
  if (of_hermite && of.form && of.form != VectorForm::hermite) return nullptr;
  return of.form ? of_vector : of.mask.dimension() == 1 ? of_curve : of_surface;
}

std::string kind_of(const Scheme& scheme) {
  return scheme.form == VectorForm::hermite ? "Hermite schemes"
         : scheme.form                      ? "vectors of functions"
         : scheme.mask.dimension() == 1     ? "schemes of one variable"
                                            : "surfaces";
}

bool Property::of_levels() const {
  using Kind = RangeProperty::Kind;
  return of_ranges == Kind::convergent || of_ranges == Kind::smooth || of_ranges == Kind::holder ||
         of_ranges == Kind::hermite;
}

const Property* find_property(std::string_view name) {
  const auto& all = known_properties();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Property& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
}

namespace {

Decision property_of(const Scheme& scheme, const Property& property, const Expectation& expectation,
                     const SearchLimits& limits) {
  const auto decide = property.decides(scheme);
  if (!decide) fail(ErrorKind::domain, "has_property: need a property of {}, got '{}'", kind_of(scheme), property.name);
  return decide(scheme, expectation, limits);
}

/// For all values: every piece is proved, single values of gaps included.
Decision property_of(const SchemeRange& range, const Property& property, const Expectation& expectation,
                     const SearchLimits& limits) {
  if (!property.of_ranges) fail(ErrorKind::domain, "has_property: need a property of ranges, got '{}'", property.name);
  const std::string& letter = range.family.name;
  const auto describe = [&](const RangePiece& piece, const char* verdict) {
    const auto text = [](const Rational& value) { return to_decimal(value, 10, Rounding::nearest); };
    return verdict + (piece.low == piece.high
                          ? " for " + letter + " = " + text(piece.low)
                          : " for " + text(piece.low) + " <= " + letter + " <= " + text(piece.high));
  };
  const PropertyRange found = property_range(range.family.mask, asked_of(property, expectation), range.values.low,
                                             range.values.high, {power(Rational(10), -9), 1, limits.budget()});
  Decision answer{Truth::yes, ""};
  for (const RangePiece& piece : found.pieces) {
    const bool outside = piece.low == piece.high && ((piece.low == range.values.low && !range.values.low_included) ||
                                                     (piece.high == range.values.high && !range.values.high_included));
    if (piece.holds == Truth::no && !outside) return decided(false, describe(piece, "refuted"));
    if (piece.holds == Truth::unknown && !outside && answer.is_yes())
      answer = {Truth::unknown, describe(piece, "open") + ": " + piece.reason};
  }
  for (const SpecialValue& value : found.special)
    if (value.holds == Truth::no && value.value.is_exact()) {
      const Rational& w = *value.value.lower;
      if ((w > range.values.low || range.values.low_included) && (w < range.values.high || range.values.high_included))
        return decided(false, describe({w, w}, "refuted"));
    }
  return answer;
}

}  // namespace

Decision has_property(const ExpectedScheme& scheme, const Expectation& expectation, const SearchLimits& limits) {
  const Property* property = find_property(expectation.property);
  if (!property) fail(ErrorKind::domain, "has_property: need a known property, got '{}'", expectation.property);
  return std::visit([&](const auto& one) { return property_of(one, *property, expectation, limits); }, scheme.scheme);
}

}  // namespace subcert::properties
