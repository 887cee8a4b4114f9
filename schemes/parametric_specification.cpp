// Families with a parameter: masks with a letter where a number may stand.
#include "parametric_specification.hpp"

#include "classical.hpp"
#include "regression_text.hpp"

#include <subcert/analysis/symbol/decimal.hpp>
#include <subcert/analysis/symbol/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace subcert {
namespace {

using namespace specification_text;

constexpr long max_degree = 12, max_coefficients = 100;
constexpr long max_symbolic_work = 500;  // points * d^2 of a regression: its fractions are long
constexpr const char* mask_usage = "mask:[-w,0,1/2+w,1,1/2+w,0,-w]@-3,arity=2";
constexpr const char* regression_usage = "regression:stencils=[-1..1;-1..2],at=[0;1/2],d=1,weights=[w;1;w|w;1;1;w]";

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// The one letter inside brackets and parentheses.
char read_parameter(const Piece& body, const char* usage) {
  char parameter = '\0';
  int depth = 0;
  for (std::size_t i = 0; i < body.text.size(); ++i) {
    const char c = body.text[i];
    if (c == '[' || c == '(') ++depth;
    if (c == ']' || c == ')') --depth;
    if (depth == 0 || !is_letter(c)) continue;
    if (parameter != '\0' && c != parameter)
      fail({body.text.substr(i, 1), body.at + i}, fmt::format("one letter for the parameter, here {}", parameter));
    parameter = c;
  }
  if (parameter == '\0') fail(body, std::string("a letter for the parameter, as in ") + usage);
  return parameter;
}

RationalFunction read_function(const Piece& piece, char parameter) {
  try {
    return RationalFunction::parse(piece.text, parameter);
  } catch (const ParseError& error) {
    throw SpecificationError(error.token(), piece.at + error.position(), error.expected());
  }
}

void require_size(const ParametricMask& mask, const Piece& piece) {
  const IndexRange range = mask.support();
  if (mask.degree() > max_degree || range.last - range.first >= max_coefficients)
    fail(piece, fmt::format("up to {} coefficients of degree up to {}, over their common denominator; here {} of "
                            "degree {}",
                            max_coefficients, max_degree, range.last - range.first + 1, mask.degree()));
}

/// The place behind the parenthesis that closes the first one.
std::size_t end_of_parentheses(std::string_view text) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
    if (depth == 0) return i + 1;
  }
  return text.size();
}

ParametricScheme make_mask(const Piece& family, const Piece& body) {
  const std::size_t close = body.text.find(']');
  if (body.text.empty() || body.text.front() != '[' || close == std::string_view::npos)
    fail(body, std::string("coefficients in brackets, as in ") + mask_usage);
  const char parameter = read_parameter(body, mask_usage);
  const Piece list{body.text.substr(0, close + 1), body.at};
  const std::vector<Piece> entries = read_list(list, ',');
  if (static_cast<long>(entries.size()) > max_coefficients)
    fail(list, fmt::format("at most {} coefficients", max_coefficients));
  // A denominator in parentheses may depend on the parameter.
  Piece rest{body.text.substr(close + 1), body.at + close + 1};
  RationalFunction denominator = 1;
  if (rest.text.starts_with("/(")) {
    const std::size_t end = 1 + end_of_parentheses(rest.text.substr(1));
    const Piece divisor{rest.text.substr(1, end - 1), rest.at + 1};
    denominator = read_function(divisor, parameter);
    if (denominator == RationalFunction()) fail(divisor, "a denominator that is not zero");
    rest = {rest.text.substr(end), rest.at + end};
  }
  // What follows is read as that of a mask of ones.
  std::string ones = "[1";
  for (std::size_t k = 1; k < entries.size(); ++k) ones += ",1";
  ones += "]" + std::string(rest.text);
  auto [parts, fields] = read_mask(family, {ones, body.at}, mask_usage, 1, max_coefficients);
  const auto arity_piece = fields.optional("arity");
  const long arity = arity_piece ? read_integer(*arity_piece, "arity", 2, max_arity) : 2;
  fields.finish();

  std::vector<RationalFunction> coefficients;
  for (std::size_t k = 0; k < entries.size(); ++k)
    coefficients.push_back(read_function(entries[k], parameter) * RationalFunction(parts.coefficients[k]) /
                           denominator);
  if (std::all_of(coefficients.begin(), coefficients.end(),
                  [](const RationalFunction& c) { return c == RationalFunction(); }))
    fail(list, "at least one coefficient that is not zero");
  const long first = parts.first ? parts.first->front() : -static_cast<long>(entries.size() / 2);
  ParametricMask mask(coefficients, first, static_cast<int>(arity));
  require_size(mask, list);
  for (long residue = 0; residue < arity; ++residue) {
    RationalFunction sum;
    for (std::size_t k = 0; k < coefficients.size(); ++k)
      if ((first + static_cast<long>(k) - residue) % arity == 0) sum += coefficients[k];
    if (!(sum == RationalFunction(1)))
      fail(list, fmt::format("coefficients that sum to 1 over each residue class for all {}; the class {} mod {} sums "
                             "to {}",
                             parameter, residue, arity, sum.to_text(parameter)));
  }
  const std::string text = mask.to_text(parameter);
  return {"mask:" + text + (arity == 2 ? "" : ",arity=" + std::to_string(arity)),
          fmt::format("mask with the parameter {}", parameter), parameter, std::move(mask)};
}

