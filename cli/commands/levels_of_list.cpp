#include "levels_of_list.hpp"

#include "checker.hpp"
#include "level_values.hpp"
#include "parameter_range.hpp"
#include "width.hpp"

#include <subcert/proofs-checks/certificates/certificate.hpp>
#include <subcert/proofs-checks/properties/mask_list_file.hpp>
#include <subcert/reports/facts/exponent_formula.hpp>
#include <subcert/reports/facts/exponents.hpp>
#include <subcert/reports/facts/screen_lines.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <fmt/ranges.h>

#include <algorithm>

namespace subcert::cli {
namespace {

using properties::MaskListFile;

std::string order_text(const MaskList& list) {
  if (!list.period.empty()) return fmt::format("{} again and again", fmt::join(list.period, ", "));
  if (list.follows.empty()) return "any";
  std::vector<std::string> pairs;
  for (const auto& [before, after] : list.follows) pairs.push_back(fmt::format("{} after {}", after, before));
  return fmt::format("{}", fmt::join(pairs, ", "));
}

std::string exponent_text(const ExponentOfList& found) {
  const Enclosure& exponent = found.exponent;
  if (!exponent.lower) return "no convergence is proved for all sequences";
  if (found.exact.is_yes()) return enclosure_text(exponent, 12) + "  (the least of all sequences, exact)";
  std::string text = fmt::format("at least {} for all sequences", exponent.lower_text(12));
  if (exponent.upper) text += fmt::format(", at most {} for one of them", exponent.upper_text(12));
  return text;
}

std::string sequence_text(const std::vector<std::size_t>& sequence) {
  return fmt::format("{}{}", fmt::join(sequence, ", "), sequence.size() > 1 ? " in turn" : " at all levels");
}

/// Of masks of matrices of which some keep more data by themselves than all do in common.
std::string alone_line(const ExponentOfList& found) {
  if (!found.vectors || std::ranges::max(found.vectors->alone) <= found.sum_rules) return "";
  const bool differ = std::ranges::min(found.vectors->alone) > found.sum_rules;
  return fmt::format("by itself    {} sum rules{}\n", fmt::join(found.vectors->alone, ", "),
                     differ ? ", with other data for each mask" : "");
}

/// Of Hermite schemes.
std::string hermite_line(const ExponentOfList& found) {
  const auto known = hermite_order_of(found);
  if (!known) return "";
  const auto& [order, next] = *known;
  if (order < 0) return fmt::format("Hermite      {}\n", next.is_no() ? "none for all sequences" : "unknown");
  return fmt::format("Hermite      HC^{} for all sequences{}\n", order,
                     next.is_no() ? fmt::format(", not HC^{}", order + 1) : fmt::format("; HC^{} is open", order + 1));
}

Json hermite_json(const ExponentOfList& found) {
  const auto known = hermite_order_of(found);
  if (!known) return nullptr;
  return {{"order", known->order < 0 ? Json() : Json(known->order)}, {"next", to_text(known->next.truth)}};
}

std::string text_of(const MaskListFile& file, const ExponentOfList& found, const std::string& property, Truth answer) {
  std::string text;
  for (std::size_t k = 0; k < file.specifications.size(); ++k)
    text += fmt::format("mask {}{}\n", padded(std::to_string(k), 8), file.specifications[k]);
  text += fmt::format("order        {}\nsum rules    {}{}\nexponent     {}\n", order_text(file.list), found.sum_rules,
                      file.list.period.empty() ? " in common" : "", exponent_text(found));
  text += alone_line(found);
  text += formula_line(found) + hermite_line(found);
  if (!found.sequence.empty() && file.list.period.empty())
    text += fmt::format("least for    {}\n", sequence_text(found.sequence));
  if (found.exponent.lower && !found.exact.is_yes()) text += "not exact    " + found.exact.reason + "\n";
  if (!property.empty()) text += fmt::format("property     {}: {}\n", property, verdict_text(answer));
  return facts::wrapped(text, 13);
}

Json json_of(const MaskListFile& file, const ExponentOfList& found, const std::string& property, Truth answer) {
  Json json{{"masks", file.specifications}, {"order", order_text(file.list)}, {"sum_rules", found.sum_rules}};
  json.update(exponent_json(found));
  json["sequence"] = found.sequence;
  json["stable"] = found.stable.is_yes();
  if (found.vectors) {
    json["sum_rules_alone"] = found.vectors->alone;
    json["hermite"] = hermite_json(found);
  }
  if (!property.empty()) {
    json["property"] = property;
    json["verdict"] = verdict_text(answer);
  }
  return json;
}

/// Of all sequences first.
std::vector<NamedCertificate> certificates_of(const MaskList& list, const ExponentOfList& found, const Budget& budget) {
  std::vector<NamedCertificate> result;
  for (Certificate& one : list_certificates(list, found, budget)) {
    const auto* about_list = std::get_if<ListSubject>(&one.claim.subject);
    const bool of_matrices = about_list && !about_list->of_matrices.empty(),
               all = of_matrices || (result.empty() && list.period.empty()),
               of_scheme = std::holds_alternative<MaskSubject>(one.claim.subject);
    result.push_back({fmt::format("0{}{}-{}", result.size() + 1,
                                  of_matrices && about_list->of_matrices == "hermite" ? "-hermite" : "",
                                  all         ? "all"
                                  : of_scheme ? "scheme"
                                              : "sequence"),
                      std::move(one)});
  }
  return result;
}

}  // namespace

Json exponent_json(const ExponentOfList& found) {
  Json json{{"holder", enclosure_json(positive_part(found.exponent))},
            {"exact", found.exact.is_yes()},
            {"exactness", found.exact.reason}};
  json.update(facts::page_json(facts::formula_facts(facts::exponent_formula(found))));
  return json;
}

std::string formula_line(const ExponentOfList& found) {
  const auto formula = facts::exponent_formula(found);
  return formula ? fmt::format("formula      {}\n", formula->text()) : "";
}

RangeProperty read_levels_property(const std::string& text, bool of_matrices) {
  using Kind = RangeProperty::Kind;
  const auto property = parse_range_property(text);
  if (!property || (property->kind != Kind::convergent && property->kind != Kind::smooth &&
                    property->kind != Kind::holder && !(of_matrices && property->kind == Kind::hermite)))
    fail(ErrorKind::usage, "--property: expected convergent, C1, C2, ...{} or holder>=3/2, got '{}'",
         of_matrices ? ", HC1, HC2, ..." : "", text);
  return *property;
}

ExitCode run_levels_of_list(const SearchOptions& options, const std::string& file, const std::string& property,
                            const std::string& certificates) {
  const MaskListFile read_file = read_lists(file);
  const auto asked = property.empty() ? std::nullopt
                                      : std::optional(read_levels_property(property, read_file.list.hermite));
  if (asked) require_property(read_file.list, *asked);
  if (!certificates.empty()) require_folder(certificates);
  const Budget budget = options.limits();
  options.progress("masks");
  const ExponentOfList found = exponent_of(read_file.list, budget);
  options.end_progress();
  const Truth answer = asked                                                 ? holds(found, *asked)
                       : found.exponent.is_bounded() && found.exact.is_yes() ? Truth::yes
                                                                             : Truth::unknown;
  Json json = json_of(read_file, found, property, answer);
  WrittenCertificates written;
  if (!certificates.empty())
    written = write_certificates(certificates, certificates_of(read_file.list, found, budget),
                                 {"-all", "-sequence", "-scheme"}, "what is not proved", json);
  options.answer(json, text_of(read_file, found, property, answer) + written.text);
  written.failure.raise();
  return exit_code(answer, !budget.deadline.expired());
}

}  // namespace subcert::cli
