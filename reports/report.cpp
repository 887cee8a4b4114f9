#include "report.hpp"

#include "bivariate.hpp"
#include "daubechies.hpp"
#include "dyn_2015.hpp"
#include "families.hpp"
#include "formats/check_in_page.hpp"
#include "formats/html.hpp"
#include "joint_spectral_radii.hpp"
#include "least_squares_surfaces.hpp"
#include "paper_experiments.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/symbol/parallel.hpp>
#include <subcert/proofs-checks/certificates/checker_arguments.hpp>
#include <subcert/proofs-checks/papers/registry.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace subcert::reports {
namespace {

using Json = nlohmann::ordered_json;
using formats::html;

constexpr std::size_t longest_open_table = 12;  // rows; longer ones are folded on the page, claims never

Json computed_json(const formats::Computed& computed) {
  if (const auto* text = std::get_if<std::string>(&computed)) return {{"lower", *text}, {"upper", *text}};
  const Enclosure& enclosure = std::get<Enclosure>(computed);
  const int digits = enclosure.telling_digits(20);
  return {{"lower", enclosure.lower_text(digits)}, {"upper", enclosure.upper_text(digits)}};
}

Json comparison_json(const formats::ComparisonTable& table, const formats::Comparison& comparison) {
  Json json{{"paper", table.paper},
            {"table", table.id},
            {"cell", comparison.cell()},
            {"scheme", comparison.scheme},
            {"printed", comparison.printed},
            {"computed", computed_json(comparison.computed)},
            {"verdict", to_text(comparison.verdict)},
            {"recorded", to_text(comparison.recorded)},
            {"note", comparison.note}};
  if (!comparison.source.empty()) json.update({{"stable", comparison.stable}, {"source", comparison.source}});
  return json;
}

std::string escaped(const std::string& text, const std::string& special, const std::string& prefix) {
  std::string result;
  for (char c : text) {
    if (special.find(c) != std::string::npos) result += prefix;
    result += c;
  }
  return result;
}

std::string latex(const std::string& text) { return escaped(text, "_&%#$^", "\\"); }

std::string csv_field(const std::string& text) {
  std::string result = "\"";
  for (char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

std::string csv(const std::vector<std::vector<std::string>>& rows) {
  std::string result;
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) result += (i ? "," : "") + csv_field(row[i]);
    result += "\n";
  }
  return result;
}

std::string latex_table(const std::string& caption, const std::vector<std::vector<std::string>>& rows) {
  std::string result = "% needs \\usepackage{booktabs}\n\\begin{table}\n  \\centering\n  \\caption{" + latex(caption) +
                       "}\n  \\begin{tabular}{l" + std::string(rows.front().size() - 1, 'r') + "}\n    \\toprule\n";
  for (std::size_t r = 0; r < rows.size(); ++r) {
    result += "    ";
    for (std::size_t i = 0; i < rows[r].size(); ++i) result += (i ? " & " : "") + latex(rows[r][i]);
    result += r == 0 ? " \\\\\n    \\midrule\n" : " \\\\\n";
  }
  return result + "    \\bottomrule\n  \\end{tabular}\n\\end{table}\n";
}

std::vector<std::vector<std::string>> rows_of(const formats::ComparisonTable& table) {
  std::vector<std::vector<std::string>> rows{{"cell", "scheme", "printed", "computed", "verdict", "note"}};
  for (const formats::Comparison& c : table.comparisons)
    rows.push_back({c.cell(), c.scheme, c.printed, c.computed_text(), to_text(c.verdict), c.note});
  if (!table.is_gathered()) return rows;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].push_back(i == 0 ? "stable" : table.comparisons[i - 1].stable);
    rows[i].push_back(i == 0 ? "source" : table.comparisons[i - 1].source);
  }
  return rows;
}

std::vector<std::vector<std::string>> rows_of(const formats::PlainTable& table) {
  std::vector<std::vector<std::string>> rows{table.head};
  rows.insert(rows.end(), table.rows.begin(), table.rows.end());
  return rows;
}

