// subcert compare SCHEME SCHEME...: schemes side by side

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cli/checker.hpp>
#include <subcert/cli/command.hpp>
#include <subcert/cli/pages/plates.hpp>
#include <subcert/cli/paper_form.hpp>
#include <subcert/reports/facts/screen_lines.hpp>
#include <subcert/reports/gallery/gallery.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <algorithm>

namespace subcert::cli {
namespace {

constexpr double small_budget = 5;
constexpr std::size_t most_beside = 3;  // schemes in a table on the screen; more stand below
constexpr std::size_t most_lines = 3;   // of a cell

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

/// Where a line of the cell ends: behind a blank or a comma, or in the middle of a word.
std::size_t line_end(const std::string& text, std::size_t width) {
  if (text.size() <= width) return text.size();
  if (const std::size_t blank = text.rfind(' ', width); blank != std::string::npos && blank > 0) return blank;
  const std::size_t comma = text.rfind(',', width - 1);
  return comma == std::string::npos ? width : comma + 1;
}

/// The cell in lines of a width; where they do not suffice, the last one ends in dots.
std::vector<std::string> cell_lines(std::string text, std::size_t width) {
  std::vector<std::string> lines;
  do {
    const std::size_t end = line_end(text, width);
    lines.push_back(text.substr(0, end));
    text.erase(0, std::min(text.find_first_not_of(' ', end), text.size()));
  } while (!text.empty() && lines.size() < most_lines);
  if (!text.empty()) lines.back() = lines.back().substr(0, width - 3) + "...";
  return lines;
}

/// A row in lines, cells from their columns on.
std::string row_text(const std::vector<std::string>& row, std::size_t label_width, std::size_t width) {
  std::vector<std::vector<std::string>> cells{{row.front()}};
  std::size_t height = 1;
  for (std::size_t i = 1; i < row.size(); ++i) {
    cells.push_back(cell_lines(row[i], width));
    height = std::max(height, cells.back().size());
  }
  std::string text;
  for (std::size_t k = 0; k < height; ++k) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i)
      line += padded(k < cells[i].size() ? cells[i][k] : "", (i == 0 ? label_width : width) + 2);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

/// As wide as the screen: tables of equally many schemes, one below the other.
std::string table_text(const formats::TableRows& rows) {
  std::size_t label_width = 0;
  for (const auto& row : rows) label_width = std::max(label_width, row.front().size());
  const std::size_t schemes = rows.front().size() - 1, tables = (schemes + most_beside - 1) / most_beside;
  const std::size_t beside = (schemes + tables - 1) / tables;
  const std::size_t width = (facts::screen_width - label_width) / beside - 2;
  std::string text;
  for (std::size_t first = 1; first <= schemes; first += beside) {
    if (first > 1) text += "\n";
    for (const auto& row : rows) {
      std::vector<std::string> part{row.front()};
      for (std::size_t i = first; i < std::min(first + beside, schemes + 1); ++i) part.push_back(row[i]);
      text += row_text(part, label_width, width);
    }
  }
  return text;
}

ExitCode run(const CompareOptions& options) {
  require_one_form(options, options.form);
  if (options.schemes.size() < 2)
    fail(ErrorKind::usage, "compare: needs two schemes or more, got '{}'", options.schemes.front());
  std::vector<reports::GalleryScheme> schemes;
  for (const std::string& scheme : options.schemes) {
    static_cast<void>(make_refinable_scheme(scheme));  // errors before work
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
    options.answer(plates_json(plates), table_text(rows));
  return exit_code(schemes, plates);
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
