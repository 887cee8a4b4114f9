// Families with a parameter: masks with a letter where a number may stand.
#include "parametric_specification.hpp"

#include "classical.hpp"
#include "specification_text.hpp"

#include <subcert/analysis/symbol/decimal.hpp>
#include <subcert/analysis/symbol/error.hpp>

#include <fmt/format.h>

#include <cctype>

namespace subcert {
namespace {

using namespace specification_text;

constexpr long max_degree = 12, max_coefficients = 100;
constexpr const char* mask_usage = "mask:[-w,0,1/2+w,1,1/2+w,0,-w]@-3,arity=2";

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// A sum of terms in the parameter.
LaurentPolynomial read_coefficient(const Piece& piece, char parameter) {
  const std::string expected = std::string("a sum of terms c, ") + parameter + " or c*" + parameter +
                               "^k with exact numbers c and k up to " + std::to_string(max_degree);
  try {
    LaurentPolynomial result = parse_polynomial(piece.text, parameter);
    if (!result.is_zero() && (result.lowest() < 0 || result.highest() > max_degree)) fail(piece, expected);
    return result;
  } catch (const ParseError&) {
    fail(piece, expected);
  }
}

/// The one letter of the coefficients.
char read_parameter(const Piece& list) {
  char parameter = '\0';
  for (std::size_t i = 0; i < list.text.size(); ++i) {
    const char c = list.text[i];
    if (!is_letter(c)) continue;
    if (parameter != '\0' && c != parameter)
      fail({list.text.substr(i, 1), list.at + i}, std::string("one letter for the parameter, here ") + parameter);
    parameter = c;
  }
  if (parameter == '\0') fail(list, std::string("a letter for the parameter, as in ") + mask_usage);
  return parameter;
}

ParametricScheme make_mask(const Piece& family, const Piece& body) {
  const std::size_t close = body.text.find(']');
  if (body.text.empty() || body.text.front() != '[' || close == std::string_view::npos)
    fail(body, std::string("coefficients in brackets, as in ") + mask_usage);
  const Piece list{body.text.substr(0, close + 1), body.at};
  const char parameter = read_parameter(list);
  const std::vector<Piece> entries = read_list(list, ',');
  if (static_cast<long>(entries.size()) > max_coefficients)
    fail(list, "at most " + std::to_string(max_coefficients) + " coefficients");
  // What follows is read as that of a mask of ones.
  std::string ones = "[1";
  for (std::size_t k = 1; k < entries.size(); ++k) ones += ",1";
  ones += "]" + std::string(body.text.substr(close + 1));
  auto [parts, fields] = read_mask(family, {ones, body.at}, mask_usage, 1, max_coefficients);
  const auto arity_piece = fields.optional("arity");
  const long arity = arity_piece ? read_integer(*arity_piece, "arity", 2, max_arity) : 2;
  fields.finish();

  std::vector<LaurentPolynomial> powers;
  const long first = parts.first ? parts.first->front() : -static_cast<long>(entries.size() / 2);
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const LaurentPolynomial coefficient = read_coefficient(entries[k], parameter);
    for (long i = 0; !coefficient.is_zero() && i <= coefficient.highest(); ++i) {
      if (static_cast<std::size_t>(i) >= powers.size()) powers.resize(static_cast<std::size_t>(i) + 1);
      powers[static_cast<std::size_t>(i)] += LaurentPolynomial::monomial(
          coefficient.coefficient(i) * parts.coefficients[k], first + static_cast<long>(k));
    }
  }
  ParametricMask mask(std::move(powers), static_cast<int>(arity));
  for (long residue = 0; residue < arity; ++residue) {
    LaurentPolynomial sum;
    for (long i = mask.support().first; i <= mask.support().last; ++i)
      if ((i - residue) % arity == 0) sum += mask.coefficient(i);
    if (!(sum == LaurentPolynomial(1)))
      fail(list, std::string("coefficients that sum to 1 over each residue class for all ") + parameter +
                     "; the class " + std::to_string(residue) + " mod " + std::to_string(arity) + " sums to " +
                     to_text(sum, parameter));
  }
  const std::string text = mask.to_text(parameter);
  return {"mask:" + text + (arity == 2 ? "" : ",arity=" + std::to_string(arity)),
          fmt::format("mask with the parameter {}", parameter), parameter, std::move(mask)};
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
  std::string names;
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