Json table_json(const Report& report, const formats::PlainTable& table) {
  return {{"paper", report.paper}, {"table", table.id}, {"rows", rows_of(table)}};
}

template <class Value, class Get>
std::vector<std::string> distinct(const std::vector<Value>& values, Get get) {
  std::vector<std::string> result;
  for (const Value& value : values)
    if (std::find(result.begin(), result.end(), get(value)) == result.end()) result.push_back(get(value));
  return result;
}

std::string cell_html(const formats::Comparison& c) {
  return fmt::format(
      "<td class=\"{0}\" title=\"{1}\"><span class=printed>{2}</span><span class=computed>{3}</span>"
      "<span class=verdict>{0}</span></td>",
      to_text(c.verdict), html(c.scheme), html(c.printed), html(c.computed_text()));
}

std::string grid_html(const formats::ComparisonTable& table) {
  const auto columns = distinct(table.comparisons, [](const formats::Comparison& c) { return c.column; });
  std::string result = "<tr><th></th>";
  for (const std::string& column : columns) result += "<th>" + html(column) + "</th>";
  result += "</tr>\n";
  for (const std::string& row : distinct(table.comparisons, [](const formats::Comparison& c) { return c.row; })) {
    result += "<tr><th>" + html(row) + "</th>";
    for (const std::string& column : columns) {
      const auto found = std::ranges::find_if(
          table.comparisons, [&](const formats::Comparison& c) { return c.row == row && c.column == column; });
      result += found == table.comparisons.end() ? "<td></td>" : cell_html(*found);
    }
    result += "</tr>\n";
  }
  return result;
}

std::string list_html(const formats::ComparisonTable& table) {
  const bool gathered = table.is_gathered();
  std::string result = fmt::format(
      "<tr><th></th><th class=left>printed</th><th class=left>computed</th>{}<th>verdict</th>{}</tr>\n",
      gathered ? "<th>stable</th>" : "", gathered ? "<th class=text>source</th>" : "");
  for (const formats::Comparison& c : table.comparisons)
    result += fmt::format(
        "<tr><th title=\"{}\">{}</th><td class=wide>{}</td><td class=wide>{}</td>{}<td class=\"{}\"><span "
        "class=verdict>{}"
        "</span></td>{}</tr>\n",
        html(c.scheme), html(gathered ? c.cell() : c.column), html(c.printed), html(c.computed_text()),
        gathered ? "<td>" + c.stable + "</td>" : "", to_text(c.verdict), to_text(c.verdict),
        gathered ? "<td class=text>" + html(c.source) + "</td>" : "");
  return result;
}

std::string table_html(const formats::ComparisonTable& table) {
  std::string result = fmt::format(
      "<h3 id=\"{}-table-{}\">{}</h3>\n<p class=place>{}</p>\n<div class=scroll><table>\n{}</table></div>\n",
      table.paper, table.id, html(table.title), html(table.place), table.grid ? grid_html(table) : list_html(table));
  std::string notes;
  for (const formats::Comparison& c : table.comparisons)
    if (!c.note.empty())
      notes += fmt::format("<li><b>{}</b> (printed {}, computed {}): {}</li>\n", html(c.cell()), html(c.printed),
                           html(c.computed_text()), html(c.note));
  if (!notes.empty()) result += "<details><summary>Notes on single cells</summary><ul>\n" + notes + "</ul></details>\n";
  return result;
}

constexpr std::size_t widest_cell = 40;  // characters in a line

/// " class=text" for the columns with sentences.
std::vector<std::string> column_classes(const formats::PlainTable& table) {
  std::vector<std::string> result(table.head.size());
  for (const auto& row : table.rows)
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i == result.size()) result.emplace_back();
      if (row[i].size() > widest_cell) result[i] = " class=text";
    }
  return result;
}

