#include "expression.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>

#include <algorithm>
#include <cctype>
#include <optional>

namespace subcert {
namespace {

constexpr long max_power = 64, max_depth = 50;
constexpr unsigned max_bits = 20'000;         // of a number in a product
constexpr std::size_t max_terms = 1'000'000;  // that all products make

class Reader {
 public:
  Reader(const char* subject, std::string_view text, std::string_view letters, long degree)
      : subject_(subject), text_(text), letters_(letters), degree_(degree) {}

  LetterFunction expression() {
    LetterFunction result = sum();
    if (at_ < text_.size()) fail();
    return result;
  }

  MultivariatePolynomial polynomial() {
    const auto terms = terms_of(expression());
    if (!terms) fail(0, "no quotients by sums");
    return {variables(), *terms};
  }

 private:
  using Polynomial = MultivariatePolynomial;
  int variables() const { return static_cast<int>(letters_.size()); }

  /// Terms are put together at the end: there may be many.
  LetterFunction sum() {
    if (++depth_ > max_depth) fail();
    std::vector<Monomial> terms;
    LetterFunction quotients = Polynomial(variables());
    bool negative = takes('-');
    if (!negative) takes('+');
    do {
      const LetterFunction summand = negative ? -product() : product();
      if (const auto monomials = terms_of(summand))
        terms.insert(terms.end(), monomials->begin(), monomials->end());
      else
        quotients = bounded(quotients + summand);
    } while ((negative = takes('-')) || takes('+'));
    --depth_;
    return bounded(LetterFunction(Polynomial(variables(), terms), Polynomial(variables(), 1)) + quotients);
  }

  /// Of a Laurent polynomial.
  static std::optional<std::vector<Monomial>> terms_of(const LetterFunction& value) {
    const std::vector<Monomial> below = value.denominator().terms();
    if (below.size() > 1) return std::nullopt;
    std::vector<Monomial> terms = value.numerator().terms();
    for (Monomial& term : terms) {
      term.coefficient /= below.front().coefficient;
      for (std::size_t v = 0; v < term.exponents.size(); ++v) term.exponents[v] -= below.front().exponents[v];
    }
    return terms;
  }

  LetterFunction product() {
    bool in_parentheses = next_is('(');
    LetterFunction result = power();
    for (;;) {
      const std::size_t begin = at_;
      if (takes('/')) {
        const LetterFunction below = divisor(begin, in_parentheses, is_number(result));
        if (below.is_zero()) fail(begin + 1, "a divisor that is not zero");
        result = times(result, {below.denominator(), below.numerator()});
        in_parentheses = false;
      } else if (takes('*') || next_is('(') || next_is_letter()) {
        in_parentheses = next_is('(');
        result = times(result, power());
      } else {
        return result;
      }
    }
  }

  static bool is_number(const LetterFunction& value) {
    const auto is_free = [](long exponent) { return exponent == 0; };
    return value.is_polynomial() && value.numerator().count() == 1 &&
           std::ranges::all_of(value.numerator().terms().front().exponents, is_free);
  }

  /// What stands under a quotient, as papers write it: `(1+z)^4/16z^3` has 16 z^3 there, and a fraction of numbers ends
  /// before a blank, `1/6 w`. Where it could be taken in two ways, as in 1/2w, a sign or parentheses are asked for.
  LetterFunction divisor(std::size_t begin, bool in_parentheses, bool number_above) {
    LetterFunction result = power();
    if (number_above && is_number(result) && text_[at_ - 1] == ' ') return result;
    while (in_parentheses && next_is_letter()) {
      const std::size_t letter = at_;
      result = times(result, power());
      if (text_.substr(letter, at_ - letter).find('-') != std::string_view::npos)
        fail(letter, "a * before a negative power");
    }
    if (next_is_letter() || next_is('(')) fail(begin, "a * or parentheses that say how far the divisor goes");
    return result;
  }

  LetterFunction times(const LetterFunction& a, const LetterFunction& b) {
    made_ += a.numerator().count() * b.numerator().count() + a.denominator().count() * b.denominator().count();
    if (made_ > max_terms) fail(0, "fewer terms");
    return bounded(a * b);
  }

