#include "rounded_family.hpp"

#include "one_block.hpp"

#include <algorithm>

namespace subcert::radius {
namespace {

/// The largest 1-norm of a vertex.
Rational longest_vertex(const PolytopeProof& proof) {
  Integer longest = 0;
  for (std::size_t k = 0; k < proof.vertices.size(); ++k) {
    Integer sum = 0;
    for (const Integer& x : proof.vertices[k]) sum += abs(x);
    if (!proof.imaginary.empty())
      for (const Integer& y : proof.imaginary[k]) sum += abs(y);
    longest = std::max(longest, sum);
  }
  return Rational(longest) * power(Rational(2), -proof.vertex_bits);
}

}  // namespace

EntryError::EntryError(const MatrixFamily& family, const Rational& distance)
    : norm(0), error(static_cast<long>(family.size()) * distance) {
  for (const RationalMatrix& matrix : family) norm = std::max(norm, one_norm(matrix));
}

JointSpectralRadius radius_of_rounded_family(const MatrixFamily& family, const Rational& distance, const Budget& budget,
                                             const NormProof& known) {
  // Any bound will do: nothing can be exact.
  JointSpectralRadius radius = family.size() == 1 ? radius_of_numbers(family)
                                                  : radius_of_one_block(family, budget, known, known.bound());
  auto* polytope = std::get_if<PolytopeProof>(&radius.proof);
  if (polytope && (polytope->group.size() <= 1 || polytope->is_flip_symmetric())) {
    // What an image moves by is one more residual.
    const Rational moved = EntryError(family, distance).error * longest_vertex(*polytope);
    for (Rational& residual : polytope->residuals) residual += moved;
    polytope->bound += Rational(polytope->unit_norm) * moved;
    radius.radius.upper = polytope->bound;
  } else {
    radius.proof = known;
    radius.radius.upper = known.bound();
  }
  radius.product = prove_product(family, radius.product.word, budget.deadline, distance);
  radius.radius.lower = radius.product.radius.lower;
  radius.exact = {Truth::unknown, "the coefficients are rounded"};
  return radius;
}

}  // namespace subcert::radius
