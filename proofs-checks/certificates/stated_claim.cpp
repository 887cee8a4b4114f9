#include "stated_claim.hpp"

#include "certificate_text.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/utf8.hpp>
#include <subcert/schemes/specification.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace subcert {
namespace {

constexpr std::string_view of_contraction = "contraction ", belongs_to = " of ", of_component = "component",
                           hc = "HC of ", of_scheme = "scheme of ";
constexpr std::string_view range_begins = " for ", all = "all ", of_levels = "levels ", of_points = "points ",
                           with_limit = "limit ";

[[noreturn]] void refuse(const std::string& claim) {
  fail(ErrorKind::usage,
       "--claim '{}': expected [NUMBER <=] SUBJECT [= EXACT [with |log h|^P]] [<= NUMBER or C2], where SUBJECT is a "
       "scheme, 'component K of SCHEME', 'scheme of SCHEME', 'HC of SCHEME', '[HC of] FAMILY for LOW <= w <= HIGH', "
       "'FAMILY for all levels w=LOW..HIGH[, w=STEP, w0=FIRST..LAST[, limit VALUE]]', 'FAMILY for all points "
       "w=LOW..HIGH', 'lists:FILE', 'radius FILE' or 'subradius FILE'; or NUMBER <= l1:points=N,d=D [<= NUMBER], or "
       "contraction STEPS,ORDER of l1:points=N,d=D <= NUMBER",
       claim);
}

/// What stands between the signs, in increasing order.
struct Chain {
  std::vector<std::string> parts;
  std::vector<bool> strict;  ///< strict[i]: parts[i] < parts[i + 1], not <=
};

/// Nothing where signs point in both directions.
std::optional<Chain> chain_of(const std::string& text) {
  Chain chain;
  bool up = false, down = false;
  std::size_t begin = 0;
  for (std::size_t at = 0; (at = text.find_first_of("<>", begin)) != std::string::npos;) {
    (text[at] == '<' ? up : down) = true;
    chain.parts.push_back(trimmed(text.substr(begin, at - begin)));
    chain.strict.push_back(text.substr(at + 1, 1) != "=");
    begin = at + (chain.strict.back() ? 1 : 2);
  }
  chain.parts.push_back(trimmed(text.substr(begin)));
  if (down) {
    std::ranges::reverse(chain.parts);
    std::reverse(chain.strict.begin(), chain.strict.end());
  }
  return up && down ? std::nullopt : std::optional(chain);
}

/// Of one variable.
L1Subject l1_subject(const std::string& scheme) {
  const L1Scheme rule = make_l1_scheme(scheme).rules;
  if (rule.points.size() > 1) fail(ErrorKind::usage, "--claim: {} is no rule of one variable", scheme);
  return {std::to_string(rule.points[0]), std::to_string(rule.degree),
          rule.arity == 2 ? "" : std::to_string(rule.arity)};
}

/// `w=LOW..HIGH` or `w=VALUE`.
std::optional<ParameterRange> values_of(const std::string& text, const std::string& name) {
  const std::size_t equal = text.find('='), dots = text.find("..");
  if (equal == std::string::npos || trimmed(text.substr(0, equal)) != name) return std::nullopt;
  const auto low = parse_number(trimmed(text.substr(equal + 1, dots - std::min(dots, equal + 1))));
  const auto high = dots == std::string::npos ? low : parse_number(trimmed(text.substr(dots + 2)));
  return low && high && *low <= *high ? std::optional(ParameterRange{*low, *high}) : std::nullopt;
}

/// What stands behind `for`: the values of a parameter, and perhaps an upper end.
struct ForClause {
  ParameterRange values;
  bool is_levels = false, is_each_point = false;
  Chain behind;  ///< the values, then the upper end
  std::optional<Recurrence> recurrence = {};
  std::optional<FirstValues> start = {};  ///< with it
  std::optional<Rational> limit = {};     ///< with it, the value to which they tend
};

/// `w0=FIRST..LAST`, `w0=FIRST..inf` or `w0=VALUE`.
std::optional<FirstValues> first_values_of(std::string text, const std::string& name) {
  constexpr std::string_view open = "..inf";
  const bool unbounded = text.ends_with(open);
  if (unbounded) text.resize(text.size() - open.size());
  const auto values = values_of(text, name + "0");
  if (!values || (unbounded && values->low < values->high)) return std::nullopt;
  return FirstValues{{values->low, values->high}, unbounded};
}

/// Behind the range of levels, `w=STEP, w0=FIRST..LAST`, and perhaps `, limit VALUE`; false for another text.
bool read_following(std::string text, const ParametricScheme& family, ForClause& clause) {
  std::size_t comma = text.rfind(',');
  if (comma == std::string::npos) return false;
  if (const std::string last = trimmed(text.substr(comma + 1)); last.starts_with(with_limit)) {
    clause.limit = parse_number(trimmed(last.substr(with_limit.size())));
    text.resize(comma);
    comma = text.rfind(',');
    if (!clause.limit || comma == std::string::npos) return false;
  }
  clause.start = first_values_of(trimmed(text.substr(comma + 1)), family.name);
  try {
    clause.recurrence = Recurrence::parse(trimmed(text.substr(0, comma)), family.name, family.letter);
  } catch (const ParseError&) {
    return false;
  }
  return clause.start.has_value();
}

std::optional<ForClause> read_for(std::string text, const ParametricScheme& family) {
  const std::string& name = family.name;
  ForClause clause{};
  if (text.starts_with(all)) text = trimmed(text.substr(all.size()));
  clause.is_each_point = text.starts_with(of_points);
  if (clause.is_each_point) text = trimmed(text.substr(of_points.size()));
  clause.is_levels = !clause.is_each_point && text.starts_with(of_levels);
  if (clause.is_levels) text = trimmed(text.substr(of_levels.size()));
  if (const std::size_t comma = text.find(','); clause.is_levels && comma != std::string::npos) {
    if (!read_following(text.substr(comma + 1), family, clause)) return std::nullopt;
    text = trimmed(text.substr(0, comma));
  }
  if (const auto values = parse_parameter_range(text, name)) {
    clause.values = *values;
    clause.behind.parts = {text};
    return clause;
  }
  const auto chain = chain_of(text);
  const auto values = chain && chain->parts.size() <= 2 ? values_of(chain->parts.front(), name) : std::nullopt;
  if (!values) return std::nullopt;
  clause.values = *values;
  clause.behind = *chain;
  return clause;
}

/// A family on the values of its parameter, in the letter that certificates have.
MaskSubject family_subject(const ParametricScheme& family, const ForClause& clause, bool hermite,
                           const std::string& text) {
  const bool is_of_matrices = family.mask.components() > 1;
  if (hermite && !is_of_matrices) fail(ErrorKind::usage, "--claim: {} is no Hermite scheme", text);
  if (clause.is_each_point && is_of_matrices)
    fail(ErrorKind::usage, "--claim '{}': of all points need a mask of numbers", text);
  return {family.mask.to_text(family.letter),
          std::to_string(family.mask.arity()),
          fmt::format("{}={}..{}", family.letter, to_text(clause.values.low), to_text(clause.values.high)),
          clause.is_levels,
          {},
          hermite          ? "hermite"
          : is_of_matrices ? "vectors"
                           : "",
          clause.recurrence ? clause.recurrence->to_text(family.letter) : "",
          {},
          {},
          clause.limit ? to_text(*clause.limit) : "",
          clause.is_each_point};
}

/// A vector scheme itself, of whose refinable functions claims are made otherwise.
MaskSubject vector_scheme_subject(const std::string& specification, bool hermite) {
  const Scheme scheme = make_refinable_scheme(specification);
  if (scheme.mask.components() == 1 || (hermite && scheme.form != VectorForm::hermite))
    fail(ErrorKind::usage, "--claim: need a {}, got {}", hermite ? "Hermite scheme" : "vector scheme", specification);
  if (!hermite && !is_told_by_polynomials(scheme))
    return {scheme.quadratic ? certificate_text::mask_text(*scheme.quadratic) : to_mask_text(scheme.mask),
            scheme.mask.dilation().to_text(),
            {},
            false,
            {},
            "vectors"};
  return {scheme.quadratic ? certificate_text::mask_text(*scheme.quadratic) : without_letters(scheme.mask).to_text('w'),
          std::to_string(scheme.mask.arity()),
          {},
          false,
          {},
          hermite ? "hermite" : "vectors"};
}

ClaimSubject stated_subject(const std::string& subject, const ReadList& read_list) {
  constexpr std::string_view radius = "radius ", subradius = "subradius ", lists = "lists:";
  if (read_list && subject.starts_with(lists)) return read_list(subject.substr(lists.size()));
  if (subject.starts_with(radius)) return FamilySubject{false, {}, {}, trimmed(subject.substr(radius.size()))};
  if (subject.starts_with(subradius)) return FamilySubject{true, {}, {}, trimmed(subject.substr(subradius.size()))};
  if (is_l1_specification(subject)) return l1_subject(subject);
  for (const bool hermite : {false, true})
    if (const std::string_view word = hermite ? hc : of_scheme; subject.starts_with(word))
      return vector_scheme_subject(trimmed(subject.substr(word.size())), hermite);
  std::string scheme_text = subject;
  std::optional<int> number;
  if (const std::size_t at = subject.find(belongs_to); subject.starts_with(of_component) && at != std::string::npos) {
    number = whole_number(trimmed(subject.substr(of_component.size(), at - of_component.size()))).value_or(0);
    scheme_text = trimmed(subject.substr(at + belongs_to.size()));
  }
  const Scheme scheme = make_refinable_scheme(scheme_text);
  const auto components = static_cast<int>(scheme.mask.components());
  if (number && (components == 1 || *number < 1 || *number > components))
    fail(ErrorKind::usage, "--claim: {}: need a mask of matrices and one of its components, counted from 1", subject);
  const bool is_refinable = scheme.mask.components() > 1;
  if (scheme.mask.dimension() > 1 || is_refinable)
    return SurfaceSubject{scheme.quadratic ? certificate_text::mask_text(*scheme.quadratic) : to_mask_text(scheme.mask),
                          scheme.mask.dilation().to_text(), is_refinable, number ? std::to_string(*number - 1) : "",
                          integral_text(scheme.integral, scheme.quadratic ? scheme.quadratic->root : 0)};
  if (scheme.rounding)
    fail(ErrorKind::usage, "--claim: {} has rounded coefficients; state it to subcert-check, with --within", subject);
  return MaskSubject{to_mask_text(scheme.mask), std::to_string(scheme.mask.arity())};
}

/// `contraction STEPS,ORDER of SCHEME <= BOUND`, if the claim is one.
std::optional<StatedClaim> stated_contraction(const std::string& words) {
  const std::optional<Chain> chain = chain_of(words);
  if (!chain || !chain->parts[0].starts_with(of_contraction)) return std::nullopt;
  const std::vector<std::string>& parts = chain->parts;
  const std::size_t at = parts[0].find(belongs_to);
  const std::optional<Rational> bound = parts.size() == 2 && !chain->strict[0] ? parse_number(parts[1]) : std::nullopt;
  if (!bound || at == std::string::npos) refuse(words);
  L1Subject subject = l1_subject(trimmed(parts[0].substr(at + belongs_to.size())));
  subject.contraction = fmt::format(
      "{},{}", trimmed(parts[0].substr(of_contraction.size(), at - of_contraction.size())), to_text(*bound));
  StatedClaim stated;
  stated.claim.subject = subject;
  return stated;
}

/// SUBJECT = EXACT with |log h|^P: what the number is, after a sign with blanks, as specifications have signs without.
std::string take_exact(const std::string& text, CertificateClaim& claim, const std::string& words) {
  constexpr std::string_view is = " = ", logarithm = " with |log h|^";
  const std::size_t equal = text.find(is), power = text.find(logarithm);
  if (power != std::string::npos && (equal == std::string::npos || power < equal)) refuse(words);
  if (equal != std::string::npos) claim.exact = trimmed(text.substr(equal + is.size(), power - equal - is.size()));
  if (power != std::string::npos && !(claim.logarithm = whole_number(trimmed(text.substr(power + logarithm.size())))))
    refuse(words);
  return trimmed(text.substr(0, equal));
}

/// Ends as numbers; of limits that are not C^k the upper one is k.
std::optional<Rational> number_of(const std::optional<std::string>& end) {
  if (!end) return std::nullopt;
  return parse_number(end->starts_with('C') ? end->substr(1) : *end);
}

/// The values that a claim about a family is for.
std::optional<ParameterRange> values_of(const CertificateClaim& claim) {
  const auto* mask = std::get_if<MaskSubject>(&claim.subject);
  if (!mask || mask->range.empty()) return std::nullopt;
  return values_of(mask->range, mask->range.substr(0, 1));
}

/// Whether ends of that sign leave no number between them.
bool excludes(const std::optional<Rational>& least, const std::optional<Rational>& most, bool strict) {
  return least && most && (*most < *least || (*most == *least && strict));
}

/// Whether a lower end follows from the one that is proved, `also_equal` from the same number.
bool implies(const std::optional<Rational>& proved, const std::optional<Rational>& stated, bool also_equal) {
  return !stated || (proved && (*proved > *stated || (*proved == *stated && also_equal)));
}

std::optional<Rational> negated(const std::optional<Rational>& number) {
  return number ? std::optional(-*number) : std::nullopt;
}

MaskSubject mask_of(const CertificateClaim& claim) {
  const auto* mask = std::get_if<MaskSubject>(&claim.subject);
  return mask ? *mask : MaskSubject{};
}

/// Of families: certificates are about closed ranges.
bool is_within(const std::optional<ParameterRange>& stated, const std::optional<ParameterRange>& proved) {
  return !stated || (proved->low <= stated->low && stated->high <= proved->high);
}

/// Of values that follow from each other: whether all first values that are stated are among those that are proved, and
/// the range is the one into which they come.
bool starts_within(const StatedClaim& stated, const CertificateClaim& proved) {
  if (!stated.start) return true;
  const auto theirs = stated.values, ours = values_of(proved);
  const auto start = first_values_of(fmt::format("w0={}", mask_of(proved).start), "w");
  if (!start || theirs->low != ours->low || theirs->high != ours->high) return false;
  const auto& [values, unbounded] = *stated.start;
  return start->values.lower <= values.lower &&
         (start->unbounded || (!unbounded && values.upper <= start->values.upper));
}

/// Whether some value is in both.
bool meet(const std::optional<ParameterRange>& stated, const std::optional<ParameterRange>& proved) {
  if (!stated) return true;
  const Rational low = std::max(stated->low, proved->low), high = std::min(stated->high, proved->high);
  return low < high || (low == high && stated->low_included && stated->high_included);
}

/// Contractions of as many steps and of the same order; without one, of none.
bool contracts_as(const ClaimSubject& stated, const ClaimSubject& proved) {
  const auto *theirs = std::get_if<L1Subject>(&stated), *ours = std::get_if<L1Subject>(&proved);
  if (!theirs || theirs->contraction.empty()) return true;
  if (!ours) return false;
  const std::size_t bound = theirs->contraction.rfind(','), own = ours->contraction.rfind(',');
  if (own == std::string::npos || theirs->contraction.substr(0, bound) != ours->contraction.substr(0, own))
    return false;
  const auto most = parse_number(theirs->contraction.substr(bound + 1)),
             proved_most = parse_number(ours->contraction.substr(own + 1));
  return most && proved_most && *proved_most <= *most;
}

}  // namespace

