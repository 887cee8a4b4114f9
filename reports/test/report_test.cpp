#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/cmake/folder.hpp>
#include <subcert/proofs-checks/papers/registry.hpp>
#include <subcert/reports/report_files.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <set>

using namespace subcert;
using namespace subcert::reports;
using subcert::testing::content;
using subcert::testing::Folder;
namespace fs = std::filesystem;

// The long cases compute what `subcert reproduce` computes, which ./check runs first.
TEST_CASE("every verdict on Dyn et al. is the recorded one", "[long]") {
  const Report report = make_report(
      "dyn-2015", {{"masks", "supports", "table1", "table2", "table3", "fig2", "fig8", "fig9"}, 2, {}});
  for (const formats::ComparisonTable* table : report.comparison_tables())
    for (const formats::Comparison& c : table->comparisons) {
      CAPTURE(table->id, c.cell(), c.printed, c.computed_text());
      CHECK(to_text(c.verdict) == to_text(c.recorded));
      // Tables 1 and 2 agree in every printed digit, rounded to nearest.
      if (table->id == "table1" || table->id == "table2")
        CHECK(to_fixed(*std::get<Enclosure>(c.computed).lower, 3, Rounding::nearest) == c.printed);
    }
  CHECK(report.as_recorded());
}

TEST_CASE("the story of Conjecture 7 comes with its numbers", "[long]") {
  const Report report = make_report("dyn-2015", {{"conjecture7"}, 2, {}});
  REQUIRE(report.sections.size() == 1);
  const formats::Section& section = report.sections.front();
  CHECK(section.paragraphs.size() == 5);
  REQUIRE(section.tables.size() == 1);
  CHECK(section.tables.front().rows.size() == 3);
  CHECK(section.tables.front().rows.front().at(1).substr(0, 22) == "0.40443676798398528146");
  REQUIRE(section.figures.size() == 1);
  CHECK(section.figures.front().panels.size() == 4);
}

TEST_CASE("a changed verdict is noticed") {
  Report report = make_report("dyn-2015", {{"supports"}, 1, {}});
  REQUIRE(report.as_recorded());
  report.sections.front().comparisons.front().comparisons.front().verdict = ValueVerdict::open;
  CHECK_FALSE(report.as_recorded());
}

TEST_CASE("unknown papers and items are refused") {
  CHECK_FAILS(make_report("nobody-1900", {}), domain);
  CHECK_FAILS(make_report("dyn-2015", {{"table9"}, 1, {}}), domain);
}

TEST_CASE("a report is written whole, in every format") {
  const Folder folder;
  const Report report = make_report("dyn-2015", {{"masks", "table1", "levels"}, 2, {}});
  write_reports({{report}}, folder.path, 2);
  const fs::path inside = folder.path / "dyn-2015";
  for (const char* name : {"masks", "table1", "levels"})
    for (const char* ending : {".csv", ".json", ".tex"}) {
      CAPTURE(name, ending);
      CHECK(fs::file_size(inside / (std::string(name) + ending)) > 100);
    }
  CHECK(content(inside / "levels-plot.svg").find("</svg>") != std::string::npos);
  CHECK(content(inside / "levels-plot.png").substr(1, 3) == "PNG");
  const std::string page = content(folder.path / "dyn-2015.html");
  CHECK(page.find("1.649") != std::string::npos);
  CHECK(page.substr(page.size() - 8) == "</html>\n");
  const auto json = nlohmann::json::parse(content(inside / "table1.json"));
  CHECK(json.at("comparisons").size() == 9);
  CHECK(json.at("comparisons").at(0).at("computed").at("lower").is_string());
  CHECK(content(inside / "table1.tex").find("\\bottomrule") != std::string::npos);
  for (const auto& entry : fs::recursive_directory_iterator(folder.path))
    CHECK(entry.path().string().find(".part") == std::string::npos);
}

