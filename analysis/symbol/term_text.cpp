#include "term_text.hpp"

#include "decimal.hpp"
#include "error.hpp"
#include "parse_error.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

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

class MaskReader {
 public:
  MaskReader(std::string_view text, int variables) : text_(text), result_{{}, {}, {}} {
    result_.sizes.resize(static_cast<std::size_t>(variables), 0);
  }

  MaskText mask() {
    list(result_.sizes.size());
    divisor();
    if (at_ < text_.size()) first();
    return std::move(result_);
  }

 private:
  [[noreturn]] static void fail(std::string_view token, std::size_t at, const std::string& expected) {
    throw ParseError("mask", token, at + 1, expected);
  }
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  /// The text from here to the next of these characters.
  std::string_view until(const char* ends) const {
    return text_.substr(at_, std::min(text_.find_first_of(ends, at_), text_.size()) - at_);
  }
  std::string form() const {
    const std::size_t depth = result_.sizes.size();
    return depth == 1 ? "coefficients in brackets, as in [1,3,3,1]/4@-2"
                      : "lists in brackets, nested " + std::to_string(depth) + " deep for as many variables";
  }

  /// Lists of one level have one length.
  void list(std::size_t depth) {
    if (peek() != '[') fail(text_.substr(at_), at_, form());
    const std::size_t begin = at_;
    std::size_t count = 0;
    do {
      ++at_;
      if (depth > 1) {
        list(depth - 1);
      } else {
        if (peek() == '[') fail(text_.substr(at_), at_, form());
        const std::string_view number = until(",]");
        const auto value = parse_number(number);
        if (!value) fail(number, at_, "an exact number p, p/q with q > 0, or a decimal");
        result_.coefficients.push_back(*value);
        at_ += number.size();
      }
      ++count;
    } while (peek() == ',');
    if (peek() != ']') fail(text_.substr(at_), at_, "a comma or a closing bracket");
    ++at_;
    std::size_t& size = result_.sizes[depth - 1];
    if (size != 0 && size != count)
      fail(text_.substr(begin, at_ - begin), begin,
           "rows of one length: a list of " + std::to_string(size) + ", as before, not of " + std::to_string(count));
    size = count;
  }

  void divisor() {
    const std::string_view divisor_text = until("@");
    if (divisor_text.empty()) return;
    const auto divisor = parse_rational(divisor_text.substr(1));
    if (divisor_text.front() != '/' || !divisor || denominator(*divisor) != 1 || *divisor <= 0)
      fail(divisor_text, at_, "/D with a positive integer D, or @ and the first index");
    for (Rational& c : result_.coefficients) c /= *divisor;
    at_ += divisor_text.size();
  }

  void first() {
    result_.first.emplace();
    for (const std::string& name : variable_names(static_cast<int>(result_.sizes.size()))) {
      const std::string of = result_.sizes.size() == 1 ? "" : " of " + name;
      if (at_ == text_.size()) fail("", at_, "@ and as many first indices as variables");
      ++at_;  // '@' or ','
      const std::string_view index_text = until(",");
      const auto index = parse_rational(index_text);
      if (!index || denominator(*index) != 1 || abs(*index) > max_index)
        fail(index_text, at_, "the first index" + of + " as an integer from -1000000000 to 1000000000");
      result_.first->push_back(numerator(*index).convert_to<long>());
      at_ += index_text.size();
    }
    if (at_ < text_.size()) fail(text_.substr(at_), at_, "as many first indices as variables");
  }

  std::string_view text_;
  MaskText result_;
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

MaskText parse_mask_text(std::string_view text, int variables) { return MaskReader(text, variables).mask(); }

std::string print_mask_text(const MaskText& mask) {
  Integer common = 1;
  for (const Rational& c : mask.coefficients) common = lcm(common, denominator(c));
  std::string text;
  for (std::size_t i = 0; i < mask.coefficients.size(); ++i) {
    if (i > 0) text += ',';
    std::size_t run = 1;  // entries of the lists that begin or end here
    for (std::size_t v = 0; v < mask.sizes.size() && i % (run *= mask.sizes[v]) == 0; ++v) text += '[';
    text += to_text(Rational(mask.coefficients[i] * common));
    run = 1;
    for (std::size_t v = 0; v < mask.sizes.size() && (i + 1) % (run *= mask.sizes[v]) == 0; ++v) text += ']';
  }
  if (common != 1) text += "/" + common.str();
  if (mask.first)
    for (std::size_t v = 0; v < mask.sizes.size(); ++v) text += (v ? "," : "@") + std::to_string((*mask.first)[v]);
  return text;
}

}  // namespace subcert::text
