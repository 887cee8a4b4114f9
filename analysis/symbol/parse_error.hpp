#pragma once
/// Text that cannot be read: what, where, and what would be right.

#include "error.hpp"

#include <string>
#include <string_view>

namespace subcert {

/// At most 40 characters of the text, unprintable ones replaced by `?`, and `...` for what is cut.
std::string printable(std::string_view text);

/// what() is one printable line `SUBJECT, position P: 'TOKEN'; expected EXPECTED` with the 1-based position P.
class ParseError : public Error {
 public:
  /// Tokens are cut to 40 characters and unprintable ones replaced.
  ParseError(const std::string& subject, std::string_view token, std::size_t position, std::string expected);

  const std::string& token() const { return token_; }
  std::size_t position() const { return position_; }
  const std::string& expected() const { return expected_; }

 private:
  std::string token_;
  std::size_t position_;
  std::string expected_;
};

}  // namespace subcert
