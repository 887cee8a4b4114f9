#include "parameter_names.hpp"

#include <subcert/analysis/symbol/support/utf8.hpp>

#include <fmt/ranges.h>

#include <algorithm>

namespace subcert::specification_text {
namespace {

/// Whether the letter at this place belongs to a decimal, as in 25e-2.
bool is_of_decimal(std::string_view text, std::size_t at) {
  const auto digit_at = [&](std::size_t i) { return i < text.size() && is_digit(text[i]); };
  if ((text[at] != 'e' && text[at] != 'E') || at == 0 || (!digit_at(at - 1) && text[at - 1] != '.')) return false;
  const bool sign = at + 1 < text.size() && (text[at + 1] == '-' || text[at + 1] == '+');
  return digit_at(at + (sign ? 2 : 1));
}

/// One letter for those that are a product of it.
std::string_view name_of(std::string_view letters) {
  return letters.find_first_not_of(letters.front()) == std::string_view::npos ? letters.substr(0, 1) : letters;
}

/// Where names end in letters that are a product of them; empty for no product, or for more than one.
std::vector<std::size_t> ends_of_names(std::string_view letters, const std::vector<std::string>& names) {
  std::vector<std::size_t> ways(letters.size() + 1, 0), from(letters.size() + 1, 0);
  ways[0] = 1;
  for (std::size_t end = 1; end <= letters.size(); ++end)
    for (const std::string& name : names)
      if (letters.substr(0, end).ends_with(name) && ways[end - name.size()] > 0) {
        ways[end] = std::min<std::size_t>(ways[end] + ways[end - name.size()], 2);
        from[end] = end - name.size();
      }
  std::vector<std::size_t> ends;
  if (ways.back() == 1)
    for (std::size_t end = letters.size(); end > 0; end = from[end]) ends.insert(ends.begin(), end);
  return ends;
}

}  // namespace

std::vector<Piece> names_inside(const Piece& family, const Piece& body) {
  const bool is_symbol = family.text == "symbol";
  const Piece whole = is_symbol ? split(body, ',').front() : body;
  std::vector<Piece> names;
  int depth = is_symbol ? 1 : 0;
  for (std::size_t i = 0; i < whole.text.size(); ++i) {
    const char c = whole.text[i];
    depth += c == '[' || c == '(' ? 1 : c == ']' || c == ')' ? -1 : 0;
    std::size_t end = i;
    while (end < whole.text.size() && is_letter(whole.text[end])) ++end;
    if (end == i) continue;
    const Piece letters{whole.text.substr(i, end - i), whole.at + i};
    if (is_symbol && letters.text.find("zeta") != std::string_view::npos)
      fail(letters, "another name for the parameter, as z is the variable");
    if (depth != 0 && !(end == i + 1 && is_of_decimal(whole.text, i)))
      for (const Piece& part : is_symbol ? split(letters, 'z') : std::vector<Piece>{letters})
        if (!part.text.empty()) names.push_back(part);
    i = end - 1;
  }
  return names;
}

std::string read_parameter(const Piece& family, const Piece& body, const char* usage) {
  const std::vector<Piece> names = names_inside(family, body);
  if (names.empty()) fail(body, std::string("a letter for the parameter, as in ") + usage);
  const std::string_view parameter = name_of(names.front().text);
  for (const Piece& name : names) {
    constexpr std::string_view functions[] = {"sqrt", "sin", "cos", "tan", "exp", "log", "ln", "abs", "pi"};
    if (std::ranges::find(functions, name.text) != std::end(functions))
      fail(name, std::string("exact numbers and a parameter; a root as ") + algebraic_usage);
    if (name_of(name.text) != parameter)
      fail(name,
           fmt::format("one letter or name for the parameter, here {}; 'subcert map' takes two or three", parameter));
  }
  for (std::size_t i = 0; i < body.text.size(); ++i)
    if (parameter.size() == 1 && body.text[i] == parameter.front() && is_of_decimal(body.text, i))
      fail({body.text.substr(i, 1), body.at + i}, "a * before the parameter");
  return std::string(parameter);
}

std::string with_name(const std::string& expression, char letter, const std::string& name) {
  std::string result;
  for (const char c : expression) result += c == letter ? name : std::string(1, c);
  return result;
}

std::string letters_for(const std::vector<std::string>& names) {
  std::string letters;
  for (const std::string& name : names)
    for (const char c : name + "wtsuvabcdfghk")
      if (letters.find(c) == std::string::npos &&
          (name.size() == 1 || (c != 'z' && std::ranges::find(names, std::string(1, c)) == names.end()))) {
        letters += c;
        break;
      }
  return letters;
}

std::string replaced(std::string_view text, const std::vector<Piece>& pieces, const std::vector<std::string>& names,
                     std::string_view letters) {
  std::string result;
  std::size_t done = 0;
  for (const Piece& piece : pieces) {
    const std::vector<std::size_t> ends = ends_of_names(piece.text, names);
    if (ends.empty())
      fail(piece, fmt::format("products of {}, with * where they stand together", fmt::join(names, ", ")));
    result += text.substr(done, piece.at - done);
    for (std::size_t k = 0, begin = 0; k < ends.size(); begin = ends[k++]) {
      const auto name = std::ranges::find(names, piece.text.substr(begin, ends[k] - begin));
      result += letters[static_cast<std::size_t>(name - names.begin())];
    }
    done = piece.at + piece.text.size();
  }
  return result += text.substr(done);
}

}  // namespace subcert::specification_text