bool StatedClaim::is_plain() const {
  const bool upper_alone = claim.upper && !claim.lower && !claim.exact && !claim.says_rough() && !values &&
                           mask_of(claim).of_matrices.empty() && !std::holds_alternative<FamilySubject>(claim.subject);
  return !lower_strict && !upper_strict && !upper_alone && !(values && values->low == values->high) && !start;
}

namespace {

StatedClaim read_claim(const std::string& words, const ReadList& read_list) {
  if (const auto contraction = stated_contraction(words)) return *contraction;
  const std::size_t at = words.find(range_begins);
  const std::optional<Chain> chain = chain_of(words.substr(0, at));
  if (!chain || chain->parts.size() > 3) refuse(words);
  const std::vector<std::string>& parts = chain->parts;
  // One part is the subject; of two, the first is a number or the second is.
  const bool lower = parts.size() == 3 || (parts.size() == 2 && parse_number(parts[0]));
  const std::size_t subject = lower ? 1 : 0;
  if (parts[subject].empty()) refuse(words);
  StatedClaim stated;
  CertificateClaim& claim = stated.claim;
  const auto end_of = [&](const std::string& end, bool roughness) {
    const auto value = parse_number(end);
    const bool order = roughness && end.size() > 1 && end[0] == 'C' && whole_number(end.substr(1));
    if (!value && !order) refuse(words);
    return order ? end : to_text(*value);
  };
  const std::string text = take_exact(parts[subject], claim, words);
  if (lower) claim.lower = end_of(parts[0], false);
  if (lower) stated.lower_strict = chain->strict[0];
  std::optional<std::string> upper;
  if (parts.size() > subject + 1) upper = parts[subject + 1];
  if (upper) stated.upper_strict = chain->strict[subject];
  if (at == std::string::npos) {
    claim.subject = stated_subject(text, read_list);
  } else {
    const bool hermite = text.starts_with(hc);
    const ParametricScheme family = make_parametric_scheme(trimmed(text.substr(hermite ? hc.size() : 0)));
    const auto clause = read_for(trimmed(words.substr(at + range_begins.size())), family);
    if (!clause || (upper && clause->behind.parts.size() > 1)) refuse(words);
    if (clause->behind.parts.size() > 1) upper = clause->behind.parts[1];
    if (((clause->is_levels && !clause->limit) || clause->is_each_point) && (!lower || upper || claim.exact))
      fail(ErrorKind::usage, "--claim '{}': of all levels and of all points a lower end is claimed, and nothing else",
           words);
    claim.subject = family_subject(family, *clause, hermite, words);
    stated.values = clause->values;
    stated.start = clause->start;
    if (!clause->limit) stated.lower_strict = stated.upper_strict = false;  // as certificates have it
  }
  if (!mask_of(claim).of_matrices.empty()) stated.lower_strict = stated.upper_strict = false;
  if (upper) claim.upper = end_of(*upper, true);
  if (claim.says_rough()) stated.upper_strict = false;
  return stated;
}

}  // namespace

