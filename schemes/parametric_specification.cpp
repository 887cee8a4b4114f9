// Families with a parameter: masks with a letter where a number may stand.
#include "parametric_specification.hpp"

#include "classical.hpp"
#include "parameter_names.hpp"
#include "plain_text.hpp"
#include "regression_text.hpp"
#include "vector_schemes.hpp"

#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>
#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/polynomials/expression.hpp>
#include <subcert/analysis/symbol/polynomials/real_roots.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/utf8.hpp>

#include <fmt/ranges.h>

#include <algorithm>
#include <map>

namespace subcert {
namespace {

using namespace specification_text;

constexpr long max_degree = 12, max_coefficients = 100, max_matrix_entries = 400;
constexpr long algebraic_bits = 1500;    // of a number that stands for an algebraic one
constexpr long max_symbolic_work = 500;  // points * d^2 of a regression: its fractions are long
constexpr const char* mask_usage = "mask:[-w,0,1/2+w,1,1/2+w,0,-w]@-3,arity=2";
constexpr const char* matrices_usage = "refinable:[[[1,0],[w,1]],[[2,1],[0,1]]]/2@0";
constexpr const char* merrien_usage = "merrien:lambda=-1/8,mu";
constexpr const char* regression_usage = "regression:stencils=[-1..1;-1..2],at=[0;1/2],d=1,weights=[w;1;w|w;1;1;w]";

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

/// A mask with letters in its coefficients, or in the entries of its matrices, row by row.
struct LetterMask {
  std::vector<LetterFunction> coefficients;
  long first;
  int arity;
  std::string letters;
  Piece list;  ///< of the coefficients
  Fields fields;
  std::size_t components = 1;
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
  const auto entries = form_of(family.text) ? text::Entries::matrices : text::Entries::numbers;
  const bool matrices = entries == text::Entries::matrices;
  auto [mask, fields] = split_mask(family, body, usage, 1, matrices ? max_matrix_entries : max_coefficients);
  auto parts = placed(mask,
                      [&mask = mask, &letters, entries] { return text::parse_mask_text(mask.text, letters, entries); });
  const std::size_t components = matrices ? read_components(parts, mask) : 1;
  const int arity = static_cast<int>(read_arity(fields));
  const Piece list{mask.text.substr(0, mask.text.rfind(']') + 1), mask.at};
  if (std::ranges::all_of(parts.coefficients, &LetterFunction::is_zero))
    fail(list, "at least one coefficient that is not zero");
  const long first = parts.first ? parts.first->front() : -static_cast<long>(parts.sizes.back() / 2);
  return {std::move(parts.coefficients), first, arity, letters, list, std::move(fields), components};
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

/// Nothing is asked of the sums of matrices. They come as they are typed.
ParametricMask checked_mask(const LetterMask& text) {
  ParametricMask mask(text.coefficients, text.first, text.arity, text.components);
  require_size(mask, text.list);
  if (text.components == 1) require_sums(text, "all");
  return mask;
}

ParametricScheme make_matrices(VectorForm form, const Piece& family, const Piece& body, char letter,
                               const std::string& name) {
  const LetterMask text = read_letter_mask(family, body, std::string(1, letter), matrices_usage);
  text.fields.finish();
  ParametricMask typed = checked_mask(text);
  return {fmt::format("{}:{}{}", family.text, with_name(typed.to_text(letter), letter, name),
                      text.arity == 2 ? "" : fmt::format(",arity={}", text.arity)),
          "matrices with the parameter " + name,
          letter,
          name,
          form == VectorForm::refinable ? std::move(typed) : transposed(typed),
          form};
}

ParametricScheme make_mask(const Piece& family, const Piece& body, char letter, const std::string& name) {
  const LetterMask text = read_letter_mask(family, body, std::string(1, letter), mask_usage);
  text.fields.finish();
  ParametricMask mask = checked_mask(text);
  const std::string printed = with_name(mask.to_text(letter), letter, name);
  return {"mask:" + printed + (text.arity == 2 ? "" : ",arity=" + std::to_string(text.arity)),
          "mask with the parameter " + name, letter, name, std::move(mask)};
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

ParametricScheme make_regression(const Piece& family, const Piece& body, char parameter, const std::string& name) {
  Fields fields(family, body, regression_usage);
  const auto number = [=](const Piece& piece) { return read_function(piece, parameter); };
  const auto weight = [=](const Piece& piece) {
    RationalFunction value = read_function(piece, parameter);
    if (value.numerator().is_zero() || (value.is_polynomial() && value.numerator().highest() == 0 && value(0) < 0))
      fail(piece, "a weight > 0");
    return value;
  };
  const auto [scheme, text, points, digits, stencils] = read_regression<RationalFunction>(
      fields, number, weight,
      [&](const RationalFunction& value) { return with_name(value.to_text(parameter), parameter, name); });
  fields.finish();
  const long effective = std::min<long>(scheme.degree, points - 1);
  if (points * std::max(1L, effective * effective) > max_symbolic_work)
    fail(stencils, fmt::format("points * d^2 <= {} with a parameter", max_symbolic_work));
  ParametricMask mask = parametric_regression_mask(scheme);
  require_size(mask, stencils);
  return {text, fmt::format("local regression of degree {} with the parameter {}", scheme.degree, name), parameter,
          name, std::move(mask)};
}

}  // namespace

Scheme specification_text::make_algebraic_mask(const Piece& family, const Piece& body) {
  const std::string name = read_parameter(family, body, algebraic_usage);
  if (name.size() > 1) fail(body, "one letter for the number, as t in " + std::string(algebraic_usage));
  const char letter = name.front();
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
  const Rational value = number.value.is_exact() ? low : to_multiple(low, unit, Rounding::nearest);
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
  const bool symmetric = std::equal(text.coefficients.begin(), text.coefficients.end(), text.coefficients.rbegin());
  if (distance > 0) {
    scheme.rounding = {power(Rational(2), binary_exponent(distance) + 1), sum_rules(mask), symmetric};
    scheme.algebraic = {mask, number.polynomial};
  }
  return scheme;
}

namespace {

const ClassicalFamily* classical_family(std::string_view name) {
  const auto& families = classical_families();
  const auto found = std::ranges::find(families, name, &ClassicalFamily::name);
  return found == families.end() ? nullptr : &*found;
}

bool has_letters(std::string_view family) {
  return family == "mask" || family == "symbol" || family == "regression" || form_of(family);
}

bool is_name(std::string_view text) { return !text.empty() && std::ranges::all_of(text, is_letter); }

/// The matrices that `merrien:lambda=-1/8,mu` stands for, typed; a key alone is its own value.
/// Other specifications as they are.
std::string typed_out(std::string_view specification) {
  const Piece family = family_of(specification), body = body_of(specification);
  if (family.text != "merrien") return std::string(specification);
  std::map<std::string_view, std::string_view> values;
  for (const Piece& field : split(body, ',')) {
    const std::size_t equals = std::min(field.text.find('='), field.text.size());
    const Piece key = trimmed({field.text.substr(0, equals), field.at});
    if (key.text != "lambda" && key.text != "mu") fail(key, std::string("a key of ") + merrien_usage);
    const std::string_view value = equals < field.text.size() ? field.text.substr(equals + 1) : key.text;
    if (!values.emplace(key.text, value).second) fail(key, "each key once");
  }
  if (values.size() < 2) fail(family, std::string("the keys lambda and mu, as in ") + merrien_usage);
  return merrien_matrices(values["lambda"], values["mu"]);
}

/// A specification with one letter for the parameter.
struct Lettered {
  std::string specification;
  std::string name;
  char letter;

