#pragma once
/// Files with matrices.

#include <subcert/analysis/radii/joint/constrained.hpp>

#include <string>

namespace subcert {

struct MatricesFile {
  MatrixFamily family;
  std::vector<Succession> graph;  ///< empty where all matrices may follow all
};

/// Reads JSON, {"matrices": [[["1", "1/2"], [0, 0.5]], ...], "edges": [[from, to, matrix], ...]} with or without edges,
/// or the text that `verify` reads: a line `matrices COUNT SIZE`, then a line `row ...` for each row. Numbers are
/// integers, fractions or decimals, all of them exact. Domain: `file` is what errors call the text. Errors: throws
/// Error with the place.
MatricesFile parse_matrices(const std::string& text, const std::string& file);

}  // namespace subcert
