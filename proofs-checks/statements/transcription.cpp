#include "transcription.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/analysis/symbol/support/utf8.hpp>

#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <stdexcept>

namespace subcert::statements {
namespace {

struct Number {
  std::size_t begin;
  std::size_t length;
};

std::vector<Number> numbers(const std::string& text) {
  std::vector<Number> result;
  for (std::size_t i = 0; i < text.size();) {
    if (!is_digit(text[i])) {
      ++i;
      continue;
    }
    const std::size_t begin = i;
    while (i < text.size() && (is_digit(text[i]) || (text[i] == '.' && i + 1 < text.size() && is_digit(text[i + 1]))))
      ++i;
    result.push_back({begin, i - begin});
  }
  return result;
}

/// The number with `ulps` added in its last place, as many decimals as before.
std::string raised(const std::string& number, long ulps) {
  const std::size_t point = number.find('.');
  const long decimals = point == std::string::npos ? 0 : static_cast<long>(number.size() - point - 1);
  std::string digits = number;
  if (point != std::string::npos) digits.erase(point, 1);
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
  const Rational scaled = *parse_rational(digits) + ulps;
  return to_fixed(scaled * power(Rational(10), -decimals), static_cast<int>(decimals), Rounding::nearest);
}

struct Braces {
  std::size_t open;
  std::size_t arrow;
  std::size_t close;
};

std::vector<Braces> braces(const std::string& text) {
  std::vector<Braces> result;
  const auto fail = [&](std::size_t at, const std::string& expected) {
    throw ParseError("transcription", std::string_view(text).substr(at), at + 1, expected);
  };
  for (std::size_t at = text.find_first_of("{}"); at != std::string::npos; at = text.find_first_of("{}", at + 1)) {
    if (text[at] == '}') fail(at, "'{' before '}'");
    const std::size_t arrow = text.find("=>", at), close = text.find_first_of("{}", at + 1);
    if (close == std::string::npos || text[close] == '{') fail(at, "'}'");
    if (arrow == std::string::npos || arrow > close) fail(at, "'=>'");
    result.push_back({at, arrow, close});
    at = close;
  }
  return result;
}

}  // namespace

std::string form_text(const std::string& text, Form form) {
  std::string result;
  std::size_t from = 0;
  for (const Braces& place : braces(text)) {
    result += text.substr(from, place.open - from);
    result += trimmed(form == Form::printed ? text.substr(place.open + 1, place.arrow - place.open - 1)
                                            : text.substr(place.arrow + 2, place.close - place.arrow - 2));
    from = place.close + 1;
  }
  return result + text.substr(from);
}

std::size_t number_count(const std::string& text) { return numbers(text).size(); }

std::string with_changed_number(const std::string& text, std::size_t index) {
  const Number number = numbers(text).at(index);
  const std::string old = text.substr(number.begin, number.length);
  return text.substr(0, number.begin) + raised(old, old.find('.') == std::string::npos ? 1 : 3) +
         text.substr(number.begin + number.length);
}

bool is_in_misprint(const std::string& text, std::size_t index) {
  const std::size_t at = numbers(text).at(index).begin;
  const auto places = braces(text);
  return std::any_of(places.begin(), places.end(), [&](const Braces& p) { return p.open < at && at < p.arrow; });
}

Transcriptions::Transcriptions(const std::vector<Transcription>& all) {
  for (const Transcription& one : all)
    if (!texts_.emplace(one.id, one.text).second)
      fail(ErrorKind::data, "transcriptions: need different ids, got {} twice", one.id);
}

const std::string& Transcriptions::text(const std::string& id) const {
  const auto found = texts_.find(id);
  require(found != texts_.end(), "no transcription '{}'", id);
  return found->second;
}

std::vector<std::string> Transcriptions::ids() const {
  std::vector<std::string> result;
  for (const auto& [id, text] : texts_) result.push_back(id);
  return result;
}

Transcriptions Transcriptions::with(const std::string& id, const std::string& text) const {
  Transcriptions result = *this;
  result.texts_.at(id) = text;
  return result;
}

Formula Transcriptions::formula(const std::string& id, Form form) const {
  return Formula::parse(form_text(text(id), form));
}

std::vector<Formula> Transcriptions::list(const std::string& id, Form form) const {
  const std::string whole = trimmed(form_text(text(id), form));
  const std::size_t close = whole.rfind(']');
  if (whole.empty() || whole.front() != '[' || close == std::string::npos)
    throw ParseError("transcription", whole, 1, "a list in square brackets");
  const std::string divisor = whole.substr(close + 1);
  std::vector<Formula> result;
  std::istringstream entries(whole.substr(1, close - 1));
  for (std::string entry; std::getline(entries, entry, ',');)
    result.push_back(Formula::parse("(" + entry + ")" + divisor));
  return result;
}

std::vector<std::string> Transcriptions::words(const std::string& id, Form form) const {
  std::istringstream stream(form_text(text(id), form));
  std::vector<std::string> result;
  for (std::string word; stream >> word;) result.push_back(word);
  return result;
}

std::string Transcriptions::latex(const std::string& id, Form form) const {
  std::string whole = trimmed(form_text(text(id), form));
  if (whole.front() == '[') return whole;
  if (whole.find('.') != std::string::npos) return fmt::format("{}", fmt::join(words(id, form), ", \\; "));
  return formula(id, form).to_latex();
}

}  // namespace subcert::statements
