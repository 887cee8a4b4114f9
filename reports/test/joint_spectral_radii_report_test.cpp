// The published joint spectral radii and their verdicts.
#include <subcert/cmake/catch.hpp>
#include <subcert/reports/report.hpp>

#include <algorithm>

using namespace subcert;
using namespace subcert::reports;

TEST_CASE("published joint spectral radii") {
  ReportOptions options;
  options.jobs = 2;
  const Report report = make_report("jsr", options);
  CHECK(report.as_recorded());
  const auto tables = report.comparison_tables();
  REQUIRE(tables.size() == 1);
  CHECK(tables.front()->comparisons.size() >= 18);
  // One last digit is wrong in print.
  CHECK(tables.front()->count(ValueVerdict::mismatch) == 1);
  // The pair at the end of its plateau, on a slow machine.
  CHECK(tables.front()->count(ValueVerdict::open) <= 1);
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
