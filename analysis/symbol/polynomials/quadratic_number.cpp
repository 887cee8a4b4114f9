#include "quadratic_number.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>
#include "expression.hpp"
#include "rational_function.hpp"

#include <algorithm>
#include <cctype>

namespace subcert {
namespace {

constexpr std::string_view head = "sqrt(";
constexpr std::size_t most_digits = 9;

[[noreturn]] void fail(std::string_view token, std::size_t at, const std::string& expected) {
  throw ParseError("number", token, at + 1, expected);
}

/// sqrt(number) = factor * sqrt(root), without square factors in the root; 1 for the root of a square.
struct Root {
  long factor, root;
};
Root root_of(long number) {
  Root result{1, number};
  for (long f = 2; f * f <= result.root; ++f)
    for (; result.root % (f * f) == 0; result.root /= f * f) result.factor *= f;
  return result;
}

/// p at the root of a number, in powers of it.
QuadraticNumber at_root(const LaurentPolynomial& p, long root) {
  QuadraticNumber result{0, 0, root};
  for (long k = 0; !p.is_zero() && k <= p.highest(); ++k)
    (k % 2 == 0 ? result.rational : result.multiple) += p.coefficient(k) * power(Rational(root), k / 2);
  return result;
}

QuadraticNumber canonical(QuadraticNumber number) {
  if (number.multiple == 0) number.root = 0;
  return number;
}

}  // namespace

QuadraticNumber operator/(const QuadraticNumber& a, const QuadraticNumber& b) {
  const long root = std::max(a.root, b.root);
  const Rational norm = b.rational * b.rational - root * b.multiple * b.multiple;
  return canonical({(a.rational * b.rational - root * a.multiple * b.multiple) / norm,
                    (a.multiple * b.rational - a.rational * b.multiple) / norm, root});
}

QuadraticNumber QuadraticNumber::parse(std::string_view text, long root) {
  if (text.find(head) == std::string_view::npos) {
    const auto value = parse_constant(text);
    if (!value) throw ParseError("mask", text, 1, "an exact number p, p/q with q > 0, a decimal, or a sum of such");
    return {*value};
  }
  // Each root becomes a multiple of a letter, as long as its text, so that places stay the same.
  std::string lettered(text);
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (!text.substr(at).starts_with(head)) {
      if (std::isalpha(static_cast<unsigned char>(text[at])) != 0)
        fail(text, 0, "sums, products and quotients of whole numbers and sqrt(7)");
      continue;
    }
    const std::size_t begin = at + head.size(), end = std::min(text.find(')', begin), text.size());
    const std::string_view digits = text.substr(begin, end - begin),
                           token = text.substr(at, std::min(end + 1, text.size()) - at);
    const bool is_number = end < text.size() && !digits.empty() && digits.size() <= most_digits &&
                           std::ranges::all_of(digits, [](unsigned char c) { return std::isdigit(c) != 0; });
    const Root found = is_number ? root_of(std::stol(std::string(digits))) : Root{0, 0};
    if (found.root == 0) fail(token, at, "sqrt(N) with a whole number N from 1 to 10^9");
    if (found.root > 1 && root > 1 && found.root != root)
      fail(token, at, "one square root in all entries, here multiples of sqrt(" + std::to_string(root) + ")");
    if (found.root > 1) root = found.root;
    std::string factor = std::to_string(found.factor);
    const std::string end_text = found.root > 1 ? "*t)" : ")";
    factor.insert(0, token.size() - 1 - end_text.size() - factor.size(), '0');
    lettered.replace(at, token.size(), "(" + factor + end_text);
    at = end;
  }
  const RationalFunction function = RationalFunction::parse(lettered, "t");
  const QuadraticNumber below = at_root(function.denominator(), root);
  if (below.is_zero()) fail(text, 0, "a denominator that is not zero");
  return at_root(function.numerator(), root) / below;
}

std::string QuadraticNumber::to_text() const {
  if (multiple == 0) return subcert::to_text(rational);
  const std::string square_root = "sqrt(" + std::to_string(root) + ")";
  const std::string part = abs(multiple) == 1 ? (multiple < 0 ? "-" : "") + square_root
                                              : subcert::to_text(multiple) + "*" + square_root;
  return rational == 0 ? part : subcert::to_text(rational) + (multiple < 0 ? "" : "+") + part;
}

}  // namespace subcert
