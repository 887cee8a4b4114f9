#include "frequency_symbol.hpp"

#include "plain_text.hpp"
#include "specification.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/polynomials/expression.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/analysis/symbol/support/utf8.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace subcert {
namespace {

using std::string_view;

constexpr long most = 64;  // halves of the frequency in an argument, and powers
constexpr const char* argument_form = "a multiple of half a frequency, as e^{-i w}, exp(2 i w), cos(w/2) or sin^2(w/2)";

enum class Kind { exponential, cosine, sine };

/// A function of multiple/2 times the frequency, and its power; where it stands in the text.
struct Wave {
  Kind kind;
  std::size_t begin, end;
  long multiple = 0, power = 1;
};

class Symbol {
 public:
  explicit Symbol(string_view text) : text_(text) {
    for (std::size_t at = 0; at < text_.size(); ++at)
      if (const auto wave = wave_at(at)) {
        waves_.push_back(*wave);
        at = wave->end - 1;
      }
  }

  bool has_waves() const { return !waves_.empty(); }

  /// Behind the sign of an equation whose left side is a function, as `a(w) =`.
  std::string symbol() const {
    std::size_t begin = 0;
    if (const std::size_t equal = text_.find('='); equal != string_view::npos)
      if (trimmed(text_.substr(0, equal)).ends_with(')')) begin = equal + 1;
    std::size_t fields = text_.size();
    if (const std::size_t arity = text_.find("arity", begin); arity != string_view::npos)
      fields = std::min(text_.rfind(',', arity), text_.size());
    // In the square root of z where its odd powers occur.
    const bool halves = std::ranges::any_of(waves_, [&](const Wave& wave) {
      return wave.begin >= begin && wave.multiple % 2 != 0 && (wave.kind == Kind::exponential || wave.power % 2 != 0);
    });
    require_parameters_alone(begin, fields);
    std::string body = with_waves(begin, fields, [&](const Wave& wave) { return in_powers(wave, halves ? 2 : 1); });
    if (halves) body = in_whole_powers(body);
    return "symbol:" + body + std::string(text_.substr(fields));
  }

 private:
  [[noreturn]] void fail(std::size_t begin, std::size_t end, const std::string& expected) const {
    throw SpecificationError(text_.substr(begin, end - begin), begin + 1, expected);
  }

  bool is_word(std::size_t at, string_view word) const {
    const auto is_part = [&](std::size_t i) { return i < text_.size() && is_letter(text_[i]); };
    return text_.substr(at).starts_with(word) && (at == 0 || !is_part(at - 1)) &&
           (!is_part(at + word.size()) || !is_letter(word.back()));
  }

  std::size_t after_blanks(std::size_t at) const { return std::min(text_.find_first_not_of(' ', at), text_.size()); }

  /// Behind the bracket that opens at `at`.
  std::size_t closing(std::size_t at) const {
    const std::size_t end = closing_bracket(text_, at);
    if (end == string_view::npos) fail(at, text_.size(), "a bracket that closes");
    return end + 1;
  }
  bool opens(std::size_t at) const { return at < text_.size() && (text_[at] == '(' || text_[at] == '{'); }

  std::optional<Wave> wave_at(std::size_t at) {
    std::size_t end = at;
    const bool is_command = text_[at] == '\\';
    const std::size_t name = at + (is_command ? 1 : 0);
    if (is_command && text_.substr(name).starts_with("mathrm{e}^"))
      end = name + 10;
    else if (is_word(name, "e^") && !is_command)
      end = name + 2;
    if (end > at) return opens(end) && is_imaginary(end) ? std::optional(exponential(at, end)) : std::nullopt;
    if (is_word(name, "exp")) return exponential(at, after_blanks(name + 3));
    for (const auto& [word, kind] : {std::pair<string_view, Kind>{"cos", Kind::cosine}, {"sin", Kind::sine}})
      if (is_word(name, word)) return cosine_or_sine(kind, at, name + word.size());
    return std::nullopt;
  }

  /// Whether an i or j, and a frequency, stand in what opens there: e may be a parameter.
  bool is_imaginary(std::size_t at) const {
    const string_view inside = text_.substr(at + 1, closing(at) - at - 2);
    return inside.find_first_of("ijI") != string_view::npos;
  }

  Wave exponential(std::size_t begin, std::size_t at) {
    Wave wave{Kind::exponential, begin, at};
    read_argument(wave, true);
    return wave;
  }

