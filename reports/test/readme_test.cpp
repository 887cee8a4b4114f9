#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/folder.hpp>
#include <subcert/proofs-checks/papers/registry.hpp>
#include <subcert/reports/results.hpp>

#include <sstream>

using namespace subcert;
using namespace subcert::reports;

namespace {

/// Every cell and every claim of a paper with the verdict on record.
Report recorded_report(const statements::Paper& paper) {
  Report report{paper.key, paper.citation, {{"tables", "Tables", {}}}};
  for (const statements::PublishedTable& table : paper.tables) {
    formats::ComparisonTable compared{paper.key, table.id, table.title, table.place, table.grid, {}};
    for (const statements::PublishedCell& cell : table.cells) {
      compared.comparisons.push_back(
          {cell.row, cell.column, cell.scheme, cell.printed, std::string(), cell.recorded, cell.recorded, ""});
      compared.comparisons.back().derived = cell.derived;
    }
    report.sections.front().comparisons.push_back(std::move(compared));
  }
  for (const experiments::Experiment& experiment : experiments::experiments()) {
    if (experiment.paper != paper.key) continue;
    report.experiments.push_back({&experiment, {}, {}});
    for (const experiments::Claim& claim : experiment.claims)
      if (claim.counted_in.empty())
        report.experiments.back().result.claims.push_back(
            {claim.sentence, claim.place, claim.recorded, "", "", claim.recorded});
  }
  return report;
}

/// What a run finds where all verdicts are as recorded.
Findings recorded_findings() {
  Findings findings;
  for (const std::string& key : statements::paper_keys())
    findings.reports.push_back(recorded_report(statements::paper(key)));
  for (const statements::Statement& one : statements::statements())
    findings.statements.push_back(
        {&one, {one.recorded, "", "", "", one.grade == Grade::edge ? std::string("n = 1") : std::string()}, 0});
  return findings;
}

/// With one blank for all white space between words.
std::string in_one_line(const std::string& text) {
  std::istringstream words(text);
  std::string result;
  for (std::string word; words >> word;) result += (result.empty() ? "" : " ") + word;
  return result;
}

}  // namespace

TEST_CASE("README and docs quote the counts on record") {
  const auto quote = [](const char* page, const std::string& text) {
    CAPTURE(page, text);
    CHECK(in_one_line(testing::content(std::string(SUBCERT_SOURCE_DIR "/") + page)).find(text) != std::string::npos);
  };
  const Findings findings = recorded_findings();
  REQUIRE(findings.as_recorded());
  const std::vector<Result> all = results(findings);
  for (const ResultKind kind : {ResultKind::value, ResultKind::statement, ResultKind::claim}) {
    quote("README.md", counts(all, kind).text());
    for (const std::string& key : statements::paper_keys()) quote("docs/report.md", counts(all, kind, key).text());
  }
  quote("docs/report.md", errata_sentence(counts(all, ResultKind::statement)));
}
