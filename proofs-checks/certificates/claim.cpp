#include "claim.hpp"

#include <subcert/analysis/symbol/numbers/numbers.hpp>
#include <subcert/analysis/symbol/polynomials/quadratic_number.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

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
constexpr std::string_view recurrence = "recurrence=", start = "start=", from = "from=", limit = "limit=",
                           period = "period=";
constexpr std::string_view levels = "levels", each_point = "each-point", lists = "lists", component = "component",
                           integral = "integral";
constexpr std::string_view vertex = "vertex", not_c1 = "not-c1";

/// The line of a certificate that says what it is about.
struct SubjectLine {
  std::string operator()(const MaskSubject& of) const {
    const std::string more = of.within.empty() ? of.range : std::string(within) + of.within;
    const std::string_view of_numbers = of.is_levels ? levels : of.is_each_point ? each_point : "exponent";
    const std::string line = fmt::format("{} {} {}{}{}{}", of.of_matrices.empty() ? of_numbers : of.of_matrices,
                                         of.mask, of.arity, more.empty() ? "" : " ", more,
                                         of.is_levels && !of.of_matrices.empty() ? " levels" : "");
    return of.recurrence.empty()
               ? line
               : fmt::format("{} {}{} {}{} {}{}{}", line, recurrence, of.recurrence, start, of.start, from, of.from,
                             of.limit.empty() ? "" : fmt::format(" {}{}", limit, of.limit));
  }
  std::string operator()(const SurfaceSubject& of) const {
    return fmt::format("{} {} {}{}{}{}", of.is_refinable ? "refinable" : "surface", of.mask, of.dilation,
                       of.vertex.empty() ? "" : fmt::format(" {}={}", of.is_c1 ? vertex : not_c1, of.vertex),
                       of.integral.empty() ? "" : fmt::format(" {}={}", integral, of.integral),
                       of.component.empty() ? "" : fmt::format(" {}={}", component, of.component));
  }
  std::string operator()(const FamilySubject& of) const {
    return fmt::format("{} {} {}", of.is_subradius ? "subradius" : "radius", of.count, of.size);
  }
  std::string operator()(const ListSubject& of) const {
    return fmt::format("{} {} {} {}{}{}", lists, of.masks, of.arity, of.order, of.of_matrices.empty() ? "" : " ",
                       of.of_matrices);
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
  const bool of_matrices = kind == "vectors" || kind == "hermite";
  if (kind == "exponent" || kind == levels || kind == each_point || of_matrices) {
    MaskSubject subject{first, second, more, kind == levels, {}, of_matrices ? kind : ""};
    subject.is_each_point = kind == each_point;
    for (std::string word; words >> word; subject.is_levels = subject.is_levels || word == levels)
      for (const auto& [name, field] : {std::pair(recurrence, &subject.recurrence),
                                        {start, &subject.start},
                                        {from, &subject.from},
                                        {limit, &subject.limit}})
        if (word.starts_with(name)) *field = word.substr(name.size());
    return subject;
  }
  if (kind == lists) {
    ListSubject subject{first, second, more};
    words >> subject.of_matrices;
    return subject;
  }
  if (kind == "surface" || kind == "refinable") {
    SurfaceSubject subject{first, second, kind == "refinable"};
    for (; !more.empty(); more.clear(), words >> more) {
      for (const auto& [name, field] : {std::pair(integral, &subject.integral),
                                        {component, &subject.component},
                                        {vertex, &subject.vertex},
                                        {not_c1, &subject.vertex}})
        if (more.starts_with(name)) *field = more.substr(std::min(more.size(), name.size() + 1));
      if (more.starts_with(not_c1)) subject.is_c1 = false;
    }
    return subject;
  }
  if (kind == "radius" || kind == "subradius") return FamilySubject{kind == "subradius", first, second};
  if (kind == "l1") return L1Subject{first, second, more};
  fail(ErrorKind::data,
       "{}, line 2: expected exponent, levels, each-point, lists, vectors, hermite, surface, refinable, radius, "
       "subradius or l1",
       file);
}

/// Whether a claim without a lower end and a number is one: of stability, of a range or a family with an upper end, of
/// roughness, and of a contraction.
bool may_lack_lower(const CertificateClaim& claim) {
  if (std::holds_alternative<L1Subject>(claim.subject)) return true;
  const auto* mask = std::get_if<MaskSubject>(&claim.subject);
  const auto* list = std::get_if<ListSubject>(&claim.subject);
  if (!claim.upper) return mask || (list && list->of_matrices.empty() && list->order.starts_with(period));
  return claim.says_rough() || (mask && (!mask->range.empty() || !mask->of_matrices.empty())) ||
         std::holds_alternative<FamilySubject>(claim.subject);
}

struct SubjectArguments {
  const std::string& file;

  std::vector<std::string> operator()(const MaskSubject& of) const {
    std::vector<std::string> arguments{of.of_matrices.empty() ? "--mask" : "--" + of.of_matrices, of.mask,
                                       of.arity.starts_with('[') ? "--dilation" : "--arity", of.arity};
    if (!of.within.empty()) arguments.insert(arguments.end(), {"--within", of.within});
    if (!of.range.empty())
      arguments.insert(arguments.end(), {of.is_levels       ? "--levels"
                                         : of.is_each_point ? "--each-point"
                                                            : "--for",
                                         of.range});
    if (!of.recurrence.empty())
      arguments.insert(arguments.end(), {"--recurrence", of.recurrence, "--start", of.start, "--from", of.from});
    if (!of.limit.empty()) arguments.insert(arguments.end(), {"--limit", of.limit});
    return arguments;
  }
  std::vector<std::string> operator()(const SurfaceSubject& of) const {
    std::vector<std::string> arguments{of.is_refinable ? "--refinable" : "--surface", of.mask, "--dilation",
                                       of.dilation};
    if (!of.vertex.empty()) arguments.insert(arguments.end(), {of.is_c1 ? "--vertex" : "--not-c1", of.vertex});
    if (!of.integral.empty()) arguments.insert(arguments.end(), {"--integral", of.integral});
    if (!of.component.empty()) arguments.insert(arguments.end(), {"--component", of.component});
    return arguments;
  }
  std::vector<std::string> operator()(const FamilySubject& of) const {
    return {of.is_subradius ? "--subradius" : "--matrices", of.matrices.value_or(file + ".matrices")};
  }
  std::vector<std::string> operator()(const ListSubject& of) const {
    return {
        of.of_matrices.empty() ? "--masks" : "--" + of.of_matrices, of.masks, "--arity", of.arity, "--order", of.order};
  }
  std::vector<std::string> operator()(const L1Subject& of) const {
    std::vector<std::string> arguments{"--l1", of.points + "," + of.degree + (of.arity.empty() ? "" : ",") + of.arity};
    if (!of.contraction.empty()) arguments.insert(arguments.end(), {"--contraction", of.contraction});
    return arguments;
  }
};

}  // namespace

std::optional<int> whole_number(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

std::string integral_text(const std::optional<std::vector<Rational>>& numbers, long root) {
  if (!numbers) return "";
  const std::size_t functions = root > 0 ? numbers->size() / 2 : numbers->size();
  std::string text;
  for (std::size_t c = 0; c < functions; ++c) {
    QuadraticNumber number{(*numbers)[c]};
    if (root > 0 && (*numbers)[functions + c] != 0) number = {number.rational, (*numbers)[functions + c], root};
    text += (c == 0 ? "" : ",") + number.to_text();
  }
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
