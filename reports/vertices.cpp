#include "collections.hpp"

#include "computed_quantities.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/vertex/every_valence.hpp>
#include <subcert/proofs-checks/certificates/vertex_certificate.hpp>
#include <subcert/proofs-checks/vertex_rules_file.hpp>
#include <subcert/reports/facts/vertex_facts.hpp>

#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace subcert {
// Made by the build: docs/examples/vertices, by the names of the files.
extern const std::map<std::string, std::string_view> vertex_rule_files;
}  // namespace subcert

namespace subcert::reports {
namespace {

constexpr double seconds_of_scheme = 60;  // what closes needs 25
constexpr int usual_valences = 12;        // up to this one
const Rational beside = Rational(1) / 500;

constexpr std::array classics{"loop",      "catmull-clark",      "doo-sabin", "midedge",
                              "butterfly", "modified-butterfly", "sqrt3"};
constexpr std::array fits{"triangular:L=8/5,d=1", "triangular:L=17/10,d=1,power=1", "triangular:L=17/10,d=1,power=2"};

/// By its name, or from a file of docs/examples/vertices, with a value of its letter.
VertexScheme scheme_of(const std::string& text, const std::optional<Rational>& value = std::nullopt) {
  if (!text.ends_with(".toml")) return VertexScheme::named(text);
  const std::size_t begin = text.rfind('/') + 1;
  const std::string name = text.substr(begin, text.size() - begin - std::string_view(".toml").size());
  VertexScheme scheme = read_vertex_rules(vertex_rule_files.at(name), text);
  if (value) scheme.written->letters.front().value = value;
  return scheme;
}

Budget budget_of_scheme(const ReportOptions& options) {
  return {Deadline::in(options.budget.value_or(seconds_of_scheme))};
}

/// What is proved of a scheme at vertices, of valences 3 to 12 or all.
struct AtVertices {
  VertexScheme scheme;
  std::vector<SectorRules> rules;
  std::optional<SectorRuleFamily> family;
  RegularPart regular;
  std::vector<VertexSmoothness> valences;
  std::optional<EveryValence> rest;

  Truth c1() const { return facts::all_of(valences, rest); }
};

AtVertices at_vertices(const std::string& text, bool all, const ReportOptions& options) {
  VertexScheme scheme = scheme_of(text);
  std::optional<SectorRuleFamily> family;
  if (all) family = scheme.family();
  std::vector<int> numbers;
  for (int n = smallest_valence; n <= usual_valences || (all && n < first_of_all(*family)); ++n) numbers.push_back(n);
  std::vector<SectorRules> rules = scheme.at(numbers);
  RegularPart regular = regular_part(rules.front(), budget_of_scheme(options));
  std::vector<VertexSmoothness> valences = vertex_smoothness(rules, regular, 1);
  std::optional<EveryValence> rest;
  if (all) rest = every_valence(*family, regular, numbers.back() + 1, budget_of_scheme(options));
  return {std::move(scheme),  std::move(rules),    std::move(family),
          std::move(regular), std::move(valences), std::move(rest)};
}

class VerticesReport {
 public:
  explicit VerticesReport(const ReportOptions& options) : options_(options) {}

  void need(const std::vector<std::string>& schemes) {
    make_missing(all_, schemes, options_, [&](const std::string& text) { return at_vertices(text, true, options_); });
  }

  formats::Comparison compare(const statements::PublishedCell& cell) const {
    formats::Comparison comparison = cell.quantity == "lambda"             ? eigenvalue(cell)
                                     : cell.quantity == "C^1 up to lambda" ? largest_eigenvalue(cell)
                                                                           : every_valence_of(cell);
    comparison.source = source_text(cell);
    return comparison;
  }

  formats::PlainTable scheme_table() const {
    formats::PlainTable table{"schemes",
                              "Schemes at vertices of every valence; no source was read for these proofs",
                              {"scheme", "regular part", "C^1 for every n", "proved for", "why not"},
                              {}};
    for (const char* name : classics) {
      const AtVertices& found = *all_.at(name);
      std::vector<std::string> proved, reasons;
      for (const VertexSmoothness& at : found.valences) {
        if (at.c1.is_yes())
          proved.push_back(std::to_string(at.valence));
        else if (std::ranges::find(reasons, at.c1.reason) == reasons.end())
          reasons.push_back(at.c1.reason);
      }
      if (found.rest->c1.is_yes())
        proved.push_back(fmt::format("all from {} on", found.rest->first));
      else
        reasons.push_back(found.rest->c1.reason);
      table.rows.push_back({name, formats::fixed_text(found.regular.exponent, 6), to_text(found.c1()),
                            fmt::format("{}", fmt::join(proved, ", ")), fmt::format("{}", fmt::join(reasons, "; "))});
      table.proofs.push_back(proof_of(name, found));
    }
    return table;
  }

  formats::PlainTable valence_table() const {
    formats::PlainTable table = empty_valences("valences", "Vertices of valences 3 to 12");
    for (const char* name : classics) add_valences(table, *all_.at(name));
    return table;
  }

