#include "pages.hpp"

#include "formats/html.hpp"
#include "formats/section.hpp"
#include "formats/surface_figure.hpp"
#include "formats/svg.hpp"

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace subcert::reports {
namespace {

using formats::html;
using Json = nlohmann::ordered_json;

constexpr std::size_t longest_open_table = 12;  // rows; longer ones are folded on the page, claims never
constexpr std::size_t widest_cell = 40;         // characters in a line

template <class Value, class Get>
std::vector<std::string> distinct(const std::vector<Value>& values, Get get) {
  std::vector<std::string> result;
  for (const Value& value : values)
    if (std::find(result.begin(), result.end(), get(value)) == result.end()) result.push_back(get(value));
  return result;
}

std::string cell_html(const formats::Comparison& c, const std::string& key) {
  return fmt::format(
      "<td id=\"{4}\" class=\"{0}\" title=\"{1}\"><span class=printed>{2}</span><span class=computed>{3}</span>"
      "<span class=verdict>{0}</span></td>",
      to_text(c.verdict), html(c.scheme), html(c.printed), html(c.computed_text()), key);
}

std::string grid_html(const formats::ComparisonTable& table, const std::vector<Result>& keyed) {
  const auto columns = distinct(table.comparisons, [](const formats::Comparison& c) { return c.column; });
  std::string result = "<tr><th></th>";
  for (const std::string& column : columns) result += "<th>" + html(column) + "</th>";
  result += "</tr>\n";
  for (const std::string& row : distinct(table.comparisons, [](const formats::Comparison& c) { return c.row; })) {
    result += "<tr><th>" + html(row) + "</th>";
    for (const std::string& column : columns) {
      const auto found = std::ranges::find_if(
          table.comparisons, [&](const formats::Comparison& c) { return c.row == row && c.column == column; });
      const auto index = static_cast<std::size_t>(found - table.comparisons.begin());
      result += found == table.comparisons.end() ? "<td></td>" : cell_html(*found, keyed[index].key);
    }
    result += "</tr>\n";
  }
  return result;
}

std::string list_html(const formats::ComparisonTable& table, const std::vector<Result>& keyed) {
  const bool gathered = table.is_gathered();
  std::string result = fmt::format(
      "<tr><th></th><th class=left>printed</th><th class=left>computed</th>{}<th>verdict</th>{}</tr>\n",
      gathered ? "<th>stable</th>" : "", gathered ? "<th class=text>source</th>" : "");
  for (std::size_t i = 0; i < keyed.size(); ++i) {
    const formats::Comparison& c = table.comparisons[i];
    result += fmt::format(
        "<tr id=\"{}\"><th title=\"{}\">{}</th><td class=wide>{}</td><td class=wide>{}</td>{}<td class=\"{}\"><span "
        "class=verdict>{}</span></td>{}</tr>\n",
        keyed[i].key, html(c.scheme), html(gathered ? c.cell() : c.column), html(c.printed), html(c.computed_text()),
        gathered ? "<td>" + c.stable + "</td>" : "", to_text(c.verdict), to_text(c.verdict),
        gathered ? "<td class=text>" + html(c.source) + "</td>" : "");
  }
  return result;
}

/// Links to the files of an item.
std::string files_html(const std::string& paper, const std::string& id, const std::vector<std::string>& endings) {
  std::vector<std::string> links;
  for (const std::string& ending : endings)
    links.push_back(fmt::format("<a href=\"{}/{}.{}\">{}</a>", paper, id, ending, ending));
  return fmt::format("<span class=files>{}</span>", fmt::join(links, " "));
}

const std::vector<std::string> table_files{"csv", "tex", "json"};

std::string table_html(const formats::ComparisonTable& table) {
  const std::vector<Result> keyed = results(table);
  std::string text = fmt::format(
      "<h3 id=\"{0}-table-{1}\">{2}</h3>\n<p class=place>{3} {4}</p>\n<div class=scroll tabindex=0 role=region "
      "aria-label=\"{2}\"><table>\n{5}</table></div>\n",
      table.paper, table.id, html(table.title), html(table.place), files_html(table.paper, table.id, table_files),
      table.grid ? grid_html(table, keyed) : list_html(table, keyed));
  std::string notes;
  for (const formats::Comparison& c : table.comparisons)
    if (!c.note.empty())
      notes += fmt::format("<li><b>{}</b> (printed {}, computed {}): {}</li>\n", html(c.cell()), html(c.printed),
                           html(c.computed_text()), html(c.note));
  if (!notes.empty()) text += "<details><summary>Notes on single cells</summary><ul>\n" + notes + "</ul></details>\n";
  return text;
}

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

std::string attribute(const char* name, const std::vector<std::string>& values, std::size_t row) {
  return row < values.size() && !values[row].empty() ? fmt::format(" {}=\"{}\"", name, html(values[row])) : "";
}

std::string table_html(const std::string& paper, const formats::PlainTable& table) {
  const auto classes = column_classes(table);
  const bool folded = table.rows.size() > longest_open_table && table.row_classes.empty();
  const std::string id = fmt::format(" id=\"{}-table-{}\"", paper, table.id), title = html(table.title),
                    files = files_html(paper, table.id, table_files);
  std::string result = folded
                           ? "<details" + id + "><summary>" + title + "</summary>\n<p class=place>" + files + "</p>\n"
                           : "<h3" + id + ">" + title + "</h3>\n<p class=place>" + files + "</p>\n";
  result += "<div class=scroll tabindex=0 role=region aria-label=\"" + title + "\"><table>\n<tr>";
  for (std::size_t i = 0; i < table.head.size(); ++i)
    result += fmt::format("<th{}>{}</th>", classes[i], html(table.head[i]));
  result += table.proofs.empty() ? "</tr>\n" : "<th class=text>proof</th></tr>\n";
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    result += "<tr" + attribute("id", table.row_ids, r) + attribute("class", table.row_classes, r) + ">";
    for (std::size_t i = 0; i < table.rows[r].size(); ++i)
      result += fmt::format("<{0}{1}>{2}</{0}>", i == 0 ? "th" : "td", classes[i], html(table.rows[r][i]));
    if (!table.proofs.empty()) result += "<td class=proof>" + formats::check_button(paper, table.proofs[r]) + "</td>";
    result += "</tr>\n";
  }
  return result + "</table></div>\n" + (folded ? "</details>\n" : "");
}

template <class Picture>
std::string caption_html(const std::string& paper, const Picture& figure, const std::vector<std::string>& endings) {
  return fmt::format("<figcaption><b>{}.</b> {} {}</figcaption>", html(figure.title), html(figure.caption),
                     files_html(paper, figure.id, endings));
}

std::string figure_html(const std::string& paper, const formats::Figure& figure) {
  return fmt::format("<figure id=\"{}-figure-{}\">{}{}</figure>\n", paper, figure.id, formats::panels_html(figure),
                     caption_html(paper, figure, {"svg", "png", "csv"}));
}

std::string figure_html(const std::string& paper, const formats::SurfaceFigure& figure) {
  return fmt::format("<figure id=\"{}-figure-{}\">{}{}</figure>\n", paper, figure.id,
                     formats::surface_views(figure, paper), caption_html(paper, figure, {"svg", "png"}));
}

/// What the tables of a paper and its experiments found, a line each.
std::string summaries_html(const Report& report) {
  std::vector<formats::SummaryRow> tables, experiments;
  for (const formats::ComparisonTable* table : report.comparison_tables()) {
    const auto count = [&](ValueVerdict verdict) { return static_cast<std::size_t>(table->count(verdict)); };
    tables.push_back({report.paper + "-table-" + table->id,
                      table->title,
                      {static_cast<std::size_t>(table->values()), count(ValueVerdict::match),
                       count(ValueVerdict::mismatch), count(ValueVerdict::open)}});
  }
  for (const auto& [experiment, options, result] : report.experiments)
    experiments.push_back({report.paper + "-" + experiment->id,
                           experiment->title,
                           {result.claims.size(), result.count(ClaimVerdict::holds), result.count(ClaimVerdict::weaker),
                            result.count(ClaimVerdict::contrary), result.count(ClaimVerdict::depends),
                            result.count(ClaimVerdict::own_data), result.count(ClaimVerdict::undecided)}});
  return formats::summary_html({"table", "values", "match", "mismatch", "open"}, tables) +
         formats::summary_html({"experiment", "claims", "hold as printed", "in a weaker reading", "contrary shown",
                                "depend on a choice", "on our data only", "undecided"},
                               experiments);
}

/// Whether the paper calls it a theorem or the like.
bool is_theorem(const Result& result) {
  return std::ranges::any_of(std::vector<std::string>{"Theorem", "Proposition", "Corollary", "Lemma", "Conjecture"},
                             [&](const std::string& word) { return result.item.starts_with(word); });
}

/// Of what is wrong, the remark tells how much.
std::string statement_item(const Result& result) {
  const bool with_remark = result.standing == Standing::wrong && !result.remark.empty();
  return fmt::format("<li><a href=\"{}\">{}</a>: {} <b>{}</b>{}</li>\n", html(result.link()), html(result.item),
                     html(result.subject), html(result.words), with_remark ? ": " + html(result.remark) : "");
}

/// First what holds, its theorems by name; then what to correct, each fault once, with how many others repeat it.
std::string statements_html(const std::vector<Result>& own) {
  std::string theorems, errata;
  int others = 0;
  for (const Result& one : own) {
    if (one.kind != ResultKind::statement) continue;
    if (one.standing == Standing::right && is_theorem(one)) theorems += statement_item(one);
    if (one.standing == Standing::right && !is_theorem(one)) ++others;
    if (one.standing == Standing::wrong && one.follows.empty()) errata += statement_item(one);
  }
  if (const auto more = std::ranges::count_if(
          own, [](const Result& one) { return one.standing == Standing::wrong && !one.follows.empty(); });
      more > 0)
    errata += fmt::format("<li>and {} that {} one of these</li>\n", more, more == 1 ? "repeats" : "repeat");
  std::string text;
  if (!theorems.empty() || others > 0)
    text += "<h2 id=holds>What holds</h2>\n" + (theorems.empty() ? "" : "<ul>\n" + theorems + "</ul>\n") +
            (others > 0 ? fmt::format("<p>{}{} formulas, masks and sentences hold, too.</p>\n",
                                      theorems.empty() ? "" : "And ", others)
                        : "");
  return text + (errata.empty() ? "" : "<h2 id=errata>What to correct</h2>\n<ul>\n" + errata + "</ul>\n");
}

bool is_experiment(const Report& report, const formats::Section& section) {
  return std::ranges::any_of(report.experiments,
                             [&](const experiments::RanExperiment& ran) { return ran.experiment->id == section.id; });
}

/// What the page tells of a result when a reader asks.
Json details(const Result& result) {
  Json json{{"verdict", result.verdict}, {"subject", result.subject}, {"command", result.command}};
  const auto add = [&](const char* name, const std::string& text) {
    if (!text.empty()) json[name] = text;
  };
  add("scheme", result.scheme);
  add("printed", result.printed);
  add("computed", result.computed);
  if (result.enclosure && !result.enclosure->is_exact()) {
    const int digits = result.enclosure->telling_digits(20);
    if (result.enclosure->lower) json["lower"] = result.enclosure->lower_text(digits);
    if (result.enclosure->upper) json["upper"] = result.enclosure->upper_text(digits);
  } else if (result.enclosure) {
    json["exact"] = to_text(*result.enclosure->lower);
  }
  add("note", result.note);
  add("derived", result.derived);
  if (!result.as_recorded) json["recorded"] = result.recorded;
  return json;
}

}  // namespace

