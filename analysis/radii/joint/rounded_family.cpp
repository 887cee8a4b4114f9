#include "rounded_family.hpp"

#include "one_block.hpp"

#include <algorithm>
#include <utility>

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

Rational change_of_product(const Rational& norm, const Rational& error, long factors) {
  return power(norm + error, factors) - power(norm, factors);
}

RoundedFamily::RoundedFamily(MatrixFamily family, const Rational& distance)
    : family_(std::move(family)), distance_(distance), norm_(0), error_(static_cast<long>(family_.size()) * distance) {
  for (const RationalMatrix& matrix : family_) norm_ = std::max(norm_, one_norm(matrix));
}

JointSpectralRadius RoundedFamily::radius(const NormProof& known, const Budget& budget) const {
  // Any bound will do: nothing can be exact.
  JointSpectralRadius result = family_.size() == 1 ? radius_of_numbers(family_)
                                                   : radius_of_one_block(family_, budget, known, known.bound());
  auto* polytope = std::get_if<PolytopeProof>(&result.proof);
  if (polytope && (polytope->group.size() <= 1 || polytope->is_flip_symmetric())) {
    // What an image moves by is one more residual.
    const Rational moved = error_ * longest_vertex(*polytope);
    for (Rational& residual : polytope->residuals) residual += moved;
    polytope->bound += Rational(polytope->unit_norm) * moved;
    result.radius.upper = polytope->bound;
  } else {
    result.proof = known;
    result.radius.upper = known.bound();
  }
  result.product = prove_product(family_, result.product.word, budget.deadline, distance_);
  result.radius.lower = result.product.radius.lower;
  result.exact = {Truth::unknown, "the coefficients are rounded"};
  return result;
}

}  // namespace subcert::radius
