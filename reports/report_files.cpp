#include "report_files.hpp"

#include "documents.hpp"
#include "formats/paper_text.hpp"
#include "formats/section.hpp"
#include "formats/surface_figure.hpp"
#include "pages.hpp"

#include <subcert/analysis/symbol/support/parallel.hpp>
#include <subcert/schemes/data/formats/table.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace subcert::reports {
namespace {

using Json = nlohmann::ordered_json;

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
  if (!comparison.derived.empty()) json["derived"] = comparison.derived;
  if (!comparison.source.empty()) json.update({{"stable", comparison.stable}, {"source", comparison.source}});
  return json;
}

std::string csv(const std::vector<std::vector<std::string>>& rows) {
  std::string result;
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) result += (i ? "," : "") + data::quoted(row[i]);
    result += "\n";
  }
  return result;
}

std::string latex_table(const std::string& caption, formats::TableRows rows) {
  for (auto& row : rows)
    for (std::string& cell : row) cell = formats::latex_text(cell);
  return "% needs \\usepackage{booktabs}\n\\begin{table}\n\\centering\n\\caption{" + formats::latex_text(caption) +
         "}\n" + formats::latex_tabular(rows, "r") + "\\end{table}\n";
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

/// Of each kind all groups of counts(), and the causes of what is wrong.
Json counts_json(const std::vector<Result>& results) {
  Json json;
  for (const ResultKind kind : {ResultKind::value, ResultKind::statement, ResultKind::claim}) {
    const Counts found = counts(results, kind);
    Json& one = json[to_text(kind)] = Json::object();
    for (const auto& [name, standing, count] : found.groups) one[name] = count;
    if (found.causes > 0) one["causes"] = found.causes;
  }
  return json;
}

std::string results_json(const std::vector<Result>& results) {
  Json list = Json::array();
  for (const Result& result : results) {
    Json json{{"key", result.key},           {"kind", to_text(result.kind)}, {"paper", result.paper},
              {"item", result.item},         {"subject", result.subject},    {"printed", result.printed},
              {"computed", result.computed}, {"verdict", result.verdict},    {"note", result.note},
              {"command", result.command}};
    if (!result.grade.empty()) json["grade"] = result.grade;
    if (!result.derived.empty()) json["derived"] = result.derived;
    if (!result.follows.empty()) json["follows"] = result.follows;
    if (result.enclosure) json["enclosure"] = computed_json(*result.enclosure);
    list.push_back(std::move(json));
  }
  return Json{{"counts", counts_json(results)}, {"results", std::move(list)}}.dump(1) + "\n";
}

}  // namespace

Written written(const Findings& findings) {
  Written result;
  for (const Report& report : findings.reports)
    for (const formats::Section& section : report.sections) result.emplace(report.paper, section.id);
  return result;
}

void write_reports(const Findings& findings, const std::filesystem::path& folder, int jobs, const Written& before) {
  std::vector<std::function<void()>> pictures;
  const std::vector<Result> all = results(findings);
  for (const Report& report : findings.reports) {
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
      const bool drawn = before.contains({report.paper, section.id});
      for (const formats::Figure& figure : section.figures)
        if (!drawn) pictures.push_back([&figure, inside] { formats::draw(figure, inside); });
      for (const formats::SurfaceFigure& figure : section.surface_figures) {
        runtime::write_file(inside / (figure.id + ".surfaces.js"), formats::surface_script(figure, report.paper));
        if (!drawn) pictures.push_back([&figure, inside] { formats::draw(figure, inside); });
      }
    }
  }
  parallel_for_each(pictures.size(), jobs, [&](std::size_t i) { pictures[i](); });
  const auto write_page = [&](const std::string& name, const std::string& page) {
    runtime::write_file(folder / (name + ".html"), with_documents(page));
  };
  write_documents(folder);
  for (const Report& report : findings.reports)
    write_page(report.paper, report_page(report, results(report, findings.statements)));
  if (!findings.statements.empty()) write_page("errata", errata_page(findings.statements, all));
  runtime::write_file(folder / "results.json", results_json(all));
  write_page("results", results_page(all));
  write_page("index", front_page(findings));
}

nlohmann::ordered_json reports_json(const std::vector<Report>& reports,
                                    const std::optional<std::vector<Change>>& changed) {
  Json json{{"counts", counts_json(results(Findings{reports}))},
            {"comparisons", Json::array()},
            {"experiments", Json::array()},
            {"tables", Json::array()}};
  for (const Report& report : reports) {
    for (const formats::ComparisonTable* table : report.comparison_tables())
      for (const formats::Comparison& comparison : table->comparisons)
        json["comparisons"].push_back(comparison_json(*table, comparison));
    for (const experiments::RanExperiment& ran : report.experiments)
      json["experiments"].push_back(experiments::experiment_json(ran));
    for (const formats::Section& section : report.sections)
      for (const formats::PlainTable& table : section.tables) json["tables"].push_back(table_json(report, table));
  }
  if (changed) {
    json["changes"] = Json::array();
    for (const Change& one : *changed)
      json["changes"].push_back({{"key", one.key}, {"change", one.text}, {"matters", one.is_alarm}});
  }
  return json;
}

}  // namespace subcert::reports
