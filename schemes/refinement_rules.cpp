#include "refinement_rules.hpp"

#include "plain_text.hpp"
#include "specification.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/support/utf8.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <functional>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace subcert {
namespace {

using std::string_view;

constexpr long most_rules = 64;
constexpr int max_parentheses = 100;  // of parentheses

/// factor * letter + shift
struct Index {
  long factor = 1;
  char letter = 0;
  long shift = 0;
};

/// Of at most nine digits.
std::optional<long> whole_number(string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  long number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool all = error == std::errc() && end == text.data() + text.size() && text.size() <= 10;
  return all ? std::optional(number) : std::nullopt;
}

/// `2i+1`, `3*j-1`, `i`
std::optional<Index> read_index(string_view written) {
  std::string text;
  try {
    text = plain_text(written);
  } catch (const SpecificationError&) {
    return std::nullopt;
  }
  std::erase(text, ' ');
  const auto letter = std::ranges::find_if(text, is_letter);
  if (letter == text.end()) return std::nullopt;
  Index index{1, *letter, 0};
  std::string before(text.begin(), letter), behind(letter + 1, text.end());
  if (before.ends_with('*')) before.pop_back();
  const auto factor = before.empty() ? std::optional(1L) : whole_number(before);
  const bool has_sign = behind.starts_with('+') || behind.starts_with('-');
  const auto shift = behind.empty() ? std::optional(0L) : has_sign ? whole_number(behind) : std::nullopt;
  if (!factor || !shift) return std::nullopt;
  index.factor = *factor;
  index.shift = *shift;
  return index;
}

/// A letter with an index, and perhaps primes and a power.
struct Datum {
  std::size_t begin = 0, end = 0;
  std::string name;
  Index index;
};

/// What stands at `at` as a script, `{2i}`, `(k)`, `2i` or one character, and its end.
std::pair<string_view, std::size_t> script(string_view text, std::size_t at) {
  if (at < text.size() && (text[at] == '{' || text[at] == '(' || text[at] == '['))
    if (const std::size_t end = closing_bracket(text, at); end != string_view::npos)
      return {text.substr(at + 1, end - at - 1), end + 1};
  std::size_t end = at;
  while (end < text.size() && is_digit(text[end])) ++end;
  end = std::min(end + 1, text.size());
  return {text.substr(at, end - at), end};
}

/// The datum whose name begins at `begin`, where there is one.
std::optional<Datum> datum_at(string_view text, std::size_t begin) {
  if (!is_letter(text[begin]) || (begin > 0 && (is_letter(text[begin - 1]) || text[begin - 1] == '\\')))
    return std::nullopt;
  Datum datum{begin, begin + 1, std::string(1, text[begin]), {}};
  bool has_index = false;
  while (datum.end < text.size()) {
    const char c = text[datum.end];
    if (c == '\'') {
      ++datum.end;
    } else if (c == '^') {
      datum.end = script(text, datum.end + 1).second;
    } else if ((c == '_' || c == '[') && !has_index) {
      const auto [inside, end] = script(text, datum.end + (c == '_' ? 1 : 0));
      const auto index = read_index(inside);
      if (!index) return std::nullopt;
      datum.index = *index;
      datum.end = end;
      has_index = true;
    } else {
      break;
    }
  }
  return has_index ? std::optional(datum) : std::nullopt;
}

/// Without what LaTeX needs for equations one under the other, each sign replaced so that places stay.
std::string without_alignment(string_view written) {
  std::string text(written);
  const auto blank = [&](std::size_t at, std::size_t length, char sign) {
    std::fill_n(text.begin() + static_cast<std::ptrdiff_t>(at), length, ' ');
    text[at] = sign;
  };
  for (const string_view name : {"\\begin", "\\end"})
    for (std::size_t at = 0; (at = text.find(name, at)) != std::string::npos;) {
      const std::size_t brace = at + name.size();
      const std::size_t end = brace < text.size() && text[brace] == '{' ? closing_bracket(text, brace)
                                                                        : std::string::npos;
      blank(at, end == std::string::npos ? name.size() : end + 1 - at, ' ');
    }
  for (const auto& [sign, meaning] : {std::pair<string_view, char>{"\\left\\{", ' '},
                                      {"\\right.", ' '},
                                      {"\\\\", ';'},
                                      {"\\qquad", ' '},
                                      {"\\quad", ' '},
                                      {"\\,", ' '},
                                      {"\\;", ' '},
                                      {"\\ ", ' '},
                                      {"&", ' '},
                                      {"$", ' '},
                                      {"\n", ';'},
                                      {"\t", ' '},
                                      {"\r", ' '}})
    for (std::size_t at = 0; (at = text.find(sign, at)) != std::string::npos;) blank(at, sign.size(), meaning);
  return text;
}

/// A right side in terms of z, in which data are marked as `(#3)`: each product has one datum. In it a star stands
/// before data, as nobody divides by them.
class RightSide {
 public:
  /// `refuse` throws.
  template <class Refuse>
  RightSide(string_view text, Refuse refuse) : text_(text), refuse_(refuse) {}

