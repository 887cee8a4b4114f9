#include "exponent_formula.hpp"

#include <subcert/analysis/radii/joint/named_radius.hpp>
#include <subcert/analysis/symbol/polynomials/quadratic_number.hpp>
#include <subcert/analysis/symbol/polynomials/real_roots.hpp>
#include <subcert/reports/formats/paper_text.hpp>

#include <fmt/format.h>

namespace subcert::facts {
namespace {

constexpr int digits_of_zero = 13;
constexpr std::size_t longest_polynomial = 100;  // of a polynomial that is read
const Rational largest_square = 999'999'999;

/// The real zero of a polynomial of degree 2 next to the point; empty where the number below the root is too long.
std::string with_root(const AttainedNumber& number) {
  const LaurentPolynomial& p = number.polynomial;
  if (p.highest() != 2 || number.point.im != 0) return "";
  const Rational b = p.coefficient(1), a = 2 * p.coefficient(2), square = b * b - 2 * a * p.coefficient(0);
  if (square > largest_square) return "";
  const bool above = (number.point.re * a + b > 0);
  return QuadraticNumber::parse(
             fmt::format("({}{}sqrt({}))/({})", to_text(Rational(-b)), above ? "+" : "-", to_text(square), to_text(a)))
      .to_text();
}

/// `1+sqrt(3)`
std::string latex_of_root(std::string text) {
  constexpr std::string_view head = "sqrt(";
  const std::size_t at = text.find(head), end = text.find(')', at);
  return formats::latex_formula(text.substr(0, at)) + "\\sqrt{" +
         text.substr(at + head.size(), end - at - head.size()) + "}";
}

/// `r^2-2*r-2`
std::string polynomial_in_r(const LaurentPolynomial& p) {
  std::string text;
  for (long k = p.highest(); k >= 0; --k) {
    const Rational c = p.coefficient(k);
    if (c == 0) continue;
    const std::string power = k == 0 ? "" : k == 1 ? "r" : fmt::format("r^{}", k);
    const bool one = abs(c) == 1 && k > 0;
    text += (c < 0 ? "-" : text.empty() ? "" : "+") + (one ? "" : to_text(abs(c)) + (k > 0 ? "*" : "")) + power;
  }
  return text;
}

std::string decimals(const RationalComplex& z) {
  std::string text = to_decimal(z.re, digits_of_zero, Rounding::nearest);
  if (z.im != 0) text += fmt::format("{}{}i", z.im > 0 ? "+" : "", to_decimal(z.im, digits_of_zero, Rounding::nearest));
  return text;
}

std::optional<ExponentFormula> formula_of(const std::optional<NamedExponent>& exponent) {
  if (!exponent) return std::nullopt;
  ExponentFormula formula(*exponent);
  return formula.is_short() ? std::optional(std::move(formula)) : std::nullopt;
}

}  // namespace

ExponentFormula::ExponentFormula(NamedExponent exponent)
    : exponent_(std::move(exponent)),
      rational_(zero_of_linear(exponent_.radius.polynomial)),
      root_(with_root(exponent_.radius)) {}

/// In front of the logarithm: `2 - `, `-3*`.
std::string ExponentFormula::factor(const char* dot) const {
  const auto& [rules, base, dimension, radius] = exponent_;
  return (rules == 0 ? "-" : fmt::format("{} - ", rules)) + (dimension == 1 ? "" : fmt::format("{}{}", dimension, dot));
}

/// Whose root is meant.
std::string ExponentFormula::number() const {
  return rational_ ? to_text(*rational_) : !root_.empty() ? root_ : exponent_.radius.point.im == 0 ? "r" : "|r|";
}

/// What r is, where it has to be said.
std::string ExponentFormula::equation() const {
  if (rational_ || !root_.empty()) return "";
  const AttainedNumber& radius = exponent_.radius;
  return fmt::format(", {} = 0, r = {}", polynomial_in_r(radius.polynomial), decimals(radius.point));
}

std::string ExponentFormula::text() const {
  std::string text = fmt::format("{}log_{}({})", factor("*"), exponent_.base, number());
  if (exponent_.radius.length > 1) text += fmt::format("/{}", exponent_.radius.length);
  return text + equation();
}

std::string ExponentFormula::text_of_radius() const {
  const std::size_t length = exponent_.radius.length;
  return (length == 1 ? number() : fmt::format("({})^(1/{})", number(), length)) + equation();
}

std::string ExponentFormula::latex() const {
  const AttainedNumber& radius = exponent_.radius;
  const std::string number = rational_              ? formats::latex_formula(to_text(*rational_))
                             : !root_.empty()       ? "\\left(" + latex_of_root(root_) + "\\right)"
                             : radius.point.im == 0 ? "r"
                                                    : "|r|";
  return factor("\\,") + (radius.length > 1 ? fmt::format("\\tfrac{{1}}{{{}}} ", radius.length) : "") +
         fmt::format("\\log_{{{}}} {}", exponent_.base, number);
}

std::string ExponentFormula::latex_of_zero() const {
  if (rational_ || !root_.empty()) return "";
  const AttainedNumber& radius = exponent_.radius;
  return fmt::format(", \\quad {} = 0, \\; r \\approx {}", formats::latex_formula(polynomial_in_r(radius.polynomial)),
                     decimals(radius.point));
}

Json ExponentFormula::json() const {
  const AttainedNumber& radius = exponent_.radius;
  Json polynomial = Json::array();
  for (long k = 0; k <= radius.polynomial.highest(); ++k)
    polynomial.push_back(to_text(radius.polynomial.coefficient(k)));
  return {{"polynomial", polynomial}, {"zero", decimals(radius.point)}, {"root", radius.length}};
}

bool ExponentFormula::is_short() const {
  return rational_ || !root_.empty() || polynomial_in_r(exponent_.radius.polynomial).size() <= longest_polynomial;
}

std::optional<ExponentFormula> exponent_formula(const Scheme& scheme, const Regularity& regularity) {
  if (scheme.rounding && !scheme.algebraic) return std::nullopt;
  return formula_of(named_exponent(scheme.mask, regularity, scheme.algebraic));
}

std::optional<ExponentFormula> exponent_formula(const ExponentOfList& found) {
  return formula_of(named_exponent(found));
}

Facts radius_formula_facts(const MatrixFamily& family, const JointSpectralRadius& radius) {
  const auto number = named_radius(family, radius, largest_named_degree);
  const auto formula = number ? formula_of(NamedExponent{0, 2, 1, *number}) : std::nullopt;
  if (!formula) return formula_facts(formula);
  const std::string text = formula->text_of_radius();
  const bool whole = text.find_first_not_of("0123456789") == std::string::npos;
  return {whole ? member("formula", text) : plain("formula", "formula", text),
          member("radius_number", formula->json())};
}

Facts formula_facts(const std::optional<ExponentFormula>& formula) {
  if (!formula) return {member("formula", nullptr), member("radius_number", nullptr)};
  return {plain("formula", "formula", formula->text()), member("radius_number", formula->json())};
}

}  // namespace subcert::facts
