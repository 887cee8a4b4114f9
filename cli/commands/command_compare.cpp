// subcert compare SCHEME SCHEME...: schemes side by side

#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/cli/checker.hpp>
#include <subcert/cli/command.hpp>
#include <subcert/cli/pages/plates.hpp>
#include <subcert/cli/pages/plot.hpp>
#include <subcert/cli/paper_form.hpp>
#include <subcert/reports/facts/screen_lines.hpp>
#include <subcert/reports/gallery/gallery.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

namespace subcert::cli {
namespace {

constexpr double small_budget = 5;
constexpr std::size_t most_beside = 3;  // schemes in a table on the screen; more stand below
constexpr std::size_t most_lines = 3;   // of a cell

struct CompareOptions : SearchOptions {
  std::vector<std::string> schemes;
  std::string html, plot;
  std::vector<std::string> rows;  ///< labels of facts, or what JSON calls them; none: all
  PaperForm form;
};

/// What fits the width of a paper's text: the label, its name there, and what ends the cell.
struct PaperColumn {
  std::string_view label, name;
  char end;
};
constexpr PaperColumn paper_columns[] = {{"sum rules", "sum rules", ';'},
                                         {"Hoelder exponent", "Hoelder", '\n'},
                                         {"Sobolev exponent", "Sobolev", '\n'},
                                         {"continuous derivatives", "derivatives", '\n'},
                                         {"stable shifts", "stable", '\n'}};
constexpr int paper_digits = 6;

std::string cell_of(const Facts& known, const std::string& label, char end) {
  const Fact* fact = find(known, label);
  return fact ? fact->text.substr(0, std::min(fact->text.find('\n'), fact->text.find(end))) : "-";
}

/// The labels of all facts that people read, or of those that are asked for. Errors: throws a usage error for others.
std::vector<std::string> shown_labels(const std::vector<Facts>& known, const std::vector<std::string>& wanted) {
  std::vector<std::string> all = labels(known);
  if (wanted.empty()) return all;
  std::vector<std::string> shown;
  for (const std::string& word : wanted) {
    std::string label = std::ranges::find(all, word) == all.end() ? "" : word;
    for (const Facts& list : known)
      for (const Fact& fact : list)
        if (label.empty() && fact.key == word) label = fact.label;
    if (label.empty())
      fail(ErrorKind::usage, "--rows: no scheme has the row {}{}; the rows are {}", in_quotes(word),
           did_you_mean(word, all), fmt::join(all, ", "));
    shown.push_back(label);
  }
  return shown;
}

/// A row a fact, a column a scheme.
formats::TableRows table_rows(const std::vector<reports::Plate>& plates, const std::vector<std::string>& wanted) {
  std::vector<Facts> known;
  for (const reports::Plate& plate : plates) known.push_back(reports::plate_facts(plate));
  std::vector<std::vector<std::string>> rows{{"scheme"}};
  for (const reports::Plate& plate : plates) rows.front().push_back(plate.specification());
  for (const std::string& label : shown_labels(known, wanted)) {
    rows.push_back({label});
    for (const Facts& list : known) rows.back().push_back(cell_of(list, label, '\n'));
  }
  return rows;
}

/// A row a scheme: what is asked for, or what fits the width of a paper's text.
TableAnswer paper_table(const std::vector<reports::Plate>& plates, const std::vector<std::string>& wanted) {
  std::vector<Facts> known;
  for (const reports::Plate& plate : plates) known.push_back(reports::plate_facts(plate, paper_digits));
  std::vector<PaperColumn> columns(std::begin(paper_columns), std::end(paper_columns));
  const std::vector<std::string> shown = wanted.empty() ? wanted : shown_labels(known, wanted);
  if (!wanted.empty()) columns.clear();
  for (const std::string& label : shown) columns.push_back({label, label, '\n'});
  TableAnswer table{"", {{"scheme"}}};
  for (const PaperColumn& column : columns) {
    if (column.label == "symbol") table.formulas.push_back(table.rows.front().size());
    table.rows.front().emplace_back(column.name);
  }
  for (std::size_t i = 0; i < plates.size(); ++i) {
    table.rows.push_back({plates[i].specification()});
    for (const PaperColumn& column : columns)
      table.rows.back().push_back(cell_of(known[i], std::string(column.label), column.end));
  }
  return table;
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

/// Their functions over each other.
void draw(const std::vector<reports::Plate>& plates, const std::string& plot) {
  formats::Figure figure{"compare", "", "", 2, {}};
  for (const reports::PlatePicture& picture : reports::overlaid(plates)) {
    figure.panels.push_back(picture.panel);
    figure.panels.back().plain_texts = true;
    figure.panels.back().key = "below";
  }
  if (figure.panels.empty())
    fail(ErrorKind::undecided, "--plot {}: no two of the schemes have functions of one variable that are drawn", plot);
  formats::draw_file(figure, plot);
}

ExitCode run(const CompareOptions& options) {
  require_one_form(options, options.form);
  require_picture_name(options.plot);
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
  if (!options.plot.empty()) draw(plates, options.plot);
  if (options.form.latex)
    answer(options, options.form, paper_table(plates, options.rows));
  else if (options.form.markdown)
    answer(options, options.form, TableAnswer{"", table_rows(plates, options.rows)});
  else
    options.answer(plates_json(plates), table_text(table_rows(plates, options.rows)));
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
  command.option(
      "--plot", options->plot,
      "Draw limits, continuous derivatives and variance curves over each other, as .svg, .png, .pdf, .tex or "
      ".html");
  command
      .option(
          "--rows", options->rows,
          "Which rows, or columns of --latex, separated by commas: what stands before them, or what --json calls it")
      .separated_by_commas()
      .one_each();
  add_limits(command, *options);
  add_paper_form(command, options->form, "In LaTeX, a line a scheme: what fits the width of a text, or --rows",
                 "The table in Markdown");
}

}  // namespace subcert::cli