ParametricScheme make_regression(const Piece& family, const Piece& body) {
  Fields fields(family, body, regression_usage);
  const char parameter = read_parameter(body, regression_usage);
  const auto number = [=](const Piece& piece) { return read_function(piece, parameter); };
  const auto weight = [=](const Piece& piece) {
    RationalFunction value = read_function(piece, parameter);
    if (value.numerator().is_zero() || (value.is_polynomial() && value.numerator().highest() == 0 && value(0) < 0))
      fail(piece, "a weight > 0");
    return value;
  };
  const auto [scheme, text, points, digits, stencils] = read_regression<RationalFunction>(
      fields, number, weight, [=](const RationalFunction& value) { return value.to_text(parameter); });
  fields.finish();
  const long effective = std::min<long>(scheme.degree, points - 1);
  if (points * std::max(1L, effective * effective) > max_symbolic_work)
    fail(stencils, fmt::format("points * d^2 <= {} with a parameter", max_symbolic_work));
  ParametricMask mask = parametric_regression_mask(scheme);
  require_size(mask, stencils);
  return {text, fmt::format("local regression of degree {} with the parameter {}", scheme.degree, parameter), parameter,
          std::move(mask)};
}

ParametricScheme make_classical(const ClassicalFamily& family, const Piece& body) {
  if (body.text.size() != 1 || !is_letter(body.text.front()))
    fail(body, "a letter for the parameter, as in " + family.name + ":w");
  const char letter = body.text.front();
  return {fmt::format("{}:{}", family.name, letter), fmt::format("{} {}", family.title, letter), letter, family.mask};
}

}  // namespace

ParametricScheme make_parametric_scheme(std::string_view specification) {
  if (specification.size() > max_text) fail({specification, 0}, "at most " + std::to_string(max_text) + " characters");
  const Piece family = family_of(specification);
  const std::size_t begin = std::min(family.text.size() + 1, specification.size());
  const Piece body{specification.substr(begin), begin};
  if (family.text == "mask") return make_mask(family, body);
  if (family.text == "regression") return make_regression(family, body);
  std::string names = std::string(" or ") + regression_usage;
  for (const ClassicalFamily& classical : classical_families()) {
    if (family.text == classical.name) return make_classical(classical, body);
    names += " or " + classical.name + ":w";
  }
  fail(family, std::string("a family with a parameter: ") + mask_usage + names);
}

std::optional<ParameterRange> parse_parameter_range(std::string text, char parameter) {
  std::erase(text, ' ');
  const std::size_t at = text.find(parameter);
  if (at == std::string::npos || text.size() > 1000) return std::nullopt;
  std::string_view low = std::string_view(text).substr(0, at), high = std::string_view(text).substr(at + 1);
  if (!(low.ends_with('<') || low.ends_with("<=")) || !high.starts_with('<')) return std::nullopt;
  ParameterRange range{0, 0, low.ends_with('='), high.starts_with("<=")};
  low.remove_suffix(range.low_included ? 2 : 1);
  high.remove_prefix(range.high_included ? 2 : 1);
  const auto first = parse_number(low), last = parse_number(high);
  if (!first || !last || !(*first < *last)) return std::nullopt;
  range.low = *first;
  range.high = *last;
  return range;
}

}  // namespace subcert
