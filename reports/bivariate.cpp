#include "collections.hpp"

#include "computed_quantities.hpp"
#include "surface_facts.hpp"

#include <subcert/proofs-checks/papers/registry.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace subcert::reports {
namespace {

constexpr double published_seconds = 10;  // seconds; what closes needs 1

struct Named {
  std::string name, specification;
};

/// The schemes of the table, each once, and those for which no published value with a sure source is known.
std::vector<Named> schemes_of_collection(const statements::PublishedTable& published) {
  std::vector<Named> list;
  std::set<std::string> seen;
  for (const statements::PublishedCell& cell : published.cells)
    if (seen.insert(cell.scheme).second) list.push_back({cell.row, cell.scheme});
  list.push_back({"quincunx, bilinear", "quincunx"});
  return list;
}

}  // namespace

Report report_bivariate(const ReportOptions& options) {
  const statements::PublishedTable& published = statements::paper("bivariate").table("published");
  const std::vector<Named> schemes = schemes_of_collection(published);
  std::vector<std::string> specifications;
  for (const Named& one : schemes) specifications.push_back(one.specification);
  const std::vector<SurfaceFacts> facts = surface_facts(specifications, options, published_seconds);

  formats::Section section{"published", "Published smoothness, and what is proved", {}};
  section.paragraphs.push_back(
      "Exponents and classes that the literature states for bivariate schemes in their regular part, with the source "
      "of "
      "each. A decimal number is compared in the printed digits. A whole number is meant exactly. C^k holds where the "
      "Hoelder exponent is above k, and fails where it is below.");
  if (options.wants("published"))
    add_published(section, "bivariate", published, [&](const statements::PublishedCell& cell) {
      const auto at = std::ranges::find(specifications, cell.scheme) - specifications.begin();
      const SurfaceFacts& found = facts[static_cast<std::size_t>(at)];
      return compare_smoothness(cell, found.specification, found.regularity);
    });
  if (options.wants("schemes")) {
    formats::PlainTable table{
        "schemes", "The schemes, and what is proved about them", surface_facts_head({"scheme"}), {}};
    table.head.push_back("specification");
    for (std::size_t i = 0; i < facts.size(); ++i) {
      table.rows.push_back(facts[i].row({schemes[i].name}));
      table.rows.back().push_back(facts[i].specification);
    }
    section.tables.push_back(std::move(table));
  }
  return collection_report("bivariate", std::move(section));
}

}  // namespace subcert::reports
