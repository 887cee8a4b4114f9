#pragma once
/// Exponents in closed form.

#include "fact.hpp"

#include <subcert/analysis/family/named_exponent.hpp>
#include <subcert/schemes/specification.hpp>

#include <optional>
#include <string>

namespace subcert::facts {

/// The exponent in closed form: rules - log_arity(radius), the radius by what it is a zero of where no roots say it.
class ExponentFormula {
 public:
  explicit ExponentFormula(NamedExponent exponent);

  std::string text() const;   ///< `3 - log_2(3)`, `2 - log_2(1+sqrt(3))`, `3 - log_2(r)/2, r^3-r-1 = 0, r = 1.32`
  std::string latex() const;  ///< `3 - \log_{2} 3`
  /// Of the radius alone: `1/2+1/2*sqrt(5)`, `(3)^(1/2)`, `r, r^3-r-1 = 0, r = 1.32`.
  std::string text_of_radius() const;
  /// What stands behind it and its value: `\quad r^3-r-1 = 0`, or nothing.
  std::string latex_of_zero() const;
  Json json() const;  ///< the polynomial from the constant on, its zero, and which root of its modulus is meant
  /// Whether it is of a length that people read.
  bool is_short() const;

 private:
  std::string factor(const char* dot) const;
  std::string number() const;
  std::string equation() const;

  NamedExponent exponent_;
  std::optional<Rational> rational_;
  std::string root_;  ///< with a square root, or else empty
};

/// Nothing where the exponent is rational, or there is no number of small degree that is known to be behind it.
std::optional<ExponentFormula> exponent_formula(const Scheme& scheme, const Regularity& regularity);
std::optional<ExponentFormula> exponent_formula(const ExponentOfList& found);

/// The radius of matrices in the same way, `formula` and `radius_number`: for programs alone where it is no number of
/// small degree that a product is proved to attain, or a whole one.
Facts radius_formula_facts(const MatrixFamily& family, const JointSpectralRadius& radius);

/// The formula and the number as facts, for programs alone where there is none.
Facts formula_facts(const std::optional<ExponentFormula>& formula);

}  // namespace subcert::facts
