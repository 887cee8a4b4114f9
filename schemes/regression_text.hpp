#pragma once
// The keys of `regression:`, with any kind of number at positions and weights.

#include "specification_text.hpp"

#include <string>
#include <vector>

namespace subcert::specification_text {

/// What the keys say, and how they are printed back.
template <class Number>
struct RegressionText {
  LocalRegressionOf<Number> scheme;
  std::string text;
  long points = 0;         ///< of the longest stencil
  std::size_t digits = 0;  ///< of the longest position or weight
  Piece stencils;
};

/// `position` and `weight` read a number; `print` prints it.
template <class Number, class Position, class Weight, class Print>
RegressionText<Number> read_regression(Fields& fields, Position position, Weight weight, Print print) {
  RegressionText<Number> result;
  std::string stencils, positions, weights;
  const auto printed = [&](const Number& value) {
    std::string text = print(value);
    result.digits = std::max(result.digits, text.size());
    return text;
  };
  result.stencils = fields.required("stencils");
  auto& rules = result.scheme.rules;
  for (const Piece& stencil : read_list(result.stencils, ';')) {
    const std::size_t dots = stencil.text.find("..");
    if (dots == std::string_view::npos) fail(stencil, "a stencil first..last, as -1..2");
    const long first = read_integer({stencil.text.substr(0, dots), stencil.at}, "first", -max_points, max_points);
    const long last = read_integer({stencil.text.substr(dots + 2), stencil.at + dots + 2}, "last", -max_points,
                                   max_points);
    if (first > last || last - first >= max_points)
      fail(stencil, "a stencil first..last with at most " + std::to_string(max_points) + " points");
    result.points = std::max(result.points, last - first + 1);
    rules.push_back({first, last, 0, {}});
    stencils += (stencils.empty() ? "" : ";") + std::to_string(first) + ".." + std::to_string(last);
  }
  if (rules.size() < 2 || rules.size() > static_cast<std::size_t>(max_arity))
    fail(result.stencils, "one stencil for each of 2 to " + std::to_string(max_arity) + " rules");
  if (result.points * static_cast<long>(rules.size()) > 4 * max_points)
    fail(result.stencils, "rules * points <= " + std::to_string(4 * max_points));

  const Piece at_piece = fields.required("at");
  const auto at = read_list(at_piece, ';');
  if (at.size() != rules.size()) fail(at_piece, "as many positions as stencils");
  for (std::size_t k = 0; k < at.size(); ++k) {
    rules[k].position = position(at[k]);
    positions += (k == 0 ? "" : ";") + printed(rules[k].position);
  }

  if (const auto piece = fields.optional("weights")) {
    const auto lists = read_list(*piece, '|');
    if (lists.size() != rules.size()) fail(*piece, "as many weight lists as stencils, separated by |");
    for (std::size_t k = 0; k < lists.size(); ++k) {
      auto& rule = rules[k];
      for (const Piece& entry : split(lists[k], ';')) {
        rule.weights.push_back(weight(entry));
        weights += (rule.weights.size() > 1 ? ";" : (k == 0 ? "" : "|")) + printed(rule.weights.back());
      }
      if (rule.weights.size() != static_cast<std::size_t>(rule.last - rule.first + 1))
        fail(lists[k], "one weight for each point of the stencil");
    }
  }
  result.scheme.degree = static_cast<int>(read_degree(fields, result.points));
  if (const auto piece = fields.optional("first"))
    result.scheme.first_output = read_integer(*piece, "first", -max_points, max_points);
  result.text = "regression:stencils=[" + stencils + "],at=[" + positions +
                "],d=" + std::to_string(result.scheme.degree);
  if (!weights.empty()) result.text += ",weights=[" + weights + "]";
  if (result.scheme.first_output != 0) result.text += ",first=" + std::to_string(result.scheme.first_output);
  return result;
}

}  // namespace subcert::specification_text
