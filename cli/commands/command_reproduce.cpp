// subcert reproduce [PAPER...]: the main job

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/cli/checker.hpp>
#include <subcert/cli/command.hpp>
#include <subcert/reports/facts/screen_lines.hpp>
#include <subcert/reports/formats/provenance.hpp>
#include <subcert/reports/pages.hpp>
#include <subcert/reports/report_files.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <fmt/ranges.h>

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <mutex>

namespace subcert::cli {
namespace {

struct ReproduceOptions : CommonOptions {
  std::vector<std::string> papers;
  std::vector<std::string> only;
  std::optional<double> budget;
  std::string baseline;
};

/// Of the items that were asked for those of this paper.
std::vector<std::string> items_of(const std::string& paper, const std::vector<std::string>& only) {
  const std::vector<std::string> known = reports::report_items(paper);
  std::vector<std::string> items;
  std::ranges::copy_if(only, std::back_inserter(items),
                       [&](const std::string& item) { return std::ranges::find(known, item) != known.end(); });
  return items;
}

void require_known(const ReproduceOptions& options, const std::vector<std::string>& papers) {
  const auto known = reports::reproducible_papers();
  for (const std::string& paper : papers)
    if (std::find(known.begin(), known.end(), paper) == known.end())
      fail(ErrorKind::usage, "PAPER: {}", expected_one_of(known, paper));
  for (const std::string& item : options.only) {
    std::vector<std::string> items;
    for (const std::string& paper : papers) {
      const auto more = reports::report_items(paper);
      items.insert(items.end(), more.begin(), more.end());
    }
    if (std::find(items.begin(), items.end(), item) == items.end())
      fail(ErrorKind::usage, "--only: {}", expected_one_of(items, item));
  }
}

using Progress = std::function<void(const std::string&)>;

/// Of collections there are none.
std::vector<statements::CheckedStatement> check_statements_of(const std::vector<std::string>& papers, int threads,
                                                              const Progress& progress) {
  std::vector<const statements::Statement*> chosen;
  for (const statements::Statement& statement : statements::statements())
    if (std::find(papers.begin(), papers.end(), statement.paper()) != papers.end()) chosen.push_back(&statement);
  return statements::check_statements(chosen, statements::Tier::quick, threads, progress);
}

/// Which program ran, what was asked for, and today's date.
reports::Origin origin(const ReproduceOptions& options) {
  std::string input = "subcert reproduce";
  for (const std::string& paper : options.papers) input += " " + paper;
  if (!options.only.empty()) input += fmt::format(" --only {}", fmt::join(options.only, ","));
  if (options.seed != ReproduceOptions().seed) input += fmt::format(" --seed {}", options.seed);
  const std::time_t now = std::time(nullptr);
  char when[16] = "";
  if (const std::tm* day = std::gmtime(&now)) std::strftime(when, sizeof when, "%Y-%m-%d", day);
  return {formats::version(), formats::commit(), input, when};
}

bool wants_colours() {
  const char* terminal = std::getenv("TERM");
  return isatty(STDOUT_FILENO) && !std::getenv("NO_COLOR") && terminal && std::string(terminal) != "dumb";
}

/// The papers, and for pages of whole papers their statements, too. The experiments come last: `exact` is told of all
/// the rest before they are begun, if there is anything of it.
reports::Findings findings_of(const std::vector<std::string>& papers, const ReproduceOptions& options,
                              const std::function<void(const reports::Findings&)>& exact) {
  std::mutex terminal;
  const Progress progress = [&](const std::string& line) {
    const std::lock_guard lock(terminal);
    options.progress(line);
  };
  reports::ReportOptions report_options{options.only, options.threads(), progress, options.seed};
  report_options.budget = options.budget;
  report_options.experiments = false;
  report_options.verified = [](const Certificate& certificate, const std::string& matrices) {
    return verified(certificate, matrices);
  };
  std::vector<std::pair<std::string, reports::ReportOptions>> asked;  // of the papers with items that are wanted
  for (const std::string& paper : papers) {
    report_options.only = items_of(paper, options.only);
    if (options.only.empty() || !report_options.only.empty()) asked.emplace_back(paper, report_options);
  }
  reports::Findings findings;
  findings.origin = origin(options);
  findings.reports.resize(asked.size());
  const bool with_statements = !options.out.empty() && options.only.empty();
  // Side by side, as each has parts that one thread does alone.
  parallel_tasks(asked.size() + (with_statements ? 1 : 0), options.threads(), [&](std::size_t i) {
    if (i < asked.size())
      findings.reports[i] = reports::make_report(asked[i].first, asked[i].second);
    else
      findings.statements = check_statements_of(papers, options.threads(), progress);
  });
  findings.complete = false;
  if (with_statements) exact(findings);
  parallel_tasks(asked.size(), options.threads(),
                 [&](std::size_t i) { reports::add_experiments(findings.reports[i], asked[i].second); });
  findings.complete = true;
  return findings;
}

void write_page(const reports::Findings& findings, const ReproduceOptions& options,
                const reports::Written& before = {}) {
  options.progress("writing " + options.out);
  reports::write_reports(findings, options.out, options.threads(), before);
  runtime::write_file(std::filesystem::path(options.out) / "summary.txt",
                      to_text(findings.origin) + reports::full_list(findings));
}

ExitCode run(ReproduceOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const auto papers = options.papers.empty() ? reports::default_papers() : options.papers;
  require_known(options, papers);
  std::optional<std::vector<reports::EarlierResult>> earlier;
  if (!options.baseline.empty()) {
    const std::string file = (std::filesystem::path(options.baseline) / "results.json").string();
    earlier = reports::read_results(read_file(file), file);
  }
  reports::Written written;
  const reports::Findings findings = findings_of(papers, options, [&](const reports::Findings& exact) {
    write_page(exact, options);
    written = reports::written(exact);
  });
  if (!options.out.empty()) write_page(findings, options, written);
  options.end_progress();
  const std::vector<reports::Result> all = reports::results(findings);
  std::optional<std::vector<reports::Change>> changed;
  if (earlier) changed = reports::changes(*earlier, all);
  if (options.json) {
    print_json(reports::reports_json(findings.reports, changed));
  } else {
    if (options.out.empty()) std::cout << reports::full_list(findings, facts::screen_width) << "\n";
    // Of wall clock, as it is the reader who waits.
    const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - start;
    std::cout << reports::first_screen(findings, {wants_colours(), options.out, duration.count()});
    if (changed) std::cout << reports::changes_text(*changed, all.size(), options.baseline);
  }
  const bool is_alarm = changed && std::ranges::any_of(*changed, &reports::Change::is_alarm);
  return findings.as_recorded() && !is_alarm ? done : failed;
}

}  // namespace

void add_reproduce(Command& app) {
  auto options = std::make_shared<ReproduceOptions>();
  Command command = add_command(
      app, "reproduce", "Recomputes tables, figures and experiments of papers beside what they print",
      "subcert reproduce dyn-2015 --only table1,table2 --out out", options, [=] { return run(*options); });
  command
      .option(
          "PAPER", options->papers,
          fmt::format("Papers and collections: {} (default: all but {})",
                      fmt::join(reports::reproducible_papers(), ", "), fmt::join(statements::collection_keys(), ", ")))
      .suggest([] {
        std::vector<Suggestion> words;
        for (const std::string& paper : reports::reproducible_papers()) words.push_back({paper, ""});
        return words;
      });
  command.option("--only", options->only, "Items, separated by commas").separated_by_commas();
  command
      .option("--budget", options->budget,
              "Seconds of processor time for the exponent of each surface (default: those of the page)")
      .within(0.001, 1e6);
  command.option("--baseline", options->baseline,
                 "Folder of an earlier run: says what changed, and fails where that matters");
  command.existing("--out").describe("Folder for index.html, tables and figures");
}

}  // namespace subcert::cli
