#pragma once
/// Closed forms as papers print them: exact expressions in named variables, read from text.

#include <subcert/analysis/symbol/multivariate_polynomial.hpp>
#include <subcert/analysis/symbol/numbers.hpp>

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace subcert::statements {

/// Values of variables.
using Values = std::vector<std::pair<std::string, Rational>>;

/// `n = 2, r = -1`.
std::string to_text(const Values& values);

/// Bounds for the degrees of a numerator and a denominator.
struct Degrees {
  long numerator;
  long denominator;
};

/// numerator / denominator, not in lowest terms.
struct Fraction {
  MultivariatePolynomial numerator;
  MultivariatePolynomial denominator;
};

/// An expression in +, -, *, /, ^ and brackets over names and non-negative decimal numbers. Immutable.
class Formula {
 public:
  struct Node;

  /// Reads `(6*j - 3)/(8*n^2 - 2)`. Multiplication is written out; `^` takes a single name, number or bracket; a minus
  /// in front binds less than `^`. Errors: throws ParseError. Domain: at most 10,000 characters, 100 nested brackets.
  static Formula parse(std::string_view text);

  /// The value. Errors: throws std::domain_error for a division by zero and for an exponent that is not an integer of
  /// modulus at most 1000, std::out_of_range for a name without value.
  Rational operator()(const Values& values) const;

  /// The expression is a quotient of two polynomials in this variable with at most these degrees, whatever the other
  /// variables are. Nothing is cancelled. Domain: exponents are constants. Errors: throws std::domain_error otherwise.
  Degrees degrees(const std::string& variable) const;

  /// The expression with every name replaced by a polynomial. Domain: constant exponents. Errors: as operator().
  Fraction substituted(const std::vector<std::pair<std::string, MultivariatePolynomial>>& values) const;

  /// For `$...$`: fractions set as \frac, names of several letters as commands.
  std::string to_latex() const;

 private:
  explicit Formula(std::shared_ptr<const Node> root) : root_(std::move(root)) {}
  std::shared_ptr<const Node> root_;
};

}  // namespace subcert::statements
