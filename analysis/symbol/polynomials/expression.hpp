#pragma once
/// The one reader of expressions. Inner header.

#include "rational_function.hpp"

#include <optional>

namespace subcert {

/// sum = ['+'|'-'] product {('+'|'-') product}; product = power {['*'] power | '/' power}; power = atom ['^' integer];
/// atom = a number, a letter, or a sum in parentheses; powers may be negative. The star may be absent before letters
/// and parentheses; letters that follow a divisor without one belong to it behind parentheses, `(1+z)/4z`, stand beside
/// a fraction of numbers with a blank, `1/2 w`, and are refused elsewhere, `1/2w`. Domain: one to three letters,
/// `degree` in each. Errors: throws ParseError.
LetterFunction read_expression(std::string_view text, std::string_view letters, long degree);

/// The same where the value is a Laurent polynomial.
MultivariatePolynomial read_polynomial(std::string_view text, std::string_view letters, long degree);

/// The value of a sum, a product, ... of numbers, as `1/2-1/4`; nothing for another text, also for `1/2/3`, which could
/// mean two.
std::optional<Rational> parse_constant(std::string_view text);

/// A polynomial in one letter. Domain: one variable.
LaurentPolynomial in_one_letter(const MultivariatePolynomial& p);

}  // namespace subcert