  LetterFunction power() {
    LetterFunction base = atom();
    if (!takes('^')) return base;
    const bool negative = takes('-');
    const std::size_t begin = at_;
    const std::optional<Rational> exponent = digits();
    auto terms = base.is_polynomial() && base.numerator().count() == 1 ? base.numerator().terms()
                                                                       : std::vector<Monomial>();
    const bool is_letter = !terms.empty() && terms.front().coefficient == 1;
    const long most = is_letter ? degree_ : max_power;
    if (!exponent || denominator(*exponent) != 1 || *exponent > most)
      fail(begin, fmt::format("a whole power up to {}", most));
    const long count = numerator(*exponent).convert_to<long>();
    if (negative && base.is_zero()) fail(begin, "a base that is not zero");
    LetterFunction result = Polynomial(variables(), 1);
    if (is_letter) {
      for (long& one : terms.front().exponents) one *= count;
      result = bounded(Polynomial(variables(), terms));
    } else {
      for (long k = 0; k < count; ++k) result = times(result, base);
    }
    return negative ? LetterFunction(result.denominator(), result.numerator()) : result;
  }

  LetterFunction atom() {
    if (takes('(')) {
      LetterFunction result = sum();
      if (!takes(')')) fail();
      return result;
    }
    for (std::size_t v = 0; v < letters_.size(); ++v)
      if (takes(letters_[v])) {
        Monomial letter{1, std::vector<long>(letters_.size(), 0)};
        letter.exponents[v] = 1;
        return Polynomial(variables(), {letter});
      }
    if (const auto number = digits()) return Polynomial(variables(), *number);
    fail();
  }

  std::optional<Rational> digits() {
    blanks();
    const std::size_t begin = at_;
    while (at_ < text_.size() && (std::isdigit(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '.'))
      ++at_;
    const auto number = parse_number(text_.substr(begin, at_ - begin));
    if (!number) at_ = begin;
    return number;
  }

  void blanks() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }

  bool next_is(char c) {
    blanks();
    return at_ < text_.size() && text_[at_] == c;
  }
  bool next_is_letter() {
    return std::ranges::any_of(letters_, [&](char letter) { return next_is(letter); });
  }
  bool takes(char c) {
    if (!next_is(c)) return false;
    ++at_;
    return true;
  }

  LetterFunction bounded(LetterFunction value) const {
    for (const Polynomial* p : {&value.numerator(), &value.denominator()})
      for (const Monomial& term : p->terms()) {
        if (std::ranges::any_of(term.exponents, [&](long exponent) { return exponent > degree_; }))
          fail(0, fmt::format("degrees up to {}", degree_));
        for (const Integer& c : {numerator(term.coefficient), denominator(term.coefficient)})
          if (c != 0 && msb(abs(c)) > max_bits) fail(0, "numbers with fewer digits");
      }
    return value;
  }

  [[noreturn]] void fail() const {
    std::string named = letters_.size() == 1 ? "the letter " : "the letters ";
    for (std::size_t v = 0; v < letters_.size(); ++v)
      named += (v == 0 ? "" : v + 1 < letters_.size() ? ", " : " and ") + std::string(1, letters_[v]);
    fail(at_, fmt::format("exact numbers, {}, +, -, *, /, ^ and parentheses", named));
  }
  [[noreturn]] void fail(std::size_t at, const std::string& expected) const {
    throw ParseError(subject_, text_.substr(std::min(at, text_.size())), at + 1, expected);
  }

  const char* subject_;
  std::string_view text_, letters_;
  long degree_;
  std::size_t at_ = 0;
  long depth_ = 0;
  std::size_t made_ = 0;  // terms
};

}  // namespace

LetterFunction read_expression(std::string_view text, std::string_view letters, long degree) {
  return Reader("expression", text, letters, degree).expression();
}

MultivariatePolynomial read_polynomial(std::string_view text, std::string_view letters, long degree) {
  return Reader("polynomial", text, letters, degree).polynomial();
}

std::optional<Rational> parse_constant(std::string_view text) {
  if (auto number = parse_number(text)) return number;
  constexpr std::string_view letter = "z";  // a reader has one
  if (text.empty() || text.find_first_of(letter) != std::string_view::npos) return std::nullopt;
  bool divided = false;
  for (const char c : text) {
    if (c == '/' && divided) return std::nullopt;
    divided = c == '/' || (divided && std::string_view("+-*()").find(c) == std::string_view::npos);
  }
  try {
    return in_one_letter(read_polynomial(text, letter, 1)).coefficient(0);
  } catch (const ParseError&) {
    return std::nullopt;
  }
}

LaurentPolynomial in_one_letter(const MultivariatePolynomial& p) {
  if (p.is_zero()) return {};
  const long lowest = p.lowest().front();
  std::vector<Rational> coefficients(static_cast<std::size_t>(p.highest().front() - lowest + 1), 0);
  for (Monomial& term : p.terms())
    coefficients[static_cast<std::size_t>(term.exponents.front() - lowest)] = std::move(term.coefficient);
  return {coefficients, lowest};
}

}  // namespace subcert
