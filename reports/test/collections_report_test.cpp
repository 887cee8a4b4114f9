// Published values of collections of the literature and their verdicts.
#include <subcert/cmake/catch.hpp>
#include <subcert/reports/report.hpp>

#include <algorithm>

using namespace subcert;
using namespace subcert::reports;

namespace {

/// Of a collection with one table of comparisons, whose verdicts are those on record.
Report recorded_report(const char* collection) {
  ReportOptions options;
  options.jobs = 2;
  Report report = make_report(collection, options);
  CHECK(report.as_recorded());
  REQUIRE(report.comparison_tables().size() == 1);
  return report;
}

const formats::ComparisonTable& only_table(const Report& report) { return *report.comparison_tables().front(); }

}  // namespace

TEST_CASE("published exponents of Daubechies' scaling functions", "[long]") {
  const Report report = recorded_report("daubechies");
  CHECK(only_table(report).count(ValueVerdict::match) == static_cast<int>(only_table(report).comparisons.size()));
  const formats::PlainTable& exponents = report.sections.front().tables.front();
  REQUIRE(exponents.rows.size() == 24);
  CHECK(exponents.rows.back().front() == "D50");
  REQUIRE(exponents.proofs.size() == exponents.rows.size());
  CHECK(exponents.rows.front()[4] == "yes");
  CHECK(exponents.rows.back()[4] == "yes");
  for (std::size_t i = 0; i < exponents.rows.size(); ++i) {
    const formats::RowProof& proof = exponents.proofs[i];
    CAPTURE(proof.name);
    CHECK(proof.files.at(proof.name).find(" within=1/") != std::string::npos);
    if (exponents.rows[i][4] == "yes") CHECK(exponents.rows[i][2].find("e-") != std::string::npos);
    // No checker is asked here, so that the file claims no more than the bounds.
    CHECK(proof.files.at(proof.name).find("\nattains ") == std::string::npos);
  }
}

TEST_CASE("published ranges of a parameter") {
  const Report report = recorded_report("families");
  const formats::ComparisonTable& table = only_table(report);
  CHECK(table.comparisons.size() >= 10);
  CHECK(table.count(ValueVerdict::match) == static_cast<int>(table.comparisons.size()));
  for (const formats::Comparison& comparison : table.comparisons) {
    if (comparison.source_key() == "[HMR09]") {
      CHECK(comparison.computed_text() == "0 < w < 0.1927292");
      CHECK(comparison.note.find("-1 + 4*w + 32*w^3") != std::string::npos);
    }
    if (comparison.source_key() == "[HIDS02]") CHECK(comparison.note == "exactly the proved range");
    if (comparison.source_key() == "[Wei90]")
      CHECK(comparison.note.starts_with("true, but a part of the proved range"));
  }
}

TEST_CASE("published smoothness of vectors of functions") {
  const Report report = recorded_report("vectors");
  const formats::ComparisonTable& table = only_table(report);
  CHECK(table.comparisons.size() >= 15);
  CHECK(table.count(ValueVerdict::open) == 0);
  // The ends of a range that computations showed, but not its middle, and one last digit.
  CHECK(table.count(ValueVerdict::mismatch) == 3);
  const formats::PlainTable& functions = report.sections.front().tables.front();
  REQUIRE(functions.rows.size() >= 20);
  for (const auto& row : functions.rows) {
    CAPTURE(row.front());
    CHECK(row.size() == functions.head.size());
    CHECK(row.back() != "open");
    CHECK(row[3].find(" ... ") == std::string::npos);
  }
}

