#include "term_text.hpp"

#include "error.hpp"
#include "parse_error.hpp"

#include <algorithm>
#include <cstdlib>

namespace subcert::text {
namespace {

constexpr long max_exponent = 1'000'000;
constexpr long max_index = 1'000'000'000;

std::string print_power(const std::string& name, long exponent, Style style) {
  if (exponent == 1) return name;
  const std::string text = std::to_string(exponent);
  return style == Style::latex ? name + "^{" + text + "}" : name + "^" + text;
}

std::string print_magnitude(const Rational& value, Style style) {
  if (style == Style::latex && denominator(value) != 1)
    return "\\frac{" + numerator(value).str() + "}{" + denominator(value).str() + "}";
  return to_text(value);
}

class Reader {
 public:
  Reader(std::string_view text, int variables) : text_(text), names_(variable_names(variables)) {}

  std::vector<Monomial> sum() {
    std::vector<Monomial> terms;
    skip_blanks();
    bool negative = take('-');
    if (!negative) take('+');
    for (;;) {
      terms.push_back(term(negative));
      skip_blanks();
      if (at_ == text_.size()) return terms;
      negative = peek() == '-';
      if (!take('-') && !take('+')) fail("'+', '-' or the end");
    }
  }

 private:
  [[noreturn]] void fail(const std::string& expected) const {
    throw ParseError("polynomial", text_.substr(std::min(at_, text_.size()), 1), at_ + 1, expected);
  }
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void skip_blanks() {
    while (peek() == ' ') ++at_;
  }
  bool take(char c) {
    skip_blanks();
    if (peek() != c) return false;
    ++at_;
    return true;
  }
  std::string_view digits() {
    const std::size_t begin = at_;
    while (peek() >= '0' && peek() <= '9') ++at_;
    return text_.substr(begin, at_ - begin);
  }

  Monomial term(bool negative) {
    Monomial result{negative ? -1 : 1, std::vector<long>(names_.size(), 0)};
    do factor(result);
    while (take('*'));
    return result;
  }

  void factor(Monomial& term) {
    skip_blanks();
    const auto name = std::find(names_.begin(), names_.end(), std::string(1, peek()));
    if (name != names_.end()) {
      ++at_;
      long& total = term.exponents[static_cast<std::size_t>(name - names_.begin())];
      total += peek() == '^' ? exponent() : 1;
      if (std::abs(total) > max_exponent) fail("exponents that add up to -1000000 ... 1000000");
      return;
    }
    const std::size_t begin = at_;
    digits();
    if (peek() == '/') {
      ++at_;
      digits();
    }
    const auto value = parse_rational(text_.substr(begin, at_ - begin));
    if (!value) {
      at_ = begin;
      fail("a number p or p/q, or a variable");
    }
    term.coefficient *= *value;
  }

  long exponent() {
    ++at_;  // '^'
    const bool negative = peek() == '-';
    if (negative) ++at_;
    const std::size_t begin = at_;
    const std::string_view text = digits();
    if (text.empty() || text.size() > 7 || std::stol(std::string(text)) > max_exponent) {
      at_ = begin;
      fail("an exponent from -1000000 to 1000000");
    }
    const long value = std::stol(std::string(text));
    return negative ? -value : value;
  }

  std::string_view text_;
  std::vector<std::string> names_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<std::string> variable_names(int variables) {
  if (variables == 1) return {"z"};
  if (variables == 2) return {"x", "y"};
  if (variables == 3) return {"x", "y", "z"};
  fail(ErrorKind::domain, "variable_names: need 1 <= variables <= 3, got {}", variables);
}

std::string print_terms(const std::vector<Monomial>& terms, Style style) {
  std::string text;
  for (const Monomial& term : terms) {
    const auto names = variable_names(static_cast<int>(term.exponents.size()));
    std::vector<std::string> factors;
    const Rational magnitude = abs(term.coefficient);
    for (std::size_t i = 0; i < names.size(); ++i)
      if (term.exponents[i] != 0) factors.push_back(print_power(names[i], term.exponents[i], style));
    if (magnitude != 1 || factors.empty()) factors.insert(factors.begin(), print_magnitude(magnitude, style));
    const bool negative = term.coefficient < 0;
    text += text.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
    for (std::size_t i = 0; i < factors.size(); ++i) {
      if (i > 0) text += style == Style::latex ? " " : "*";
      text += factors[i];
    }
  }
  return text.empty() ? "0" : text;
}

std::vector<Monomial> parse_terms(std::string_view text, int variables) { return Reader(text, variables).sum(); }

MaskText parse_mask_text(std::string_view text) {
  const auto fail = [](std::string_view token, std::size_t at, const std::string& expected) {
    throw ParseError("mask", token, at + 1, expected);
  };
  const std::size_t close = text.find(']');
  if (text.empty() || text.front() != '[' || close == std::string_view::npos)
    fail(text, 0, "coefficients in brackets, as in [1,3,3,1]/4@-2");
  MaskText result;
  for (std::size_t begin = 1; begin <= close;) {
    const std::size_t end = std::min(text.find(',', begin), close);
    const auto value = parse_rational(text.substr(begin, end - begin));
    if (!value) fail(text.substr(begin, end - begin), begin, "an exact number p or p/q with q > 0");
    result.coefficients.push_back(*value);
    begin = end + 1;
  }
  const std::size_t at = std::min(text.find('@', close), text.size());
  const std::string_view divisor_text = text.substr(close + 1, at - close - 1);
  if (!divisor_text.empty()) {
    const auto divisor = parse_rational(divisor_text.substr(1));
    if (divisor_text.front() != '/' || !divisor || denominator(*divisor) != 1 || *divisor <= 0)
      fail(divisor_text, close + 1, "/D with a positive integer D, or @ and the first index");
    for (Rational& c : result.coefficients) c /= *divisor;
  }
  if (at < text.size()) {
    const auto first = parse_rational(text.substr(at + 1));
    if (!first || denominator(*first) != 1 || abs(*first) > max_index)
      fail(text.substr(at + 1), at + 1, "the first index as an integer from -1000000000 to 1000000000");
    result.first = numerator(*first).convert_to<long>();
  }
  return result;
}

}  // namespace subcert::text