  Wave cosine_or_sine(Kind kind, std::size_t begin, std::size_t at) {
    Wave wave{kind, begin, at};
    read_power(wave);
    const bool power_first = wave.end > at;
    const bool in_brackets = read_argument(wave, false);
    if (!power_first && in_brackets) read_power(wave);
    if (kind == Kind::sine && wave.power % 2 != 0) fail(wave.begin, wave.end, "an even power of a sine, as sin^2(w/2)");
    return wave;
  }

  /// `^4`, `^{4}`, `**4`, `⁴` where the wave ends, if any.
  void read_power(Wave& wave) const {
    std::size_t end = after_blanks(wave.end);
    if (end == text_.size()) return;
    const bool stars = text_.substr(end).starts_with("**");
    std::string power;
    const std::size_t begin = end;
    if (text_[end] == '^' || stars) {
      end += stars ? 2 : 1;
      const std::size_t last = opens(end) ? closing(end)
                                          : std::min(text_.find_first_not_of("0123456789", end), text_.size());
      power = trimmed(opens(end) ? text_.substr(end + 1, last - end - 2) : text_.substr(end, last - end));
      end = last;
    } else if (static_cast<unsigned char>(text_[end]) >= 0x80) {
      const std::size_t length = first_character(text_.substr(end)).length;
      try {
        power = plain_text("z" + std::string(text_.substr(end, length)));
      } catch (const SpecificationError&) {
        return;
      }
      if (!power.starts_with("z^")) return;
      power.erase(0, 2);
      end += length;
    } else {
      return;
    }
    const auto value = parse_number(power);
    if (!value || *value < 1 || *value > most || denominator(*value) != 1)
      fail(begin, end, fmt::format("a whole power from 1 to {}", most));
    wave.power = numerator(*value).convert_to<long>();
    wave.end = end;
  }

  /// In brackets, as a fraction of LaTeX or one name, where the wave ends; whether in brackets.
  bool read_argument(Wave& wave, bool imaginary) {
    std::size_t begin = after_blanks(wave.end);
    if (text_.substr(begin).starts_with("\\left(")) begin += 5;
    std::size_t end = begin;
    const bool in_brackets = opens(begin);
    if (in_brackets) {
      end = closing(begin);
    } else if (text_.substr(begin).starts_with("\\frac{")) {
      end = closing(begin + 5);
      if (opens(end)) end = closing(end);
    } else if (begin < text_.size()) {
      end = begin + (text_[begin] == '\\' ? 1 : std::max<std::size_t>(first_character(text_.substr(begin)).length, 1));
      if (text_[begin] == '\\' || is_letter(text_[begin]))
        while (end < text_.size() && is_letter(text_[end])) ++end;
    }
    wave.end = std::min(end, text_.size());
    string_view inside = text_.substr(begin, wave.end - begin);
    if (in_brackets) inside = inside.substr(1, inside.size() - 2);
    if (inside.ends_with("\\right")) inside.remove_suffix(6);
    const std::size_t next = after_blanks(wave.end);
    if (!in_brackets && next < text_.size() && (text_[next] == '/' || text_[next] == '^'))
      fail(wave.begin, next + 1, "parentheses about the argument, as cos(w/2)");
    wave.multiple = halves_in(wave, inside, imaginary);
    return in_brackets;
  }

  /// Of the frequency in an argument.
  long halves_in(const Wave& wave, string_view inside, bool imaginary) {
    const auto refuse = [&] { fail(wave.begin, wave.end, argument_form); };
    std::string text;
    try {
      text = plain_text(inside);
    } catch (const SpecificationError&) {
      refuse();
    }
    std::string in_letters;
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (!is_letter(text[i])) {
        in_letters += text[i];
        continue;
      }
      std::size_t end = i;
      while (end < text.size() && is_letter(text[end])) ++end;
      string_view name = string_view(text).substr(i, end - i);
      i = end - 1;
      const bool unit_first = imaginary && string_view("ijI").find(name.front()) != string_view::npos;
      const bool unit_last = !unit_first && imaginary && name.size() > 1 &&
                             string_view("ijI").find(name.back()) != string_view::npos && !is_greek(name);
      if (unit_first) name.remove_prefix(1);
      if (unit_last) name.remove_suffix(1);
      if (unit_first || unit_last) in_letters += "i";
      if (name.empty()) continue;
      if (string_view("ijI").find(name) != string_view::npos || (name.size() > 1 && !is_greek(name))) refuse();
      if (frequency_.empty()) frequency_ = name;
      if (name != frequency_) fail(wave.begin, wave.end, "the same frequency everywhere, here " + frequency_);
      in_letters += "w";
    }
    std::vector<Monomial> terms;
    try {
      terms = read_polynomial(in_letters, "iw", 1).terms();
    } catch (const ParseError&) {
      refuse();
    }
    if (terms.empty()) return 0;
    const MultivariatePolynomial::Exponents right{imaginary ? 1 : 0, 1};
    if (terms.size() != 1 || terms.front().exponents != right) refuse();
    const Rational halves = terms.front().coefficient * 2;
    if (denominator(halves) != 1 || halves > most || halves < -most) refuse();
    return numerator(halves).convert_to<long>();
  }

