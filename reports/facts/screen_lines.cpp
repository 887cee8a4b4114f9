#include "screen_lines.hpp"

#include <algorithm>

namespace subcert::facts {
namespace {

/// Where a line is broken: at the last blank that makes it short enough, else at the first one; npos if at none.
std::size_t break_of(const std::string& line, std::size_t indent, std::size_t width) {
  const std::size_t begin = line.find_first_not_of(' ', std::min(indent, line.size()));
  if (line.size() <= width || begin == std::string::npos) return std::string::npos;
  const std::size_t last = line.rfind(' ', width);
  return last != std::string::npos && last > begin ? last : line.find(' ', std::max(begin, width));
}

}  // namespace

std::string wrapped(const std::string& text, std::size_t indent, std::size_t width) {
  std::string result;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string line = text.substr(at, end - at);
    for (std::size_t cut; (cut = break_of(line, indent, width)) != std::string::npos;) {
      const std::size_t rest = line.find_first_not_of(' ', cut);
      if (rest == std::string::npos) break;
      result += line.substr(0, line.find_last_not_of(' ', cut) + 1) + "\n";
      line = std::string(indent, ' ') + line.substr(rest);
    }
    result += line + (end < text.size() ? "\n" : "");
    at = end + 1;
  }
  return result;
}

}  // namespace subcert::facts