std::string report_page(const Report& report, const std::vector<Result>& own) {
  std::string body = fmt::format("<p class=up><a href=\"index.html\">All papers</a></p>\n<h1 class=paper>{}</h1>\n",
                                 html(report.citation));
  body += score_bars(own, report.paper);
  body += "<nav aria-label=\"Parts of this page\">";
  for (const formats::Section& section : report.sections)
    if (!is_experiment(report, section))
      body += fmt::format("<a href=\"#{}-{}\">{}</a> ", report.paper, section.id, html(section.heading));
  if (counts(own, ResultKind::statement).all() > 0)
    body += fmt::format("<a href=\"errata.html#{}\">Statements and errata</a>", report.paper);
  body += "</nav>\n" + statements_html(own) + summaries_html(report);
  for (const formats::Section& section : report.sections) {
    body += fmt::format("<h2 id=\"{}-{}\">{}</h2>\n", report.paper, section.id, html(section.heading));
    for (const std::string& paragraph : section.paragraphs) body += "<p>" + html(paragraph) + "</p>\n";
    for (const formats::ComparisonTable& table : section.comparisons) body += table_html(table);
    for (const formats::PlainTable& table : section.tables) body += table_html(report.paper, table);
    for (const formats::Figure& figure : section.figures) body += figure_html(report.paper, figure);
    for (const formats::SurfaceFigure& figure : section.surface_figures) body += figure_html(report.paper, figure);
  }
  Json told = Json::object();
  for (const Result& result : own)
    if (result.kind != ResultKind::statement) told[result.key] = details(result);
  body += formats::data_script("details", told.dump());
  return formats::html_page("subcert: " + html(report.paper), body);
}

}  // namespace subcert::reports
