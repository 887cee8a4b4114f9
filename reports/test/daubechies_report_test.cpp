// The published exponents of Daubechies' scaling functions.
#include <subcert/cmake/catch.hpp>
#include <subcert/reports/report.hpp>

using namespace subcert;
using namespace subcert::reports;

TEST_CASE("published exponents of Daubechies' scaling functions") {
  ReportOptions options;
  options.jobs = 2;
  const Report report = make_report("daubechies", options);
  CHECK(report.as_recorded());
  const auto tables = report.comparison_tables();
  REQUIRE(tables.size() == 1);
  CHECK(tables.front()->count(ValueVerdict::match) == static_cast<int>(tables.front()->comparisons.size()));
  const formats::PlainTable& exponents = report.sections.front().tables.front();
  REQUIRE(exponents.rows.size() == 20);
  CHECK(exponents.rows.back().front() == "D42");
  REQUIRE(exponents.proofs.size() == exponents.rows.size());
  for (std::size_t i = 0; i < exponents.rows.size(); ++i) {
    const formats::RowProof& proof = exponents.proofs[i];
    CAPTURE(proof.name);
    CHECK(proof.files.at(proof.name).find(" within=1/") != std::string::npos);
    CHECK(exponents.rows[i][2].find("e-") != std::string::npos);
  }
}