  std::string read() {
    const Part whole = sum();
    if (at_ < text_.size() || !whole.has_datum) refuse_();
    return whole.text;
  }

 private:
  struct Part {
    std::string text;
    bool has_datum = false;
  };

  char here() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  Part sum() {
    if (++depth_ > max_parentheses) refuse_();
    Part result;
    for (bool first = true;; first = false) {
      const char sign = here();
      const bool has_sign = sign == '+' || sign == '-';
      if (!first && !has_sign) break;
      if (has_sign) {
        result.text += sign;
        ++at_;
      }
      const Part term = product();
      if (!first && term.has_datum != result.has_datum) refuse_();
      result.has_datum = term.has_datum;
      result.text += term.text;
    }
    --depth_;
    return result;
  }

  Part product() {
    Part result = factor();
    for (;;) {
      const char c = here();
      const bool parted = text_[at_ - 1] == ' ';
      const bool divides = c == '/';
      if (divides || c == '*')
        ++at_;
      else if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '(' && c != '[' && c != '.')
        return result;
      const Part next = factor();
      if (next.has_datum && (divides || result.has_datum)) refuse_();
      if (divides || c == '*')
        result.text += c;
      else
        result.text += next.has_datum ? "*" : parted ? " " : "";
      result.text += next.text;
      result.has_datum = result.has_datum || next.has_datum;
    }
  }

  Part factor() {
    Part result;
    const char c = here();
    if (c == '(' || c == '[') {
      ++at_;
      if (here() == '#') {
        const std::size_t end = text_.find(')', at_);
        result = {"z^" + std::string(text_.substr(at_ + 1, end - at_ - 1)), true};
        at_ = end;
      } else {
        const Part inside = sum();
        result = {"(" + inside.text + ")", inside.has_datum};
      }
      if (here() != (c == '(' ? ')' : ']')) refuse_();
      ++at_;
    } else {
      const auto belongs = [&](char one) { return is_letter(c) ? is_letter(one) : is_digit(one) || one == '.'; };
      for (; at_ < text_.size() && belongs(text_[at_]); ++at_) result.text += text_[at_];
      if (result.text.empty() || result.text.find('z') != std::string::npos) refuse_();
    }
    if (here() == '^') {
      if (result.has_datum) refuse_();
      do result.text += text_[at_++];
      while (at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == '-'));
    }
    return result;
  }

  string_view text_;
  std::function<void()> refuse_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

/// The rules of a text, whose left sides have been found.
class Rules {
 public:
  Rules(string_view text, std::vector<Datum> data) : text_(text), data_(std::move(data)) {
    for (std::size_t d = 0; d < data_.size(); ++d)
      if (const std::size_t sign = text_.find_first_not_of(' ', data_[d].end);
          sign != string_view::npos && text_[sign] == '=' && data_[d].index.factor != 1)
        lefts_.push_back({d, sign + 1});
  }

  bool exist() const { return !lefts_.empty(); }

  std::string symbol() const {
    const Datum& first = data_[lefts_.front().datum];
    const long arity = first.index.factor;
    if (arity < 2 || arity > most_rules) fail(first, fmt::format("an index from 2i to {}i", most_rules));
    if (const std::size_t before = text_.find_first_not_of(' '); before != first.begin)
      throw SpecificationError(text_.substr(before, first.begin - before), before + 1, "a rule, as f_{2i} = ...");
    std::set<long> classes;
    for (const Left& left : lefts_) {
      const Datum& datum = data_[left.datum];
      if (datum.index.factor != arity || datum.index.letter != first.index.letter || datum.name != first.name)
        fail(datum, fmt::format("{}_{{{}{}+q}}, as in the first rule", first.name, arity, first.index.letter));
      if (!classes.insert(((datum.index.shift % arity) + arity) % arity).second)
        fail(datum, "one rule for each class of indices");
    }
    if (static_cast<long>(classes.size()) < arity)
      fail(first,
           fmt::format("{} rules, one for each class of indices modulo {}; found {}", arity, arity, classes.size()));
    long lowest = 0;  // power of z
    for (std::size_t k = 0; k < lefts_.size(); ++k)
      for (const Datum& datum : data_of(k)) lowest = std::min(lowest, power_of(datum, k));
    std::string result;
    for (std::size_t k = 0; k < lefts_.size(); ++k) result += (k > 0 ? "+" : "") + ("(" + right_side(k, lowest) + ")");
    if (lowest < 0) result = fmt::format("({})/z^{}", result, -lowest);
    return "symbol:" + result + (arity == 2 ? "" : ",arity=" + std::to_string(arity));
  }

 private:
  struct Left {
    std::size_t datum, end;  ///< behind its =
  };

  [[noreturn]] void fail(const Datum& datum, const std::string& expected) const {
    throw SpecificationError(text_.substr(datum.begin, datum.end - datum.begin), datum.begin + 1, expected);
  }

