// The published ranges of a parameter and their verdicts.
#include <subcert/cmake/catch.hpp>
#include <subcert/reports/report.hpp>

using namespace subcert;
using namespace subcert::reports;

TEST_CASE("published ranges of a parameter") {
  ReportOptions options;
  options.jobs = 2;
  const Report report = make_report("families", options);
  CHECK(report.as_recorded());
  const auto tables = report.comparison_tables();
  REQUIRE(tables.size() == 1);
  const formats::ComparisonTable& table = *tables.front();
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
