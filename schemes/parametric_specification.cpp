// Families with a parameter: masks with a letter where a number may stand.
#include "parametric_specification.hpp"

#include "classical.hpp"
#include "regression_text.hpp"

#include <subcert/analysis/symbol/decimal.hpp>
#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/symbol/expression.hpp>
#include <subcert/analysis/symbol/index_arithmetic.hpp>
#include <subcert/analysis/symbol/rational_matrix.hpp>
#include <subcert/analysis/symbol/real_roots.hpp>

#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <map>

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

/// The letters inside brackets and parentheses, or of a symbol all but z, each with its place.
std::vector<Piece> letters_inside(const Piece& family, const Piece& body) {
  if (family.text == "symbol") {
    const Piece expression = split(body, ',').front();
    std::vector<Piece> letters;
    for (std::size_t i = 0; i < expression.text.size(); ++i)
      if (is_letter(expression.text[i]) && expression.text[i] != 'z')
        letters.push_back({expression.text.substr(i, 1), expression.at + i});
    return letters;
  }
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
char read_parameter(const Piece& family, const Piece& body, const char* usage) {
  const std::vector<Piece> letters = letters_inside(family, body);
  if (letters.empty()) fail(body, std::string("a letter for the parameter, as in ") + usage);
  const char parameter = letters.front().text.front();
  for (const Piece& letter : letters)
    if (letter.text.front() != parameter) fail(letter, fmt::format("one letter for the parameter, here {}", parameter));
  return parameter;
}

RationalFunction read_function(const Piece& piece, char parameter) {
  return placed(piece, [&] { return RationalFunction::parse(piece.text, {&parameter, 1}); });
}

void require_size(const ParametricMask& mask, const Piece& piece) {
  const IndexRange range = mask.support();
  const auto sizes = mask.sizes();
  const auto degree = static_cast<long>(*std::ranges::max_element(sizes)) - 1;
  if (degree > max_degree || range.last - range.first >= max_coefficients)
    fail(piece, fmt::format("up to {} coefficients of degree up to {}, over their common denominator; here {} of "
                            "degree {}",
                            max_coefficients, max_degree, range.last - range.first + 1, degree));
}

/// A mask with letters in its coefficients.
struct LetterMask {
  std::vector<LetterFunction> coefficients;
  long first;
  int arity;
  std::string letters;
  Piece list;  ///< of the coefficients
  Fields fields;
};

/// `(1+z)^2(...)/16z^3,arity=2` with letters beside z.
LetterMask read_letter_symbol(const Piece& family, const Piece& body, const std::string& letters,
                              const std::string& usage) {
  auto [expression, fields] = split_symbol(family, body, usage);
  const LetterFunction symbol = placed(expression, [&expression = expression, &letters] {
    return LetterFunction::parse(expression.text, letters + "z");
  });
  if (symbol.is_zero()) fail(expression, "at least one coefficient that is not zero");
  // By powers of z.
  const auto parted = [&](const MultivariatePolynomial& p) {
    std::map<long, std::vector<Monomial>> parts;
    for (Monomial& term : p.terms()) {
      const long power = term.exponents.back();
      term.exponents.pop_back();
      parts[power].push_back(std::move(term));
    }
    return parts;
  };
  const auto above = parted(symbol.numerator()), below = parted(symbol.denominator());
  if (below.size() > 1) fail(expression, "a Laurent polynomial in z");
  const int variables = static_cast<int>(letters.size());
  const MultivariatePolynomial divisor(variables, below.begin()->second);
  const long first = above.begin()->first, last = above.rbegin()->first;
  std::vector<LetterFunction> coefficients(static_cast<std::size_t>(last - first + 1),
                                           MultivariatePolynomial(variables));
  for (const auto& [power, terms] : above)
    coefficients[static_cast<std::size_t>(power - first)] = {MultivariatePolynomial(variables, terms), divisor};
  const int arity = static_cast<int>(read_arity(fields));
  return {std::move(coefficients), first - below.begin()->first, arity, letters, expression, std::move(fields)};
}

/// `[...]/D@first,arity=2` and further keys, of which all behind the coefficients may be absent. A denominator in
/// parentheses may depend on the letters.
LetterMask read_letter_mask(const Piece& family, const Piece& body, const std::string& letters,
                            const std::string& usage) {
  if (family.text == "symbol") return read_letter_symbol(family, body, letters, usage);
  auto [mask, fields] = split_mask(family, body, usage, 1, max_coefficients);
  auto parts = placed(mask, [&mask = mask, &letters] { return text::parse_mask_text(mask.text, letters); });
  const int arity = static_cast<int>(read_arity(fields));
  const Piece list{mask.text.substr(0, mask.text.find(']') + 1), mask.at};
  if (std::ranges::all_of(parts.coefficients, &LetterFunction::is_zero))
    fail(list, "at least one coefficient that is not zero");
  const long first = parts.first ? parts.first->front() : -static_cast<long>(parts.coefficients.size() / 2);
  return {std::move(parts.coefficients), first, arity, letters, list, std::move(fields)};
}

/// `for all w` or `for this t`
void require_sums(const LetterMask& text, const std::string& values) {
  std::vector<LetterFunction> sums(static_cast<std::size_t>(text.arity),
                                   MultivariatePolynomial(static_cast<int>(text.letters.size())));
  for (std::size_t k = 0; k < text.coefficients.size(); ++k)
    sums[static_cast<std::size_t>(modulo(text.first + static_cast<long>(k), text.arity))] += text.coefficients[k];
  for (std::size_t residue = 0; residue < sums.size(); ++residue)
    if (const LetterFunction& sum = sums[residue]; !(sum.is_polynomial() && sum.numerator() == sum.denominator()))
      fail(text.list,
           fmt::format("coefficients that sum to 1 over each residue class for {} {}; the class {} mod {} "
                       "sums to {}",
                       values, fmt::join(text.letters, ", "), residue, text.arity, sum.to_text(text.letters)));
}

ParametricMask checked_mask(const LetterMask& text) {
  ParametricMask mask(text.coefficients, text.first, text.arity);
  require_size(mask, text.list);
  require_sums(text, "all");
  return mask;
}

ParametricScheme make_mask(const Piece& family, const Piece& body) {
  const char letter = read_parameter(family, body, mask_usage);
  const LetterMask text = read_letter_mask(family, body, std::string(1, letter), mask_usage);
  text.fields.finish();
  ParametricMask mask = checked_mask(text);
  const std::string printed = mask.to_text(letter);
  return {"mask:" + printed + (text.arity == 2 ? "" : ",arity=" + std::to_string(text.arity)),
          fmt::format("mask with the parameter {}", letter), letter, std::move(mask)};
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
  const char parameter = read_parameter(family, body, regression_usage);
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
  const char letter = read_parameter(family, body, algebraic_usage);
  LetterMask text = read_letter_mask(family, body, std::string(1, letter), algebraic_usage);
  const AlgebraicNumber number = read_number(text.fields.required("where"), letter);
  text.fields.finish();
  // Powers of the number below the degree of its polynomial are independent over the rationals: what holds for the
  // coefficients modulo the polynomial holds for all numbers in place of this one, sum rules too.
  for (LetterFunction& c : text.coefficients) {
    if (!c.is_polynomial()) fail(text.list, fmt::format("coefficients that are polynomials in {}", letter));
    c = MultivariatePolynomial::in_variable(1, 0, remainder(in_one_letter(c.numerator()), number.polynomial));
  }
  require_sums(text, "this");
  const ParametricMask mask(text.coefficients, text.first, text.arity);
  const std::string arity = text.arity == 2 ? "" : ",arity=" + std::to_string(text.arity);
  const Rational unit = power(Rational(2), -algebraic_bits), &low = *number.value.lower, &high = *number.value.upper;
  const Rational value = number.value.is_exact() ? low : unit * Rational(to_integer(low / unit, Rounding::nearest));
  Scheme scheme{
      fmt::format("mask:{}{},where={}:{}..{}", mask.to_text(letter), arity,
                  RationalFunction(number.polynomial).to_text(letter), to_text(number.low), to_text(number.high)),
      "mask given by its coefficients, rounded", mask.at(value)};
  if (number.value.is_exact()) return scheme;
  // |t^k - v^k| <= k |t - v| max(|t|, |v|)^(k-1)
  const Rational away = high - low + unit, most = std::max(abs(low), abs(high)) + unit;
  Rational distance = 0;
  for (const LetterFunction& c : text.coefficients) {
    Rational slope = 0;
    for (const Monomial& term : c.numerator().terms())
      if (const long k = term.exponents.front(); k > 0) slope += abs(term.coefficient) * k * power(most, k - 1);
    distance = std::max(distance, Rational(slope * away));
  }
  if (distance > 0) scheme.rounding = {power(Rational(2), binary_exponent(distance) + 1), sum_rules(mask)};
  return scheme;
}

namespace {

ParametricScheme parametric_scheme_of(std::string_view specification) {
  const Piece family = family_of(specification);
  const Piece body = body_of(specification);
  if (family.text == "mask" || family.text == "symbol") return make_mask(family, body);
  if (family.text == "regression") return make_regression(family, body);
  std::string names = std::string(" or ") + regression_usage;
  for (const ClassicalFamily& classical : classical_families()) {
    if (family.text == classical.name) return make_classical(classical, body);
    names += " or " + classical.name + ":w";
  }
  fail(family, std::string("a family with a parameter: ") + mask_usage + names);
}

}  // namespace

ParametricScheme make_parametric_scheme(std::string_view specification) {
  return from_written(specification, parametric_scheme_of);
}

bool has_parameter(std::string_view text) {
  const std::string specification = specification_as_written(text);
  const std::string_view family = family_of(specification).text;
  const Piece body = body_of(specification);
  if (body.text.find(",where=") != std::string_view::npos) return false;
  if (family == "mask" || family == "regression" || family == "symbol")
    return !letters_inside(family_of(specification), body).empty();
  const auto& families = classical_families();
  return body.text.size() == 1 && is_letter(body.text.front()) &&
         std::any_of(families.begin(), families.end(), [&](const ClassicalFamily& one) { return one.name == family; });
}

ParametricMask make_parametric_mask(std::string_view specification, const std::string& letters) {
  const std::string usage = fmt::format("mask:[{1},0,-{0}-3*{1},0,1/2+{0}+2*{1},1,...]@-5", letters[0], letters[1]);
  return from_written(specification, [&](std::string_view read) {
    const Piece family = family_of(read);
    if (family.text != "mask" && family.text != "symbol") fail(family, "a mask with several letters, " + usage);
    const LetterMask text = read_letter_mask(family, body_of(read), letters, usage);
    text.fields.finish();
    return checked_mask(text);
  });
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
