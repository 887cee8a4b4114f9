#pragma once
// Upper bounds by quadratic forms, and by graphs of words that are checked with few digits: sections 4.8, 4.13 and
// 4.14 of ../certificates/SPEC.md.

#include "exact_radius.hpp"
#include "scheme.hpp"

#include <optional>

namespace subcert_check {

struct GraphBound {
  mpq_class bound;
  bool attained;  // some product has the exact radius, which is that of the block
};

/// What a section `graph` proves; `fields` are those of its first line. `exact`: the number that the radius may be, or
/// nullptr.
GraphBound read_graph(const Family& family, const Fields& fields, const ExactRadius* exact, Reader& reader,
                      Arithmetic& arithmetic);

/// What a section `quadratic` proves.
GraphBound read_quadratic(const Family& family, const Fields& fields, const ExactRadius* exact, Reader& reader,
                          Arithmetic& arithmetic);

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