  formats::PlainTable fit_table() {
    std::map<std::string, std::optional<AtVertices>> found;
    make_missing(found, {fits.begin(), fits.end()}, options_,
                 [&](const std::string& text) { return at_vertices(text, false, options_); });
    formats::PlainTable table = empty_valences("fits", "Local regression at vertices, by fits in the flat fan");
    for (const char* name : fits) add_valences(table, *found.at(name));
    return table;
  }

 private:
  formats::Comparison every_valence_of(const statements::PublishedCell& cell) const {
    const AtVertices& found = *all_.at(cell.scheme);
    const Truth truth = found.c1();
    formats::Comparison comparison = compare_text(cell,
                                                  truth == Truth::yes  ? "every valence"
                                                  : truth == Truth::no ? "not every valence"
                                                                       : "not decided",
                                                  truth);
    comparison.command = fmt::format("subcert vertex {} --all-valences", cell.scheme);
    return comparison;
  }

  formats::Comparison eigenvalue(const statements::PublishedCell& cell) const {
    const auto& valences = all_.at(cell.scheme)->valences;
    const auto at = std::ranges::find(valences, static_cast<long>(cell.n.value()), &VertexSmoothness::valence);
    require(at != valences.end(), "vertices: need a valence up to {}, got {}", valences.back().valence, *cell.n);
    formats::Comparison comparison = compare_number(cell, at->subdominant);
    comparison.command = fmt::format("subcert vertex {} --valence {}", cell.scheme, *cell.n);
    return comparison;
  }

  /// By values on both sides of the printed one.
  formats::Comparison largest_eigenvalue(const statements::PublishedCell& cell) const {
    const Rational printed = *parse_number(cell.printed);
    std::optional<RegularPart> regular;  // the same for all values
    const auto c1_at = [&](const Rational& value) {
      const SectorRules rules = scheme_of(cell.scheme, value).at(cell.n.value());
      if (!regular) regular = regular_part(rules, budget_of_scheme(options_));
      return vertex_smoothness(rules, *regular).c1.truth;
    };
    const Rational low = printed - beside, high = printed + beside;
    const Truth below = c1_at(low), above = c1_at(high);
    const bool refuted = below == Truth::no || above == Truth::yes;
    const Truth truth = below == Truth::yes && above == Truth::no ? Truth::yes : refuted ? Truth::no : Truth::unknown;
    const auto said = [](Truth c1, const Rational& value) {
      return fmt::format("{} at {}",
                         c1 == Truth::yes  ? "C^1"
                         : c1 == Truth::no ? "not C^1"
                                           : "open",
                         decimal(value, 4));
    };
    formats::Comparison comparison = compare_text(cell, said(below, low) + ", " + said(above, high), truth);
    comparison.command = fmt::format("subcert vertex {} --over b=1/2..1 --valence {}", cell.scheme, *cell.n);
    return comparison;
  }

  /// The certificate of all valences that are proved at once.
  formats::RowProof proof_of(const std::string& name, const AtVertices& found) const {
    if (!found.rest->evidence) return {};
    const MultivariateRegularity regularity = regularity_around(found.rules.front().mask, true,
                                                                budget_of_scheme(options_));
    return row_proof(name + "-vertices.cert", vertex_certificate(*found.family, regularity, *found.rest),
                     options_.verified);
  }

  static formats::PlainTable empty_valences(const char* id, const char* title) {
    return {id, title, {"scheme", "n", "C^1", "lambda", "|mu|", "exponent", "curvature"}, {}};
  }
  static void add_valences(formats::PlainTable& table, const AtVertices& found) {
    const auto number = [](const Enclosure& value) {
      return value.lower || value.upper ? formats::fixed_text(value, 8) : std::string();
    };
    for (const VertexSmoothness& at : found.valences)
      table.rows.push_back({found.scheme.specification, std::to_string(at.valence), to_text(at.c1.truth),
                            number(at.subdominant), number(at.next), number(at.exponent),
                            at.curvature ? to_text(*at.curvature) : ""});
  }

  const ReportOptions& options_;
  std::map<std::string, std::optional<AtVertices>> all_;
};

}  // namespace

Report report_vertices(const ReportOptions& options) {
  const statements::PublishedTable& published = statements::paper("vertices").table("published");
  VerticesReport report(options);
  std::vector<std::string> schemes;
  if (options.wants("published"))
    for (const statements::PublishedCell& cell : published.cells)
      if (cell.quantity != "C^1 up to lambda") schemes.push_back(cell.scheme);
  if (options.wants("schemes") || options.wants("valences"))
    schemes.insert(schemes.end(), classics.begin(), classics.end());
  report.need(schemes);

  formats::Section section{"vertices", "Surfaces at extraordinary vertices", {}};
  section.paragraphs.push_back(
      "What sources that were read say of smoothness at vertices, and what is proved for every valence: C^1 means that "
      "for all initial data but a set of measure zero the surface is, near the vertex, the graph of a C^1 function "
      "over "
      "its tangent plane.");
  if (options.wants("published"))
    add_published(section, "vertices", published,
                  [&](const statements::PublishedCell& cell) { return report.compare(cell); });
  if (options.wants("schemes")) section.tables.push_back(report.scheme_table());
  if (options.wants("valences")) section.tables.push_back(report.valence_table());
  if (options.wants("fits")) section.tables.push_back(report.fit_table());
  return collection_report("vertices", std::move(section));
}

}  // namespace subcert::reports
