#pragma once
/// What readers of TOML files share. Inner: no public header may read toml++.

#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/proofs-checks/ascii_toml.hpp>
#include <subcert/proofs-checks/file_error.hpp>

#define TOML_HEADER_ONLY 1
#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>

#include <string_view>

namespace subcert {

inline Place place_of(const toml::source_region& source) { return {source.begin.line, source.begin.column}; }
inline Place place_of(const toml::node& node) { return place_of(node.source()); }

/// Errors: throws FileError for what is no TOML or longer than 10^6 characters.
inline toml::table parse_toml(std::string_view text) {
  if (text.size() > 1'000'000) throw FileError({1, 1}, "at most 1,000,000 characters");
  const std::string ascii = ascii_toml(text);
  try {
    return toml::parse(ascii);
  } catch (const toml::parse_error& error) {
    throw FileError(place_of(error.source()), "not TOML: " + visible(error.description()));
  }
}

}  // namespace subcert
