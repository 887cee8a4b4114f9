#include "between_zeros.hpp"

#include "family_radius.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/regularity/holder_regularity.hpp>
#include <subcert/analysis/regularity/sobolev.hpp>
#include <subcert/analysis/regularity/stability.hpp>
#include <subcert/analysis/symbol/polynomials/real_roots.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <functional>

namespace subcert::family {
namespace {

using Kind = RangeProperty::Kind;
using Why = SpecialValue::Why;

constexpr double special_seconds = 10;  // for one value
constexpr int levels = 12;              // of norms, at special values
constexpr long most_terms = 250;        // of a polynomial that is factored

bool is_same(const SpecialValue& a, const SpecialValue& b) {
  return a.polynomial == b.polynomial && a.value.lower == b.value.lower;
}

/// What is asked for, and what is known about it.
struct Question {
  const ParametricMask& mask;
  const RangeProperty& property;
  Rational low, high;  ///< of the range
  const RangeOptions& options;

  Truth at(const Rational& w) const { return holds_at(mask.at(w), property, options.budget.deadline); }
  std::vector<SpecialValue> zeros(const LaurentPolynomial& polynomial, Why why) const {
    return zeros_of(polynomial, low, high, options.width, why);
  }
};

/// One verdict between neighbouring zeros of polynomials, which are looked at on their own. `between`: the verdict at a
/// value there.
PropertyRange by_verdicts(const Question& question, std::vector<SpecialValue> zeros,
                          const std::function<Truth(const Rational&)>& between) {
  std::vector<RangePiece> pieces;
  Rational reached = question.low;
  const auto add_up_to = [&](const Rational& end, bool included) {
    if (reached < end) pieces.push_back({reached, end, between((reached + end) / 2), pieces.empty(), included});
  };
  for (SpecialValue& zero : zeros) {
    const Rational &low = *zero.value.lower, &high = *zero.value.upper;
    if (low == high) zero.holds = question.at(low);
    if (!pieces.empty() && low < reached) {
      // Enclosures of zeros of two polynomials overlap.
      pieces.back().holds = Truth::unknown;
      pieces.back().high = std::max(reached, high);
    } else {
      add_up_to(low, false);
      pieces.push_back({low, high, zero.holds});
    }
    reached = pieces.back().high;
  }
  add_up_to(question.high, true);
  for (RangePiece& piece : pieces)
    if (piece.holds == Truth::unknown)
      piece.reason = question.options.budget.deadline.expired() ? spent
                     : piece.low == piece.high                  ? "a single value, at which no proof was found"
                                                                : "values at which the answer may change lie there";
  PropertyRange result;
  result.pieces = merged(pieces);
  result.special = std::move(zeros);
  return result;
}

/// Values at which all that is known may change: none where the polynomial of stability is not known.
std::optional<std::vector<SpecialValue>> values_of_stability(const Question& question) {
  const LaurentPolynomial unstable = unstable_values(question.mask, question.options.budget.deadline);
  if (unstable.is_zero()) return std::nullopt;
  if (question.property.kind == Kind::stable) return question.zeros(unstable, Why::unstable);
  return single_values(question.mask, unstable, question.low, question.high, question.options.width);
}

PropertyRange all_undecided(const Question& question, const std::string& reason) {
  PropertyRange result;
  result.pieces = {{question.low, question.high, Truth::unknown, true, true, reason}};
  return result;
}

/// Stability, or smoothness that stable shifts have with more sum rules only.
PropertyRange by_stability(const Question& question) {
  auto values = values_of_stability(question);
  if (!values) return all_undecided(question, why_stability_is_open(question.options.budget.deadline));
  const Truth verdict = question.property.kind == Kind::stable ? Truth::yes : Truth::no;
  return by_verdicts(question, std::move(*values), [=](const Rational&) { return verdict; });
}

/// By the signs of the coefficients.
PropertyRange by_signs(const Question& question) {
  const ParametricMask differences = divided_difference_scheme(question.mask,
                                                               numerator(question.property.order).convert_to<int>());
  std::vector<SpecialValue> zeros;
  for (long i = differences.support().first; i <= differences.support().last; ++i)
    for (SpecialValue& zero : question.zeros(differences.coefficient(i), Why::sign))
      replace_equal(zeros, std::move(zero));
  sort_values(zeros);
  return by_verdicts(question, std::move(zeros), [&](const Rational& w) { return question.at(w); });
}

/// The matrices of the Sobolev exponent have their spectral radius as an eigenvalue, so that the exponent meets a
/// number only where that eigenvalue is a power of the arity.
class SobolevCrossing {
 public:
  SobolevCrossing(const Question& question, int rules)
      : question_(question),
        exponent_(2 * (rules - question.property.order) + 1),
        family_(central_matrices(divided_difference_scheme(question.mask, rules))),
        radius_(family_) {}

