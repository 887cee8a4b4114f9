#include "vector_operators.hpp"

#include <subcert/analysis/radii/joint/congruences.hpp>
#include <subcert/analysis/radii/joint/one_block.hpp>
#include <subcert/analysis/radii/joint/p_radius.hpp>
#include <subcert/analysis/radii/joint/rounded_family.hpp>
#include <subcert/analysis/radii/schedule.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>

namespace subcert::vectors {

Operators operators_of(std::vector<RationalMatrix> matrices, const Parts& parts) {
  if (parts.root == 0) return {MatrixFamily(std::move(matrices))};
  RationalMatrix root = std::move(matrices.back());
  matrices.pop_back();
  return {MatrixFamily(std::move(matrices)), std::move(root)};
}

Operators operators_of(const DifferenceSpace& space, const Parts& parts) {
  return operators_of(space.basis, space.pivots, space.family, parts);
}

Operators operators_of(const std::vector<LatticeSequence>& basis, const std::vector<LatticePoint>& pivots,
                       const MatrixFamily& family, const Parts& parts) {
  if (parts.root == 0) return {family};
  const auto half = static_cast<long>(parts.components());
  RationalMatrix root(basis.size(), basis.size());
  for (std::size_t k = 0; k < pivots.size(); ++k) {
    LatticePoint from = pivots[k];
    const bool is_first = from.back() < half;
    from.back() += is_first ? half : -half;
    for (std::size_t c = 0; c < basis.size(); ++c)
      if (const auto found = basis[c].find(from); found != basis[c].end())
        root(k, c) = is_first ? Rational(parts.root * found->second) : found->second;
  }
  return {family, std::move(root)};
}

std::vector<std::vector<Rational>> basis_over_field(const std::vector<std::vector<Rational>>& rows, long root) {
  const std::size_t size = rows.front().size(), half = root > 0 ? size / 2 : size;
  const auto column = [&](std::size_t c) { return root > 0 ? c % half * 2 + c / half : c; };
  RationalMatrix matrix(rows.size(), size), conditions(size, size);
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t c = 0; c < size; ++c) matrix(r, column(c)) = rows[r][c];
  const auto annihilators = kernel(matrix);
  for (std::size_t r = 0; r < annihilators.size(); ++r)
    for (std::size_t c = 0; c < size; ++c) conditions(r, c) = annihilators[r][c];
  const auto basis = kernel(conditions);
  const std::vector<std::size_t> places = free_columns(basis);
  std::vector<std::vector<Rational>> result;
  for (std::size_t k = 0; k < basis.size(); ++k) {
    if (root > 0 && places[k] % 2 == 1) continue;
    std::vector<Rational>& row = result.emplace_back();
    for (std::size_t c = 0; c < size; ++c) row.push_back(basis[k][column(c)]);
  }
  return result;
}

RealFamily on_functions(const Operators& operators, long number, long root_bits) {
  if (!operators.root) return {operators.family};
  const RationalMatrix basis = basis_of_pairs(RationalMatrix::identity(operators.family.size()), *operators.root);
  const std::size_t size = basis.rows() / 2;
  const Rational value = rounded_root(number, root_bits);
  Rational largest = 0;
  std::vector<RationalMatrix> result;
  for (const RationalMatrix& matrix : operators.family) {
    const RationalMatrix x = solve(basis, matrix * basis);
    RationalMatrix& real = result.emplace_back(size, size);
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t k = 0; k < size; ++k) {
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

/// Of a block of numbers of the field, which are equal up to their sign or differ by more than rounding.
JointSpectralRadius radius_of_field_numbers(const Operators& block, const RealFamily& family) {
  JointSpectralRadius result = radius::radius_of_numbers(family.matrices);
  if (family.distance == 0) return result;
  const auto best = static_cast<std::size_t>(result.product.word.front());
  const Rational size = *result.radius.upper;
  result.radius = {std::max(Rational(0), Rational(size - family.distance)), size + family.distance};
  result.product.radius = result.radius;
  result.product.exact.reset();
  result.proof = NormProof{1, size + family.distance};
  for (std::size_t t = 0; t < family.matrices.count(); ++t) {
    const bool is_equal = block.family[t] == block.family[best] || block.family[t] == Rational(-1) * block.family[best];
    if (!is_equal && abs(family.matrices[t](0, 0)) + 2 * family.distance >= size)
      result.exact = {Truth::unknown, "two numbers of the field are too near"};
  }
  return result;
}

/// Whether the product of the leading block attains the radius of the whole, each block being known by itself.
Decision largest_is_attained(const BlockProof& proof, const std::vector<Operators>& blocks, const Deadline& deadline) {
  const JointSpectralRadius& leader = proof.blocks[proof.leading];
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const JointSpectralRadius& other = proof.blocks[k];
    const bool is_product_of_both = other.exact.is_yes() && other.product.word == leader.product.word;
    if (*other.radius.upper > *leader.radius.lower && !is_product_of_both &&
        !are_similar(blocks[proof.leading], blocks[k], deadline))
      return {Truth::unknown,
              other.exact.is_yes() ? "two blocks have radii that could not be compared exactly" : other.exact.reason};
  }
  return leader.exact;
}

/// Diagonal blocks over the field of the root.
struct FieldBlocks {
  BlockTriangular triangular;
  std::vector<Operators> blocks;

  FieldBlocks(const Operators& operators, const Deadline& deadline)
      : triangular(block_triangularise(MatrixFamily(operators.matrices()), deadline)) {
    for (std::size_t k = 0; k < triangular.sizes.size(); ++k) {
      std::vector<RationalMatrix> block = triangular.block(k).matrices();
      RationalMatrix root = std::move(block.back());
      block.pop_back();
      blocks.push_back({MatrixFamily(std::move(block)), std::move(root)});
    }
  }
};

}  // namespace

