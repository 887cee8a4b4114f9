// Families with a parameter: masks with a letter where a number may stand.
#include "parametric_specification.hpp"

#include "classical.hpp"
#include "regression_text.hpp"

#include <subcert/analysis/symbol/decimal.hpp>
#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/symbol/index_arithmetic.hpp>
#include <subcert/analysis/symbol/rational_matrix.hpp>
#include <subcert/analysis/symbol/real_roots.hpp>

#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

namespace subcert {
namespace {

using namespace specification_text;

constexpr long max_degree = 12, max_coefficients = 100;
constexpr long algebraic_bits = 1500;    // of a number that stands for an algebraic one
constexpr long max_symbolic_work = 500;  // points * d^2 of a regression: its fractions are long
constexpr const char* mask_usage = "mask:[-w,0,1/2+w,1,1/2+w,0,-w]@-3,arity=2";
constexpr const char* algebraic_usage = "mask:[1+t,3+t,3-t,1-t]/4,where=t^2-3:1.7..1.8";
constexpr const char* regression_usage = "regression:stencils=[-1..1;-1..2],at=[0;1/2],d=1,weights=[w;1;w|w;1;1;w]";

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// The letters inside brackets and parentheses, each with its place.
std::vector<Piece> letters_inside(const Piece& body) {
  std::vector<Piece> letters;
  int depth = 0;
  for (std::size_t i = 0; i < body.text.size(); ++i) {
    const char c = body.text[i];
    depth += c == '[' || c == '(' ? 1 : c == ']' || c == ')' ? -1 : 0;
    if (depth != 0 && is_letter(c)) letters.push_back({body.text.substr(i, 1), body.at + i});
  }
  return letters;
}

/// The one letter inside brackets and parentheses.
char read_parameter(const Piece& body, const char* usage) {
  const std::vector<Piece> letters = letters_inside(body);
  if (letters.empty()) fail(body, std::string("a letter for the parameter, as in ") + usage);
  const char parameter = letters.front().text.front();
  for (const Piece& letter : letters)
    if (letter.text.front() != parameter) fail(letter, fmt::format("one letter for the parameter, here {}", parameter));
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

/// The keys of `mask:` with a letter in its coefficients.
struct MaskText {
  std::vector<RationalFunction> coefficients;
  long first;
  int arity;
  char letter;
  Piece list;  ///< of the coefficients
  Fields fields;
};

/// The coefficients in brackets, and what follows.
std::pair<Piece, Piece> list_and_rest(const Piece& body, const char* usage) {
  const std::size_t close = body.text.find(']');
  if (body.text.empty() || body.text.front() != '[' || close == std::string_view::npos)
    fail(body, std::string("coefficients in brackets, as in ") + usage);
  return {{body.text.substr(0, close + 1), body.at}, {body.text.substr(close + 1), body.at + close + 1}};
}

/// What stands behind the coefficients: `/D@first,arity=2` and further keys. All may be absent.
struct MaskTail {
  Rational scale;  ///< 1/D
  long first;
  int arity;
  Fields fields;
};

MaskTail read_tail(const Piece& family, const Piece& rest, std::size_t coefficients, const std::string& usage) {
  const std::vector<Piece> pieces = split(rest, ',');
  const Piece& scale = pieces.front();
  const std::string one = "[1]";
  text::MaskText parts;
  try {
    parts = text::parse_mask_text(one + std::string(scale.text), 1);
  } catch (const ParseError& error) {
    throw SpecificationError(error.token(), scale.at + std::max(error.position(), one.size() + 1) - one.size(),
                             error.expected());
  }
  Fields fields(family, {pieces.begin() + 1, pieces.end()}, usage);
  const auto arity_piece = fields.optional("arity");
  const long arity = arity_piece ? read_integer(*arity_piece, "arity", 2, max_arity) : 2;
  return {parts.coefficients.front(), parts.first ? parts.first->front() : -static_cast<long>(coefficients / 2),
          static_cast<int>(arity), std::move(fields)};
}

MaskText read_mask_with_letter(const Piece& family, const Piece& body, const char* usage) {
  auto [list, rest] = list_and_rest(body, usage);
  const char letter = read_parameter(body, usage);
  const std::vector<Piece> entries = read_list(list, ',');
  if (static_cast<long>(entries.size()) > max_coefficients)
    fail(list, fmt::format("at most {} coefficients", max_coefficients));
  // A denominator in parentheses may depend on the letter.
  RationalFunction denominator = 1;
  if (rest.text.starts_with("/(")) {
    const std::size_t end = 1 + end_of_parentheses(rest.text.substr(1));
    const Piece divisor{rest.text.substr(1, end - 1), rest.at + 1};
    denominator = read_function(divisor, letter);
    if (denominator == RationalFunction()) fail(divisor, "a denominator that is not zero");
    rest = {rest.text.substr(end), rest.at + end};
  }
  MaskTail tail = read_tail(family, rest, entries.size(), usage);
  std::vector<RationalFunction> coefficients;
  for (std::size_t k = 0; k < entries.size(); ++k)
    coefficients.push_back(read_function(entries[k], letter) * RationalFunction(tail.scale) / denominator);
  if (std::all_of(coefficients.begin(), coefficients.end(),
                  [](const RationalFunction& c) { return c == RationalFunction(); }))
    fail(list, "at least one coefficient that is not zero");
  return {std::move(coefficients), tail.first, tail.arity, letter, list, std::move(tail.fields)};
}

/// `for all w` or `for this t`
void require_sums(const MaskText& text, const std::string& values) {
  for (long residue = 0; residue < text.arity; ++residue) {
    RationalFunction sum;
    for (std::size_t k = 0; k < text.coefficients.size(); ++k)
      if ((text.first + static_cast<long>(k) - residue) % text.arity == 0) sum += text.coefficients[k];
    if (!(sum == RationalFunction(1)))
      fail(text.list, fmt::format("coefficients that sum to 1 over each residue class for {} {}; the class {} mod {} "
                                  "sums to {}",
                                  values, text.letter, residue, text.arity, sum.to_text(text.letter)));
  }
}

ParametricScheme make_mask(const Piece& family, const Piece& body) {
  MaskText text = read_mask_with_letter(family, body, mask_usage);
  text.fields.finish();
  ParametricMask mask(text.coefficients, text.first, text.arity);
  require_size(mask, text.list);
  require_sums(text, "all");
  const std::string printed = mask.to_text(text.letter);
  return {"mask:" + printed + (text.arity == 2 ? "" : ",arity=" + std::to_string(text.arity)),
          fmt::format("mask with the parameter {}", text.letter), text.letter, std::move(mask)};
}

/// p modulo a polynomial of positive degree.
LaurentPolynomial remainder(LaurentPolynomial p, const LaurentPolynomial& divisor) {
  while (!p.is_zero() && p.highest() >= divisor.highest())
    p -= LaurentPolynomial::monomial(p.coefficient(p.highest()) / divisor.coefficient(divisor.highest()),
                                     p.highest() - divisor.highest()) *
         divisor;
  return p;
}

/// A real algebraic number.
struct AlgebraicNumber {
  LaurentPolynomial polynomial;  ///< irreducible
  Rational low, high;            ///< with no other zero of it between them
  Enclosure value;
};

/// `t^2-3:1.7..1.8`
AlgebraicNumber read_number(const Piece& piece, char letter) {
  const std::size_t colon = piece.text.find(':'), dots = piece.text.find("..");
  if (colon == std::string_view::npos || dots == std::string_view::npos || dots < colon)
    fail(piece, fmt::format("a polynomial and an interval with one zero of it, as {0}^2-3:1.7..1.8", letter));
  const Piece equation{piece.text.substr(0, colon), piece.at}, ends{piece.text.substr(colon + 1), piece.at + colon + 1};
  const RationalFunction function = read_function(equation, letter);
  const LaurentPolynomial& p = function.numerator();
  if (!function.is_polynomial() || p.is_zero() || p.highest() == 0 || p.highest() > max_degree)
    fail(equation, fmt::format("a polynomial in {} of degree 1 to {}", letter, max_degree));
  const auto low = parse_number(piece.text.substr(colon + 1, dots - colon - 1)),
             high = parse_number(piece.text.substr(dots + 2));
  if (!low || !high || !(*low < *high)) fail(ends, "exact numbers LOW..HIGH with LOW < HIGH");
  if (p(*low) == 0 || p(*high) == 0 || count_real_roots(p, *low, *high) != 1)
    fail(ends, "an interval with exactly one zero of " + to_text(p, letter) + " inside");
  for (const PolynomialFactor& factor : irreducible_factors(p))
    if (count_real_roots(factor.polynomial, *low, *high) == 1)
      return {factor.polynomial, *low, *high,
              real_roots(factor.polynomial, *low, *high, power(Rational(2), -algebraic_bits)).front()};
  fail(ends, "an interval with a zero");
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

Scheme specification_text::make_algebraic_mask(const Piece& family, const Piece& body) {
  MaskText text = read_mask_with_letter(family, body, algebraic_usage);
  const AlgebraicNumber number = read_number(text.fields.required("where"), text.letter);
  text.fields.finish();
  // Powers of the number below the degree of its polynomial are independent over the rationals: what holds for the
  // coefficients modulo the polynomial holds for all numbers in place of this one, sum rules too.
  for (RationalFunction& c : text.coefficients) {
    if (!c.is_polynomial()) fail(text.list, fmt::format("coefficients that are polynomials in {}", text.letter));
    c = remainder(c.numerator(), number.polynomial);
  }
  require_sums(text, "this");
  const ParametricMask mask(text.coefficients, text.first, text.arity);
  const std::string arity = text.arity == 2 ? "" : ",arity=" + std::to_string(text.arity);
  const Rational unit = power(Rational(2), -algebraic_bits), &low = *number.value.lower, &high = *number.value.upper;
  const Rational value = number.value.is_exact() ? low : unit * Rational(to_integer(low / unit, Rounding::nearest));
  Scheme scheme{
      fmt::format("mask:{}{},where={}:{}..{}", mask.to_text(text.letter), arity,
                  RationalFunction(number.polynomial).to_text(text.letter), to_text(number.low), to_text(number.high)),
      "mask given by its coefficients, rounded", mask.at(value)};
  if (number.value.is_exact()) return scheme;
  // |t^k - v^k| <= k |t - v| max(|t|, |v|)^(k-1)
  const Rational away = high - low + unit, most = std::max(abs(low), abs(high)) + unit;
  Rational distance = 0;
  for (const RationalFunction& c : text.coefficients) {
    Rational slope = 0;
    for (long k = 1; !c.numerator().is_zero() && k <= c.numerator().highest(); ++k)
      slope += abs(c.numerator().coefficient(k)) * k * power(most, k - 1);
    distance = std::max(distance, Rational(slope * away));
  }
  if (distance > 0) scheme.rounding = {power(Rational(2), binary_exponent(distance) + 1), sum_rules(mask)};
  return scheme;
}

ParametricScheme make_parametric_scheme(std::string_view specification) {
  if (specification.size() > max_text) fail({specification, 0}, "at most " + std::to_string(max_text) + " characters");
  const Piece family = family_of(specification);
  const Piece body = body_of(specification);
  if (family.text == "mask") return make_mask(family, body);
  if (family.text == "regression") return make_regression(family, body);
  std::string names = std::string(" or ") + regression_usage;
  for (const ClassicalFamily& classical : classical_families()) {
    if (family.text == classical.name) return make_classical(classical, body);
    names += " or " + classical.name + ":w";
  }
  fail(family, std::string("a family with a parameter: ") + mask_usage + names);
}

bool has_parameter(std::string_view specification) {
  const std::string_view family = family_of(specification).text;
  const Piece body = body_of(specification);
  if (body.text.find(",where=") != std::string_view::npos) return false;
  if (family == "mask" || family == "regression") return !letters_inside(body).empty();
  const auto& families = classical_families();
  return body.text.size() == 1 && is_letter(body.text.front()) &&
         std::any_of(families.begin(), families.end(), [&](const ClassicalFamily& one) { return one.name == family; });
}

ParametricMask make_parametric_mask(std::string_view specification, const std::string& letters) {
  const auto variables = static_cast<int>(letters.size());
  const std::string listed = fmt::format("{} and {}", fmt::join(letters.substr(0, letters.size() - 1), ", "),
                                         letters.back());
  const std::string usage = fmt::format("mask:[{1},0,-{0}-3*{1},0,1/2+{0}+2*{1},1,...]@-5", letters[0], letters[1]);
  if (specification.size() > max_text) fail({specification, 0}, fmt::format("at most {} characters", max_text));
  const Piece family = family_of(specification);
  if (family.text != "mask") fail(family, "a mask with several letters, " + usage);
  const Piece body = body_of(specification);
  const auto [list, rest] = list_and_rest(body, usage.c_str());
  std::vector<MultivariatePolynomial> coefficients;
  for (const Piece& entry : read_list(list, ',')) {
    std::string in_xy(entry.text);
    for (std::size_t i = 0; i < in_xy.size(); ++i) {
      if (!is_letter(in_xy[i])) continue;
      const std::size_t letter = letters.find(in_xy[i]);
      if (letter == std::string::npos) fail({entry.text.substr(i, 1), entry.at + i}, "the letters " + listed);
      in_xy[i] = text::variable_names(variables)[letter].front();
    }
    try {
      coefficients.push_back(MultivariatePolynomial::parse(in_xy, variables));
    } catch (const ParseError& error) {
      throw SpecificationError(error.token(), entry.at + error.position(),
                               fmt::format("a sum of terms c*{}^i*{}^j with exact numbers c", letters[0], letters[1]));
    }
    const MultivariatePolynomial& c = coefficients.back();
    for (std::size_t v = 0; v < letters.size(); ++v)
      if (!c.is_zero() && (c.lowest()[v] < 0 || c.highest()[v] > max_degree))
        fail(entry, fmt::format("powers from 0 to {}", max_degree));
  }
  if (static_cast<long>(coefficients.size()) > max_coefficients)
    fail(list, fmt::format("at most {} coefficients", max_coefficients));
  const auto [scale, first_index, arity, fields] = read_tail(family, rest, coefficients.size(), usage);
  fields.finish();

  Powers<LaurentPolynomial> powers{std::vector<std::size_t>(letters.size(), 1), {}};
  for (const MultivariatePolynomial& c : coefficients)
    for (std::size_t v = 0; !c.is_zero() && v < letters.size(); ++v)
      powers.sizes[v] = std::max(powers.sizes[v], static_cast<std::size_t>(c.highest()[v]) + 1);
  std::size_t count = 1;
  for (const std::size_t size : powers.sizes) count *= size;
  powers.entries.resize(count);
  std::vector<MultivariatePolynomial> sums(static_cast<std::size_t>(arity), MultivariatePolynomial(variables));
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    const long place = first_index + static_cast<long>(k);
    sums[static_cast<std::size_t>(modulo(place, arity))] += coefficients[k];
    for (const auto& term : coefficients[k].terms()) {
      std::size_t at = 0;
      for (std::size_t v = letters.size(); v-- > 0;)
        at = at * powers.sizes[v] + static_cast<std::size_t>(term.exponents[v]);
      powers.entries[at] += LaurentPolynomial::monomial(term.coefficient * scale, place);
    }
  }
  for (std::size_t residue = 0; residue < sums.size(); ++residue)
    if (!(sums[residue] == MultivariatePolynomial(variables, 1 / scale)))
      fail(list, fmt::format("coefficients that sum to 1 over each residue class for all values; the class {} mod {} "
                             "does not",
                             residue, arity));
  return {std::move(powers), arity, Powers<Rational>{std::vector<std::size_t>(letters.size(), 1), {1}}};
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
