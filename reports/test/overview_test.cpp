#include <subcert/cmake/catch.hpp>
#include <subcert/reports/computed_quantities.hpp>
#include <subcert/reports/pages.hpp>
#include <subcert/reports/results.hpp>

#include <algorithm>
#include <sstream>

using namespace subcert;
using namespace subcert::reports;

namespace {

formats::Comparison comparison(ValueVerdict verdict, ValueVerdict recorded) {
  return {"max psi", "n=2", "primal:n=2", "0.5", Enclosure::exactly(Rational(1, 3)), verdict, recorded, ""};
}

Findings findings_with(std::size_t mismatches, std::size_t surprises) {
  Findings findings;
  for (int paper = 0; paper < 4; ++paper) {
    const std::string key = "a-201" + std::to_string(paper);
    Report report{key, "A. Author, B. Author: On " + std::string(90, 'x') + " y. Journal 1 (2015), 1-2.", {}};
    formats::Section section{"table1", "Table 1", {}};
    section.finding = "A sentence of " + std::string(120, '-') + " and then more than fits into a line of a terminal.";
    section.comparisons.push_back({key, "table1", "A table", "Table 1", true, {}});
    auto& cells = section.comparisons.back().comparisons;
    cells.push_back(comparison(ValueVerdict::match, ValueVerdict::match));
    cells.insert(cells.end(), mismatches, comparison(ValueVerdict::mismatch, ValueVerdict::mismatch));
    cells.insert(cells.end(), paper == 0 ? surprises : 0, comparison(ValueVerdict::mismatch, ValueVerdict::match));
    report.sections.push_back(section);
    findings.reports.push_back(report);
  }
  return findings;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

bool mentions(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("the first screen is short and in plain text") {
  const Findings findings = findings_with(20, 0);
  const std::string screen = first_screen(findings, {false, "out", 75.4});
  const auto lines = lines_of(screen);
  CHECK(lines.size() <= 45);
  for (const std::string& line : lines) {
    CAPTURE(line);
    const bool one_word = line.find_first_of(' ', line.find_first_not_of(" -")) == std::string::npos;
    CHECK((line.size() <= 100 || one_word));
  }
  CHECK_FALSE(mentions(screen, "\033"));
  CHECK(mentions(screen, "1 of 21 printed values match"));
  CHECK(mentions(screen, "out/index.html"));
  CHECK(mentions(screen, "All verdicts are as recorded, in 1 min 15 s."));
  CHECK_FALSE(mentions(screen, "printed 0.5"));
  CHECK(mentions(first_screen(findings, {true, "out", 1}), "\033[1m"));
  CHECK_FALSE(mentions(first_screen(findings, {false, "", 1}), "The page "));
  CHECK(mentions(first_screen(findings, {false, "", 1}), "The pages, with each value: --out FOLDER\n"));
}

TEST_CASE("the first screen shows what is open and what cannot be checked") {
  Findings findings = findings_with(2, 0);
  auto& cells = findings.reports.front().sections.front().comparisons.front().comparisons;
  cells.push_back(comparison(ValueVerdict::open, ValueVerdict::open));
  CHECK(mentions(first_screen(findings, {}), "1 of 4 printed values match; 2 wrong, 1 open"));
  cells.insert(cells.end(), 2, comparison(ValueVerdict::not_reproducible, ValueVerdict::not_reproducible));
  CHECK(mentions(first_screen(findings, {}),
                 "1 of 4 printed values match; 2 wrong, 1 open; beside them 2 rest on data that were not published"));
  cells.erase(cells.begin(), cells.end() - 2);
  CHECK(mentions(first_screen(findings, {}), "2 printed values: 2 rest on data that were not published"));
}

TEST_CASE("verdicts that are not the recorded ones stand on the first screen") {
  const Findings findings = findings_with(1, 13);
  CHECK_FALSE(findings.as_recorded());
  const std::string screen = first_screen(findings, {false, "out", 1});
  const auto lines = lines_of(screen);
  CHECK(std::ranges::count_if(lines, [](const std::string& l) { return mentions(l, "[recorded: match]"); }) == 10);
  CHECK(mentions(screen, "and 3 more"));
  CHECK(mentions(screen, "NOT AS RECORDED"));
  CHECK(mentions(full_list(findings), "NOT AS RECORDED"));
}

TEST_CASE("the full list names whatever does not match") {
  const auto lines = lines_of(full_list(findings_with(3, 0)));
  CHECK(std::ranges::count_if(lines,
                              [](const std::string& l) { return mentions(l, "printed 0.5, computed 0.3333"); }) == 12);
  for (const std::string& line : lines_of(full_list(findings_with(3, 0), 100)))
    CHECK((line.size() <= 100 || mentions(line, std::string(90, 'x'))));
}

TEST_CASE("what follows from other values is counted alone, unless it is not as recorded") {
  Findings findings = findings_with(1, 0);
  auto& cells = findings.reports.front().sections.front().comparisons.front().comparisons;
  formats::Comparison multiple = comparison(ValueVerdict::mismatch, ValueVerdict::mismatch);
  multiple.column = "n max psi";
  multiple.derived = "a multiple";
  cells.push_back(multiple);
  CHECK_FALSE(mentions(full_list(findings), "n max psi"));
  CHECK(mentions(full_list(findings), "\nand 1 that follow from others of the table, as their multiples\n"));
  cells.back().recorded = ValueVerdict::match;
  CHECK(mentions(full_list(findings), "n max psi"));
}

TEST_CASE("only an open value of a collection may turn out to match") {
  statements::PublishedCell cell;
  const auto recorded = [&](ValueVerdict on_record, ValueVerdict found) {
    cell.recorded = on_record;
    return recorded_verdict(cell, found);
  };
  for (const char* source : {"", "GP16"}) {
    cell.source = source;
    for (const ValueVerdict on_record : {ValueVerdict::match, ValueVerdict::mismatch, ValueVerdict::open})
      for (const ValueVerdict found :
           {ValueVerdict::match, ValueVerdict::mismatch, ValueVerdict::open, ValueVerdict::not_reproducible}) {
        const bool may_match = cell.source == "GP16" && on_record == ValueVerdict::open && found == ValueVerdict::match;
        CHECK(recorded(on_record, found) == (may_match ? ValueVerdict::match : on_record));
      }
  }
}
