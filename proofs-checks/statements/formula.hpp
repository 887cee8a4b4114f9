#pragma once
/// Closed forms as papers print them: exact expressions in named variables, read from text.

#include <subcert/analysis/symbol/numbers/numbers.hpp>
#include <subcert/analysis/symbol/polynomials/multivariate_polynomial.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace subcert::statements {

/// A form without a value where it is asked for one: a division by zero, a singular system.
struct Undefined : Error {
  explicit Undefined(const std::string& what) : Error(ErrorKind::domain, what) {}
};

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

/// An expression in +, -, *, /, ^ and brackets over names and non-negative decimal numbers. A name is letters,
/// perhaps with digits behind them for an index. Immutable.
class Formula {
 public:
  struct Node;

  /// Reads `(6*j - 3)/(8*n^2 - 2)`. Multiplication is written out; `^` takes a single name, number or bracket; a minus
  /// in front binds less than `^`. Errors: throws ParseError. Domain: at most 10,000 characters, 100 nested brackets.
  static Formula parse(std::string_view text);

  /// The value. Errors: throws Undefined for a division by zero and for an exponent that is not an integer of modulus
  /// at most 1000, a domain error for a name without value.
  Rational operator()(const Values& values) const;

  /// The expression is a quotient of two polynomials in these variables together with at most these total degrees,
  /// whatever the other variables are. Nothing is cancelled. Domain: exponents are constants. Errors: throws
  /// Undefined otherwise.
  Degrees degrees(const std::vector<std::string>& variables) const;
  Degrees degrees(const std::string& variable) const { return degrees(std::vector<std::string>{variable}); }

  /// The expression with every name replaced by a polynomial. Domain: constant exponents. Errors: as operator().
  Fraction substituted(const std::vector<std::pair<std::string, MultivariatePolynomial>>& values) const;

  /// The expression with the name replaced by another expression.
  Formula replaced(const std::string& name, const Formula& by) const;

  friend Formula operator+(const Formula& a, const Formula& b) { return joined('+', a, b); }
  friend Formula operator-(const Formula& a, const Formula& b) { return joined('-', a, b); }
  friend Formula operator*(const Formula& a, const Formula& b) { return joined('*', a, b); }
  friend Formula operator/(const Formula& a, const Formula& b) { return joined('/', a, b); }

  /// For `$...$`: fractions set as \frac, names of several letters as commands, digits as indices.
  std::string to_latex() const;

 private:
  explicit Formula(std::shared_ptr<const Node> root) : root_(std::move(root)) {}
  static Formula joined(char kind, const Formula& a, const Formula& b);

  std::shared_ptr<const Node> root_;
};

/// Formula::parse, short, as transcriptions are full of it.
inline Formula f(std::string_view text) { return Formula::parse(text); }

}  // namespace subcert::statements
