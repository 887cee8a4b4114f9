#include "as_written.hpp"

#include "frequency_symbol.hpp"
#include "plain_text.hpp"
#include "refinement_rules.hpp"
#include "specification.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/polynomials/expression.hpp>
#include <subcert/analysis/symbol/support/utf8.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>
#include <utility>

namespace subcert {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 26> names{{
    {"chaikin", "bspline:degree=2"},
    {"quadratic-bspline", "bspline:degree=2"},
    {"quadratic-b-spline", "bspline:degree=2"},
    {"quadratic", "bspline:degree=2"},
    {"quadratic-spline", "bspline:degree=2"},
    {"cubic", "bspline:degree=3"},
    {"cubic-spline", "bspline:degree=3"},
    {"cubic-bspline", "bspline:degree=3"},
    {"cubic-b-spline", "bspline:degree=3"},
    {"quartic", "bspline:degree=4"},
    {"quartic-spline", "bspline:degree=4"},
    {"quintic", "bspline:degree=5"},
    {"quintic-spline", "bspline:degree=5"},
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

/// Behind the list that the text begins with, or the end.
std::size_t end_of_list(std::string_view text) {
  const std::size_t last = closing_bracket(text, 0);
  return last == std::string_view::npos ? text.size() : last + 1;
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

/// The lines of a list as its rows: ; or a blank for the ends of lines inside of brackets.
std::string with_lines(std::string_view text) {
  std::string result;
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    depth += c == '[' ? 1 : c == ']' ? -1 : 0;
    if (depth <= 0 || (c != '\n' && c != '\r')) {
      result += c;
      continue;
    }
    const std::size_t next = std::min(text.find_first_not_of(" \t\r\n", i), text.size());
    const std::size_t last = result.find_last_not_of(" \t");
    const bool parted = next == text.size() || std::string_view("],;").find(text[next]) != std::string_view::npos ||
                        std::string_view("[,;").find(result[last]) != std::string_view::npos;
    result += parted || (result[last] == ']' && text[next] == '[') ? ' ' : ';';
    i = next - 1;
  }
  return result;
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

/// `1/4, 3/4, 3/4, 1/4` in brackets: numbers with commas, blanks or ends of lines between them.
std::string in_list(std::string text) {
  const bool numbers = std::ranges::all_of(text, [](char c) {
    return is_digit(c) || is_blank(c) || std::string_view(",.+-*/^()\r\n").find(c) != std::string_view::npos;
  });
  std::string list = with_lines("[" + text + "]");
  const bool parts = text.find(',') == std::string::npos;
  if (!numbers || without_blanks(list, parts).find_first_of(",;") == std::string::npos) return text;
  return list;
}

/// Of a name with an index and an =, as `A_[-1] =`, `A_0 =` or `A(1) =`, that begins here: the index, and its end.
std::optional<std::pair<long, std::size_t>> name_with_index(std::string_view text, std::size_t at) {
  const std::size_t begin = at;
  while (at < text.size() && is_letter(text[at])) ++at;
  if (at == begin) return std::nullopt;
  if (at < text.size() && text[at] == '_') ++at;
  const bool brackets = at < text.size() && (text[at] == '[' || text[at] == '(');
  if (brackets) ++at;
  const std::size_t end = std::min(text.find_first_not_of("-0123456789", at), text.size());
  const auto index = parse_rational(text.substr(at, end - at));
  const std::size_t equal = text.find_first_not_of(" \t", std::min(end + (brackets ? 1 : 0), text.size()));
  if (!index || abs(*index) > 1000 || equal == std::string_view::npos || text[equal] != '=') return std::nullopt;
  return std::pair(numerator(*index).convert_to<long>(), equal + 1);
}

/// Lists that begin one behind the other, with a name and its index each or without, and where they end.
struct Lists {
  std::map<long, std::string> by_index;
  std::size_t end = 0;
};
Lists lists_of(std::string_view text, bool named, std::size_t origin = 0) {
  Lists lists;
  for (std::size_t at = 0; at < text.size();) {
    const auto name = named ? name_with_index(text, at) : std::pair(static_cast<long>(lists.by_index.size()), at);
    const std::size_t begin = name ? text.find_first_not_of(" \t", name->second) : std::string_view::npos;
    if (begin == std::string_view::npos || text[begin] != '[') break;
    const std::size_t size = end_of_list(text.substr(begin));
    if (!lists.by_index.emplace(name->first, text.substr(begin, size)).second)
      throw SpecificationError(text.substr(at, begin + size - at), origin + at + 1, "one matrix for each index");
    lists.end = begin + size;
    at = std::min(text.find_first_not_of(" \t\r\n,;", lists.end), text.size());
  }
  return lists;
}

/// The innermost lists of one with their rows in brackets.
std::string with_rows(std::string_view list) {
  std::string result;
  for (std::size_t at = 0; at < list.size();) {
    const std::size_t next = list[at] == '[' ? list.find_first_of("[]", at + 1) : std::string_view::npos;
    const bool innermost = next != std::string_view::npos && list[next] == ']';
    const std::string_view piece = list.substr(at, innermost ? next + 1 - at : 1);
    const bool parts = piece.find(',') == std::string_view::npos;
    result += innermost ? in_rows(without_blanks(piece, parts)) : std::string(piece);
    at += piece.size();
  }
  return result;
}

/// The body of `refinable:`, `vector:` or `hermite:` as a list of lists of rows: matrices with rows as in MATLAB,
/// without brackets about all of them, or with a name and its index each, as `A_[-1] = [1 0;0 1]`.
/// `at`: where it begins.
std::string matrices_as_written(std::string body, std::size_t at) {
  const bool named = !body.empty() && is_letter(body.front());
  const Lists lists = lists_of(body, named, at);
  if (lists.by_index.empty()) return body;
  const auto& [first, list] = *lists.by_index.begin();
  const std::string rest = body.substr(lists.end);
  if (!named && lists.by_index.size() == 1) return with_rows(list) + rest;
  std::string matrices;
  long index = first;
  for (const auto& [k, matrix] : lists.by_index) {
    if (k != index++) throw SpecificationError(body, at + 1, fmt::format("a matrix for the index {}", index - 1));
    matrices += (matrices.empty() ? "" : ",") + with_rows(matrix);
  }
  return "[" + matrices + "]" + (named ? "@" + std::to_string(first) : "") + rest;
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
    return text[i] == 'z' && text[i + (text[i + 1] == '_' ? 2 : 1)] == digit;  // a string ends with a 0
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
  if (const auto symbol = frequency_symbol_as_written(trimmed(text))) return *symbol;
  const std::string plain = trimmed(plain_text(text));
  if (lists_of(plain, true).by_index.size() > 1)
    throw SpecificationError(text.substr(0, text.find('=')), 1, "refinable:, vector: or hermite: before the matrices");
  const std::string right = without_left_side(plain);
  const std::string written = with_lines(in_list(in_brackets(without_array(right))));
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
  if (name == "refinable" || name == "vector" || name == "hermite")
    return name + ":" + matrices_as_written(body, colon + 1);
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