  /// Those on the right side.
  std::span<const Datum> data_of(std::size_t k) const {
    const std::size_t begin = lefts_[k].datum + 1, end = k + 1 < lefts_.size() ? lefts_[k + 1].datum : data_.size();
    return std::span(data_).subspan(begin, end - begin);
  }

  /// Of z: the index of the coefficient of a datum in rule k.
  long power_of(const Datum& datum, std::size_t k) const {
    const Index& left = data_[lefts_[k].datum].index;
    return left.shift - left.factor * datum.index.shift;
  }

  /// Without what parts it from the next one, or ends the last.
  string_view trimmed_right_side(std::size_t k) const {
    const bool last = k + 1 == lefts_.size();
    const std::size_t begin = lefts_[k].end, end = last ? text_.size() : data_[lefts_[k + 1].datum].begin;
    string_view side = text_.substr(begin, end - begin);
    bool parted = last;
    for (;;) {
      const std::size_t size = side.size();
      if (side.ends_with(' ')) side.remove_suffix(1);
      if (side.ends_with(" and")) side.remove_suffix(3);
      if (side.ends_with(',') || side.ends_with(';')) side.remove_suffix(1);
      if (side.ends_with('.') && !(side.size() > 1 && is_digit(side[side.size() - 2]))) side.remove_suffix(1);
      parted = parted || (side.size() < size && text_[begin + side.size()] != ' ');
      if (side.size() == size) break;
    }
    if (!parted) fail(data_[lefts_[k + 1].datum], "a comma or a semicolon before the next rule");
    return side;
  }

  /// In terms of z, over its lowest power.
  std::string right_side(std::size_t k, long lowest) const {
    const string_view side = trimmed_right_side(k);
    const std::size_t begin = lefts_[k].end;
    const Index& left = data_[lefts_[k].datum].index;
    const auto refuse = [&]() {
      const std::size_t from = std::min(side.find_first_not_of(' '), side.size());
      throw SpecificationError(
          side.substr(from), begin + from + 1,
          fmt::format("a sum of data as {}_{{{}+1}}, each times a number, or a letter other than z",
                      data_[lefts_[k].datum].name, left.letter));
    };
    if (side.find('#') != string_view::npos) refuse();
    std::string marked;
    std::size_t at = begin;
    std::string name;
    for (const Datum& datum : data_of(k)) {
      const Index& index = datum.index;
      if (index.factor != 1 || index.letter != left.letter || (!name.empty() && datum.name != name)) refuse();
      name = datum.name;
      marked += text_.substr(at, datum.begin - at);
      marked += fmt::format("(#{})", power_of(datum, k) - lowest);
      at = datum.end;
    }
    marked += text_.substr(at, begin + side.size() - at);
    try {
      marked = plain_text(marked);
    } catch (const SpecificationError&) {
      refuse();
    }
    return RightSide(marked, refuse).read();
  }

  string_view text_;
  std::vector<Datum> data_;
  std::vector<Left> lefts_;
};

}  // namespace

std::optional<std::string> rules_as_written(string_view written) {
  if (written.find('=') == string_view::npos || written.find_first_of("_[") == string_view::npos) return std::nullopt;
  const std::string text = without_alignment(written);
  std::vector<Datum> data;
  for (std::size_t at = 0; at < text.size(); ++at)
    if (const auto datum = datum_at(text, at)) {
      data.push_back(*datum);
      at = datum->end - 1;
    }
  const Rules rules(text, std::move(data));
  if (!rules.exist()) return std::nullopt;
  try {
    return rules.symbol();
  } catch (const SpecificationError& error) {
    throw SpecificationError(error.token(), characters_before(text, error.position() - 1) + 1, error.expected());
  }
}

std::string rules_text(const Mask& mask, bool decimals) {
  const LaurentPolynomial& symbol = mask.symbol();
  const long arity = mask.arity();
  const auto index = [](const std::string& i, long shift) { return shift == 0 ? i : fmt::format("{}{:+}", i, shift); };
  std::string lines;
  for (long phase = 0; phase < arity; ++phase) {
    std::string sum;
    // f'_{a i + phase} combines the f_{i+shift} by a_{phase - a shift}.
    for (long k = symbol.highest(); k >= symbol.lowest(); --k) {
      const Rational weight = symbol.coefficient(k);
      if (modulo(k, arity) != phase || weight == 0) continue;
      const Rational modulus = abs(weight);
      const std::string datum = index("i", (phase - k) / arity),
                        size = decimals ? fmt::format("{}", static_cast<double>(modulus)) : to_text(modulus);
      sum += weight < 0 ? (sum.empty() ? "-" : " - ") : sum.empty() ? "" : " + ";
      sum += fmt::format("{}{}", size == "1" ? "" : size + " ", datum == "i" ? "f_i" : "f_{" + datum + "}");
    }
    lines += fmt::format("f_{{{}}} = {}\n", index(std::to_string(arity) + "i", phase), sum.empty() ? "0" : sum);
  }
  return lines;
}

}  // namespace subcert
