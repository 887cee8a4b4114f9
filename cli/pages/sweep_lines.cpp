#include "sweep_lines.hpp"

#include <subcert/proofs-checks/sweeps/sweep_plan.hpp>
#include <subcert/schemes/data/formats/table.hpp>

#include <algorithm>

namespace subcert::cli {
namespace {

std::string value_text(const Json& result, const std::string& column) {
  const Json* value = sweeps::value_of(result, column);
  if (!value || value->is_null() || (value->is_structured() && value->empty())) return "";
  if (value->is_boolean()) return value->get<bool>() ? "yes" : "no";
  return value->is_string() ? value->get<std::string>() : value->dump();
}

std::string joined(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t k = 0; k < cells.size(); ++k)
    line += (k > 0 ? "," : "") + (cells[k].empty() ? "" : data::quoted_where_needed(cells[k], ','));
  return line + "\n";
}

}  // namespace

std::string SweepLines::head() const { return json_ ? "" : joined(columns_); }

std::string SweepLines::line(const Json& result) const {
  if (json_) return result.dump() + "\n";
  std::vector<std::string> cells;
  for (const std::string& column : columns_) cells.push_back(value_text(result, column));
  return joined(cells);
}

std::vector<std::string> usual_columns(const std::vector<std::string>& asked) {
  static const std::vector<std::pair<std::string, std::vector<std::string>>> of_commands = {
      {"regularity", {"sum_rules", "converges", "holder.lower", "holder.upper", "exact", "stable"}},
      {"analyze", {"sum_rules", "converges", "holder.lower", "holder.upper"}},
      {"variance", {"mean", "sup.lower", "sup.upper", "inf.lower", "inf.upper"}},
      {"limit", {"maximum.lower", "maximum.upper", "minimum.lower", "minimum.upper"}},
      {"mask", {"arity", "first_index"}},
      {"vertex", {"regular_c1.verdict", "all"}},
      {"levels", {"summary"}},
      {"range", {"summary"}},
      {"curve", {"sum_rules"}},
      {"l1", {"converges", "unique", "lipschitz"}}};
  std::vector<std::string> columns = {"scheme"};
  const auto add = [&](const std::string& member) {
    if (std::ranges::find(columns, member) == columns.end()) columns.push_back(member);
  };
  for (const std::string& question : asked) {
    const std::string command = question.substr(0, question.find(' '));
    for (const auto& [name, members] : of_commands)
      if (name == command) std::ranges::for_each(members, add);
    for (const std::string& member : sweeps::SchemeQuestion::parse(question).members()) add(member);
  }
  columns.emplace_back("errors");
  return columns;
}

}  // namespace subcert::cli
