#include "weight_facts.hpp"

#include "vertex_facts.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/polynomials/rational_function.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace subcert::facts {
namespace {

constexpr int end_digits = 12;

/// The coefficients of powers of a letter, as one expression.
std::string in_letter(const std::vector<LaurentPolynomial>& p, char letter) {
  std::string text;
  for (std::size_t k = p.size(); k-- > 0;) {
    if (p[k].is_zero()) continue;
    text += fmt::format("{}({}){}", text.empty() ? "" : " + ", to_text(p[k], 'c'),
                        k == 0   ? ""
                        : k == 1 ? fmt::format("*{}", letter)
                                 : fmt::format("*{}^{}", letter, k));
  }
  return text;
}

const WeightEnd* end_of(const WeightRange& range, const WeightPiece& piece) {
  const auto found = std::ranges::find_if(
      range.ends, [&](const WeightEnd& end) { return piece.low <= end.low && end.high <= piece.high; });
  return found == range.ends.end() ? nullptr : &*found;
}

std::string short_number(const Rational& value, Rounding rounding) {
  const std::string exact = to_text(value);
  return exact.size() <= end_digits ? exact : to_decimal(value, end_digits, rounding);
}

std::string line_of(const WeightEnd& end, char letter) {
  const std::string near = short_number(end.low, Rounding::down);
  const std::string what = end.value ? fmt::format("{} = {}, near {}", letter, to_text(*end.value, 'c'), near)
                                     : fmt::format("the zero of {} near {}", in_letter(end.polynomial, letter), near);
  return fmt::format("{:<10} {}: {} there", "end", what, verdict_text(end.holds.truth));
}

std::string lines_of(const WeightRange& range, char letter) {
  std::string text;
  for (const WeightPiece& piece : range.pieces) {
    if (!text.empty()) text += '\n';
    if (const WeightEnd* end = end_of(range, piece)) {
      text += line_of(*end, letter);
      continue;
    }
    // What is said of a piece is true as it is printed.
    const bool open = piece.holds.truth == Truth::unknown;
    text += fmt::format("{:<10} {} <= {} <= {}", verdict_text(piece.holds.truth),
                        short_number(piece.low, open ? Rounding::down : Rounding::up), letter,
                        short_number(piece.high, open ? Rounding::up : Rounding::down));
    if (open || piece.holds.is_no()) text += ": " + piece.holds.reason;
  }
  return text;
}

Json json_of(const WeightRange& range, char letter) {
  Json pieces = Json::array(), ends = Json::array();
  for (const WeightPiece& piece : range.pieces)
    pieces.push_back({{"from", to_text(piece.low)},
                      {"to", to_text(piece.high)},
                      {"verdict", verdict_text(piece.holds.truth)},
                      {"reason", piece.holds.reason}});
  for (const WeightEnd& end : range.ends)
    ends.push_back({{"lower", to_text(end.low)},
                    {"upper", to_text(end.high)},
                    {"value", end.value ? Json(to_text(*end.value, 'c')) : Json()},
                    {"polynomial", in_letter(end.polynomial, letter)},
                    {"verdict", verdict_text(end.holds.truth)},
                    {"reason", end.holds.reason}});
  return {{"valence", range.valence}, {"pieces", pieces}, {"ends", ends}};
}

}  // namespace

const char* property_text(WeightProperty property) {
  return property == WeightProperty::c1 ? "C1" : "bounded-curvature";
}

WeightProperty parse_weight_property(const std::string& text, const std::string& place) {
  for (const WeightProperty property : {WeightProperty::c1, WeightProperty::bounded_curvature})
    if (text == property_text(property)) return property;
  fail(ErrorKind::usage, "{}: expected C1 or bounded-curvature, got '{}'", place, printable(text));
}

std::string polynomial_text(const WeightEnd& end, char letter) { return in_letter(end.polynomial, letter); }

bool is_decided(const WeightRange& range) {
  return std::ranges::all_of(range.pieces, [&](const WeightPiece& piece) {
    return piece.holds.truth != Truth::unknown || end_of(range, piece) != nullptr;
  });
}

Facts weight_facts(const VertexScheme& scheme, const RegularPart& regular, WeightProperty property,
                   const std::vector<WeightRange>& ranges) {
  const char letter = scheme.written->letters.front().name;
  Facts list = regular_part_facts(scheme, regular);
  list.push_back(member("letter", std::string(1, letter)));
  list.push_back({"property", "property", property_text(property), {}, property_text(property)});
  Json all = Json::array();
  for (const WeightRange& range : ranges) all.push_back(json_of(range, letter));
  list.push_back(member("ranges", all));
  for (const WeightRange& range : ranges)
    list.push_back({{}, fmt::format("n = {}", range.valence), lines_of(range, letter), {}, {}});
  return list;
}

}  // namespace subcert::facts
