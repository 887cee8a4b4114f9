#include "as_written.hpp"

#include "plain_text.hpp"
#include "refinement_rules.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/polynomials/expression.hpp>
#include <subcert/analysis/symbol/support/utf8.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <utility>

namespace subcert {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 18> names{{
    {"chaikin", "bspline:degree=2"},
    {"quadratic-bspline", "bspline:degree=2"},
    {"quadratic-b-spline", "bspline:degree=2"},
    {"cubic-bspline", "bspline:degree=3"},
    {"cubic-b-spline", "bspline:degree=3"},
    {"dd4", "dd:n=2"},
    {"dd6", "dd:n=3"},
    {"dd8", "dd:n=4"},
    {"db2", "daubechies:n=2"},
    {"db3", "daubechies:n=3"},
    {"db4", "daubechies:n=4"},
    {"four-point", "four-point:w=1/16"},
    {"4-point", "four-point:w=1/16"},
    {"butterfly", "butterfly:w=1/16"},
    {"kobbelt", "kobbelt:w=1/16"},
    {"catmullclark", "catmull-clark"},
    {"doosabin", "doo-sabin"},
    {"4-8", "four-eight"},
}};

bool is_blank(char c) { return c == ' ' || c == '\t'; }
bool ends_operand(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == ')' || c == '.' || c == ']';
}
bool begins_operand(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '(' || c == '.' || c == '[';
}

/// In small letters, with - for _.
std::string name_of(std::string_view text) {
  std::string name(text);
  for (char& c : name) c = c == '_' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return name;
}

/// Where the bracket that opens first is closed, or the end.
std::size_t end_of_list(std::string_view text) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '[') ++depth;
    if (text[i] == ']' && --depth == 0) return i + 1;
  }
  return text.size();
}

/// Blanks go, or stand for commas where they part the entries of a row. Between two operands of a list with commas, or
/// behind it, one stays, for a reader to refuse.
std::string without_blanks(std::string_view list, bool parts) {
  std::string result;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!is_blank(list[i])) {
      result += list[i];
      continue;
    }
    std::size_t next = i;
    while (next < list.size() && is_blank(list[next])) ++next;
    if (next < list.size() && !result.empty() && ends_operand(result.back())) {
      const bool is_sign = (list[next] == '+' || list[next] == '-') && next + 1 < list.size();
      if (begins_operand(list[next]))
        result += parts ? ',' : ' ';
      else if (parts && is_sign && !is_blank(list[next + 1]))
        result += ',';
    }
    i = next - 1;
  }
  return result;
}

/// `[1,2;3,4]` as `[[1,2],[3,4]]`, and a column `[1;2]` as `[1,2]`.
std::string in_rows(std::string list) {
  if (list.find(';') == std::string::npos || list.find('[', 1) != std::string::npos) return list;
  if (list.find(',') == std::string::npos) {
    std::ranges::replace(list, ';', ',');
    return list;
  }
  std::string rows = "[";
  for (const char c : list) rows += c == ';' ? "],[" : std::string(1, c);
  return rows + "]";
}

std::size_t depth_of(std::string_view list) {
  std::size_t depth = 0;
  while (depth < list.size() && list[depth] == '[') ++depth;
  return depth;
}

/// Whether one of these signs stands outside of parentheses, but for one before the number or in a power.
bool has_sign(std::string_view text, std::string_view signs) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
    const bool is_own = i == 0 || text[i - 1] == '^';
    if (depth == 0 && !is_own && signs.find(text[i]) != std::string_view::npos) return true;
  }
  return false;
}

/// A number before a list, with or without a star, or behind one with its sign; 1 for none, nothing for another text
/// and for what could mean two things, as `1+1/4 [...]` and `[...]/4/2`.
std::optional<Rational> factor_of(std::string_view text, bool before) {
  std::string factor = trimmed(text);
  if (factor.empty()) return 1;
  if (before && factor.ends_with('*')) factor = trimmed(factor.substr(0, factor.size() - 1));
  const bool divides = !before && factor.front() == '/';
  if (!before) {
    if (!divides && factor.front() != '*') return std::nullopt;
    factor = trimmed(factor.substr(1));
  }
  const auto value = has_sign(factor, divides ? "+-*/" : "+-") ? std::nullopt : parse_constant(factor);
  if (!value || *value == 0) return std::nullopt;
  return divides ? Rational(1 / *value) : *value;
}

