#include "rational_function.hpp"

#include "decimal.hpp"
#include "parse_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <tuple>
#include <utility>

namespace subcert {
namespace {

constexpr long max_degree = 64, max_depth = 50;
constexpr unsigned max_bits = 20'000;  // of a coefficient

/// p and q without what both have in common.
std::pair<LaurentPolynomial, LaurentPolynomial> reduced(LaurentPolynomial p, LaurentPolynomial q) {
  if (p.is_zero()) return {std::move(p), 1};
  // The gcd leaves out powers of w.
  const long power = -std::min(p.lowest(), q.lowest());
  p = p.shifted(power);
  q = q.shifted(power);
  if (q.length() > 1) {
    const LaurentPolynomial common = gcd(p, q);
    p = *p.exact_quotient(common);
    q = *q.exact_quotient(common);
  }
  Integer content = 0;
  for (const Integer& c : q.numerators()) content = gcd(content, c);
  Rational unit(q.denominator(), content);
  if (q.coefficient(q.lowest()) < 0) unit = -unit;
  return {std::move(p) * LaurentPolynomial(unit), std::move(q) * LaurentPolynomial(unit)};
}

/// sum = ['+'|'-'] product {('+'|'-') product}; product = power {('*'|'/') power}; power = atom ['^' integer]; atom = a
/// number, the letter, or a sum in parentheses.
class Reader {
 public:
  Reader(std::string_view text, char letter) : text_(text), letter_(letter) {}

  RationalFunction read() {
    RationalFunction result = sum();
    if (at_ < text_.size()) fail();
    return result;
  }

 private:
  RationalFunction sum() {
    if (++depth_ > max_depth) fail();
    const bool negative = takes('-');
    if (!negative) takes('+');
    RationalFunction result = product();
    if (negative) result = -result;
    for (;;) {
      if (takes('+'))
        result = bounded(result + product());
      else if (takes('-'))
        result = bounded(result - product());
      else
        break;
    }
    --depth_;
    return result;
  }

  RationalFunction product() {
    RationalFunction result = power();
    for (;;) {
      if (takes('*')) {
        result = bounded(result * power());
      } else if (takes('/')) {
        const std::size_t begin = at_;
        const RationalFunction divisor = power();
        if (divisor == RationalFunction()) fail(begin, "a divisor that is not zero");
        result = bounded(result / divisor);
      } else {
        return result;
      }
    }
  }

  RationalFunction power() {
    RationalFunction base = atom();
    if (!takes('^')) return base;
    const std::size_t begin = at_;
    const std::optional<Rational> exponent = digits();
    if (!exponent || denominator(*exponent) != 1 || *exponent > max_degree)
      fail(begin, fmt::format("a whole power up to {}", max_degree));
    RationalFunction result = 1;
    for (long k = numerator(*exponent).convert_to<long>(); k > 0; --k) result = bounded(result * base);
    return result;
  }

  RationalFunction atom() {
    if (takes('(')) {
      RationalFunction result = sum();
      if (!takes(')')) fail();
      return result;
    }
    if (takes(letter_)) return LaurentPolynomial::monomial(1, 1);
    if (const auto number = digits()) return *number;
    fail();
  }

  std::optional<Rational> digits() {
    blanks();
    const std::size_t begin = at_;
    while (at_ < text_.size() && (std::isdigit(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '.'))
      ++at_;
    return parse_number(text_.substr(begin, at_ - begin));
  }

  void blanks() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }

  bool takes(char c) {
    blanks();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

  RationalFunction bounded(RationalFunction value) const {
    for (const LaurentPolynomial* p : {&value.numerator(), &value.denominator()}) {
      if (p->is_zero()) continue;
      if (p->highest() > max_degree) fail(0, fmt::format("degrees up to {}", max_degree));
      std::vector<Integer> numbers = p->numerators();
      numbers.push_back(p->denominator());
      for (const Integer& c : numbers)
        if (c != 0 && msb(abs(c)) > max_bits) fail(0, "numbers with fewer digits");
    }
    return value;
  }

  [[noreturn]] void fail() const {
    fail(at_, fmt::format("exact numbers, the letter {}, +, -, *, /, ^ and parentheses", letter_));
  }
  [[noreturn]] void fail(std::size_t at, const std::string& expected) const {
    throw ParseError("expression", text_.substr(std::min(at, text_.size())), at + 1, expected);
  }

  std::string_view text_;
  char letter_;
  std::size_t at_ = 0;
  long depth_ = 0;
};

}  // namespace

RationalFunction::RationalFunction(LaurentPolynomial numerator, LaurentPolynomial denominator) {
  require(!denominator.is_zero(), "rational function: need a denominator that is not zero, got zero");
  std::tie(numerator_, denominator_) = reduced(std::move(numerator), std::move(denominator));
}

RationalFunction RationalFunction::parse(std::string_view text, char letter) { return Reader(text, letter).read(); }

Rational RationalFunction::operator()(const Rational& w) const {
  const Rational below = denominator_(w);
  require(below != 0, "rational function: need a value where the denominator is not zero, got {}", w);
  return numerator_(w) / below;
}

RationalFunction operator+(const RationalFunction& a, const RationalFunction& b) {
  if (a.denominator_ == b.denominator_) return {a.numerator_ + b.numerator_, a.denominator_};
  return {a.numerator_ * b.denominator_ + b.numerator_ * a.denominator_, a.denominator_ * b.denominator_};
}

RationalFunction operator*(const RationalFunction& a, const RationalFunction& b) {
  return {a.numerator_ * b.numerator_, a.denominator_ * b.denominator_};
}

RationalFunction operator/(const RationalFunction& a, const RationalFunction& b) {
  return {a.numerator_ * b.denominator_, a.denominator_ * b.numerator_};
}

std::string RationalFunction::to_text(char letter) const {
  std::string above = subcert::to_text(numerator_, letter), below = subcert::to_text(denominator_, letter);
  std::erase(above, ' ');
  std::erase(below, ' ');
  if (is_polynomial()) return above;
  return numerator_.length() > 1 ? fmt::format("({})/({})", above, below) : fmt::format("{}/({})", above, below);
}

std::string to_text(const LaurentPolynomial& polynomial, char letter) {
  std::string text = polynomial.to_text();
  std::replace(text.begin(), text.end(), 'z', letter);
  return text;
}

}  // namespace subcert
