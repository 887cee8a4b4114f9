#include "stencil_facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

namespace subcert::facts {
namespace {

constexpr int weight_digits = 10;
constexpr std::array<const char*, 3> array_names{"limit", "tangent_1", "tangent_2"};

using Row = std::array<const StencilWeight*, 3>;

/// What each datum counts in the limit and in both tangents, or null.
std::map<SectorPoint, Row> rows_of(const VertexStencils& stencils) {
  std::map<SectorPoint, Row> rows;
  const auto add = [&](const VertexStencils::Stencil& stencil, std::size_t column) {
    for (const StencilWeight& weight : stencil) rows[weight.at][column] = &weight;
  };
  add(stencils.limit, 0);
  add(stencils.tangents[0], 1);
  add(stencils.tangents[1], 2);
  return rows;
}

bool is_rational(const StencilWeight& weight) {
  return weight.exact && weight.exact->lowest() == 0 && weight.exact->highest() == 0;
}

std::string cell(const StencilWeight* weight, bool with_sine) {
  if (weight == nullptr) return "0";
  if (!with_sine && is_rational(*weight)) return to_text(weight->exact->coefficient(0));
  return enclosure_text(weight->value, weight_digits);
}

Json stencil_json(const VertexStencils::Stencil& stencil, bool with_sine) {
  Json list = Json::array();
  for (const StencilWeight& weight : stencil)
    list.push_back({{"point", weight.at.point},
                    {"sector", weight.at.turn},
                    {"weight", enclosure_json(weight.value)},
                    {"exact", weight.exact ? Json(exact_weight_text(weight, with_sine)) : Json()}});
  return list;
}

/// Letters, digits and underscores.
std::string identifier(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char letter) { return std::isalnum(letter) == 0; }, '_');
  return text.substr(0, text.find_last_not_of('_') + 1);
}

std::string weights_in_c(const std::map<SectorPoint, Row>& rows, std::size_t column) {
  std::string text;
  for (const auto& [at, row] : rows) {
    const StencilWeight* const weight = row[column];
    const double value = weight ? Rational((*weight->value.lower + *weight->value.upper) / 2).convert_to<double>() : 0;
    text += fmt::format("  {},", value);
    if (weight && weight->exact) text += fmt::format("  /* {} */", exact_weight_text(*weight, column == 2));
    text += "\n";
  }
  return text;
}

}  // namespace

std::string exact_weight_text(const StencilWeight& weight, bool of_second_tangent) {
  const std::string text = to_text(*weight.exact, 'c');
  if (!of_second_tangent) return text;
  return text == "1" ? "s" : text == "-1" ? "-s" : fmt::format("s*({})", text);
}

std::string stencils_table(const VertexStencils& stencils) {
  std::string text = fmt::format("{:<8}  {:>6}  {:<18}  {:<18}  {}", "point", "sector", "limit", "tangent 1",
                                 "tangent 2");
  for (const auto& [at, row] : rows_of(stencils))
    text += fmt::format("\n{:<8}  {:>6}  {:<18}  {:<18}  {}", fmt::format("({},{})", at.point[0], at.point[1]), at.turn,
                        cell(row[0], false), cell(row[1], false), cell(row[2], true));
  return text;
}

Json stencils_json(const VertexStencils& stencils) {
  return {{"limit", stencil_json(stencils.limit, false)},
          {"tangents", {stencil_json(stencils.tangents[0], false), stencil_json(stencils.tangents[1], true)}}};
}

std::string stencils_header(const VertexScheme& scheme, const std::vector<StencilsAt>& valences) {
  const std::string name = identifier(scheme.specification);
  std::string guard = "STENCILS_" + name + "_H";
  std::ranges::transform(guard, guard.begin(), [](unsigned char letter) { return std::toupper(letter); });
  std::string text = fmt::format(
      "/* {}: stencils at vertices of valence n, by subcert.\n"
      " * DATA: x, y and the sector of each datum; (0,0) is the vertex, (1,0) and (0,1) the ends of two edges at it,\n"
      " * and the sectors follow counter-clockwise; of dual schemes (0,0) is a corner of the face with n corners.\n"
      " * The sum of weights times data is the point of the surface, or one of two tangents; their cross product is\n"
      " * the normal. Nearest doubles; exact in comments, c = cos(2 pi/n), s = sin(2 pi/n). */\n"
      "#ifndef {}\n#define {}\n",
      scheme.specification, guard, guard);
  for (const StencilsAt& at : valences) {
    const std::map<SectorPoint, Row> rows = rows_of(at.stencils);
    const std::string array = fmt::format("{}_{}", name, at.valence);
    text += fmt::format("\nstatic const int {}_data[{}][3] = {{\n", array, rows.size());
    for (const auto& [datum, row] : rows)
      text += fmt::format("  {{{}, {}, {}}},\n", datum.point[0], datum.point[1], datum.turn);
    text += "};\n";
    for (std::size_t column = 0; column < array_names.size(); ++column) {
      if (column > 0 && at.stencils.tangents[0].empty()) continue;
      text += fmt::format("static const double {}_{}[{}] = {{\n{}}};\n", array, array_names[column], rows.size(),
                          weights_in_c(rows, column));
    }
  }
  return text + "\n#endif\n";
}

}  // namespace subcert::facts
