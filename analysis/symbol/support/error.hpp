#pragma once
/// What goes wrong and whose matter it is: one root for every exception that the library throws on purpose.

#include <fmt/core.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace subcert {

/// Whose matter an error is. The command line maps kinds to exit codes (cli/main.cpp).
enum class ErrorKind {
  usage,         ///< a text that cannot be read as a scheme, a number, an option
  domain,        ///< an argument outside of the domain of a function
  size,          ///< an argument beyond what the function is able or willing to treat
  data,          ///< a file whose content is not what its format asks for
  missing_file,  ///< a file or folder that cannot be read or written
  undecided,     ///< neither yes nor no within the limits given
};

/// what() is one line that names what was wrong, where, and what would be right.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& what) : std::runtime_error(what), kind_(kind) {}
  ErrorKind kind() const { return kind_; }

 private:
  ErrorKind kind_;
};

/// Throws an Error whose text is formatted from the arguments. Meant for `need CONDITION, got VALUE`.
template <class... Arguments>
[[noreturn]] void fail(ErrorKind kind, fmt::format_string<Arguments...> text, Arguments&&... arguments) {
  throw Error(kind, fmt::format(text, std::forward<Arguments>(arguments)...));
}

/// fail(ErrorKind::domain, ...) unless the condition holds: a precondition and the text that names it. The arguments
/// are evaluated in either case.
template <class... Arguments>
void require(bool condition, fmt::format_string<Arguments...> text, Arguments&&... arguments) {
  if (!condition) fail(ErrorKind::domain, text, std::forward<Arguments>(arguments)...);
}

}  // namespace subcert
