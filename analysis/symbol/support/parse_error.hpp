#pragma once
/// Text that cannot be read: what, where, and what would be right.

#include "error.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace subcert {

/// The text on one line, in valid UTF-8, with nothing that cannot be seen: bytes that are no UTF-8 as `\xNN`, control
/// characters and blanks other than the plain one as `\u00a0`, all others as they are.
std::string visible(std::string_view text);

/// The same of at most 40 characters, and `...` for what is cut.
std::string printable(std::string_view text);

/// The token between quotes, as printable; where a character is beyond ASCII its code follows, as look-alikes of signs
/// and digits are seen by it alone: `'−3' (with U+2212)`.
std::string in_quotes(std::string_view token);

/// what() is one line `SUBJECT, position P: 'TOKEN'; expected EXPECTED` with the 1-based position P, in bytes.
class ParseError : public Error {
 public:
  /// Tokens are printed as `in_quotes` has them.
  ParseError(const std::string& subject, std::string_view token, std::size_t position, std::string expected);

  const std::string& token() const { return token_; }
  std::size_t position() const { return position_; }
  const std::string& expected() const { return expected_; }

 private:
  std::string token_;
  std::size_t position_;
  std::string expected_;
};

/// The word of `known` that is meant: the one from which it differs by the fewest insertions, deletions, changes and
/// swaps of letters, at most a third of its length, case aside; empty where none is that near. Cost: the product of the
/// lengths for each word.
std::string nearest_word(std::string_view word, const std::vector<std::string>& known);

/// `; did you mean 'primal'?`, the nearest word or else the only one that begins so; or nothing.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);

/// `'pirmal'; expected primal, dual; did you mean 'primal'?`
std::string expected_one_of(const std::vector<std::string>& known, std::string_view word);

}  // namespace subcert
