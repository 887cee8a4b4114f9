#include "facts/screen_lines.hpp"
#include "pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace subcert::reports {
namespace {

constexpr std::size_t most_alarms = 10;

std::string coloured(const std::string& text, const char* code, bool colours) {
  return colours ? fmt::format("\033[{}m{}\033[0m", code, text) : text;
}

/// The text in lines of the screen's width, behind `before`.
std::string wrapped(const std::string& text, const std::string& before) {
  return facts::wrapped(before + text, before.size()) + "\n";
}

/// `Authors: Title` of a citation that goes on with the journal.
std::string short_citation(const std::string& citation) {
  const std::size_t title = citation.find(": ");
  const std::size_t end = citation.find(". ", title == std::string::npos ? 0 : title);
  return citation.substr(0, end);
}

/// Two verdicts where they differ, for instance `mismatch [recorded: match]`.
std::string verdict_text(const std::string& found, const std::string& recorded, bool as_recorded) {
  return found + (as_recorded ? "" : " [recorded: " + recorded + "]");
}

std::string line_of(const Result& result) {
  const std::string verdict = result.verdict + (result.grade.empty() ? "" : ", " + result.grade);
  std::string text = verdict_text(verdict, result.recorded, result.as_recorded) + "  ";
  switch (result.kind) {
    case ResultKind::value:
      text += fmt::format("{} {}: {}: printed {}, computed {}", result.paper, result.item, result.subject,
                          result.printed, result.computed);
      break;
    case ResultKind::claim: return text + fmt::format("{}: {} ({})", result.item, result.subject, result.computed);
    case ResultKind::statement: text += fmt::format("{} ({}): {}", result.key, result.item, result.subject);
  }
  return text + (result.note.empty() ? "" : " (" + result.note + ")");
}

/// What is not as recorded.
std::vector<std::string> alarms_of(const std::vector<Result>& all) {
  std::vector<std::string> lines;
  for (const Result& result : all)
    if (!result.as_recorded) lines.push_back(line_of(result));
  return lines;
}

/// Everything that is not right, or not as recorded; what follows from other values is counted alone.
std::string deviations_text(const std::vector<Result>& all, std::size_t width) {
  std::string text;
  int derived = 0;
  for (const Result& result : all) {
    if (result.as_recorded && result.standing != Standing::wrong) continue;
    if (result.as_recorded && !result.derived.empty())
      ++derived;
    else
      text += facts::wrapped(line_of(result), 10, width) + "\n";
  }
  if (derived > 0) text += fmt::format("and {} that follow from others of the table, as their multiples\n", derived);
  return text;
}

std::string paper_lines(const std::vector<Result>& all, const Report& report, bool colours) {
  std::string lines = coloured(wrapped(short_citation(report.citation), "  "), "1", colours);
  for (const ResultKind kind : {ResultKind::statement, ResultKind::value, ResultKind::claim})
    if (const std::string text = counts(all, kind, report.paper).text(); !text.empty()) lines += wrapped(text, "    ");
  return lines;
}

std::string table_line(const formats::ComparisonTable& table) {
  const std::string text = counts(results(table), ResultKind::value).text();
  return fmt::format("  {:<9} {}{}\n", table.id, text.empty() ? "no printed values of its own" : text,
                     table.as_recorded() ? "" : "   NOT AS RECORDED");
}

/// The rows in columns, left aligned.
std::string columns_text(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) line += fmt::format("  {:<{}}", row[i], widths[i]);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text + "\n";
}

/// Every table of the report, whole.
std::string tables_text(const Report& report) {
  std::string text;
  for (const formats::Section& section : report.sections) {
    for (const formats::ComparisonTable& table : section.comparisons) {
      std::vector<std::vector<std::string>> rows{{"scheme", "", "published", "proved", "stable", "verdict", "source"}};
      for (const formats::Comparison& c : table.comparisons)
        rows.push_back({c.row, c.column, c.printed, c.computed_text(), c.stable,
                        verdict_text(to_text(c.verdict), to_text(c.recorded), c.verdict == c.recorded),
                        c.source_key()});
      text += columns_text(rows);
    }
    for (const formats::PlainTable& table : section.tables) {
      std::vector<std::vector<std::string>> rows{table.head};
      rows.insert(rows.end(), table.rows.begin(), table.rows.end());
      text += table.title + "\n\n" + columns_text(rows);
    }
  }
  return text;
}

std::string experiment_line(const experiments::RanExperiment& ran) {
  const std::string text = counts(results(ran), ResultKind::claim).text();
  return fmt::format("  {:<9} {}{}\n", ran.experiment->id, text.empty() ? "pictures" : text,
                     ran.result.as_recorded() ? "" : "   NOT AS RECORDED");
}

}  // namespace

std::string first_screen(const Findings& findings, const ScreenOptions& options) {
  std::string text = "What the papers print, recomputed\n\n";
  const std::vector<Result> all = results(findings);
  for (const Report& report : findings.reports) text += paper_lines(all, report, options.colours);
  std::string points;
  for (const Report& report : findings.reports)
    for (const formats::Section& section : report.sections)
      if (!section.finding.empty()) points += wrapped(section.finding, "  - ");
  if (const std::string errata = errata_sentence(counts(all, ResultKind::statement)); !errata.empty())
    points += wrapped(errata, "  - ");
  if (!points.empty()) text += "\n" + coloured("What matters", "1", options.colours) + "\n" + points;
  const auto alarms = alarms_of(all);
  text += "\n";
  for (std::size_t i = 0; i < std::min(alarms.size(), most_alarms); ++i)
    text += coloured(wrapped(alarms[i], "  ! "), "31", options.colours);
  if (alarms.size() > most_alarms) text += fmt::format("  ! and {} more\n", alarms.size() - most_alarms);
  if (options.folder.empty()) {
    text += "The pages, with each value: --out FOLDER\n";
  } else {
    text += fmt::format("The page        {}/index.html\n", options.folder);
    if (!findings.statements.empty()) text += fmt::format("Errata          {}/errata.html\n", options.folder);
    text += fmt::format("The full list   {}/summary.txt\n", options.folder);
  }
  const long seconds = std::lround(options.seconds);
  const std::string duration = seconds < 60 ? fmt::format("{} s", seconds)
                                            : fmt::format("{} min {} s", seconds / 60, seconds % 60);
  return text +
         (alarms.empty() ? coloured("All verdicts are as recorded", "32", options.colours)
                         : coloured("NOT AS RECORDED", "31", options.colours)) +
         ", in " + duration + ".\n";
}

std::string full_list(const Findings& findings, std::size_t width) {
  std::string text;
  const std::vector<Result> all = results(findings);
  for (const Report& report : findings.reports) {
    text += facts::wrapped(report.citation, 0, width) + "\n\n";
    if (report.listed) text += tables_text(report);
    for (const formats::ComparisonTable* table : report.comparison_tables()) text += table_line(*table);
    for (const experiments::RanExperiment& ran : report.experiments) text += experiment_line(ran);
    if (const std::string held = counts(all, ResultKind::statement, report.paper).text(); !held.empty())
      text += "  " + held + "\n";
    text += "\n";
  }
  return text + deviations_text(all, width);
}

}  // namespace subcert::reports
