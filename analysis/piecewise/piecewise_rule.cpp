#include "piecewise_rule.hpp"

#include "cone_program.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>

namespace subcert::piecewise {

Rational value_at(const Row& form, const std::vector<Rational>& x) {
  Rational sum = 0;
  for (std::size_t j = 0; j < form.size(); ++j)
    if (x[j] != 0) sum += form[j] * x[j];
  return sum;
}

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

std::optional<Rational> largest_output(const Rule& rule, const Deadline& deadline) {
  Rational largest = 0;
  for (const Piece& piece : rule.pieces) {
    const std::vector<Side> sides(piece.cell.size(), Side::nonnegative);
    for (Row output : piece.outputs)
      for (const int sign : {1, -1}) {
        if (deadline.expired()) return std::nullopt;
        if (sign < 0)
          for (Rational& entry : output) entry = -entry;
        const ConeProgram program(rule.points + piece.own, rule.points, piece.cell, output);
        ConeProgram::Corner corner = program.corner_of_box();
        if (!program.improve(corner, sides, 0)) return std::nullopt;
        const auto bound = program.bound(corner, sides);
        if (!bound) return std::nullopt;
        largest = std::max(largest, bound->bound);
      }
  }
  return largest;
}

std::optional<Mask> linear_mask(const Rule& rule, long first) {
  if (rule.pieces.empty() || !rule.is_function()) return std::nullopt;
  const std::vector<Row>& outputs = rule.pieces.front().outputs;
  for (const Piece& piece : rule.pieces)
    if (piece.outputs != outputs) return std::nullopt;
  // Datum r of window 0 has the index first + r; output `phase` of it has the coefficient of phase - a (first + r).
  const std::size_t a = rule.places.size();
  std::vector<Rational> coefficients(a * rule.points, 0);
  for (std::size_t r = 0; r < rule.points; ++r)
    for (std::size_t phase = 0; phase < a; ++phase) coefficients[a * (rule.points - 1 - r) + phase] = outputs[phase][r];
  const int arity = rule.arity();
  return Mask(LaurentPolynomial(coefficients, -arity * (first + static_cast<long>(rule.points) - 1)), arity);
}

}  // namespace subcert::piecewise
