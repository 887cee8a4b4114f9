#include "polytope_proof.hpp"

#include <algorithm>

namespace subcert {
namespace {

/// The 1-norm of the vertex of a term, under the element of the group.
Rational size_of_image(const PolytopeProof& proof, const WeightedVertex& term) {
  Integer sum = 0;
  for (const auto* parts : {&proof.vertices, &proof.imaginary})
    if (!parts->empty())
      for (const Integer& c : proof.group[term.element].map((*parts)[term.vertex])) sum += abs(c);
  return Rational(sum) * power(Rational(2), -proof.vertex_bits);
}

}  // namespace

ComplexVector PolytopeProof::vertex(std::size_t index) const {
  const Integer one = Integer(1) << vertex_bits;
  ComplexVector result;
  for (std::size_t i = 0; i < vertices[index].size(); ++i)
    result.push_back(
        {Rational(vertices[index][i], one), imaginary.empty() ? Rational(0) : Rational(imaginary[index][i], one)});
  return result;
}

bool PolytopeProof::is_flip_symmetric() const {
  if (group.size() != 2 || !(group[1].map == SparseMap::reversal(group[1].map.size()))) return false;
  const std::vector<std::size_t>& letters = group[1].letters;
  for (std::size_t t = 0; t < letters.size(); ++t)
    if (letters[t] != letters.size() - 1 - t) return false;
  return true;
}

PolytopeProof scaled(PolytopeProof proof, const Rational& factor) {
  if (factor == 1) return proof;
  // Weights of images become multiples of 2^-weight_bits; those of units keep their values.
  constexpr int guard_bits = 64;
  const bool exact = factor == power(Rational(2), binary_exponent(factor));
  const int more = static_cast<int>(std::max(0L, -binary_exponent(factor))) + (exact ? 0 : guard_bits);
  const Rational in_units = factor * power(Rational(2), more);
  if (proof.attained) proof.attained->number = scaled(proof.attained->number, factor);
  proof.weight_bits += more;
  for (auto& unit : proof.units)
    for (WeightedVertex& term : unit)
      for (Integer* part : {&term.weight, &term.imaginary, &term.modulus}) *part <<= static_cast<std::size_t>(more);
  const Rational unit = power(Rational(2), -proof.weight_bits);
  proof.bound = 0;
  for (std::size_t k = 0; k < proof.images.size(); ++k) {
    Rational rounding = 0, moduli = 0;
    for (WeightedVertex& term : proof.images[k]) {
      for (Integer* part : {&term.weight, &term.imaginary, &term.modulus}) {
        const Rational value = in_units * Rational(*part);
        // Cones want weights that are not too small, and moduli are upper bounds.
        *part = to_integer(value, Rounding::up);
        if (part != &term.modulus) rounding += unit * (Rational(*part) - value) * size_of_image(proof, term);
      }
      if (!exact && proof.kind == PolytopeKind::complex) term.modulus += 2;
      moduli += unit * Rational(term.modulus);
    }
    proof.moduli[k] = moduli;
    proof.residuals[k] = factor * proof.residuals[k] + rounding;
    proof.bound = std::max(proof.bound, Rational(moduli + proof.residuals[k] * Rational(proof.unit_norm)));
  }
  return proof;
}

}  // namespace subcert
