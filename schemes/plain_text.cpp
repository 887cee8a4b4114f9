#include "plain_text.hpp"

#include "specification.hpp"

#include <subcert/analysis/symbol/support/utf8.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <utility>

namespace subcert {
namespace {

using std::string_view;

constexpr int max_depth = 20;  // of fractions in fractions

/// From alpha, as Unicode has them, with both forms of sigma; omicron and pi are no names here.
constexpr std::array<string_view, 25> greek{
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta",  "eta", "theta",   "iota", "kappa", "lambda", "mu",   "nu",
    "xi",    "",     "",      "rho",   "sigma",   "sigma", "tau", "upsilon", "phi",  "chi",   "psi",    "omega"};
constexpr std::array<string_view, 11> capital_greek{"Gamma", "Delta", "Theta",   "Lambda", "Xi",   "Pi",
                                                    "Sigma", "Phi",   "Upsilon", "Psi",    "Omega"};

constexpr std::array<std::pair<std::uint32_t, string_view>, 42> signs{{
    {0x00A0, " "}, {0x2002, " "}, {0x2003, " "}, {0x2004, " "}, {0x2005, " "}, {0x2006, " "}, {0x2007, " "},
    {0x2008, " "}, {0x2009, " "}, {0x200A, " "}, {0x202F, " "}, {0x205F, " "}, {0x2010, "-"}, {0x2011, "-"},
    {0x2012, "-"}, {0x2013, "-"}, {0x2212, "-"}, {0xFE63, "-"}, {0xFF0D, "-"}, {0xFF0B, "+"}, {0x00B7, "*"},
    {0x00D7, "*"}, {0x2062, "*"}, {0x2217, "*"}, {0x2219, "*"}, {0x22C5, "*"}, {0xFF0A, "*"}, {0x00F7, "/"},
    {0x2044, "/"}, {0x2215, "/"}, {0xFF0F, "/"}, {0xFF08, "("}, {0xFF09, ")"}, {0xFF3B, "["}, {0xFF3D, "]"},
    {0xFF0C, ","}, {0xFF1A, ":"}, {0xFF1B, ";"}, {0xFF1D, "="}, {0x2061, ""},  {0x2064, "+"}, {0x2236, ":"},
}};

constexpr std::array<std::pair<std::uint32_t, string_view>, 18> fractions{{
    {0x00BC, "1/4"},
    {0x00BD, "1/2"},
    {0x00BE, "3/4"},
    {0x2150, "1/7"},
    {0x2151, "1/9"},
    {0x2152, "1/10"},
    {0x2153, "1/3"},
    {0x2154, "2/3"},
    {0x2155, "1/5"},
    {0x2156, "2/5"},
    {0x2157, "3/5"},
    {0x2158, "4/5"},
    {0x2159, "1/6"},
    {0x215A, "5/6"},
    {0x215B, "1/8"},
    {0x215C, "3/8"},
    {0x215D, "5/8"},
    {0x215E, "7/8"},
}};

constexpr std::array<std::pair<string_view, string_view>, 24> commands{{
    {"cdot", "*"}, {"times", "*"}, {"ast", "*"},   {"left", ""}, {"right", ""}, {"big", ""},
    {"Big", ""},   {"bigl", ""},   {"bigr", ""},   {"Bigl", ""}, {"Bigr", ""},  {"biggl", ""},
    {"biggr", ""}, {"quad", " "},  {"qquad", " "}, {",", " "},   {";", " "},    {":", " "},
    {"!", ""},     {" ", " "},     {"{", "["},     {"}", "]"},   {"\\", ";"},   {"displaystyle", ""},
}};

template <std::size_t N, class Key>
std::optional<string_view> found(const std::array<std::pair<Key, string_view>, N>& table, Key key) {
  for (const auto& [one, meaning] : table)
    if (one == key) return meaning;
  return std::nullopt;
}

bool is_whole(string_view text) {
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) text.remove_prefix(1);
  return !text.empty() && std::ranges::all_of(text, is_digit);
}

/// The name of a letter, or nothing.
string_view greek_name(std::uint32_t code) {
  if (code == 0x00B5) return "mu";
  if (code >= 0x03B1 && code <= 0x03C9) return greek[code - 0x03B1];
  if (code == 0x03D1) return "theta";
  if (code == 0x03D5) return "phi";
  if (code == 0x03F5) return "epsilon";
  return {};
}

/// A digit or a sign above the line (or below), or nothing.
char raised(std::uint32_t code) {
  if (code == 0x00B9) return '1';
  if (code == 0x00B2 || code == 0x00B3) return static_cast<char>('0' + (code - 0x00B0));
  if (code == 0x2070 || (code >= 0x2074 && code <= 0x2079)) return static_cast<char>('0' + (code - 0x2070));
  return code == 0x207A ? '+' : code == 0x207B ? '-' : '\0';
}
char lowered(std::uint32_t code) {
  return code >= 0x2080 && code <= 0x2089 ? static_cast<char>('0' + (code - 0x2080)) : '\0';
}

class Plain {
 public:
  /// `at`: where the text begins in what was written.
  Plain(string_view text, std::size_t at, int depth) : text_(text), origin_(at), depth_(depth) {}