  /// The text from `begin` to `end` with `print` of each wave in its place.
  template <class Print>
  std::string with_waves(std::size_t begin, std::size_t end, Print print) const {
    std::string result;
    for (const Wave& wave : waves_) {
      if (wave.begin < begin || wave.begin >= end) continue;
      result += text_.substr(begin, wave.begin - begin);
      result += print(wave);
      begin = wave.end;
    }
    return plain_text(result += text_.substr(begin, end - begin));
  }

  /// Neither z nor the frequency stands beside the waves.
  void require_parameters_alone(std::size_t begin, std::size_t end) const {
    const std::string beside = with_waves(begin, end, [](const Wave&) { return "(1)"; });
    for (std::size_t i = 0; i < beside.size(); ++i) {
      const std::size_t first = i;
      while (i < beside.size() && is_letter(beside[i])) ++i;
      const string_view name = string_view(beside).substr(first, i - first);
      if (name == "z" || (!name.empty() && name == frequency_))
        fail(begin, end,
             fmt::format("{} in functions of {} alone", name == "z" ? "no z, but e^{i w}," : frequency_, frequency_));
    }
  }

  /// In z to the power 1/scale.
  static std::string in_powers(const Wave& wave, long scale) {
    const auto pair = [&](long halves) {
      return fmt::format("z^{{{}}}{}z^{{{}}}", halves * scale / 2, wave.kind == Kind::sine ? "-" : "+",
                         -halves * scale / 2);
    };
    if (wave.kind == Kind::exponential) return fmt::format("(z^{{{}}})", wave.multiple * scale / 2);
    if (wave.power % 2 != 0) return fmt::format("(({})/2)^{}", pair(wave.multiple), wave.power);
    return fmt::format("((2{}{})/4)^{}", wave.kind == Kind::sine ? "-" : "+", pair(2 * wave.multiple), wave.power / 2);
  }

  /// What an expression in the square root of z is in z.
  std::string in_whole_powers(const std::string& body) const {
    std::vector<Monomial> terms;
    try {
      terms = read_polynomial(body, "z", most * most).terms();
    } catch (const ParseError&) {
      fail(0, text_.size(), fmt::format("numbers alone where odd multiples of {}/2 stand", frequency_));
    }
    for (Monomial& term : terms) {
      if (term.exponents.front() % 2 != 0)
        fail(0, text_.size(),
             fmt::format("whole multiples of {0} once it is multiplied out; a factor e^{{-i {0}/2}} "
                         "moves the mask by half a step",
                         frequency_));
      term.exponents.front() /= 2;
    }
    return in_one_letter({1, terms}).to_text();
  }

  string_view text_;
  std::vector<Wave> waves_;
  std::string frequency_;
};

}  // namespace

std::optional<std::string> frequency_symbol_as_written(std::string_view written) {
  if (written.find('[') != string_view::npos) return std::nullopt;
  const bool formula = written.size() > 1 && written.starts_with('$') && written.ends_with('$');
  const std::size_t before = formula ? 1 : written.starts_with("symbol:") ? 7 : 0;
  const string_view text = written.substr(before, written.size() - before - (formula ? 1 : 0));
  try {
    const Symbol symbol(text);
    return symbol.has_waves() ? std::optional(symbol.symbol()) : std::nullopt;
  } catch (const SpecificationError& error) {
    const std::size_t bytes = before + error.position() - 1;
    throw SpecificationError(error.token(), characters_before(written, bytes) + 1, error.expected());
  }
}

}  // namespace subcert
