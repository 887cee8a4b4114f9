#include "checker_arguments.hpp"

#include <subcert/analysis/symbol/decimal.hpp>
#include <subcert/analysis/symbol/error.hpp>
#include <subcert/schemes/parametric_specification.hpp>

#include <sstream>
#include <string_view>

namespace subcert {
namespace {

constexpr std::size_t longest_head = 2'000'000;  // characters in which the first four lines end

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
}

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
       "scheme, 'FAMILY for w=LOW..HIGH', 'radius FILE' or 'subradius FILE'",
       claim);
}

std::vector<std::string> subject_arguments(const std::string& subject) {
  constexpr std::string_view radius = "radius ", subradius = "subradius ", range = " for ";
  if (subject.starts_with(radius)) return {"--matrices", trimmed(subject.substr(radius.size()))};
  if (subject.starts_with(subradius)) return {"--subradius", trimmed(subject.substr(subradius.size()))};
  if (const std::size_t at = subject.find(range); at != std::string::npos) {
    const std::string values = trimmed(subject.substr(at + range.size()));
    const ParametricScheme family = make_parametric_scheme(trimmed(subject.substr(0, at)));
    return {"--mask", family.mask.to_text(family.parameter), "--arity", std::to_string(family.mask.arity()), "--for",
            values};
  }
  const Scheme scheme = make_linear_scheme(subject);
  if (scheme.mask.dimension() > 1)
    return {"--surface", to_mask_text(scheme.mask), "--dilation", scheme.mask.dilation().to_text()};
  if (scheme.rounding)
    fail(ErrorKind::usage, "--claim: {} has rounded coefficients; state it to subcert-check, with --within", subject);
  return {"--mask", to_mask_text(scheme.mask), "--arity", std::to_string(scheme.mask.arity())};
}

}  // namespace

std::vector<std::string> stated_checker_arguments(const std::string& claim, const std::string& file) {
  const std::vector<std::string> parts = parts_of(claim);
  // One part is the subject; of two, the first is a number or the second is.
  const auto number = [](const std::string& text) { return parse_number(text); };
  const bool lower = parts.size() == 3 || (parts.size() == 2 && number(parts[0]));
  const std::size_t subject = lower ? 1 : 0;
  if (parts.size() > 3 || parts[subject].empty()) refuse(claim);
  // What the number is, after a sign with blanks: specifications have signs without.
  constexpr std::string_view is = " = ", logarithm = " with |log h|^";
  const std::string& text = parts[subject];
  const std::size_t equal = text.find(is), power = text.find(logarithm);
  if (power != std::string::npos && (equal == std::string::npos || power < equal)) refuse(claim);
  std::vector<std::string> arguments = subject_arguments(trimmed(text.substr(0, equal)));
  if (equal != std::string::npos) {
    const std::size_t begin = equal + is.size();
    arguments.insert(arguments.end(), {"--exact", trimmed(text.substr(begin, power - begin))});
    if (power != std::string::npos)
      arguments.insert(arguments.end(), {"--logarithm", trimmed(text.substr(power + logarithm.size()))});
  }
  const auto add = [&](const char* name, const std::string& end, bool roughness) {
    const auto value = number(end);
    const bool order = roughness && end.size() > 1 && end[0] == 'C';
    if (!value && !order) refuse(claim);
    arguments.insert(arguments.end(), {name, order ? end : to_text(*value)});
  };
  if (lower) add("--lower", parts[0], false);
  if (parts.size() > subject + 1) add("--upper", parts[subject + 1], true);
  arguments.push_back(file);
  return arguments;
}

std::vector<std::string> checker_arguments(const std::string& text, const std::string& file) {
  std::istringstream lines(text.substr(0, longest_head));
  std::string version, subject, bounds, exact;
  std::getline(lines, version);
  std::getline(lines, subject);
  std::getline(lines, bounds);
  std::getline(lines, exact);
  std::istringstream subject_words(subject), bound_words(bounds);
  std::string kind, first, second, range, word, lower, upper;
  subject_words >> kind >> first >> second >> range;
  bound_words >> word >> lower >> upper;
  if (version.rfind("subcert-certificate", 0) != 0 || word != "bounds" || upper.empty() || second.empty())
    fail(ErrorKind::data, "{}: not a certificate", file);
  std::vector<std::string> arguments;
  if (kind == "exponent")
    arguments = {"--mask", first, "--arity", second};
  else if (kind == "surface")
    arguments = {"--surface", first, "--dilation", second};
  else if (kind == "radius")
    arguments = {"--matrices", file + ".matrices"};
  else if (kind == "subradius")
    arguments = {"--subradius", file + ".matrices"};
  else
    fail(ErrorKind::data, "{}, line 2: expected exponent, surface, radius or subradius", file);
  constexpr std::string_view within = "within=";
  if (kind == "exponent" && range.starts_with(within))
    arguments.insert(arguments.end(), {"--within", range.substr(within.size())});
  else if (kind == "exponent" && !range.empty())
    arguments.insert(arguments.end(), {"--for", range});
  if (lower != "-") arguments.insert(arguments.end(), {"--lower", lower});
  if (upper != "-") arguments.insert(arguments.end(), {"--upper", upper});
  constexpr std::string_view is = "exact ";  // the line after the bounds
  if (exact.starts_with(is)) arguments.insert(arguments.end(), {"--exact", exact.substr(is.size())});
  const bool curve = kind == "exponent", ranged = curve && !range.empty() && !range.starts_with(within),
             family = kind == "radius" || kind == "subradius", upper_alone = upper.starts_with('C') || ranged || family;
  if (lower == "-" && !exact.starts_with(is) && !(upper == "-" ? curve : upper_alone))
    fail(ErrorKind::data, "{}, line 3: expected a bound, as no claim of this kind has 'bounds {} {}'", file, lower,
         upper);
  constexpr std::string_view power = "\nlogarithm ";
  if (const std::size_t at = text.find(power); at != std::string::npos && !exact.empty()) {
    const std::size_t begin = at + power.size();
    arguments.insert(arguments.end(), {"--logarithm", text.substr(begin, text.find_first_of(" \n", begin) - begin)});
  }
  arguments.push_back(file);
  return arguments;
}

}  // namespace subcert
