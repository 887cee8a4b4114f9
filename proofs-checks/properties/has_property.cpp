#include "deciding.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/family/property_range.hpp>
#include <subcert/analysis/regularity/holder_regularity.hpp>
#include <subcert/analysis/regularity/multivariate_regularity.hpp>
#include <subcert/analysis/regularity/sobolev.hpp>
#include <subcert/analysis/regularity/stability.hpp>
#include <subcert/analysis/reproduction/multivariate_reproduction.hpp>
#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/decimal.hpp>
#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/variance/variance_range.hpp>

namespace subcert::properties {
namespace {

constexpr int levels = 16;

/// The answer to a question that has a yes or no of its own.
Decision matches(const Decision& found, bool expected) {
  if (found.truth == Truth::unknown) return found;
  return decided(found.is_yes() == expected,
                 std::string(found.is_yes() ? "yes" : "no") + (found.reason.empty() ? "" : ": " + found.reason));
}

/// By contraction, or by the exponent.
Decision convergence_of(const Mask& mask, double seconds) {
  Decision decision = converges(mask, {levels, Deadline::in(seconds)});
  if (decision.truth != Truth::unknown) return decision;
  return holder_regularity(mask, levels, {Deadline::in(seconds)}).converges;
}

Decision smoothness(const Mask& mask, const Expectation& expectation, double seconds) {
  const Decision convergence = converges(mask, {levels, Deadline::in(seconds)});
  if (convergence.is_no()) return decided(false, "not convergent: " + convergence.reason);
  const SmoothnessProof proof = proved_smoothness(mask, {levels, Deadline::in(seconds)});
  if (proof.order >= expectation.number)
    return decided(true, "C^" + std::to_string(proof.order) + ": " + proof.evidence);
  if (!is_affine(mask)) return {Truth::unknown, proof.obstacle};
  const HolderRegularity regularity = holder_regularity(mask, levels, {Deadline::in(seconds)});
  const Enclosure& exponent = regularity.exponent;
  const std::string found = "the Hoelder exponent lies in [" + exponent.lower_text(8) + ", " + exponent.upper_text(8) +
                            "]";
  const Truth smooth = has_derivatives(regularity, expectation.number);
  if (smooth != Truth::unknown) return {smooth, found};
  return {Truth::unknown, "C^" + std::to_string(proof.order) + " is proved; " + found};
}

Decision holder(const Mask& mask, const Expectation& expectation, double seconds) {
  if (!is_affine(mask)) return decided(false, "a coset sum is not 1, so the scheme does not converge");
  const HolderRegularity regularity = holder_regularity(mask, levels, {Deadline::in(seconds)});
  Enclosure exponent = regularity.exponent;
  // Otherwise the lower end proves nothing.
  if (exponent.lower && *exponent.lower <= 0) exponent.lower = regularity.proved_exponent().lower;
  return compare(exponent, expectation, "the exponent");
}

Decision sobolev(const Mask& mask, const Expectation& expectation, double seconds) {
  const Decision convergence = convergence_of(mask, seconds);
  if (!convergence.is_yes()) return {Truth::unknown, "convergence is not proved: " + convergence.reason};
  const auto found = sobolev_regularity(mask, Deadline::in(seconds));
  if (!found) return {Truth::unknown, "the spectral radius was not computed in time"};
  return compare(found->exponent, expectation, "the exponent");
}

Decision variance(const Mask& mask, const Expectation& expectation, double seconds) {
  const Decision convergence = convergence_of(mask, seconds);
  if (!convergence.is_yes()) return {Truth::unknown, "convergence is not proved: " + convergence.reason};
  try {
    VarianceOptions options;
    options.budget.deadline = Deadline::in(seconds);
    return compare(variance_range(mask, options).maximum, expectation, "the maximum");
  } catch (const Error& error) {  // beyond what the library can enclose
    return {Truth::unknown, error.what()};
  }
}

std::string word_of(Symmetry kind) { return kind == Symmetry::odd ? "odd" : kind == Symmetry::even ? "even" : "none"; }

bool is_interpolatory(const Mask& mask) { return mask.symbol().coset(mask.arity(), 0) == LaurentPolynomial(1); }

Decision whole_number(long value, const Expectation& expectation) {
  return decided(compare(Rational(value), expectation.relation, expectation.number), "it is " + std::to_string(value));
}

/// Whether the old values are kept: of the indices in M Z^s only 0 has a coefficient, which is 1.
bool is_interpolatory(const MultivariateMask& mask) {
  const LatticePoint zero(mask.dilation().variables(), 0);
  const std::size_t digit = mask.dilation().divide(zero).digit;
  for (const auto& term : mask.symbol().terms())
    if (mask.dilation().divide(term.exponents).digit == digit && term.exponents != zero) return false;
  return mask.symbol().coefficient(zero) == 1;
}

Decision property_of(const MultivariateScheme& scheme, const Expectation& expectation, double seconds) {
  const std::string& property = expectation.property;
  if (property == "interpolatory")
    return matches({is_interpolatory(scheme.mask) ? Truth::yes : Truth::no, ""}, expectation.yes);
  const MultivariateReproduction polynomials = scheme.factors.empty() ? polynomial_reproduction(scheme.mask)
                                                                      : tensor_product_reproduction(scheme.factors);
  if (property == "sum_rules") return whole_number(polynomials.sum_rules, expectation);
  if (property == "generates") return whole_number(polynomials.generation_degree(), expectation);
  if (property == "reproduces") return whole_number(polynomials.reproduction_degree, expectation);
  const Budget budget{Deadline::in(seconds)};
  const MultivariateRegularity regularity = scheme.factors.empty() ? multivariate_regularity(scheme.mask, budget)
                                                                   : tensor_product_regularity(scheme.factors, budget);
  if (property == "convergent") return matches(regularity.converges, expectation.yes);
  if (property == "stable") return matches(regularity.stable, expectation.yes);
  if (property == "smoothness") return smoothness(regularity, expectation);
  if (property == "holder") {
    if (regularity.converges.is_no()) return decided(false, "not convergent: " + regularity.converges.reason);
    return compare(regularity.exponent, expectation, "the exponent");
  }
  if (property == "sobolev") {
    if (!regularity.sobolev) return {Truth::unknown, "the spectral radius was not computed in time"};
    return compare(*regularity.sobolev, expectation, "the exponent");
  }
  fail(ErrorKind::domain, "has_property: need a property of surfaces, got '{}'", property);
}

/// What depends on coefficients that are rounded; nothing for properties that do not.
std::optional<Decision> property_of_rounded(const Scheme& scheme, const Expectation& expectation, double seconds) {
  const std::string& property = expectation.property;
  if (property == "sobolev" || property == "variance" || property == "reproduces")
    return Decision{Truth::unknown, "the coefficients are rounded"};
  if (property == "stable") return matches(has_stable_shifts(scheme.mask, scheme.rounding->distance), expectation.yes);
  if (property != "convergent" && property != "holder" && property != "smoothness") return std::nullopt;
  const HolderRegularity regularity = holder_regularity(scheme.mask, levels, {Deadline::in(seconds)},
                                                        HolderProof::shortest, scheme.rounding);
  const Enclosure& exponent = regularity.exponent;
  const bool converges = *exponent.lower > 0;
  if (property == "convergent")
    return matches({converges ? Truth::yes : Truth::unknown, converges ? "the exponent is positive" : "not proved"},
                   expectation.yes);
  if (!converges) return Decision{Truth::unknown, "convergence is not proved"};
  if (property == "holder") return compare(exponent, expectation, "the exponent");
  return Decision{has_derivatives(regularity, expectation.number),
                  "the Hoelder exponent lies in [" + exponent.lower_text(8) + ", " + exponent.upper_text(8) + "]"};
}

Decision property_of(const Scheme& scheme, const Expectation& expectation, double seconds) {
  if (scheme.rounding)
    if (auto decision = property_of_rounded(scheme, expectation, seconds)) return *std::move(decision);
  const Mask& mask = scheme.mask;
  const std::string& property = expectation.property;
  if (property == "convergent") return matches(convergence_of(mask, seconds), expectation.yes);
  if (property == "stable") {
    const Decision convergence = convergence_of(mask, seconds);
    if (!convergence.is_yes()) return {Truth::unknown, "convergence is not proved: " + convergence.reason};
    return matches(has_stable_shifts(mask), expectation.yes);
  }
  if (property == "interpolatory")
    return matches({is_interpolatory(mask) ? Truth::yes : Truth::no, ""}, expectation.yes);
  if (property == "smoothness") return smoothness(mask, expectation, seconds);
  if (property == "holder") return holder(mask, expectation, seconds);
  if (property == "sobolev") return sobolev(mask, expectation, seconds);
  if (property == "variance") return variance(mask, expectation, seconds);
  if (property == "sum_rules") return whole_number(sum_rules(mask), expectation);
  if (property == "generates") return whole_number(polynomial_reproduction(mask).generation_degree, expectation);
  if (property == "reproduces") return whole_number(polynomial_reproduction(mask).reproduction_degree, expectation);
  if (property == "symmetry") {
    const std::string found = word_of(symmetry(mask).kind);
    return decided(found == expectation.word, "it is " + found);
  }
  if (property == "support") {
    const Interval found = limit_support(mask);
    return decided(found.lower == expectation.ends->lower && found.upper == expectation.ends->upper,
                   "it is [" + subcert::to_text(found.lower) + ", " + subcert::to_text(found.upper) + "]");
  }
  fail(ErrorKind::domain, "has_property: need a known property, got '{}'", property);
}

RangeProperty range_property(const Expectation& expectation) {
  using Kind = RangeProperty::Kind;
  if (expectation.property == "convergent") return {Kind::convergent, 0};
  if (expectation.property == "stable") return {Kind::stable, 0};
  if (expectation.property == "holder") return {Kind::holder, expectation.number};
  if (expectation.property == "sobolev") return {Kind::sobolev, expectation.number};
  return {expectation.number == 0 ? Kind::convergent : Kind::smooth, expectation.number};
}

/// For all values: every piece is proved, single values of gaps included.
Decision property_of(const SchemeRange& range, const Expectation& expectation, double seconds) {
  const std::string letter(1, range.family.parameter);
  const auto describe = [&](const RangePiece& piece, const char* verdict) {
    const auto text = [](const Rational& value) { return to_decimal(value, 10, Rounding::nearest); };
    return verdict + (piece.low == piece.high
                          ? " for " + letter + " = " + text(piece.low)
                          : " for " + text(piece.low) + " <= " + letter + " <= " + text(piece.high));
  };
  const PropertyRange found = property_range(range.family.mask, range_property(expectation), range.values.low,
                                             range.values.high, {power(Rational(10), -9), 1, {Deadline::in(seconds)}});
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

Decision has_property(const ExpectedScheme& scheme, const Expectation& expectation, double seconds) {
  return std::visit([&](const auto& one) { return property_of(one, expectation, seconds); }, scheme.scheme);
}

}  // namespace subcert::properties