TEST_CASE("the first page says what it is, who made it and how to object, a paper's page begins with what holds") {
  const Folder folder;
  Findings findings{{make_report("dyn-2015", {{"table3", "supports"}, 2, {}})}};
  for (const char* id : {"dyn-2015/theorem-1", "dyn-2015/remark-9"})
    findings.statements.push_back(
        check_statements({statements::find_statements(id).front()}, statements::Tier::quick, 1, {}).front());
  findings.origin = {"1.2.3", "abc123", "subcert reproduce dyn-2015", "2026-01-02"};
  write_reports(findings, folder.path, 2);
  const std::string first = content(folder.path / "index.html"), paper = content(folder.path / "dyn-2015.html");
  for (const char* text :
       {"1.2.3", "abc123", "subcert reproduce dyn-2015", "2026-01-02", "How to object", "1 of 2 statements hold"}) {
    CAPTURE(text);
    CHECK(first.find(text) != std::string::npos);
  }
  CHECK(paper.find("What holds") < paper.find("What to correct"));
  CHECK(paper.find("What to correct") < paper.find("<h2 id=\"dyn-2015-variance\">"));
  // Products and evaluated formulas are compared and not counted.
  const auto json = nlohmann::json::parse(content(folder.path / "results.json"));
  CHECK(json.at("counts").at("value") == nlohmann::json{{"match", 13}, {"wrong", 9}});
  CHECK(json.at("counts").at("statement").at("causes") == 1);
  CHECK(json.at("results").size() == 44 + 20 + 2);
}

TEST_CASE("the experiments may come after the page of the rest, at their place, and what is drawn stays") {
  const Folder folder;
  ReportOptions options{{"supports", "levels", "fig19"}, 2, {}, 1, 20};
  const Report whole = make_report("dyn-2015", options);
  REQUIRE(whole.sections.size() == 3);
  options.experiments = false;
  Findings findings{{make_report("dyn-2015", options)}};
  Report& report = findings.reports.front();
  CHECK(report.experiments.empty());
  CHECK(report.experiments_at == 2);
  report.sections.push_back(report.sections.front());  // as what comes behind them
  report.sections.back().id = "behind";
  findings.complete = false;
  write_reports(findings, folder.path, 2);
  const auto is_told = [&] {
    return content(folder.path / "index.html").find("experiments are still being computed") != std::string::npos;
  };
  CHECK(is_told());
  const Written before = written(findings);
  CHECK(before.size() == 3);
  std::vector<fs::path> drawn;
  for (const auto& entry : fs::directory_iterator(folder.path / "dyn-2015"))
    if (entry.path().extension() == ".svg") drawn.push_back(entry.path());
  REQUIRE(!drawn.empty());
  for (const fs::path& picture : drawn) std::ofstream(picture) << "drawn";
  add_experiments(report, options);
  findings.complete = true;
  REQUIRE(report.sections.size() == 4);
  CHECK(report.sections[2].id == whole.sections[2].id);
  CHECK(report.sections[2].paragraphs == whole.sections[2].paragraphs);
  CHECK(report.sections[3].id == "behind");
  write_reports(findings, folder.path, 2, before);
  CHECK_FALSE(is_told());
  for (const fs::path& picture : drawn) CHECK(content(picture) == "drawn");
  CHECK(fs::exists(folder.path / "dyn-2015" / "fig19-claims.csv"));
}

TEST_CASE("a failed write leaves the old file and nothing else") {
  const Folder folder;
  runtime::write_file(folder.path / "a.txt", "old");
  CHECK_THROWS(runtime::write_file_with(folder.path / "a.txt", [](const fs::path& temporary) {
    std::ofstream(temporary) << "half";
    throw std::runtime_error("stop");
  }));
  CHECK(content(folder.path / "a.txt") == "old");
  CHECK(std::distance(fs::directory_iterator(folder.path), fs::directory_iterator()) == 1);
  CHECK_FAILS(runtime::write_file("/proc/no/such/place", "x"), missing_file);
}
