#pragma once
/// Errors of files that people write, with the place.

#include <subcert/analysis/symbol/support/error.hpp>

#include <string>

namespace subcert {

/// Counted from 1.
struct Place {
  unsigned line;
  unsigned column;
};

/// A file that cannot be read as what it is to be; what() is one line `line L, column C: MESSAGE`.
class FileError : public Error {
 public:
  FileError(const Place& at, const std::string& what_is_wrong)
      : Error(ErrorKind::data, fmt::format("line {}, column {}: {}", at.line, at.column, what_is_wrong)),
        place(at),
        message(what_is_wrong) {}
  const Place place;
  const std::string message;
};

}  // namespace subcert
