// subcert reproduce [PAPER...]: the main job

#include "command.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/reports/errata.hpp>
#include <subcert/reports/report.hpp>
#include <subcert/reports/runtime/files.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <mutex>
#include <sstream>

namespace subcert::cli {
namespace {

struct ReproduceOptions : CommonOptions {
  std::vector<std::string> papers;
  std::vector<std::string> only;
};

void require_known(const ReproduceOptions& options, const std::vector<std::string>& papers) {
  const auto known = reports::reproducible_papers();
  for (const std::string& paper : papers)
    if (std::find(known.begin(), known.end(), paper) == known.end())
      fail(ErrorKind::usage, "PAPER '{}' cannot be reproduced by this version; expected {}", paper,
           fmt::join(known, ", "));
  for (const std::string& item : options.only) {
    std::vector<std::string> items;
    for (const std::string& paper : papers) {
      const auto more = reports::report_items(paper);
      items.insert(items.end(), more.begin(), more.end());
    }
    if (std::find(items.begin(), items.end(), item) == items.end())
      fail(ErrorKind::usage, "--only: unknown item '{}'; expected {}", item, fmt::join(items, ", "));
  }
}

std::string counted(const std::string& before, int count, const std::string& after) {
  return count == 0 ? "" : before + std::to_string(count) + after;
}

std::string experiment_line(const experiments::RanExperiment& ran) {
  const std::string& id = ran.experiment->id;
  const auto count = [&](Verdict finding) { return static_cast<int>(ran.result.count(finding)); };
  std::string findings = counted(", ", count(Verdict::confirmed), " confirmed") +
                         counted(", ", count(Verdict::not_confirmed), " not confirmed") +
                         counted(", ", count(Verdict::not_reproducible), " not reproducible");
  return "  " + id + std::string(id.size() < 10 ? 10 - id.size() : 1, ' ') +
         (findings.empty() ? "pictures" : "claims: " + findings.substr(2)) +
         (ran.result.as_recorded() ? "" : "   NOT AS RECORDED") + "\n";
}

/// The claims that are not confirmed, and those with another finding than the recorded one.
std::string unconfirmed(const experiments::RanExperiment& ran) {
  std::string result;
  for (const experiments::DecidedClaim& c : ran.result.claims)
    if (c.finding == Verdict::not_confirmed || c.finding != c.recorded)
      result += "  " + to_text(c.finding) + "  " + ran.experiment->id + ": " + c.sentence + " (" + c.numbers + ")" +
                (c.finding == c.recorded ? "" : " [recorded: " + to_text(c.recorded) + "]") + "\n";
  return result;
}

std::string summary(const std::vector<reports::Report>& reports) {
  std::ostringstream text;
  for (const reports::Report& report : reports) {
    text << report.citation << "\n\n";
    for (const formats::ComparisonTable* table : report.comparison_tables()) {
      text << "  " << table->id << std::string(table->id.size() < 10 ? 10 - table->id.size() : 1, ' ')
           << table->comparisons.size() << " values: " << table->count(Verdict::match) << " match, "
           << table->count(Verdict::mismatch) << " mismatch, " << table->count(Verdict::open) << " open"
           << counted(", ", table->count(Verdict::not_reproducible), " not reproducible")
           << (table->as_recorded() ? "" : "   NOT AS RECORDED") << "\n";
    }
    for (const experiments::RanExperiment& ran : report.experiments) text << experiment_line(ran);
    text << "\n";
    for (const formats::ComparisonTable* table : report.comparison_tables())
      for (const formats::Comparison& c : table->comparisons)
        if (c.verdict == Verdict::mismatch || c.verdict != c.recorded)
          text << "  " << to_text(c.verdict) << "  " << table->id << ": " << c.cell() << ": printed " << c.printed
               << ", computed " << c.computed_text() << (c.note.empty() ? "" : " (" + c.note + ")")
               << (c.verdict == c.recorded ? "" : " [recorded: " + to_text(c.recorded) + "]") << "\n";
    for (const experiments::RanExperiment& ran : report.experiments) text << unconfirmed(ran);
  }
  return text.str();
}

/// Checks all statements and writes errata.html beside the page; whether all verdicts are the recorded ones.
bool write_errata(const ReproduceOptions& options) {
  std::vector<const statements::Statement*> all;
  for (const statements::Statement& statement : statements::statements()) all.push_back(&statement);
  const auto checked = reports::check_statements(all, statements::Tier::quick, options.threads(),
                                                 [&](const std::string& id) { options.progress(id); });
  runtime::write_file(std::filesystem::path(options.out) / "errata.html", reports::errata_page(checked));
  return std::all_of(checked.begin(), checked.end(),
                     [](const reports::CheckedStatement& one) { return one.as_recorded(); });
}

ExitCode run(ReproduceOptions& options) {
  const auto papers = options.papers.empty() ? reports::reproducible_papers() : options.papers;
  require_known(options, papers);
  std::vector<reports::Report> reports;
  std::mutex terminal;
  reports::ReportOptions report_options{options.only, options.threads(),
                                        [&](const std::string& line) {
                                          const std::lock_guard lock(terminal);
                                          options.progress(line);
                                        },
                                        options.seed};
  for (const std::string& paper : papers) reports.push_back(reports::make_report(paper, report_options));
  bool statements_as_recorded = true;
  if (!options.out.empty()) {
    if (options.papers.empty() && options.only.empty()) statements_as_recorded = write_errata(options);
    options.progress("writing " + options.out);
    reports::write_reports(reports, options.out, options.threads());
  }
  options.end_progress();
  const bool as_recorded = std::all_of(reports.begin(), reports.end(),
                                       [](const reports::Report& r) { return r.as_recorded(); });
  if (options.json) {
    std::cout << reports::reports_json(reports) << "\n";
  } else {
    std::cout << summary(reports);
    if (!statements_as_recorded) std::cout << "\nStatements NOT AS RECORDED: see 'subcert statements check'\n";
    if (!options.out.empty()) std::cout << "\nThe page: " << options.out << "/index.html\n";
  }
  if (!std::cout.flush()) fail(ErrorKind::missing_file, "cannot write to standard output");
  return as_recorded && statements_as_recorded ? done : failed;
}

}  // namespace

void add_reproduce(Command& app) {
  auto options = std::make_shared<ReproduceOptions>();
  Command command = add_command(
      app, "reproduce", "Recomputes tables, figures and experiments of papers beside what they print",
      "subcert reproduce dyn-2015 --only table1,table2 --out out", options, [=] { return run(*options); });
  command.option("PAPER", options->papers,
                 fmt::format("Papers: {} (default: all)", fmt::join(reports::reproducible_papers(), ", ")));
  command.option("--only", options->only, "Items, separated by commas").separated_by_commas();
  command.existing("--out").describe("Folder for index.html, tables and figures");
}

}  // namespace subcert::cli
