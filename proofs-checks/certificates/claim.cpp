#include "claim.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/utf8.hpp>
#include <subcert/schemes/parametric_specification.hpp>
#include <subcert/schemes/specification.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <sstream>
#include <string_view>

namespace subcert {
namespace {

constexpr std::size_t longest_head = 2'000'000;  // characters in which the first four lines end
constexpr std::string_view within = "within=";
constexpr std::string_view is_exactly = "exact ", attains = "attains ";  // the line after the bounds
constexpr std::string_view contracts = "contraction ";
constexpr std::string_view levels = "levels", all_levels = "all levels ", belongs_to = " of ";
constexpr std::string_view component = "component", integral = "integral", hc = "HC of ", of_scheme = "scheme of ";

/// The parts between `<=`.
std::vector<std::string> parts_of(const std::string& claim) {
  constexpr std::string_view sign = "<=";
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t at = 0; (at = claim.find(sign, begin)) != std::string::npos; begin = at + sign.size())
    parts.push_back(trimmed(claim.substr(begin, at - begin)));
  parts.push_back(trimmed(claim.substr(begin)));
  return parts;
}

[[noreturn]] void refuse(const std::string& claim) {
  fail(ErrorKind::usage,
       "--claim '{}': expected [NUMBER <=] SUBJECT [= EXACT [with |log h|^P]] [<= NUMBER or C2], where SUBJECT is a "
       "scheme, 'component K of SCHEME', 'scheme of SCHEME', 'HC of SCHEME', '[HC of] FAMILY for w=LOW..HIGH', "
       "'FAMILY for all levels w=LOW..HIGH', 'radius FILE' or 'subradius FILE'; or NUMBER <= l1:points=N,d=D [<= "
       "NUMBER], "
       "or contraction STEPS,ORDER of l1:points=N,d=D <= NUMBER",
       claim);
}

/// Of one variable.
L1Subject l1_subject(const std::string& scheme) {
  const L1Scheme rule = make_l1_scheme(scheme).rules;
  if (rule.points.size() > 1) fail(ErrorKind::usage, "--claim: {} is no rule of one variable", scheme);
  return {std::to_string(rule.points[0]), std::to_string(rule.degree),
          rule.arity == 2 ? "" : std::to_string(rule.arity)};
}

/// `w=0..1` with the letter of the family, which certificates have, in the place of its name.
std::string with_letter(const ParametricScheme& family, const std::string& range) {
  return range.starts_with(family.name + "=") ? family.letter + range.substr(family.name.size()) : range;
}

/// A power of a logarithm, or the number of a component.
std::optional<int> whole_number(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

MaskSubject vector_scheme_subject(const std::string& specification, bool hermite) {
  const Scheme scheme = make_refinable_scheme(specification);
  if (scheme.mask.components() == 1 || scheme.quadratic || scheme.mask.dimension() > 1 ||
      (hermite && scheme.form != VectorForm::hermite))
    fail(ErrorKind::usage, "--claim: need a {} of one variable with rational matrices, got {}",
         hermite ? "Hermite scheme" : "vector scheme", specification);
  return {without_letters(scheme.mask).to_text('w'),
          std::to_string(scheme.mask.arity()),
          {},
          false,
          {},
          hermite ? "hermite" : "vectors"};
}

ClaimSubject stated_subject(const std::string& subject) {
  constexpr std::string_view radius = "radius ", subradius = "subradius ", range = " for ";
  if (subject.starts_with(radius)) return FamilySubject{false, {}, {}, trimmed(subject.substr(radius.size()))};
  if (subject.starts_with(subradius)) return FamilySubject{true, {}, {}, trimmed(subject.substr(subradius.size()))};
  if (const std::size_t at = subject.find(range); at != std::string::npos) {
    const bool hermite = subject.starts_with(hc);
    const std::size_t begin = hermite ? hc.size() : 0;
    const ParametricScheme family = make_parametric_scheme(trimmed(subject.substr(begin, at - begin)));
    std::string values = trimmed(subject.substr(at + range.size()));
    const bool is_levels = values.starts_with(all_levels);
    if (is_levels) values = trimmed(values.substr(all_levels.size()));
    const bool is_of_matrices = family.mask.components() > 1;
    if (is_levels && is_of_matrices) fail(ErrorKind::usage, "--claim: {}: levels are of masks of numbers", subject);
    if (hermite && !is_of_matrices) fail(ErrorKind::usage, "--claim: {} is no Hermite scheme", subject);
    return MaskSubject{family.mask.to_text(family.letter),
                       std::to_string(family.mask.arity()),
                       with_letter(family, values),
                       is_levels,
                       {},
                       hermite          ? "hermite"
                       : is_of_matrices ? "vectors"
                                        : ""};
  }
  if (is_l1_specification(subject)) return l1_subject(subject);
  std::string scheme_text = subject;
  std::optional<int> number;
  for (const bool hermite : {false, true})
    if (const std::string_view word = hermite ? hc : of_scheme; subject.starts_with(word))
      return vector_scheme_subject(trimmed(subject.substr(word.size())), hermite);
  if (const std::size_t at = subject.find(belongs_to); subject.starts_with(component) && at != std::string::npos) {
    number = whole_number(trimmed(subject.substr(component.size(), at - component.size()))).value_or(0);
    scheme_text = trimmed(subject.substr(at + belongs_to.size()));
  }
  const Scheme scheme = make_refinable_scheme(scheme_text);
  const auto components = static_cast<int>(scheme.mask.components());
  if (number && (components == 1 || *number < 1 || *number > components))
    fail(ErrorKind::usage, "--claim: {}: need a mask of matrices and one of its components, counted from 1", subject);
  const bool is_refinable = scheme.mask.components() > 1;
  if (scheme.quadratic)
    fail(ErrorKind::usage, "--claim: need rational coefficients, got {}; there are no certificates for others",
         subject);
  if (scheme.mask.dimension() > 1 || is_refinable)
    return SurfaceSubject{to_mask_text(scheme.mask), scheme.mask.dilation().to_text(), is_refinable,
                          number ? std::to_string(*number - 1) : "", integral_text(scheme.integral)};
  if (scheme.rounding)
    fail(ErrorKind::usage, "--claim: {} has rounded coefficients; state it to subcert-check, with --within", subject);
  return MaskSubject{to_mask_text(scheme.mask), std::to_string(scheme.mask.arity())};
}

/// `contraction STEPS,ORDER of SCHEME <= BOUND`, if the claim is one.
std::optional<CertificateClaim> stated_contraction(const std::string& words) {
  const std::vector<std::string> parts = parts_of(words);
  if (!parts[0].starts_with(contracts)) return std::nullopt;
  const std::size_t at = parts[0].find(belongs_to);
  const std::optional<Rational> bound = parts.size() == 2 ? parse_number(parts[1]) : std::nullopt;
  if (!bound || at == std::string::npos) refuse(words);
  L1Subject subject = l1_subject(trimmed(parts[0].substr(at + belongs_to.size())));
  subject.contraction = fmt::format("{},{}", trimmed(parts[0].substr(contracts.size(), at - contracts.size())),
                                    to_text(*bound));
  CertificateClaim claim;
  claim.subject = subject;
  return claim;
}

/// The line of a certificate that says what it is about.
struct SubjectLine {
  std::string operator()(const MaskSubject& of) const {
    const std::string more = of.within.empty() ? of.range : std::string(within) + of.within;
    const std::string_view of_numbers = of.is_levels ? levels : "exponent";
    return fmt::format("{} {} {}{}{}", of.of_matrices.empty() ? of_numbers : of.of_matrices, of.mask, of.arity,
                       more.empty() ? "" : " ", more);
  }
  std::string operator()(const SurfaceSubject& of) const {
    return fmt::format("{} {} {}{}{}", of.is_refinable ? "refinable" : "surface", of.mask, of.dilation,
                       of.integral.empty() ? "" : fmt::format(" {}={}", integral, of.integral),
                       of.component.empty() ? "" : fmt::format(" {}={}", component, of.component));
  }
  std::string operator()(const FamilySubject& of) const {
    return fmt::format("{} {} {}", of.is_subradius ? "subradius" : "radius", of.count, of.size);
  }
  std::string operator()(const L1Subject& of) const {
    return fmt::format("l1 {} {}{}{}", of.points, of.degree, of.arity.empty() ? "" : " ", of.arity);
  }
};

ClaimSubject read_subject(const std::string& line, const std::string& file) {
  std::istringstream words(line);
  std::string kind, first, second, more;
  words >> kind >> first >> second >> more;
  if (second.empty()) fail(ErrorKind::data, "{}: not a certificate", file);
  const bool rounded = more.starts_with(within);
  if (kind == "exponent" && rounded) return MaskSubject{first, second, {}, false, more.substr(within.size())};
  if (kind == "exponent" || kind == levels) return MaskSubject{first, second, more, kind == levels};
  if (kind == "vectors" || kind == "hermite") return MaskSubject{first, second, more, false, {}, kind};
  if (kind == "surface" || kind == "refinable") {
    SurfaceSubject subject{first, second, kind == "refinable"};
    for (; !more.empty(); more.clear(), words >> more)
      for (const auto& [name, field] : {std::pair(integral, &subject.integral), {component, &subject.component}})
        if (more.starts_with(name)) *field = more.substr(std::min(more.size(), name.size() + 1));
    return subject;
  }
  if (kind == "radius" || kind == "subradius") return FamilySubject{kind == "subradius", first, second};
  if (kind == "l1") return L1Subject{first, second, more};
  fail(ErrorKind::data,
       "{}, line 2: expected exponent, levels, vectors, hermite, surface, refinable, radius, subradius or l1", file);
}

/// Whether a claim without a lower end and a number is one: of stability, of a range or a family with an upper end, of
/// roughness, and of a contraction.
bool may_lack_lower(const CertificateClaim& claim) {
  if (std::holds_alternative<L1Subject>(claim.subject)) return true;
  const auto* mask = std::get_if<MaskSubject>(&claim.subject);
  if (!claim.upper) return mask != nullptr;
  return claim.says_rough() || (mask && (!mask->range.empty() || !mask->of_matrices.empty())) ||
         std::holds_alternative<FamilySubject>(claim.subject);
}

struct SubjectArguments {
  const std::string& file;

  std::vector<std::string> operator()(const MaskSubject& of) const {
    std::vector<std::string> arguments{of.of_matrices.empty() ? "--mask" : "--" + of.of_matrices, of.mask, "--arity",
                                       of.arity};
    if (!of.within.empty()) arguments.insert(arguments.end(), {"--within", of.within});
    if (!of.range.empty()) arguments.insert(arguments.end(), {of.is_levels ? "--levels" : "--for", of.range});
    return arguments;
  }
  std::vector<std::string> operator()(const SurfaceSubject& of) const {
    std::vector<std::string> arguments{of.is_refinable ? "--refinable" : "--surface", of.mask, "--dilation",
                                       of.dilation};
    if (!of.integral.empty()) arguments.insert(arguments.end(), {"--integral", of.integral});
    if (!of.component.empty()) arguments.insert(arguments.end(), {"--component", of.component});
    return arguments;
  }
  std::vector<std::string> operator()(const FamilySubject& of) const {
    return {of.is_subradius ? "--subradius" : "--matrices", of.matrices.value_or(file + ".matrices")};
  }
  std::vector<std::string> operator()(const L1Subject& of) const {
    std::vector<std::string> arguments{"--l1", of.points + "," + of.degree + (of.arity.empty() ? "" : ",") + of.arity};
    if (!of.contraction.empty()) arguments.insert(arguments.end(), {"--contraction", of.contraction});
    return arguments;
  }
};

}  // namespace

std::string integral_text(const std::optional<std::vector<Rational>>& numbers) {
  std::string text;
  for (const Rational& number : numbers.value_or(std::vector<Rational>{}))
    text += (text.empty() ? "" : ",") + to_text(number);
  return text;
}

std::string head_text(const CertificateClaim& claim) {
  const std::string head = fmt::format("subcert-certificate 3\n{}\nbounds {} {}\n",
                                       std::visit(SubjectLine{}, claim.subject), claim.lower.value_or("-"),
                                       claim.upper.value_or("-"));
  if (const auto* rule = std::get_if<L1Subject>(&claim.subject)) {
    std::string fields = rule->contraction;
    std::replace(fields.begin(), fields.end(), ',', ' ');
    return fmt::format("{}{}{}\n", head, contracts, fields);
  }
  return claim.exact ? fmt::format("{}{}{}\n", head, is_exactly, *claim.exact) : head;
}

CertificateClaim stated_claim(const std::string& words) {
  if (const auto contraction = stated_contraction(words)) return *contraction;
  const std::vector<std::string> parts = parts_of(words);
  // One part is the subject; of two, the first is a number or the second is.
  const auto number = [](const std::string& text) { return parse_number(text); };
  const bool lower = parts.size() == 3 || (parts.size() == 2 && number(parts[0]));
  const std::size_t subject = lower ? 1 : 0;
  if (parts.size() > 3 || parts[subject].empty()) refuse(words);
  // What the number is, after a sign with blanks: specifications have signs without.
  constexpr std::string_view is = " = ", logarithm = " with |log h|^";
  const std::string& text = parts[subject];
  const std::size_t equal = text.find(is), power = text.find(logarithm);
  if (power != std::string::npos && (equal == std::string::npos || power < equal)) refuse(words);
  CertificateClaim claim;
  claim.subject = stated_subject(trimmed(text.substr(0, equal)));
  if (equal != std::string::npos) claim.exact = trimmed(text.substr(equal + is.size(), power - equal - is.size()));
  if (power != std::string::npos && !(claim.logarithm = whole_number(trimmed(text.substr(power + logarithm.size())))))
    refuse(words);
  const auto end_of = [&](const std::string& end, bool roughness) {
    const auto value = number(end);
    const bool order = roughness && end.size() > 1 && end[0] == 'C';
    if (!value && !order) refuse(words);
    return order ? end : to_text(*value);
  };
  if (lower) claim.lower = end_of(parts[0], false);
  if (parts.size() > subject + 1) claim.upper = end_of(parts[subject + 1], true);
  return claim;
}

CertificateClaim read_claim(const std::string& text, const std::string& file) {
  std::istringstream lines(text.substr(0, longest_head));
  std::string version, subject, bounds, exact, word, lower, upper;
  for (std::string* line : {&version, &subject, &bounds, &exact}) std::getline(lines, *line);
  std::istringstream(bounds) >> word >> lower >> upper;
  if (!version.starts_with("subcert-certificate") || word != "bounds" || upper.empty())
    fail(ErrorKind::data, "{}: not a certificate", file);
  CertificateClaim claim;
  claim.subject = read_subject(subject, file);
  if (lower != "-") claim.lower = lower;
  if (upper != "-") claim.upper = upper;
  if (auto* rule = std::get_if<L1Subject>(&claim.subject)) {
    if (!exact.starts_with(contracts))
      fail(ErrorKind::data, "{}, line 4: expected contraction STEPS ORDER BOUND", file);
    rule->contraction = exact.substr(contracts.size());
    std::replace(rule->contraction.begin(), rule->contraction.end(), ' ', ',');
  }
  if (exact.starts_with(is_exactly)) claim.exact = exact.substr(is_exactly.size());
  if (exact.starts_with(attains))
    claim.attains = exact.substr(attains.size(), exact.find(' ', attains.size()) - attains.size());
  if (!claim.lower && !claim.exact && !claim.attains && !may_lack_lower(claim))
    fail(ErrorKind::data, "{}, line 3: expected a bound, as no claim of this kind has 'bounds {} {}'", file, lower,
         upper);
  constexpr std::string_view power = "\nlogarithm ";
  if (const std::size_t at = text.find(power); at != std::string::npos && !exact.empty()) {
    const std::size_t begin = at + power.size(), end = text.find_first_of(" \n", begin);
    if (!(claim.logarithm = whole_number(std::string_view(text).substr(begin, end - begin))))
      fail(ErrorKind::data, "{}: expected a power after 'logarithm', as in 'logarithm 1'", file);
  }
  return claim;
}

std::vector<std::string> checker_arguments(const CertificateClaim& claim, const std::string& file) {
  std::vector<std::string> arguments = std::visit(SubjectArguments{file}, claim.subject);
  const auto add = [&](const char* name, const std::string& value) {
    arguments.insert(arguments.end(), {name, value});
  };
  if (claim.lower) add("--lower", *claim.lower);
  if (claim.upper) add("--upper", *claim.upper);
  if (claim.exact) add("--exact", *claim.exact);
  if (claim.attains) add("--attains", *claim.attains);
  if (claim.logarithm) add("--logarithm", std::to_string(*claim.logarithm));
  arguments.push_back(file);
  return arguments;
}

}  // namespace subcert