StatedClaim stated_claim(const std::string& words, const ReadList& read_list) {
  try {
    return read_claim(words, read_list);
  } catch (const SpecificationError& error) {
    fail(ErrorKind::usage,
         "--claim '{}': {}; a claim names its scheme, as 3/2 < primal:n=5 or 1 < four-point:w for 1/20 <= w <= 1/10",
         words, error.what());
  }
}

StatedClaim with_letter_of(const CertificateClaim& proved, StatedClaim stated) {
  const auto* ours = std::get_if<MaskSubject>(&proved.subject);
  auto* theirs = std::get_if<MaskSubject>(&stated.claim.subject);
  if (!ours || !theirs || ours->range.empty() || theirs->range.empty()) return stated;
  const char before = theirs->range[0];
  constexpr std::string_view root = "sqrt";
  const std::ptrdiff_t skipped = theirs->recurrence.starts_with(root) ? root.size() : 0;
  for (const auto& [text, begin] :
       {std::pair(&theirs->mask, std::ptrdiff_t{0}), {&theirs->range, 0}, {&theirs->recurrence, skipped}})
    std::replace(text->begin() + begin, text->end(), before, ours->range[0]);
  return stated;
}

CertificateClaim about_subject_of(const StatedClaim& stated, const CertificateClaim& proved) {
  CertificateClaim claim = proved;
  claim.subject = stated.claim.subject;
  if (const auto* ours = std::get_if<MaskSubject>(&proved.subject))
    if (auto* theirs = std::get_if<MaskSubject>(&claim.subject)) {
      theirs->range = ours->range;
      theirs->is_levels = ours->is_levels;
      theirs->is_each_point = ours->is_each_point;
      theirs->start = ours->start;
      theirs->from = ours->from;
      theirs->limit = ours->limit;
    }
  if (const auto* ours = std::get_if<L1Subject>(&proved.subject))
    if (auto* theirs = std::get_if<L1Subject>(&claim.subject)) theirs->contraction = ours->contraction;
  return claim;
}

