#include "piecewise_rule.hpp"

#include <subcert/analysis/symbol/error.hpp>

#include <algorithm>

namespace subcert::piecewise {

bool Rule::is_function() const {
  return std::all_of(pieces.begin(), pieces.end(), [](const Piece& piece) { return piece.own == 0; });
}

Rational lipschitz_constant(const Rule& rule) {
  require(rule.is_function() && !rule.pieces.empty(), "Lipschitz constant: need a rule with one answer to each datum");
  Rational largest = 0;
  for (const Piece& piece : rule.pieces)
    for (const Row& output : piece.outputs) {
      Rational sum = 0;
      for (const Rational& entry : output) sum += abs(entry);
      largest = std::max(largest, sum);
    }
  return largest;
}

}  // namespace subcert::piecewise
