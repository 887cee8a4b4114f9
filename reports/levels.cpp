#include "collections.hpp"

#include "computed_quantities.hpp"

#include <subcert/analysis/family/limit_of_levels.hpp>
#include <subcert/analysis/family/local_levels.hpp>
#include <subcert/analysis/family/property_of_levels.hpp>
#include <subcert/proofs-checks/certificates/certificate.hpp>
#include <subcert/proofs-checks/properties/mask_list_file.hpp>
#include <subcert/reports/facts/exponent_formula.hpp>
#include <subcert/schemes/parametric_specification.hpp>

#include <fmt/ranges.h>

namespace subcert::reports {
namespace {

constexpr double seconds_of_one = 20;
constexpr const char* halving = "v=sqrt((1+v)/2)";

struct OfRange {
  const char* family;
  Rational low, high;
  const char* property = "";
};

const std::vector<OfRange>& intervals() {
  static const std::vector<OfRange> all{{"four-point:w", Rational(1, 1000), Rational(19, 100), "C1"},
                                        {"dual-four-point:w", Rational(1, 1000), Rational(21, 1000), "C2"},
                                        {"ternary-four-point:w", Rational(67, 1000), Rational(111, 1000), "C2"},
                                        {"six-point:w", Rational(1, 200), Rational(44, 1000), "C2"},
                                        {"six-point:w", Rational(13, 1000), Rational(16, 1000), "C3"},
                                        {"conic-four-point:v", Rational(9, 20), 1000, "C1"}};
  return all;
}

const std::vector<OfRange>& point_ranges() {
  static const std::vector<OfRange> all{{"four-point:w", Rational(1, 1000), Rational(3, 20)},
                                        {"four-point:w", Rational(1, 100), Rational(33, 200)},
                                        {"four-point:w", Rational(1, 100), Rational(17, 100)},
                                        {"six-point:w", Rational(1, 200), Rational(3, 100)}};
  return all;
}

struct OfRecurrence {
  const char* family;
  Rational low, high;  ///< that hold all values in the end
  Interval start;
};

const std::vector<OfRecurrence>& recurrences() {
  static const std::vector<OfRecurrence> all{{"conic-four-point:v", Rational(9, 20), 1000, {-1, 1'000'000}},
                                             {"exponential-six-point:v", Rational(1, 2), 10, {0, 100}},
                                             {"exponential-bspline:v", Rational(1, 2), 10, {0, 100}}};
  return all;
}

struct OfList {
  std::vector<const char*> masks;
  std::vector<std::size_t> period;
  std::vector<std::pair<std::size_t, std::size_t>> follows;
  const char* order;
};

constexpr const char* first_never_twice = "the first never twice in a row";

const std::vector<OfList>& lists() {
  static const std::vector<OfList> all{
      {{"dd:n=2", "bspline:degree=3"}, {}, {}, "any"},
      {{"dd:n=2", "bspline:degree=3"}, {0, 1}, {}, "in turn"},
      {{"four-point:w=1/4", "four-point:w=1/16"}, {}, {{0, 1}, {1, 0}, {1, 1}}, first_never_twice},
      {{"merrien:lambda=-1/8,mu=3/2", "merrien:lambda=-1/8,mu=-1/2"}, {}, {}, "any"},
      {{"merrien:lambda=-1/8,mu=3/2", "merrien:lambda=-1/8,mu=-1/2"}, {}, {{0, 1}, {1, 0}, {1, 1}}, first_never_twice},
      {{"hermite-dd:points=4,order=2", "hermite-dd:points=2,order=2"}, {}, {}, "any"},
      {{"ghm", "bspline:degree=3,multiplicity=2"}, {}, {}, "any"}};
  return all;
}

Budget budget_of(const ReportOptions& options) { return {Deadline::in(options.budget.value_or(seconds_of_one))}; }

std::string range_text(const OfRange& one, const ParametricScheme& scheme) {
  return fmt::format("{} <= {} <= {}", to_text(one.low), scheme.name, to_text(one.high));
}

FollowedLevels followed(const OfRecurrence& one, const ReportOptions& options) {
  const ParametricScheme scheme = make_parametric_scheme(one.family);
  return follow(scheme.mask, Recurrence::parse(halving, scheme.name, scheme.letter), {one.start}, {one.low, one.high},
                budget_of(options));
}

/// C^1 of all limits, or the exponentials that are generated.
formats::Comparison compare(const statements::PublishedCell& cell, const ReportOptions& options) {
  const OfRecurrence& one = recurrences().front();
  require(cell.scheme == one.family, "levels: need the scheme {}, got {}", one.family, cell.scheme);
  const ParametricMask mask = make_parametric_scheme(cell.scheme).mask;
  if (cell.quantity == "exponentials") {
    const std::string found = to_text(exponential_sum_rules(mask));
    formats::Comparison comparison = compare_text(cell, found, found == cell.printed ? Truth::yes : Truth::no);
    comparison.source = source_text(cell);
    return comparison;
  }
  const auto property = parse_range_property("C1");
  const PropertyOfLevels all = property_of_levels(mask, *property, {{one.low}, {one.high}}, budget_of(options));
  const FollowedLevels found = followed(one, options);
  const Truth answer = found.have(*property, all.holds);
  const std::string exponent = found.limit ? formats::fixed_text(found.limit->exponent.exponent, 10)
                                           : std::string("not known");
  formats::Comparison comparison = compare_text(cell, "C^1, exponent " + exponent, answer);
  comparison.source = source_text(cell);
  comparison.note = fmt::format(
      "for all v_0 from {} to {} that have a mask at each level; v_k is from {} to {} from level {} on",
      to_text(one.start.lower), to_text(one.start.upper), to_text(one.low), to_text(one.high),
      found.first_level().value_or(-1));
  comparison.command = fmt::format(
      "subcert levels {} --over v={}..{} --property C1 --recurrence '{}' --start v0={}..{}", cell.scheme,
      to_text(one.low), to_text(one.high), halving, to_text(one.start.lower), to_text(one.start.upper));
  return comparison;
}

formats::PlainTable interval_table(const ReportOptions& options) {
  formats::PlainTable table{"intervals",
                            "What every sequence of values has, one value for each level; no source was read for it",
                            {"family", "values", "property", "for all sequences", "sum rules", "why not"},
                            {}};
  int number = 0;
  for (const OfRange& one : intervals()) {
    const ParametricScheme scheme = make_parametric_scheme(one.family);
    const RangeProperty property = *parse_range_property(one.property);
    const Box box{{one.low}, {one.high}};
    const PropertyOfLevels found = property_of_levels(scheme.mask, property, box, budget_of(options));
    table.rows.push_back({scheme.specification, range_text(one, scheme), one.property, to_text(found.holds),
                          std::to_string(found.sum_rules), found.reason});
    const auto certificate = levels_certificate(scheme.mask, scheme.letter, property, box, found);
    table.proofs.push_back(certificate
                               ? row_proof(fmt::format("levels-{}.cert", ++number), *certificate, options.verified)
                               : formats::RowProof{});
  }
  return table;
}

formats::PlainTable recurrence_table(const ReportOptions& options) {
  formats::PlainTable table{"recurrences",
                            "v_{k+1} = sqrt((1 + v_k)/2): exponents by the mask in the limit",
                            {"family", "first values", "from level", "generates", "exponent", "exact"},
                            {}};
  for (const OfRecurrence& one : recurrences()) {
    const FollowedLevels found = followed(one, options);
    std::vector<std::string> row{one.family,
                                 fmt::format("{} <= v_0 <= {}", to_text(one.start.lower), to_text(one.start.upper)),
                                 found.way ? std::to_string(found.way->size()) : "",
                                 "",
                                 "",
                                 to_text(Truth::unknown)};
    if (found.limit) {
      row[3] = to_text(found.limit->rules);
      row[4] = formats::fixed_text(found.limit->exponent.exponent, 10);
      row[5] = to_text(found.limit->exponent.exact.truth);
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

formats::PlainTable list_table(const ReportOptions& options) {
  formats::PlainTable table{"lists",
                            "Finitely many masks: the least exponent of all sequences",
                            {"masks", "order", "sum rules", "exponent", "formula", "least for", "exact", "Hermite"},
                            {}};
  for (const OfList& one : lists()) {
    properties::MaskListFile file;
    for (const char* name : one.masks) properties::add_mask(file, name);
    file.list.period = one.period;
    file.list.follows = one.follows;
    const ExponentOfList found = exponent_of(file.list, budget_of(options));
    const auto formula = facts::exponent_formula(found);
    const auto hermite = hermite_order_of(found);
    table.rows.push_back({fmt::format("{}", fmt::join(one.masks, ", ")), one.order, std::to_string(found.sum_rules),
                          formats::fixed_text(found.exponent, 10), formula ? formula->text() : "",
                          fmt::format("{}", fmt::join(found.sequence, ", ")), to_text(found.exact.truth),
                          hermite && hermite->order >= 0 ? fmt::format("HC^{}", hermite->order) : ""});
  }
  return table;
}

formats::PlainTable point_table(const ReportOptions& options) {
  formats::PlainTable table{
      "points",
      "A value for each new point of each level: exponents of all choices, at least",
      {"family", "values", "degree kept", "matrices", "at least", "one value everywhere, at most"},
      {}};
  for (const OfRange& one : point_ranges()) {
    const ParametricScheme scheme = make_parametric_scheme(one.family);
    const LocalLevels found = local_levels(scheme.mask, {{one.low}, {one.high}}, budget_of(options));
    table.rows.push_back({scheme.specification, range_text(one, scheme), std::to_string(found.order - 1),
                          std::to_string(found.family.count()),
                          found.exponent.lower ? found.exponent.lower_text(8) : "",
                          found.exponent.upper ? found.exponent.upper_text(8) : ""});
  }
  return table;
}

}  // namespace

Report report_levels(const ReportOptions& options) {
  formats::Section section{"levels", "Masks that change from level to level", {}};
  section.paragraphs.push_back(
      "What sources that were read say of such schemes, and what is proved: for every sequence of values of an "
      "interval, with certificates; for values that follow each other, by the mask in the limit; for masks of a list "
      "in any order, in turn or along a graph; and where each new point takes a value of its own.");
  if (options.wants("published"))
    add_published(section, "levels", statements::paper("levels").table("published"),
                  [&](const statements::PublishedCell& cell) { return compare(cell, options); });
  using Made = std::pair<const char*, formats::PlainTable (*)(const ReportOptions&)>;
  for (const auto& [item, make] : {Made{"intervals", interval_table}, Made{"recurrences", recurrence_table},
                                   Made{"lists", list_table}, Made{"points", point_table}})
    if (options.wants(item)) section.tables.push_back(make(options));
  return collection_report("levels", std::move(section));
}

}  // namespace subcert::reports