  /// Zeros of one polynomial, but for those where a larger eigenvalue is proved; nothing where it would be large, or
  /// vanishes for all w.
  std::optional<std::vector<SpecialValue>> values() {
    const auto times = denominator(exponent_).convert_to<int>();
    const Rational modulus = power(Rational(question_.mask.arity()), numerator(exponent_).convert_to<long>());
    if (static_cast<long>(family_.size()) * times * family_.mask.degree() > most_terms) return std::nullopt;
    const Deadline& deadline = question_.options.budget.deadline;
    const LaurentPolynomial polynomial = in_one_letter(
        radius_.characteristic({std::vector<int>(static_cast<std::size_t>(times), 0), modulus, 0}, deadline));
    if (polynomial.is_zero()) return std::nullopt;
    std::vector<SpecialValue> zeros = question_.zeros(polynomial, Why::threshold);
    const Rational threshold = *root_enclosure(modulus, times).upper;
    std::erase_if(zeros, [&](const SpecialValue& zero) {
      return radius_.from_below({{*zero.value.lower}, {*zero.value.upper}}, {0}, threshold, false, deadline)
          .has_value();
    });
    return zeros;
  }

 private:
  const Question& question_;
  Rational exponent_;
  ParametricFamily family_;
  FamilyRadius radius_;
};

/// Where the property holds on one side of an enclosed value it holds at the value, as the spectral radius is
/// continuous and the exponent at least what it says.
void decide_by_neighbours(PropertyRange& range) {
  const std::vector<SpecialValue> values = range.special;
  std::vector<RangePiece>& pieces = range.pieces;
  const auto verdict = [&](const Rational& w, bool above) {
    for (const RangePiece& piece : pieces)
      if (above ? piece.low <= w && w < piece.high : piece.low < w && w <= piece.high) return piece.holds;
    return Truth::unknown;
  };
  std::erase_if(range.special, [&](SpecialValue& value) {
    const Rational &low = *value.value.lower, &high = *value.value.upper;
    const Truth before = verdict(low, false), after = verdict(high, true);
    if (before == Truth::yes || after == Truth::yes) value.holds = Truth::yes;
    const bool is_end = value.why == Why::threshold && before != after && before != Truth::unknown &&
                        after != Truth::unknown;
    if (is_end) range.ends.push_back({low, high, value.polynomial, {}, value.holds});
    return is_end;
  });
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const auto holds = [&](std::size_t other) {
      return other < pieces.size() && pieces[other].holds == Truth::yes && pieces[other].low < pieces[other].high;
    };
    const bool before = k > 0 && holds(k - 1), after = holds(k + 1), single = pieces[k].low == pieces[k].high;
    const auto inside = [&](const SpecialValue& value) {
      return pieces[k].low <= *value.value.lower && *value.value.upper <= pieces[k].high;
    };
    if (pieces[k].holds == Truth::unknown &&
        (single ? before || after : before && after && std::ranges::count_if(values, inside) == 1))
      pieces[k].holds = Truth::yes;
  }
  pieces = merged(pieces);
}

PropertyRange by_sobolev_exponents(const Question& question, int rules) {
  auto crossings = SobolevCrossing(question, rules).values();
  auto values = values_of_stability(question);
  const Deadline& deadline = question.options.budget.deadline;
  if (!values) return all_undecided(question, why_stability_is_open(deadline));
  if (!crossings)
    return all_undecided(question,
                         deadline.expired() ? spent : "the values where the exponent meets the order are not known");
  for (SpecialValue& value : *crossings) {
    if (std::ranges::none_of(*values, [&](const SpecialValue& other) { return is_same(value, other); }))
      values->push_back(std::move(value));
  }
  sort_values(*values);
  PropertyRange result = by_verdicts(question, std::move(*values), [&](const Rational& w) { return question.at(w); });
  decide_by_neighbours(result);
  return result;
}

/// Of the exponents of the basic limit function.
Truth is_in_sobolev_space(const Mask& mask, const Rational& order, const Deadline& deadline) {
  const auto found = sobolev_regularity(mask, deadline.at_most(special_seconds));
  if (!found) return Truth::unknown;
  if (*found->exponent.lower >= order) return Truth::yes;
  return found->exponent.upper && *found->exponent.upper < order ? Truth::no : Truth::unknown;
}

}  // namespace

void sort_values(std::vector<SpecialValue>& values) {
  std::ranges::sort(values, {}, [](const SpecialValue& value) -> const Rational& { return *value.value.lower; });
}

void replace_equal(std::vector<SpecialValue>& values, SpecialValue value) {
  std::erase_if(values, [&](const SpecialValue& other) { return is_same(value, other); });
  values.push_back(std::move(value));
}

