// subcert compare SCHEME SCHEME...: schemes side by side

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cli/checker.hpp>
#include <subcert/cli/command.hpp>
#include <subcert/cli/pages/plates.hpp>
#include <subcert/cli/paper_form.hpp>
#include <subcert/reports/gallery.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <algorithm>

namespace subcert::cli {
namespace {

constexpr double small_budget = 5;
constexpr std::size_t widest_column = 48;

struct CompareOptions : SearchOptions {
  std::vector<std::string> schemes;
  std::string html;
  PaperForm form;
};

/// A row a fact, a column a scheme.
formats::TableRows table_rows(const std::vector<reports::Plate>& plates) {
  std::vector<Facts> known;
  for (const reports::Plate& plate : plates) known.push_back(reports::plate_facts(plate));
  std::vector<std::vector<std::string>> rows{{"scheme"}};
  for (const reports::Plate& plate : plates) rows.front().push_back(plate.specification());
  for (const std::string& label : labels(known)) {
    rows.push_back({label});
    for (const Facts& list : known) {
      const Fact* fact = find(list, label);
      rows.back().push_back(fact ? fact->text.substr(0, fact->text.find('\n')) : "-");
    }
  }
  return rows;
}

/// What is too wide ends in dots.
std::string table_text(formats::TableRows rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (row[i].size() > widest_column) row[i] = row[i].substr(0, widest_column - 3) + "...";
      widths[i] = std::max(widths[i], row[i].size());
    }
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) line += fmt::format("{:<{}}  ", row[i], widths[i]);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

ExitCode run(const CompareOptions& options) {
  require_one_form(options, options.form);
  if (options.schemes.size() < 2)
    fail(ErrorKind::usage, "compare: needs two schemes or more, got '{}'", options.schemes.front());
  std::vector<reports::GalleryScheme> schemes;
  for (const std::string& scheme : options.schemes) {
    static_cast<void>(make_linear_scheme(scheme));  // errors before work
    schemes.push_back({scheme});
  }
  reports::PlateOptions plate_options{options.budget, options.memory << 20};
  if (!options.html.empty()) plate_options.verified = verified;
  const std::vector<reports::Plate> plates = make_plates(schemes, plate_options, options);
  if (!options.html.empty()) runtime::write_file(options.html, reports::comparison_html(plates));
  formats::TableRows rows = table_rows(plates);
  if (options.form.asked_for())
    answer(options, options.form, TableAnswer{"", std::move(rows)});
  else
    options.answer(plates_json(plates), table_text(std::move(rows)));
  return exit_code(plates);
}

}  // namespace

void add_compare(Command& app) {
  auto options = std::make_shared<CompareOptions>();
  options->budget = small_budget;
  Command command = add_command(app, "compare", "Schemes side by side, and their functions in one picture",
                                "subcert compare primal:n=3 dual:n=3 four-point:w=1/16 --html page.html", options,
                                [=] { return run(*options); });
  command.option("SCHEME", options->schemes, "Scheme specifications, two or more").required();
  command.option("--html", options->html, "A page with pictures and certificates, all in one file");
  add_limits(command, *options);
  add_paper_form(command, options->form, "The table in LaTeX", "The table in Markdown");
}

}  // namespace subcert::cli
