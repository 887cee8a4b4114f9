#pragma once
/// Texts for gnuplot.

#include <string>

namespace subcert::formats {

/// gnuplot without a word: whether it drew shows in the picture.
inline constexpr const char* gnuplot_command = "gnuplot 2>/dev/null || :";

/// The text between double quotes, as gnuplot reads strings; what its enhanced mode makes of it is not touched.
inline std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

}  // namespace subcert::formats