std::string table_html(const std::string& paper, const formats::PlainTable& table) {
  const auto classes = column_classes(table);
  const bool folded = table.rows.size() > longest_open_table && table.row_classes.empty();
  const std::string id = fmt::format(" id=\"{}-table-{}\"", paper, table.id), title = html(table.title);
  std::string result = folded ? "<details" + id + "><summary>" + title + "</summary>\n"
                              : "<h3" + id + ">" + title + "</h3>\n";
  result += "<div class=scroll><table>\n<tr>";
  for (std::size_t i = 0; i < table.head.size(); ++i)
    result += fmt::format("<th{}>{}</th>", classes[i], html(table.head[i]));
  result += table.proofs.empty() ? "</tr>\n" : "<th class=text>proof</th></tr>\n";
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    result += table.row_classes.empty() ? "<tr>" : "<tr class=\"" + table.row_classes[r] + "\">";
    for (std::size_t i = 0; i < table.rows[r].size(); ++i)
      result += fmt::format("<{0}{1}>{2}</{0}>", i == 0 ? "th" : "td", classes[i], html(table.rows[r][i]));
    if (!table.proofs.empty()) result += "<td class=proof>" + formats::check_button(paper, table.proofs[r]) + "</td>";
    result += "</tr>\n";
  }
  return result + "</table></div>\n" + (folded ? "</details>\n" : "");
}

template <class Picture>
std::string figure_html(const std::string& paper, const Picture& figure, const std::string& ending) {
  return fmt::format(
      "<figure id=\"{0}-figure-{1}\"><img src=\"{0}/{1}{2}\" alt=\"{3}\"><figcaption><b>{3}.</b> {4}</figcaption>"
      "</figure>\n",
      paper, figure.id, ending, html(figure.title), html(figure.caption));
}

/// What the tables of a paper and its experiments found, a line each.
std::string summaries_html(const Report& report) {
  std::vector<formats::SummaryRow> tables, experiments;
  for (const formats::ComparisonTable* table : report.comparison_tables()) {
    const auto count = [&](Verdict verdict) { return static_cast<std::size_t>(table->count(verdict)); };
    tables.push_back(
        {report.paper + "-table-" + table->id,
         table->title,
         {table->comparisons.size(), count(Verdict::match), count(Verdict::mismatch), count(Verdict::open)}});
  }
  for (const auto& [experiment, options, result] : report.experiments)
    experiments.push_back({report.paper + "-" + experiment->id,
                           experiment->title,
                           {result.claims.size(), result.count(Verdict::confirmed),
                            result.count(Verdict::not_confirmed), result.count(Verdict::not_reproducible)}});
  return formats::summary_html({"table", "values", "match", "mismatch", "open"}, tables) +
         formats::summary_html({"experiment", "claims", "confirmed", "not confirmed", "not reproducible"}, experiments);
}

bool is_experiment(const Report& report, const formats::Section& section) {
  return std::ranges::any_of(report.experiments,
                             [&](const experiments::RanExperiment& ran) { return ran.experiment->id == section.id; });
}

std::string report_html(const Report& report) {
  std::string result = fmt::format("<h1 class=paper id=\"{}\">{}</h1>\n<nav>", report.paper, html(report.citation));
  for (const formats::Section& section : report.sections)
    if (!is_experiment(report, section))
      result += fmt::format("<a href=\"#{}-{}\">{}</a>", report.paper, section.id, html(section.heading));
  result += "</nav>\n" + summaries_html(report);
  for (const formats::Section& section : report.sections) {
    result += fmt::format("<h2 id=\"{}-{}\">{}</h2>\n", report.paper, section.id, html(section.heading));
    for (const std::string& paragraph : section.paragraphs) result += "<p>" + html(paragraph) + "</p>\n";
    for (const formats::ComparisonTable& table : section.comparisons) result += table_html(table);
    for (const formats::PlainTable& table : section.tables) result += table_html(report.paper, table);
    for (const formats::Figure& figure : section.figures) result += figure_html(report.paper, figure, ".svg");
    // Surfaces have many thousands of facets.
    for (const formats::SurfaceFigure& figure : section.surface_figures)
      result += figure_html(report.paper, figure, ".png");
  }
  return result;
}