/// Each entry of a list times p; numbers are multiplied.
std::string times(const std::string& list, const Integer& p) {
  if (p == 1) return list;
  std::string result;
  for (std::size_t i = 0, begin = 0; i <= list.size(); ++i) {
    const char c = i < list.size() ? list[i] : ']';
    if (c != '[' && c != ']' && c != ',') continue;
    if (const std::string entry = list.substr(begin, i - begin); !entry.empty()) {
      const auto number = parse_constant(entry);
      result += number ? to_text(Rational(*number * p)) : p.str() + "*(" + entry + ")";
    }
    if (i < list.size()) result += c;
    begin = i + 1;
  }
  return result;
}

/// A mask that may have a factor in front; `family`: that was named, if any. Nothing for another text.
std::string mask_as_written(std::string_view text, std::string family = "mask") {
  const std::size_t begin = text.find('[');
  if (begin == std::string_view::npos) return {};
  const auto before = factor_of(text.substr(0, begin), true);
  if (!before) return {};
  text.remove_prefix(begin);
  const std::size_t end = end_of_list(text), fields = std::min(text.find_first_of("@,", end), text.size());
  const std::string_view written = text.substr(0, end), behind = text.substr(end, fields - end);
  std::string list = in_rows(without_blanks(written, written.find(',') == std::string_view::npos));
  const std::string rest = without_blanks(text.substr(fields), false);
  const std::size_t depth = depth_of(list);
  if (family == "mask" && (depth == 2 || depth == 3)) family += std::to_string(depth);
  const std::string divisor = without_blanks(behind, false);
  // One by a whole number is the form of specifications; one with letters is read there.
  const auto factor = factor_of(behind, false);
  if (*before == 1 && (!factor || (divisor.starts_with('/') && parse_rational(divisor.substr(1)))))
    return family + ":" + list + divisor + rest;
  if (!factor) return {};
  const Rational scale = *before * *factor;
  const Integer below = denominator(scale);
  return family + ":" + times(list, numerator(scale)) + (below == 1 ? "" : "/" + below.str()) + rest;
}

/// `1/4 (1,3,3,1)` in brackets: a list in parentheses, which no symbol has.
std::string in_brackets(std::string text) {
  if (text.find_first_of("[:") != std::string::npos) return text;
  int depth = 0;
  for (std::size_t i = 0, begin = 0; i < text.size(); ++i) {
    if (text[i] == '(' && depth++ == 0) begin = i;
    if (text[i] == ')') --depth;
    if (text[i] != ',' || depth != 1) continue;
    for (; i < text.size() && depth > 0; ++i) depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
    if (depth != 0) return text;
    text[begin] = '[';
    text[i - 1] = ']';
    return text;
  }
  return text;
}

/// `1/4, 3/4, 3/4, 1/4` in brackets: numbers with commas or blanks between them.
std::string in_list(std::string text) {
  const bool numbers = std::ranges::all_of(text, [](char c) {
    return is_digit(c) || is_blank(c) || std::string_view(",.+-*/^()").find(c) != std::string_view::npos;
  });
  std::string list = "[" + text + "]";
  if (!numbers || without_blanks(list, text.find(',') == std::string::npos).find(',') == std::string::npos) return text;
  return list;
}

