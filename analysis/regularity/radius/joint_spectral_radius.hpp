#pragma once
/// Joint spectral radii, enclosed with proof.

#include "block_triangular.hpp"
#include "certified_polytope.hpp"

#include <optional>

namespace subcert {

/// A product of the family with a proved lower bound of its spectral radius: some eigenvalue of the product lies within
/// size * |p(c) / p'(c)| of the point c = re + i im, p the characteristic polynomial.
struct ProductEvidence {
  std::vector<int> word;  ///< the product M_{word[0]} M_{word[1]} ..., from left to right
  Rational re, im;
  Enclosure
      radius;  ///< of rho(product)^(1/length): the lower end is proved, the upper end is that of the nearby eigenvalue
  std::optional<Rational> exact;  ///< rho(product)^(1/length), where that is proved to be a rational number
};

enum class JsrMethod { invariant_polytope, norm_of_products, single_spectral_radius };

/// The largest norm of a product of n matrices lies between positive multiples of n^at_least radius^n and n^at_most
/// radius^n; an absent end is not known.
struct GrowthPower {
  int at_least = 0;
  std::optional<int> at_most;
};

struct JointSpectralRadius {
  Enclosure radius;
  Rational certified_upper;  ///< the upper end that `polytope` or the norms prove; that of `radius` may be lower
  ProductEvidence product;
  JsrMethod method;
  /// The ends of `radius` are within 1e-12 of each other, relatively: in practice the search closed with `product` as
  /// spectrum maximizing product.
  bool closed = false;
  /// Whether `product` attains the radius exactly, proved or unknown.
  Decision exact;
  GrowthPower growth;
  std::optional<CertifiedPolytope> polytope;  ///< the proof of certified_upper; where absent, the norms are
  int norm_level = 0;
  std::size_t vertices = 0;
  /// Where a common invariant subspace was used: the triangular form, the radii of its diagonal blocks, and the block
  /// from which `product` is formed. Then the proof of certified_upper is that of the blocks.
  std::optional<BlockTriangular> triangular;
  std::vector<JointSpectralRadius> blocks;
  std::size_t leading_block = 0;
};

/// A proved upper bound that is known beforehand: the largest 1-norm of a product of `level` matrices, first columns
/// sufficing where the family consists of transition matrices.
struct KnownNorm {
  int level;
  Rational norm;
};

/// Encloses the joint spectral radius, block by block where the family is reducible over the rationals. Domain: 1 to 64
/// square matrices of one size from 1 to 256; seconds > 0. Errors: throws std::invalid_argument. Error: none, both ends
/// are proved in exact arithmetic; where the search for an invariant polytope ends within the time the width is about
/// 1e-15, otherwise as narrow as the time allowed. Cost: one linear program per vertex and matrix. Ref: [GP13, Alg. 1],
/// [Mej20].
JointSpectralRadius joint_spectral_radius(const std::vector<RationalMatrix>& matrices, double seconds,
                                          const std::optional<KnownNorm>& known = std::nullopt);

/// Encloses the leading eigenvalue of a product. Domain: a word of at least one letter over square matrices of one
/// size.
ProductEvidence prove_product(const std::vector<RationalMatrix>& matrices, const std::vector<int>& word);

}  // namespace subcert