std::string page(const std::vector<Report>& reports, bool with_errata) {
  std::string body =
      "<h1>Printed values, recomputed</h1>\n<p>Every number set beside a printed value was computed in exact rational "
      "arithmetic, or enclosed with outward rounding. In each cell the printed value stands first, ours below it, then "
      "the verdict: <b>match</b> where our enclosure is narrower than one unit of the last printed place and within "
      "one such unit of the printed value, <b>mismatch</b> where our result excludes that, <b>open</b> where it does "
      "not decide yet.</p>\n";
  if (std::any_of(reports.begin(), reports.end(), [](const Report& r) { return !r.experiments.empty(); }))
    body +=
        "<p>Experiments are another matter: they repeat what a paper shows once, over many samples of random noise, in "
        "double precision. Each sentence of the text has a statistic that decides it: <b>confirmed</b> or <b>not "
        "confirmed</b>, with numbers; <b>not-reproducible</b> where it rests on data that were not published.</p>\n";
  if (with_errata)
    body +=
        "<p><a href=\"errata.html\">Errata and confirmations</a>: every statement of the papers as a check, and what "
        "is wrong in them.</p>\n";
  if (reports.size() > 1) {
    body += "<ul>\n";
    for (const Report& report : reports)
      body += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", report.paper, html(report.citation));
    body += "</ul>\n";
  }
  for (const Report& report : reports) body += report_html(report);
  if (body.find("<button class=check") != std::string::npos) body += formats::check_scripts();
  return formats::html_page("subcert: printed values, recomputed", body);
}

/// What holds more than experiments.
struct SpecialReport {
  const std::vector<std::string>& (*items)();
  Report (*make)(const ReportOptions&);
};

const SpecialReport* special_report(const std::string& paper) {
  static const std::map<std::string, SpecialReport> all{
      {"dyn-2015", {dyn_2015_items, report_dyn_2015}},
      {"surfaces", {least_squares_surface_items, report_least_squares_surfaces}},
      {"bivariate", {bivariate_items, report_bivariate}},
      {"families", {family_items, report_families}},
      {"daubechies", {daubechies_items, report_daubechies}},
      {"jsr", {joint_spectral_radius_items, report_joint_spectral_radii}},
  };
  const auto found = all.find(paper);
  return found == all.end() ? nullptr : &found->second;
}

}  // namespace

std::vector<const formats::ComparisonTable*> Report::comparison_tables() const {
  std::vector<const formats::ComparisonTable*> result;
  for (const formats::Section& section : sections)
    for (const formats::ComparisonTable& table : section.comparisons) result.push_back(&table);
  return result;
}

bool Report::as_recorded() const {
  const auto tables = comparison_tables();
  return std::all_of(tables.begin(), tables.end(),
                     [](const formats::ComparisonTable* table) { return table->as_recorded(); }) &&
         std::all_of(experiments.begin(), experiments.end(),
                     [](const experiments::RanExperiment& e) { return e.result.as_recorded(); });
}

std::vector<std::string> default_papers() {
  std::vector<std::string> result = statements::paper_keys();
  result.push_back("surfaces");
  return result;
}

std::vector<std::string> reproducible_papers() {
  std::vector<std::string> result = default_papers();
  result.insert(result.end(), statements::collection_keys().begin(), statements::collection_keys().end());
  return result;
}

std::vector<std::string> report_items(const std::string& paper) {
  if (const SpecialReport* special = special_report(paper)) return special->items();
  const auto papers = reproducible_papers();
  if (std::find(papers.begin(), papers.end(), paper) != papers.end()) return experiment_ids(paper);
  fail(ErrorKind::domain, "unknown paper '{}'", paper);
}