RationalMatrix with_root_columns(RationalMatrix basis, const RationalMatrix& root) {
  const RationalMatrix images = root * basis;
  for (std::size_t c = 1; c < basis.columns(); c += 2)
    for (std::size_t r = 0; r < basis.rows(); ++r) basis(r, c) = images(r, c - 1);
  return basis;
}

namespace {

/// Of the diagonal blocks over the field of the root, each by itself.
JointSpectralRadius radius_over_field(const Operators& operators, long number, const Budget& budget) {
  const FieldBlocks split(operators, budget.deadline.after(schedule::vector::blocks));
  const BlockTriangular& triangular = split.triangular;
  const std::vector<Operators>& blocks = split.blocks;
  JointSpectralRadius result;
  BlockProof proof{{{}, {0, 0}, {}, triangular.irreducible}, {}, 0};
  RationalMatrix change(operators.family.size(), operators.family.size());
  std::size_t start = 0;
  for (std::size_t k = 0; k < triangular.sizes.size(); ++k) {
    const Operators& given = blocks[k];
    const bool is_number = triangular.sizes[k] == 2;
    const auto mirrored = is_number ? std::nullopt
                                    : mirror_symmetric_basis(given, budget.deadline.after(schedule::vector::mirrors));
    const RationalMatrix basis = mirrored ? *mirrored
                                          : basis_of_pairs(RationalMatrix::identity(triangular.sizes[k]), *given.root);
    for (std::size_t r = 0; r < basis.rows(); ++r)
      for (std::size_t c = 0; c < basis.columns(); ++c) change(start + r, start + c) = basis(r, c);
    start += basis.rows();
    const RealFamily family = on_functions(in_basis(given, basis), number);
    const Budget share{budget.deadline.after(1.0 / static_cast<double>(triangular.sizes.size() - k)), budget.memory};
    const NormProof norms = norms_of(family, {share.deadline.after(schedule::vector::norms), share.memory});
    proof.triangular.sizes.push_back(family.matrices.size());
    proof.blocks.push_back(is_number             ? radius_of_field_numbers(given, family)
                           : family.distance > 0 ? radius::RoundedFamily(family.matrices, family.distance,
                                                                         {.have_symmetries = mirrored.has_value()})
                                                       .radius(norms, share)
                                                 : joint_spectral_radius(family.matrices, share, norms));
    const Enclosure& radius = proof.blocks.back().radius;
    if (*radius.lower > *proof.blocks[proof.leading].radius.lower) proof.leading = k;
    result.radius.upper = k == 0 ? *radius.upper : std::max(*result.radius.upper, *radius.upper);
  }
  const JointSpectralRadius& leader = proof.blocks[proof.leading];
  result.product = leader.product;
  result.radius.lower = *leader.radius.lower;
  result.exact = largest_is_attained(proof, blocks, budget.deadline);
  proof.triangular.basis = with_root_columns(triangular.basis * change, *operators.root);
  result.proof = std::move(proof);
  return result;
}

/// The balls of the matrices of a block over the field.
std::vector<radius::BallMatrix> balls_of(const Operators& block, long number, slong bits) {
  const RationalMatrix basis = basis_of_pairs(RationalMatrix::identity(block.family.size()), *block.root);
  const std::size_t size = basis.rows() / 2;
  const Ball root = sqrt(Ball(number, bits));
  std::vector<radius::BallMatrix> result;
  for (const RationalMatrix& matrix : block.family) {
    const RationalMatrix x = solve(basis, matrix * basis);
    radius::BallMatrix& balls = result.emplace_back(size);
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t k = 0; k < size; ++k)
        balls[i].push_back(Ball(x(2 * i, 2 * k), bits) + root * Ball(x(2 * i + 1, 2 * k), bits));
  }
  return result;
}

}  // namespace

std::optional<Enclosure> mean_square_radius(const Operators& operators, long number, int bits,
                                            const Deadline& deadline) {
  if (!operators.root) {
    const auto found = p_radius(operators.family, 2, bits, deadline);
    return found ? std::optional(found->radius) : std::nullopt;
  }
  Enclosure most = Enclosure::exactly(0);
  const Rational count(static_cast<long>(operators.family.count()));
  for (const Operators& block : FieldBlocks(operators, deadline.after(schedule::vector::blocks)).blocks) {
    const int wanted = bits + 8;
    const auto found = radius::radius_of_congruences(balls_of(block, number, radius::bits_for_congruences(wanted)),
                                                     wanted, deadline);
    if (!found) return std::nullopt;
    most = {std::max(*most.lower, *found->lower), std::max(*most.upper, *found->upper)};
  }
  return Enclosure{root_enclosure(*most.lower / count, 2, bits).lower,
                   root_enclosure(*most.upper / count, 2, bits).upper};
}

JointSpectralRadius radius_of(const Operators& operators, long number, const Budget& budget, const NormProof& norms,
                              const std::optional<Rational>& target) {
  return operators.root ? radius_over_field(operators, number, budget)
                        : joint_spectral_radius(operators.family, budget, norms, target);
}

}  // namespace subcert::vectors
