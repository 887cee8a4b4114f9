#include "vector_operators.hpp"

#include <subcert/analysis/radii/joint/rounded_family.hpp>
#include <subcert/analysis/radii/schedule.hpp>

#include <algorithm>

namespace subcert::vectors {
namespace {

namespace shares = schedule::vector;

/// The columns e of the identity that, with their images J e, are a basis. Domain: J J is a number that is no square.
std::vector<std::size_t> half_basis(const RationalMatrix& root) {
  const std::size_t size = root.rows();
  RationalMatrix columns(size, 2 * size);
  for (std::size_t c = 0; c < size; ++c) {
    columns(c, 2 * c) = 1;
    for (std::size_t r = 0; r < size; ++r) columns(r, 2 * c + 1) = root(r, c);
  }
  std::vector<std::size_t> result;
  for (const std::size_t column : pivot_columns(columns))
    if (column % 2 == 0) result.push_back(column / 2);
  return result;
}

}  // namespace

Operators operators_of(std::vector<RationalMatrix> matrices, const Parts& parts) {
  if (parts.root == 0) return {MatrixFamily(std::move(matrices))};
  RationalMatrix root = std::move(matrices.back());
  matrices.pop_back();
  return {MatrixFamily(std::move(matrices)), std::move(root)};
}

Operators operators_of(const DifferenceSpace& space, const Parts& parts) {
  if (parts.root == 0) return {space.family};
  const auto half = static_cast<long>(parts.components());
  RationalMatrix root(space.basis.size(), space.basis.size());
  for (std::size_t k = 0; k < space.pivots.size(); ++k) {
    LatticePoint from = space.pivots[k];
    const bool is_first = from.back() < half;
    from.back() += is_first ? half : -half;
    for (std::size_t c = 0; c < space.basis.size(); ++c)
      if (const auto found = space.basis[c].find(from); found != space.basis[c].end())
        root(k, c) = is_first ? Rational(parts.root * found->second) : found->second;
  }
  return {space.family, std::move(root)};
}

RealFamily on_functions(const Operators& operators, long number) {
  if (!operators.root) return {operators.family};
  constexpr long root_bits = 512;
  const RationalMatrix& root = *operators.root;
  const std::vector<std::size_t> chosen = half_basis(root);
  RationalMatrix basis(root.rows(), root.rows());
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    basis(chosen[i], 2 * i) = 1;
    for (std::size_t r = 0; r < root.rows(); ++r) basis(r, 2 * i + 1) = root(r, chosen[i]);
  }
  const Rational value = rounded_root(number, root_bits);
  Rational largest = 0;
  std::vector<RationalMatrix> result;
  for (const RationalMatrix& matrix : operators.family) {
    const RationalMatrix x = solve(basis, matrix * basis);
    RationalMatrix& real = result.emplace_back(chosen.size(), chosen.size());
    for (std::size_t i = 0; i < chosen.size(); ++i)
      for (std::size_t k = 0; k < chosen.size(); ++k) {
        real(i, k) = x(2 * i, 2 * k) + value * x(2 * i + 1, 2 * k);
        largest = std::max(largest, abs(x(2 * i + 1, 2 * k)));
      }
  }
  return {MatrixFamily(std::move(result)), largest * power(Rational(2), -root_bits)};
}

NormProof norms_of(const RealFamily& family, const Budget& budget) {
  NormProof result = norm_of_products(family.matrices, budget);
  if (family.distance > 0)
    result.norm += radius::RoundedFamily(family.matrices, family.distance).change_of_products(result.level);
  return result;
}

namespace {

/// Of the diagonal blocks over the field of the root, each by itself.
JointSpectralRadius radius_over_field(const Operators& operators, long number, const Budget& budget) {
  const BlockTriangular triangular = block_triangularise(MatrixFamily(operators.matrices()),
                                                         budget.deadline.after(shares::blocks));
  JointSpectralRadius result;
  BlockProof proof{{{}, RationalMatrix::identity(operators.family.size() / 2), {}, triangular.irreducible}, {}, 0};
  for (std::size_t k = 0; k < triangular.sizes.size(); ++k) {
    std::vector<RationalMatrix> block = triangular.block(k).matrices();
    RationalMatrix root = std::move(block.back());
    block.pop_back();
    const RealFamily family = on_functions({MatrixFamily(std::move(block)), std::move(root)}, number);
    const Budget share{budget.deadline.after(1.0 / static_cast<double>(triangular.sizes.size() - k)), budget.memory};
    const NormProof norms = norms_of(family, {share.deadline.after(shares::norms), share.memory});
    proof.triangular.sizes.push_back(family.matrices.size());
    proof.blocks.push_back(family.distance > 0
                               ? radius::RoundedFamily(family.matrices, family.distance).radius(norms, share)
                               : joint_spectral_radius(family.matrices, share, norms));
    const Enclosure& radius = proof.blocks.back().radius;
    if (*radius.lower > *proof.blocks[proof.leading].radius.lower) proof.leading = k;
    result.radius.upper = k == 0 ? *radius.upper : std::max(*result.radius.upper, *radius.upper);
  }
  const JointSpectralRadius& leader = proof.blocks[proof.leading];
  result.product = leader.product;
  result.radius.lower = *leader.radius.lower;
  const bool is_number = leader.radius.is_exact() && *result.radius.upper == *result.radius.lower;
  result.exact = is_number ? leader.exact : Decision{Truth::unknown, "the matrices are rounded"};
  result.proof = std::move(proof);
  return result;
}

}  // namespace

JointSpectralRadius radius_of(const Operators& operators, long number, const Budget& budget, const NormProof& norms,
                              const std::optional<Rational>& target) {
  return operators.root ? radius_over_field(operators, number, budget)
                        : joint_spectral_radius(operators.family, budget, norms, target);
}

}  // namespace subcert::vectors