Truth follows(const StatedClaim& stated, const CertificateClaim& proved) {
  const CertificateClaim& claim = stated.claim;
  const std::optional<ParameterRange>&theirs = stated.values, ours = values_of(proved);
  const MaskSubject their_mask = mask_of(claim), our_mask = mask_of(proved);
  if (theirs.has_value() != ours.has_value() || their_mask.of_matrices != our_mask.of_matrices) return Truth::unknown;
  const auto least = number_of(claim.lower), most = number_of(claim.upper), proved_least = number_of(proved.lower),
             proved_most = number_of(proved.upper);
  const bool in_limit = !our_mask.limit.empty(), orders = our_mask.of_matrices == "hermite",
             strict = ((ours && !in_limit) || !our_mask.of_matrices.empty()) && !orders;  // of both claims
  // Without a limit more is said of what is proved with one: that exponents are above the lower end, not at least.
  if (in_limit && !(starts_within(stated, proved) && stated.start)) return Truth::unknown;
  if (!their_mask.limit.empty() && parse_number(their_mask.limit) != parse_number(our_mask.limit))
    return Truth::unknown;
  if (is_within(theirs, ours) && starts_within(stated, proved) &&
      (!their_mask.is_levels || our_mask.is_levels || our_mask.is_each_point) &&
      (!their_mask.is_each_point || our_mask.is_each_point) &&
      (least || most || claim.exact || std::holds_alternative<L1Subject>(claim.subject) ||
       (!proved_least && !proved_most && !proved.exact)) &&
      contracts_as(claim.subject, proved.subject) && (!claim.exact || claim.exact == proved.exact) &&
      (!claim.logarithm || claim.logarithm == proved.logarithm) &&
      implies(proved_least, least,
              our_mask.is_each_point ? their_mask.is_each_point
              : in_limit             ? !their_mask.limit.empty() && !stated.lower_strict
                                     : strict || !stated.lower_strict) &&
      (claim.says_rough() == proved.says_rough() || claim.says_rough() || !most) &&
      implies(negated(proved_most), negated(most),
              claim.says_rough() == proved.says_rough() ? strict || !stated.upper_strict : strict))
    return Truth::yes;
  // Of a value that both are about. HC^k and not HC^k exclude each other; so do an exponent above k and no C^k limits.
  if (!meet(theirs, ours)) return Truth::unknown;
  const bool false_lower = excludes(least, proved_most,
                                    !proved.says_rough() && (strict || stated.lower_strict || orders));
  const bool false_upper = excludes(proved_least, most,
                                    !claim.says_rough() && (strict || stated.upper_strict || orders));
  return false_lower || false_upper ? Truth::no : Truth::unknown;
}

}  // namespace subcert
