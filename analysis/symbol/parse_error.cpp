#include "parse_error.hpp"

#include <utility>

namespace subcert {

std::string printable(std::string_view text) {
  constexpr std::size_t most = 40;
  std::string result;
  for (char c : text.substr(0, most)) result += (c >= ' ' && c <= '~') ? c : '?';
  return text.size() > most ? result + "..." : result;
}

ParseError::ParseError(const std::string& subject, std::string_view token, std::size_t position, std::string expected)
    : Error(ErrorKind::usage,
            fmt::format("{}, position {}: '{}'; expected {}", subject, position, printable(token), expected)),
      token_(printable(token)),
      position_(position),
      expected_(std::move(expected)) {}

}  // namespace subcert
