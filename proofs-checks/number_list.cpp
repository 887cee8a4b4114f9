#include "number_list.hpp"

#include <subcert/analysis/symbol/support/parse_error.hpp>

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>

namespace subcert {
namespace {

std::optional<int> parse_integer(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || text.front() == '-' || error != std::errc() || end != text.data() + text.size())
    return std::nullopt;
  return value;
}

}  // namespace

std::vector<int> parse_number_list(const std::string& subject, std::string_view text, int lowest, int highest) {
  const std::string bounds = "from " + std::to_string(lowest) + " to " + std::to_string(highest);
  std::set<int> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string_view token = text.substr(begin, end - begin);
    const std::size_t dots = token.find("..");
    const auto first = parse_integer(token.substr(0, dots));
    const auto last = dots == std::string_view::npos ? first : parse_integer(token.substr(dots + 2));
    if (!first || !last || *first < lowest || *last > highest || *first > *last)
      throw ParseError(subject, token, begin + 1,
                       "an integer " + bounds + " or a range A..B of such with A <= B, as in 1..5,8");
    for (int n = *first; n <= *last; ++n) numbers.insert(n);
    begin = end + 1;
  }
  return {numbers.begin(), numbers.end()};
}

std::string number_list_text(const std::vector<int>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t end = i + 1;
    while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1) ++end;
    if (!text.empty()) text += ',';
    text += std::to_string(numbers[i]);
    if (end - i >= 3)
      text += ".." + std::to_string(numbers[end - 1]);
    else
      end = i + 1;
    i = end;
  }
  return text;
}

}  // namespace subcert
