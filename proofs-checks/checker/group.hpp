// Groups that permute the matrices of a family: section 4.7 of ../certificates/SPEC.md.
#pragma once

#include "scheme.hpp"

namespace subcert_check {

/// A map g, column by column, with T_t g = g T_s for all t, s = letters[t].
struct Generator {
  Vector map;
  std::vector<std::size_t> letters;
};

/// The one that a letter names, A the first.
const Generator& named_generator(char letter, const std::vector<Generator>& generators);

/// An index, and after it a word of generators, as in `12AB`.
struct TurnedIndex {
  std::size_t index;
  std::string word;

  auto operator<=>(const TurnedIndex&) const = default;
};
TurnedIndex parse_turned_index(std::string_view text, std::size_t count);

/// The K of `group:K`; 0 for anything else.
std::size_t parse_group(std::string_view property);

/// Reads that many and shows that they generate a finite group.
std::vector<Generator> read_generators(const Family& family, std::size_t count, Reader& reader, Arithmetic& arithmetic);

}  // namespace subcert_check
