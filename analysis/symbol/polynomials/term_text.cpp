#include "term_text.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>
#include "expression.hpp"

#include <algorithm>
#include <functional>
#include <utility>

namespace subcert::text {
namespace {

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

Rational read_number(std::string_view text) {
  const QuadraticNumber number = QuadraticNumber::parse(text);
  if (number.root > 0) throw ParseError("mask", text, 1, "an exact number without a square root");
  return number.rational;
}

bool is_zero(const Rational& value) { return value == 0; }
bool is_zero(const LetterFunction& value) { return value.is_zero(); }
bool is_zero(const QuadraticNumber& value) { return value.is_zero(); }

/// Entries in lists of these sizes, divided by the common denominator.
template <class Number>
std::string print_lists(const MaskTextOf<Number>& mask, const std::vector<std::string>& entries,
                        const Integer& common) {
  std::string text;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (i > 0) text += ',';
    std::size_t run = 1;  // entries of the lists that begin or end here
    for (std::size_t v = 0; v < mask.sizes.size() && i % (run *= mask.sizes[v]) == 0; ++v) text += '[';
    text += entries[i];
    run = 1;
    for (std::size_t v = 0; v < mask.sizes.size() && (i + 1) % (run *= mask.sizes[v]) == 0; ++v) text += ']';
  }
  if (common != 1) text += "/" + common.str();
  if (mask.first)
    for (std::size_t v = 0; v < mask.first->size(); ++v) text += (v ? "," : "@") + std::to_string((*mask.first)[v]);
  return text;
}

template <class Number>
class MaskReader {
 public:
  using Read = std::function<Number(std::string_view)>;

  /// `read`: a coefficient, with ParseErrors about places in its own text.
  MaskReader(std::string_view text, int variables, Entries entries, bool has_letters, Read read)
      : text_(text), variables_(variables), has_letters_(has_letters), read_(std::move(read)) {
    result_.sizes.resize(static_cast<std::size_t>(variables) + (entries == Entries::matrices ? 2 : 0), 0);
  }

  MaskTextOf<Number> mask() {
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
                      : "lists in brackets, nested " + std::to_string(depth) + " deep" +
                            (depth == static_cast<std::size_t>(variables_) ? " for as many variables"
                                                                           : ", the innermost two for matrices");
  }

  Number number(std::string_view text, std::size_t at) const {
    try {
      return read_(text);
    } catch (const ParseError& error) {
      fail(error.token(), at + error.position() - 1, error.expected());
    }
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
        const std::string_view entry = until(",]");
        result_.coefficients.push_back(number(entry, at_));
        at_ += entry.size();
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
    const bool is_expression = has_letters_ && divisor_text.starts_with("/(");
    const auto integer = parse_rational(divisor_text.substr(1));
    const bool is_one = divisor_text.front() == '/' && divisor_text.find('/', 1) == std::string_view::npos;
    if (!is_expression && (!is_one || !integer || denominator(*integer) != 1 || *integer <= 0))
      fail(divisor_text, at_, "/D with a positive integer D, or @ and the first index");
    const Number divisor = number(divisor_text.substr(1), at_ + 1);
    if (is_zero(divisor)) fail(divisor_text.substr(1), at_ + 1, "a denominator that is not zero");
    for (Number& c : result_.coefficients) c = c / divisor;
    at_ += divisor_text.size();
  }

  void first() {
    result_.first.emplace();
    for (const std::string& name : variable_names(variables_)) {
      const std::string of = variables_ == 1 ? "" : " of " + name;
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
  int variables_;
  bool has_letters_;
  Read read_;
  MaskTextOf<Number> result_{};
  std::size_t at_ = 0;
};

}  // namespace

std::vector<std::string> variable_names(int variables) {
  if (variables == 1) return {"z"};
  if (variables == 2) return {"x", "y"};
  if (variables == 3) return {"x", "y", "z"};
  fail(ErrorKind::domain, "variable_names: need 1 <= variables <= 3, got {}", variables);
}

std::string print_terms(const std::vector<Monomial>& terms, Style style, std::vector<std::string> names) {
  std::string text;
  if (names.empty() && !terms.empty()) names = variable_names(static_cast<int>(terms.front().exponents.size()));
  for (const Monomial& term : terms) {
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

MaskText parse_mask_text(std::string_view text, int variables, Entries entries) {
  return MaskReader<Rational>(text, variables, entries, false, read_number).mask();
}

MaskTextOf<LetterFunction> parse_mask_text(std::string_view text, std::string_view letters, Entries entries) {
  return MaskReader<LetterFunction>(text, 1, entries, true,
                                    [=](std::string_view entry) { return LetterFunction::parse(entry, letters); })
      .mask();
}

MaskTextOf<QuadraticNumber> parse_quadratic_mask_text(std::string_view text, int variables) {
  long root = 0;  // of the entries so far
  return MaskReader<QuadraticNumber>(text, variables, Entries::matrices, true,
                                     [&root](std::string_view entry) {
                                       const QuadraticNumber number = QuadraticNumber::parse(entry, root);
                                       root = std::max(root, number.root);
                                       return number;
                                     })
      .mask();
}

std::string print_mask_text(const MaskText& mask) {
  Integer common = 1;
  for (const Rational& c : mask.coefficients) common = lcm(common, denominator(c));
  std::vector<std::string> entries;
  for (const Rational& c : mask.coefficients) entries.push_back(to_text(Rational(c * common)));
  return print_lists(mask, entries, common);
}

std::string print_mask_text(const MaskTextOf<QuadraticNumber>& mask) {
  Integer common = 1;
  for (const QuadraticNumber& c : mask.coefficients)
    common = lcm(common, lcm(denominator(c.rational), denominator(c.multiple)));
  std::vector<std::string> entries;
  for (const QuadraticNumber& c : mask.coefficients)
    entries.push_back(QuadraticNumber{c.rational * common, c.multiple * common, c.root}.to_text());
  return print_lists(mask, entries, common);
}

}  // namespace subcert::text