std::vector<SpecialValue> zeros_of(const LaurentPolynomial& polynomial, const Rational& low, const Rational& high,
                                   const Rational& width, SpecialValue::Why why) {
  std::vector<SpecialValue> result;
  if (polynomial.is_zero() || polynomial == LaurentPolynomial(polynomial.coefficient(0))) return result;
  for (const PolynomialFactor& factor : irreducible_factors(polynomial)) {
    const LaurentPolynomial& p = factor.polynomial;
    if (const auto root = zero_of_linear(p)) {
      if (low <= *root && *root <= high) result.push_back({Enclosure::exactly(*root), p, why, Truth::unknown});
      continue;
    }
    for (const Enclosure& root : real_roots(p, low, high, width)) result.push_back({root, p, why, Truth::unknown});
  }
  sort_values(result);
  return result;
}

Truth holds_at(const Mask& mask, const RangeProperty& property, const Deadline& deadline) {
  if (property.kind == Kind::stable) return has_stable_shifts(mask).truth;
  if (property.kind == Kind::preserving) {
    const Mask differences = divided_difference_scheme(mask, numerator(property.order).convert_to<int>());
    const auto coefficients = differences.symbol().coefficients();
    return std::any_of(coefficients.begin(), coefficients.end(), [](const Rational& c) { return c < 0; }) ? Truth::no
                                                                                                          : Truth::yes;
  }
  if (property.kind == Kind::sobolev) return is_in_sobolev_space(mask, property.order, deadline);
  HolderRegularity regularity;
  try {
    regularity = holder_regularity(mask, levels, {deadline.at_most(special_seconds)});
  } catch (const Error&) {
    return Truth::unknown;
  }
  const Enclosure& exponent = regularity.exponent;
  if (property.kind == Kind::smooth) return has_derivatives(regularity, property.order);
  if (property.kind == Kind::convergent) return regularity.converges.truth;
  if (*exponent.lower >= property.order && regularity.converges.is_yes()) return Truth::yes;
  const bool less = exponent.upper && *exponent.upper < property.order;
  return less || regularity.converges.is_no() ? Truth::no : Truth::unknown;
}

void add_reason(std::string& reasons, const std::string& reason) {
  if (reasons.find(reason) == std::string::npos) reasons += (reasons.empty() ? "" : "; ") + reason;
}

std::string why_stability_is_open(const Deadline& deadline) {
  if (deadline.expired()) return spent;
  return "the parts of the mask have a common zero for all values of the parameter, so that stability is not decided";
}

std::vector<RangePiece> merged(const std::vector<RangePiece>& pieces) {
  std::vector<RangePiece> result;
  for (const RangePiece& piece : pieces) {
    // One of two neighbours has the number between them.
    if (!result.empty() && result.back().holds == piece.holds) {
      result.back().high = piece.high;
      result.back().high_included = piece.high_included;
      add_reason(result.back().reason, piece.reason);
    } else {
      result.push_back(piece);
    }
  }
  return result;
}

bool is_complete(const std::vector<RangePiece>& pieces, const Rational& width) {
  return std::all_of(pieces.begin(), pieces.end(), [&](const RangePiece& piece) {
    return piece.holds != Truth::unknown || piece.high - piece.low <= width;
  });
}

bool changes_at_zeros(const RangeProperty& property, int rules) {
  return property.kind == Kind::stable || property.kind == Kind::preserving || property.kind == Kind::sobolev ||
         (property.kind == Kind::smooth && property.order >= rules);
}

PropertyRange property_between_zeros(const ParametricMask& mask, int rules, const RangeProperty& property,
                                     const Rational& low, const Rational& high, const RangeOptions& options) {
  const Question question{mask, property, low, high, options};
  if (property.kind == Kind::preserving)
    require(property.order <= rules, "range: need differences of an order up to the number {} of sum rules, got {}",
            rules, property.order);
  PropertyRange result = property.kind == Kind::preserving ? by_signs(question)
                         : property.kind == Kind::sobolev  ? by_sobolev_exponents(question, rules)
                                                           : by_stability(question);
  result.sum_rules = rules;
  result.complete = is_complete(result.pieces, options.width);
  return result;
}

}  // namespace subcert::family

namespace subcert {

std::vector<SpecialValue> single_values(const ParametricMask& mask, const LaurentPolynomial& unstable,
                                        const Rational& low, const Rational& high, const Rational& width) {
  using Why = SpecialValue::Why;
  using namespace family;
  std::vector<SpecialValue> values = zeros_of(unstable, low, high, width, Why::unstable);
  for (SpecialValue& value : zeros_of(special_values(mask), low, high, width, Why::sum_rules))
    replace_equal(values, std::move(value));
  sort_values(values);
  return values;
}

}  // namespace subcert