  std::string read() {
    if (depth_ > max_depth) fail(0, 1, "fractions at most " + std::to_string(max_depth) + " deep");
    while (at_ < text_.size()) step();
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(std::size_t at, std::size_t length, const std::string& expected) const {
    throw SpecificationError(text_.substr(at, length), origin_ + at + 1, expected);
  }

  void step() {
    const char c = text_[at_];
    if (c == '\\') return command();
    if (c == '^' && text_.substr(at_ + 1).starts_with('{')) return braced_power();
    if (text_.substr(at_).starts_with("**")) return plain("^", 2);
    if (c == '{' || c == '}') return plain(c == '{' ? "[" : "]", 1);
    if (c == '&' && in_list()) return plain(",", 1);
    if (c == '~') return plain(" ", 1);
    const auto [code, length] = first_character(text_.substr(at_));
    if (length < 2) return plain(text_.substr(at_, 1), 1);
    if (const auto sign = found(signs, code)) return plain(*sign, length);
    if (const auto value = found(fractions, code)) return fraction(std::string(*value), length);
    if (const string_view name = greek_name(code); !name.empty()) return letter(name, length);
    if (raised(code) != '\0') return superscript();
    plain(text_.substr(at_, length), length);
  }

  void plain(string_view meaning, std::size_t length) {
    if (!meaning.empty()) {
      const char c = meaning.front();
      if (after_power_ && (is_digit(c) || c == '.')) fail(at_, 1, "a * behind the power");
      if (after_letter_ && is_letter(c)) beside_letter();
      after_power_ = after_letter_ = false;
    }
    result_ += meaning;
    at_ += length;
  }

  /// In a list a blank may part entries; outside, a star would end what stands under a quotient.
  void beside_letter() {
    if (in_list()) fail(at_, 1, "a * between the names of two parameters");
    result_ += ' ';
  }

  void letter(string_view name, std::size_t length) {
    if (!result_.empty() && is_letter(result_.back())) beside_letter();
    plain(name, length);
    after_letter_ = true;
  }

  /// A number that stands for itself: not behind digits, which 3½ could add or multiply.
  void fraction(const std::string& value, std::size_t length) {
    const std::size_t before = result_.find_last_not_of(' ');
    const bool number = before != std::string::npos &&
                        (is_digit(result_[before]) ||
                         (result_[before] == '.' && (before == 0 || result_[before - 1] != '.')));  // 0..½
    if (number && (before + 1 == result_.size() || text_.find(',') != string_view::npos || !in_list()))
      fail(at_, length, "a + or * before a fraction that follows a number");
    plain("(" + value + ")", length);
  }
  bool in_list() const { return std::ranges::count(result_, '[') > std::ranges::count(result_, ']'); }

  /// z² as z^2; ¹⁄₁₆ as (1/16).
  void superscript() {
    std::string digits, below;
    const auto take = [&](auto character) {
      std::string taken;
      for (std::size_t end = at_ + length_; end < text_.size();) {
        const auto [code, length] = first_character(text_.substr(end));
        const char c = length < 2 ? '\0' : character(code);
        if (c == '\0') break;
        taken += c;
        length_ += length;
        end += length;
      }
      return taken;
    };
    length_ = 0;
    digits = take(raised);
    const auto [slash, bytes] = at_ + length_ < text_.size() ? first_character(text_.substr(at_ + length_))
                                                             : Character{0, 0};
    if (slash == 0x2044 || (slash == '/' && bytes == 1 && begins_lowered(at_ + length_ + 1))) {
      length_ += bytes;
      below = take(lowered);
      if (!is_whole(digits) || below.empty()) fail(at_, length_, "a fraction of whole numbers");
      return fraction(digits + "/" + below, length_);
    }
    const bool has_base = !result_.empty() &&
                          (std::isalnum(static_cast<unsigned char>(result_.back())) != 0 || result_.back() == ')');
    if (!has_base || after_power_ || !is_whole(digits)) fail(at_, length_, "a base before the power, as z²");
    plain("^", 0);
    result_ += digits;
    at_ += length_;
    after_power_ = true;
  }
  bool begins_lowered(std::size_t at) const {
    return at < text_.size() && lowered(first_character(text_.substr(at)).code) != '\0';
  }

  /// What stands between the braces that open here, and their end.
  std::pair<string_view, std::size_t> group(std::size_t begin) const {
    int depth = 0;
    for (std::size_t i = begin; i < text_.size(); ++i) {
      if (text_[i] == '\\')
        ++i;
      else if (text_[i] == '{')
        ++depth;
      else if (text_[i] == '}' && --depth == 0)
        return {text_.substr(begin + 1, i - begin - 1), i + 1};
    }
    fail(begin, text_.size() - begin, "a brace that closes");
  }

  void braced_power() {
    const auto [inside, end] = group(at_ + 1);
    const std::string power = trimmed(Plain(inside, origin_ + at_ + 2, depth_ + 1).read());
    if (!is_whole(power)) fail(at_ + 1, end - at_ - 1, "a whole number as power, as z^{-2}");
    plain("^", 0);
    result_ += power;
    at_ = end;
    after_power_ = true;
  }

  void command() {
    const std::size_t begin = at_;
    std::size_t end = at_ + 1;
    while (end < text_.size() && is_letter(text_[end])) ++end;
    if (end == begin + 1) end = std::min(end + 1, text_.size());
    const string_view name = text_.substr(begin + 1, end - begin - 1);
    if (const auto meaning = found(commands, name)) return plain(*meaning, end - begin);
    if (name == "frac" || name == "tfrac" || name == "dfrac") return latex_fraction(end);
    if (name == "begin" || name == "end") return matrix(name, end);
    const string_view letter_name = name.starts_with("var") ? name.substr(3) : name;
    if (is_greek(letter_name)) return letter(letter_name, end - begin);
    fail(begin, end - begin, "LaTeX of \\frac, \\cdot, \\left, Greek letters and matrices alone");
  }

  void matrix(string_view name, std::size_t end) {
    if (end >= text_.size() || text_[end] != '{') fail(at_, end - at_, "the name of a matrix in braces");
    const auto [inside, after] = group(end);
    if (!inside.ends_with("matrix")) fail(at_, after - at_, "a matrix, as \\begin{pmatrix}");
    plain(name == "begin" ? "[" : "]", after - at_);
  }

  /// `\frac{1}{16}`, `\frac12`, `\frac{w}{2}`
  void latex_fraction(std::size_t end) {
    const auto argument = [&] {
      end = std::min(text_.find_first_not_of(' ', end), text_.size());
      if (end == text_.size()) fail(at_, end - at_, "\\frac with two arguments");
      string_view inside = text_.substr(end, 1);
      const std::size_t begin = end + (inside == "{" ? 1 : 0);
      if (inside == "{")
        std::tie(inside, end) = group(end);
      else if (std::isalnum(static_cast<unsigned char>(inside.front())) != 0)
        ++end;
      else
        fail(at_, end - at_, "\\frac with its arguments in braces");
      return trimmed(Plain(inside, origin_ + begin, depth_ + 1).read());
    };
    const std::string above = argument(), below = argument();
    const bool whole = is_whole(above) && is_whole(below) && is_digit(below.front());
    fraction(whole ? above + "/" + below : "(" + above + ")/(" + below + ")", end - at_);
  }

  string_view text_;
  std::size_t origin_;
  int depth_;
  std::size_t at_ = 0, length_ = 0;
  std::string result_;
  bool after_power_ = false, after_letter_ = false;
};

}  // namespace

std::size_t closing_bracket(string_view text, std::size_t begin) {
  const char open = text[begin], close = open == '{' ? '}' : open == '[' ? ']' : ')';
  int depth = 0;
  for (std::size_t i = begin; i < text.size(); ++i) {
    depth += text[i] == open ? 1 : text[i] == close ? -1 : 0;
    if (depth == 0) return i;
  }
  return string_view::npos;
}

bool is_greek(string_view word) {
  return !word.empty() && (std::ranges::find(greek, word) != greek.end() ||
                           std::ranges::find(capital_greek, word) != capital_greek.end());
}

std::string plain_text(string_view text) {
  const bool formula = text.size() > 1 && text.starts_with('$') && text.ends_with('$');
  try {
    return Plain(formula ? text.substr(1, text.size() - 2) : text, formula ? 1 : 0, 0).read();
  } catch (const SpecificationError& error) {
    throw SpecificationError(error.token(), characters_before(text, error.position() - 1) + 1, error.expected());
  }
}

}  // namespace subcert