  /// `, where m is mu`, or nothing.
  std::string meaning() const { return name.size() > 1 ? fmt::format(", where {} is {}", letter, name) : ""; }
};

Lettered in_one_letter_of(std::string_view specification) {
  const Piece family = family_of(specification), body = body_of(specification);
  if (const std::string typed = typed_out(specification); typed != specification)
    return read_as(specification, typed, "", in_one_letter_of);
  if (const ClassicalFamily* classical = classical_family(family.text)) {
    if (!is_name(body.text)) fail(body, "a letter for the parameter, as in " + classical->name + ":w");
    return {std::string(specification), std::string(body.text), letters_for({std::string(body.text)}).front()};
  }
  if (!has_letters(family.text)) {
    const auto& surfaces = multivariate_families();
    if (std::ranges::any_of(surfaces, [&](const FamilyHelp& one) { return one.family == family.text; }))
      fail(family, "a family of curves: of surfaces values are answered one by one, as by subcert sweep");
    std::string names = fmt::format(" or {} or {} or {}", regression_usage, matrices_usage, merrien_usage);
    for (const ClassicalFamily& one : classical_families()) names += " or " + one.name + ":w";
    fail(family, std::string("a family of curves with a parameter: ") + mask_usage + names);
  }
  const std::string name = read_parameter(family, body,
                                          family.text == "regression" ? regression_usage
                                          : form_of(family.text)      ? matrices_usage
                                                                      : mask_usage);
  const std::string letter = letters_for({name});
  return {replaced(specification, names_inside(family, body), {name}, letter), name, letter.front()};
}

}  // namespace

std::string ParametricScheme::named(const std::string& expression) const { return with_name(expression, letter, name); }

ParametricScheme make_parametric_scheme(std::string_view text) {
  const Lettered lettered = from_written(text, in_one_letter_of);
  ParametricScheme scheme = read_as(
      text, lettered.specification, lettered.meaning(), [&](std::string_view specification) {
        const Piece family = family_of(specification), body = body_of(specification);
        const auto& [read, name, letter] = lettered;
        if (const ClassicalFamily* classical = classical_family(family.text))
          return ParametricScheme{classical->name + ":" + name, classical->title + " " + name, letter, name,
                                  classical->mask()};
        if (const auto form = form_of(family.text)) return make_matrices(*form, family, body, letter, name);
        return family.text == "regression" ? make_regression(family, body, letter, name)
                                           : make_mask(family, body, letter, name);
      });
  std::string written = specification_as_written(text);
  if (typed_out(written) != written) {
    std::erase(written, ' ');
    scheme.specification = written;
    scheme.title = "Merrien's Hermite scheme with the parameter " + scheme.name;
  }
  return scheme;
}

bool has_parameter(std::string_view text) {
  const std::string specification = typed_out(specification_as_written(text));
  const Piece family = family_of(specification), body = body_of(specification);
  if (body.text.find(",where=") != std::string_view::npos) return false;
  if (form_of(family.text) && body.text.find("sqrt(") != std::string_view::npos) return false;
  if (has_letters(family.text)) return !names_inside(family, body).empty();
  return is_name(body.text) && classical_family(family.text) != nullptr;
}

std::pair<std::string, std::string> in_letters(std::string_view specification, const std::vector<std::string>& names) {
  const std::string letters = letters_for(names), written = typed_out(specification_as_written(specification));
  return {replaced(written, names_inside(family_of(written), body_of(written)), names, letters), letters};
}

ParametricMask make_parametric_mask(std::string_view specification, const std::string& letters) {
  const std::string usage = fmt::format("mask:[{1},0,-{0}-3*{1},0,1/2+{0}+2*{1},1,...]@-5", letters[0], letters[1]);
  return from_written(specification, [&](std::string_view read) {
    const Piece family = family_of(read);
    const auto form = form_of(family.text);
    if (family.text != "mask" && family.text != "symbol" && !form)
      fail(family, fmt::format("a mask with several letters, {}, or {}, or merrien:lambda,mu", usage, matrices_usage));
    const LetterMask text = read_letter_mask(family, body_of(read), letters, usage);
    text.fields.finish();
    ParametricMask typed = checked_mask(text);
    return form && *form != VectorForm::refinable ? transposed(typed) : typed;
  });
}

std::optional<ParameterRange> parse_parameter_range(std::string text, std::string_view name) {
  text = plain_text(text);
  std::erase(text, ' ');
  const std::size_t at = text.find(name);
  if (at == std::string::npos || text.size() > 1000) return std::nullopt;
  std::string_view low = std::string_view(text).substr(0, at), high = std::string_view(text).substr(at + name.size());
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
