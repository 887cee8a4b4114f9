#include "vertex_facts.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace subcert::facts {
namespace {

constexpr int digits = 10;

std::string cell(const Enclosure& value) { return value.lower || value.upper ? enclosure_text(value, digits) : ""; }

/// Of a row of the table.
std::vector<std::string> cells(const VertexSmoothness& at) {
  return {std::to_string(at.valence), to_text(at.c1.truth),
          cell(at.subdominant),       cell(at.next),
          cell(at.exponent),          at.curvature ? to_text(*at.curvature) : ""};
}

std::string table(const std::vector<VertexSmoothness>& valences) {
  std::string text = fmt::format("{:>3}  {:<7}  {:<12}  {:<12}  {:<26}  {}", "n", "C1", "lambda", "|mu|", "exponent",
                                 "curvature");
  for (const VertexSmoothness& at : valences) {
    const std::vector<std::string> of = cells(at);
    const std::string line = fmt::format("\n{:>3}  {:<7}  {:<12}  {:<12}  {:<26}  {}", of[0], of[1], of[2], of[3],
                                         of[4], of[5]);
    text += line.substr(0, line.find_last_not_of(' ') + 1);
  }
  return text;
}

Json row(const VertexSmoothness& at) {
  return {{"valence", at.valence},
          {"c1", to_text(at.c1.truth)},
          {"reason", at.c1.reason},
          {"frequency", at.frequency},
          {"subdominant", enclosure_json(at.subdominant)},
          {"next", enclosure_json(at.next)},
          {"exponent", enclosure_json(at.exponent)},
          {"curvature", at.curvature ? Json(to_text(*at.curvature)) : Json()},
          {"squares", at.squares},
          {"levels", at.levels}};
}

/// Why it is not yes, once for all valences with the same reason.
std::string reasons(const std::vector<VertexSmoothness>& valences) {
  std::vector<std::pair<std::string, std::string>> list;
  for (const VertexSmoothness& at : valences) {
    if (at.c1.is_yes()) continue;
    const std::string number = std::to_string(at.valence);
    const auto known = std::ranges::find(list, at.c1.reason, &std::pair<std::string, std::string>::second);
    if (known == list.end())
      list.emplace_back(number, at.c1.reason);
    else
      known->first += ", " + number;
  }
  std::string text;
  for (const auto& [numbers, reason] : list) text += (text.empty() ? "n = " : "\nn = ") + numbers + ": " + reason;
  return text;
}

Fact of_rest(const EveryValence& rest) {
  Json open = Json::array();
  for (const EveryValence::Range& range : rest.open)
    open.push_back({{"first", range.first}, {"last", range.last ? Json(*range.last) : Json()}});
  const std::string how = rest.c1.is_yes() ? fmt::format("proved in {} intervals of 1/n", rest.intervals)
                                           : rest.c1.reason;
  return {"rest",
          fmt::format("n >= {}", rest.first),
          to_text(rest.c1.truth),
          how,
          {{"first", rest.first},
           {"c1", to_text(rest.c1.truth)},
           {"reason", rest.c1.reason},
           {"open", open},
           {"intervals", rest.intervals},
           {"squares", rest.squares}}};
}

}  // namespace

std::vector<std::vector<std::string>> vertex_rows(const std::vector<VertexSmoothness>& valences,
                                                  const std::optional<EveryValence>& rest) {
  std::vector<std::vector<std::string>> rows{{"n", "C1", "subdominant", "next modulus", "exponent", "curvature"}};
  for (const VertexSmoothness& at : valences) rows.push_back(cells(at));
  if (rest) rows.push_back({fmt::format("{} and above", rest->first), to_text(rest->c1.truth), "", "", "", ""});
  return rows;
}

Truth all_of(const std::vector<VertexSmoothness>& valences, const std::optional<EveryValence>& rest) {
  const auto is = [&](Truth truth) { return [=](const VertexSmoothness& at) { return at.c1.truth == truth; }; };
  if (std::ranges::any_of(valences, is(Truth::no))) return Truth::no;
  const bool all = std::ranges::all_of(valences, is(Truth::yes)) && (!rest || rest->c1.is_yes());
  return all ? Truth::yes : Truth::unknown;
}

Facts regular_part_facts(const VertexScheme& scheme, const RegularPart& regular) {
  Facts list = named(scheme.specification, scheme.title);
  list.push_back({"regular_exponent", "regular part", cell(regular.exponent), "exponent away from vertices",
                  enclosure_json(regular.exponent)});
  list.push_back(decided("regular_c1", "C1 there", regular.c1));
  return list;
}

Facts vertex_facts(const VertexScheme& scheme, const RegularPart& regular,
                   const std::vector<VertexSmoothness>& valences, const std::optional<EveryValence>& rest,
                   const std::vector<StencilsAt>& stencils) {
  Facts list = regular_part_facts(scheme, regular);
  Json rows = Json::array();
  for (const VertexSmoothness& at : valences) rows.push_back(row(at));
  for (std::size_t i = 0; i < stencils.size(); ++i) rows[i]["stencils"] = stencils_json(stencils[i].stencils);
  list.push_back({"valences", "at a vertex", table(valences), {}, rows});
  if (const std::string why = reasons(valences); !why.empty()) list.push_back({{}, "why", why, {}, {}});
  if (rest) list.push_back(of_rest(*rest));
  for (const StencilsAt& at : stencils)
    list.push_back({{}, fmt::format("n = {}", at.valence), stencils_table(at.stencils), {}, {}});
  list.push_back({{},
                  "C1 means",
                  "for all initial data but a set of measure zero the surface is, near the vertex, the graph of a C1 "
                  "function over its tangent plane, without overlap",
                  {},
                  {}});
  // Some valences say nothing of all, but that not all are.
  const Truth all = all_of(valences, rest);
  list.push_back(member("all", to_text(rest || all == Truth::no ? all : Truth::unknown)));
  return list;
}

}  // namespace subcert::facts
