#pragma once
// Texts that are refused, each with the place of what is wrong.

#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/cmake/catch.hpp>

#include <string>
#include <utility>
#include <vector>

namespace subcert::testing {

template <class Read>
void check_refused(const std::vector<std::pair<std::string, std::size_t>>& places, const Read& read) {
  for (const auto& [text, position] : places) {
    CAPTURE(text);
    try {
      read(text);
      FAIL("not refused");
    } catch (const ParseError& error) {
      CHECK(error.position() == position);
    }
  }
}

}  // namespace subcert::testing
