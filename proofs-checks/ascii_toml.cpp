#include "ascii_toml.hpp"

#include <subcert/analysis/symbol/support/utf8.hpp>
#include <subcert/proofs-checks/file_error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace subcert {

std::string ascii_toml(std::string_view text) {
  const auto is_ascii = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
  if (std::all_of(text.begin(), text.end(), is_ascii)) return std::string(text);
  constexpr std::string_view mark = "\xEF\xBB\xBF";  // of the order of bytes
  if (text.starts_with(mark)) text.remove_prefix(mark.size());
  std::string ascii;
  std::string_view quote;  // that ends the string which is open
  bool comment = false;
  std::uint32_t line = 1, column = 1;
  for (std::size_t i = 0, taken = 1; i < text.size(); i += taken, ++column) {
    const char c = text[i];
    const bool literal = !quote.empty() && quote[0] == '\'';
    taken = 1;
    if (!is_ascii(c)) {
      const auto refuse = [&](const char* why) { throw FileError({line, column}, std::string("not TOML: ") + why); };
      const auto [code, length] = first_character(text.substr(i));
      if (length == 0) refuse("not UTF-8");
      if (!comment && quote.empty()) refuse("a character beyond ASCII outside of strings and comments");
      if (!comment) ascii += fmt::format("\\U{:08X}", code);
      taken = length;
      continue;
    }
    if (c == '\n') {
      comment = false;
      if (quote.size() == 1) quote = {};
      ++line;
      column = 0;
    } else if (!quote.empty() && text.substr(i).starts_with(quote)) {
      ascii += std::string(quote.size(), '"');
      taken = quote.size();
      quote = {};
      continue;
    } else if (quote.empty() && !comment && (c == '"' || c == '\'')) {
      quote = text.substr(i, text.substr(i, 3) == std::string(3, c) ? 3 : 1);
      ascii += std::string(quote.size(), '"');
      taken = quote.size();
      continue;
    } else if (!quote.empty() && c == '\\') {
      if (literal) ascii += '\\';
      const bool pair = !literal && (text.substr(i + 1, 1) == "\"" || text.substr(i + 1, 1) == "\\");
      taken = pair ? 2 : 1;
    } else if (literal && c == '"') {
      ascii += '\\';
    } else if (quote.empty() && c == '#') {
      comment = true;
    }
    ascii += text.substr(i, taken);
  }
  return ascii;
}

}  // namespace subcert