/// Without the name of a mask or a symbol and its equality sign: `a = [1,3,3,1]/4`, `a(z) = (1+z)^3/4`.
std::string without_left_side(std::string text) {
  const std::size_t equal = text.find('=');
  if (equal == std::string::npos || text.find_first_of("[(", equal) == std::string::npos) return text;
  std::string left = trimmed(text.substr(0, equal));
  for (const std::string_view variable : {"(z)", "(x)", "(x,y)", "(x, y)", "(z1,z2)", "(z_1,z_2)", "(z_1, z_2)"})
    if (left.ends_with(variable)) left.erase(left.size() - variable.size());
  const bool one_letter = !left.empty() && is_letter(left.front()) && (left.size() == 1 || left[1] == '_');
  const bool is_name = is_greek(left) || (one_letter && std::ranges::all_of(left.substr(1), [](char c) {
                                            return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0;
                                          }));
  return is_name ? trimmed(text.substr(equal + 1)) : text;
}

/// `array([1., 3., 3., 1.])/4`, as numpy shows it, without the word.
std::string without_array(std::string text) {
  const std::size_t open = text.find("array(");
  if (open == std::string::npos || (open != 0 && text.substr(0, open) != "np." && text.substr(0, open) != "numpy."))
    return text;
  const std::size_t begin = open + 6, close = text.find(')', begin);
  if (close == std::string::npos) return text;
  return text.substr(begin, close - begin) + text.substr(close + 1);
}

/// z1 and z2, or z_1 and z_2, and z3, as x, y and z, where no other letters stand for them.
std::string in_own_letters(std::string text) {
  const auto has_index = [&](std::size_t i, char digit) {
    return text[i] == 'z' && i + 1 < text.size() && text[i + (text[i + 1] == '_' ? 2 : 1)] == digit;
  };
  if (text.find_first_of("xy") != std::string::npos) return text;
  std::string result;
  bool first = false, second = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    char letter = 0;
    for (const char digit : {'1', '2', '3'})
      if (has_index(i, digit)) letter = static_cast<char>('x' + (digit - '1'));
    if (text[i] == 'z' && letter == 0) return text;
    first = first || letter == 'x';
    second = second || letter == 'y';
    result += letter == 0 ? text[i] : letter;
    if (letter != 0) i += text[i + 1] == '_' ? 2 : 1;
  }
  return first && second ? result : text;
}

/// The family of a symbol by its variables: symbol in z, symbol2 in x and y, symbol3 in x, y and z.
std::string symbol_family(std::string_view body) {
  const std::string_view expression = body.substr(0, body.find(','));
  if (expression.find_first_of("xy") == std::string_view::npos) return "symbol";
  return expression.find('z') == std::string_view::npos ? "symbol2" : "symbol3";
}

/// Whether a text without a family has the look of a symbol.
bool is_symbol(std::string_view text) {
  return text.find('(') != std::string_view::npos && text.find_first_of("xyz") != std::string_view::npos &&
         std::string_view("(+-.0123456789xyz").find(text.front()) != std::string_view::npos;
}

}  // namespace

std::string specification_as_written(std::string_view text) {
  if (const auto rules = rules_as_written(text)) return *rules;
  const std::string right = without_left_side(trimmed(plain_text(text)));
  const std::string written = in_list(in_brackets(without_array(right)));
  const std::size_t colon = written.starts_with('[') ? std::string::npos : written.find(':');
  if (colon == std::string::npos) {
    if (std::string mask = mask_as_written(written); !mask.empty()) return mask;
    if (is_symbol(written)) {
      const std::string symbol = in_own_letters(written);
      return symbol_family(symbol) + ":" + symbol;
    }
  }
  std::string name = name_of(trimmed(written.substr(0, colon)));
  std::string body = colon == std::string::npos ? "" : trimmed(written.substr(colon + 1));
  if (body.empty())
    for (const auto& [other, specification] : names)
      if (other == name) return std::string(specification);
  if (colon == std::string::npos) return name;
  if (name == "mask" || name == "mask2" || name == "mask3")
    if (std::string mask = mask_as_written(body, name); !mask.empty()) return mask;
  if (name == "symbol") {
    body = in_own_letters(body);
    name = symbol_family(body);
  }
  return name + ":" + body;
}

std::vector<std::string> other_names() {
  std::vector<std::string> result;
  for (const auto& [other, specification] : names) result.emplace_back(other);
  return result;
}

}  // namespace subcert
