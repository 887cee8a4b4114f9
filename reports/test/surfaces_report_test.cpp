#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/folder.hpp>
#include <subcert/proofs-checks/papers/registry.hpp>
#include <subcert/reports/pages.hpp>
#include <subcert/reports/report_files.hpp>
#include <subcert/schemes/specification.hpp>

#include <set>

using namespace subcert;
using namespace subcert::reports;
using subcert::testing::content;
using subcert::testing::Folder;

namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const formats::PlainTable& table_of(const Report& report, const std::string& id) {
  for (const formats::Section& section : report.sections)
    for (const formats::PlainTable& table : section.tables)
      if (table.id == id) return table;
  throw std::runtime_error("no table " + id);
}

}  // namespace

TEST_CASE("every published value of a surface is about a scheme that can be read, and can be compared") {
  for (const statements::PublishedCell& cell : statements::paper("bivariate").table("published").cells) {
    CAPTURE(cell.row, cell.scheme, cell.printed);
    CHECK(make_linear_scheme(cell.scheme).mask.dimension() > 1);
    CHECK(formats::compare_exponent(cell.printed, Enclosure{}) == ValueVerdict::open);
    CHECK(cell.recorded != ValueVerdict::mismatch);
  }
}

TEST_CASE("a gathered table names its sources, on the page, in the data and in a terminal") {
  formats::ComparisonTable table{"bivariate", "published", "Published smoothness", "each with its source", false, {}};
  table.comparisons.push_back({"Loop", "class", "loop", "C^2", Enclosure::exactly(3), ValueVerdict::match,
                               ValueVerdict::match, "", "[Loo87] C. Loop: A thesis", "yes"});
  Report report{"bivariate", "Bivariate schemes: a collection", {{"published", "Published smoothness", {}, {table}}}};
  report.listed = true;
  const Folder folder;
  write_reports({{report}}, folder.path, 1);
  CHECK(has(content(folder.path / "bivariate.html"), "<td class=text>[Loo87] C. Loop: A thesis</td>"));
  CHECK(has(content(folder.path / "bivariate" / "published.csv"), "\"note\",\"stable\",\"source\""));
  CHECK(has(content(folder.path / "bivariate" / "published.json"), "\"source\": \"[Loo87] C. Loop: A thesis\""));
  CHECK(has(content(folder.path / "bivariate" / "published.tex"), "& [Loo87] \\\\"));
  CHECK(has(full_list({{report}}), "Loop    class  C^2        3.000000  yes     match    [Loo87]\n"));
}

TEST_CASE("what the literature says about bivariate schemes", "[long]") {
  const Report report = make_report("bivariate", {});
  for (const formats::Comparison& c : report.sections.front().comparisons.front().comparisons) {
    CAPTURE(c.cell(), c.printed, c.computed_text());
    CHECK(to_text(c.verdict) == to_text(c.recorded));
  }
}

TEST_CASE("least squares schemes on grids: each once, with what is proved", "[long]") {
  const Report report = make_report("surfaces", {});
  const formats::PlainTable& fits = table_of(report, "least-squares");
  CHECK(fits.rows.size() == 14);
  std::set<std::string> masks;
  for (const auto& row : fits.rows) {
    CAPTURE(row.front());
    const auto scheme = make_linear_scheme(row.front());
    CHECK(masks.insert(to_mask_text(scheme.mask)).second);
    CHECK(row.size() == fits.head.size());
    CHECK(row[3] == "yes");
  }
  // Exact: for 3 x 3 data and degree 2, -log_2 of 7/16.
  CHECK(fits.rows[2][4] == "1.19264508");
  CHECK(table_of(report, "tensor-products").rows.size() == 7);
}
