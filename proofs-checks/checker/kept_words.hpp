// Graphs with products that attain the joint spectral radius: section 4.14 of ../certificates/SPEC.md.
#pragma once

#include "exact_radius.hpp"
#include "scheme.hpp"

#include <optional>

namespace subcert_check {

/// Of a state of a graph: the matrix of its norm, column by column, and its kept word, of one letter, if it has one.
struct KeptState {
  struct Word {
    std::size_t letter, to;
  };
  Vector coordinates;
  std::optional<Word> word;
};

/// Reads the lines `cycle` of a graph whose other words are below the bound, and shows that the joint spectral radius
/// is this number. False: there are none.
bool check_kept_words(const Family& family, const mpq_class& bound, const std::vector<KeptState>& states,
                      const ExactRadius& radius, Reader& reader, Arithmetic& arithmetic);

}  // namespace subcert_check
