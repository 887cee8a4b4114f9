#pragma once
// What tests of expected properties share.

#include "../properties.hpp"

#include <subcert/cmake/catch.hpp>

#include <initializer_list>
#include <string>

namespace subcert::properties::testing {

/// The answer to the first question of the file.
inline Decision first_answer(const std::string& text) {
  const auto schemes = read_expectations(text);
  return has_property(schemes.at(0), schemes.at(0).expectations.at(0), {20});
}

/// All of these hold for the mask.
inline void check_all(const std::string& mask, std::initializer_list<const char*> properties) {
  for (const char* text : properties) {
    CAPTURE(text);
    CHECK(first_answer(mask + text).is_yes());
  }
}

/// Why the file is refused.
inline std::string error_of(const std::string& text) {
  try {
    read_expectations(text);
  } catch (const FileError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace subcert::properties::testing