Report make_report(const std::string& paper, const ReportOptions& options) {
  const auto items = report_items(paper);
  for (const std::string& item : options.only)
    require(std::find(items.begin(), items.end(), item) != items.end(), "unknown item '{}' of {}", item, paper);
  if (const SpecialReport* special = special_report(paper)) return special->make(options);
  Report report{paper, statements::citation(paper), {}};
  add_experiments(report, options);
  return report;
}

formats::RowProof row_proof(const std::string& name, const Certificate& certificate, const ReportOptions& options,
                            const std::string& matrices) {
  try {
    const Certificate accepted = options.verified(certificate, matrices);
    formats::RowProof proof{name, checker_arguments(accepted.text, name), {{name, accepted.text}}};
    if (!matrices.empty()) proof.files.emplace(name + ".matrices", matrices);
    return proof;
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::undecided) throw;
    return {};
  }
}

void write_reports(const std::vector<Report>& reports, const std::filesystem::path& folder, int jobs) {
  std::vector<std::function<void()>> pictures;
  for (const Report& report : reports) {
    const std::filesystem::path inside = folder / report.paper;
    for (const formats::ComparisonTable* table : report.comparison_tables()) {
      Json json{
          {"paper", report.paper}, {"citation", report.citation}, {"table", table->id}, {"comparisons", Json::array()}};
      for (const formats::Comparison& comparison : table->comparisons)
        json["comparisons"].push_back(comparison_json(*table, comparison));
      runtime::write_file(inside / (table->id + ".json"), json.dump(2) + "\n");
      runtime::write_file(inside / (table->id + ".csv"), csv(rows_of(*table)));
      auto rows = rows_of(*table);
      for (auto& row : rows) {  // the rest is too wide for a page
        row.erase(row.begin() + 5);
        row.erase(row.begin() + 1);
        if (const auto end = row.back().find(']'); table->is_gathered() && end != std::string::npos)
          row.back().resize(end + 1);
      }
      runtime::write_file(inside / (table->id + ".tex"), latex_table(table->title, rows));
    }
    for (const formats::Section& section : report.sections) {
      for (const formats::PlainTable& table : section.tables) {
        for (const formats::RowProof& proof : table.proofs) {
          if (proof.name.empty()) continue;
          for (const auto& [name, text] : proof.files) runtime::write_file(inside / name, text);
          runtime::write_file(inside / (proof.name + ".js"), formats::certificate_script(report.paper, proof));
        }
        const auto rows = rows_of(table);
        runtime::write_file(inside / (table.id + ".json"), table_json(report, table).dump(2) + "\n");
        runtime::write_file(inside / (table.id + ".csv"), csv(rows));
        runtime::write_file(inside / (table.id + ".tex"), latex_table(table.title, rows));
      }
      for (const formats::Figure& figure : section.figures)
        pictures.push_back([&figure, inside] { formats::draw(figure, inside); });
      for (const formats::SurfaceFigure& figure : section.surface_figures)
        pictures.push_back([&figure, inside] { formats::draw(figure, inside); });
    }
  }
  parallel_for_each(pictures.size(), jobs, [&](std::size_t i) { pictures[i](); });
  runtime::write_file(folder / "index.html", page(reports, std::filesystem::exists(folder / "errata.html")));
}

std::string reports_json(const std::vector<Report>& reports) {
  Json json{{"comparisons", Json::array()}, {"experiments", Json::array()}, {"tables", Json::array()}};
  for (const Report& report : reports) {
    for (const formats::ComparisonTable* table : report.comparison_tables())
      for (const formats::Comparison& comparison : table->comparisons)
        json["comparisons"].push_back(comparison_json(*table, comparison));
    for (const experiments::RanExperiment& ran : report.experiments)
      json["experiments"].push_back(Json::parse(experiments::experiment_json(ran)));
    for (const formats::Section& section : report.sections)
      for (const formats::PlainTable& table : section.tables) json["tables"].push_back(table_json(report, table));
  }
  return json.dump(2);
}

}  // namespace subcert::reports