TEST_CASE("published smoothness at vertices", "[long]") {
  const Report report = recorded_report("vertices");
  const formats::ComparisonTable& table = only_table(report);
  CHECK(table.count(ValueVerdict::match) == table.values());
  CHECK(std::ranges::all_of(table.comparisons, [](const auto& one) { return one.verdict == ValueVerdict::match; }));
  const auto& tables = report.sections.front().tables;
  REQUIRE(tables.size() == 3);
  for (const formats::PlainTable& one : tables)
    for (const auto& row : one.rows) CHECK(row.size() == one.head.size());
  for (std::size_t i = 0; i < tables[0].rows.size(); ++i) {
    const auto& row = tables[0].rows[i];
    CAPTURE(row[0]);
    const bool is_butterfly = row[0] == "butterfly";
    CHECK(row[2] == (is_butterfly ? "no" : row[0] == "midedge" ? "unknown" : "yes"));
    if (is_butterfly) CHECK(row[3] == "4, 5, 6, 7");
  }
  CHECK(tables[1].rows.size() == 70);
  CHECK(tables[2].rows.size() == 30);
}

TEST_CASE("published joint spectral radii") {
  const Report report = recorded_report("jsr");
  CHECK(only_table(report).comparisons.size() >= 18);
  // One last digit is wrong in print.
  CHECK(only_table(report).count(ValueVerdict::mismatch) == 1);
  // The pair at the end of its plateau, on a slow machine.
  CHECK(only_table(report).count(ValueVerdict::open) <= 1);
  const formats::PlainTable& families = report.sections.front().tables.front();
  const auto& rows = families.rows;
  const auto& proofs = families.proofs;
  CHECK(rows.size() >= 34);
  // All but the pair at the end of its plateau and the one without a best product.
  CHECK(std::ranges::count_if(rows, [](const auto& row) { return row[3] != "exact"; }) == 2);
  CHECK(proofs.size() == rows.size());
  for (const formats::RowProof& proof : proofs) {
    CAPTURE(proof.name);
    CHECK(proof.files.contains(proof.name));
    CHECK(proof.files.contains(proof.name + ".matrices"));
  }
}

TEST_CASE("masks that change from level to level", "[long]") {
  const Report report = recorded_report("levels");
  const formats::ComparisonTable& table = only_table(report);
  CHECK(table.count(ValueVerdict::match) == static_cast<int>(table.comparisons.size()));
  const auto& tables = report.sections.front().tables;
  REQUIRE(tables.size() == 4);
  for (const formats::PlainTable& one : tables)
    for (const auto& row : one.rows) CHECK(row.size() == one.head.size());
  // All but C^3, whose interval needs two pieces, with a certificate each.
  const formats::PlainTable& intervals = tables[0];
  CHECK(std::ranges::count_if(intervals.rows, [](const auto& row) { return row[3] == "yes"; }) == 5);
  REQUIRE(intervals.proofs.size() == intervals.rows.size());
  for (std::size_t i = 0; i < intervals.rows.size(); ++i)
    CHECK(intervals.proofs[i].name.empty() == (intervals.rows[i][3] != "yes"));
  CHECK(tables[1].rows[0][4] == "2.0000000000");
  CHECK(tables[1].rows[1][4].starts_with("2.83007499"));
  CHECK(tables[1].rows[2][4] == "3.0000000000");
  CHECK(tables[2].rows[1][3] == "2.5000000000");
  CHECK(tables[2].rows[2][3].starts_with("0.99733985"));
  // Lists of matrices: Merrien's in any order and mu = 3/2 not twice in a row, Hermite splines, multiwavelets.
  const auto& lists = tables[2].rows;
  REQUIRE(lists.size() == 7);
  CHECK(lists[3][3].starts_with("0.67807"));
  CHECK(lists[3].back().empty());
  CHECK(lists[4][3].starts_with("1.8390359"));
  CHECK(lists[4][4] == "3 - log_2(5)/2");
  CHECK(lists[4].back() == "HC^1");
  CHECK(lists[5][3] == "2.0000000000");
  CHECK(lists[6][3].starts_with("0.6673"));
  CHECK(std::ranges::all_of(lists, [](const auto& row) { return row[6] == "yes"; }));
  CHECK(tables[3].rows[0][4].starts_with("1.00580"));
  CHECK(tables[3].rows[2][4].starts_with("0.99216"));
}
