#pragma once
/// Joint spectral radii, enclosed with proof.

#include "certified_polytope.hpp"

#include <optional>

namespace subcert {

/// A product of the family with a proved lower bound of its spectral radius: some eigenvalue of the product lies within
/// size * |p(c) / p'(c)| of the point c = re + i im, p the characteristic polynomial.
struct ProductEvidence {
  std::vector<int> word;  ///< the product M_{word[0]} M_{word[1]} ..., from left to right
  Rational re, im;
  Enclosure radius;  ///< of rho(product)^(1/length): the lower end is proved, the upper end is that of the nearby eigenvalue
};

enum class JsrMethod { invariant_polytope, norm_of_products };

struct JointSpectralRadius {
  Enclosure radius;
  ProductEvidence product;
  JsrMethod method;
  /// The ends of `radius` are within 1e-12 of each other, relatively: in practice the search closed with `product` as
  /// spectrum maximizing product.
  bool closed = false;
  /// Whether `product` attains the radius exactly, proved or unknown.
  Decision exact;
  std::optional<CertifiedPolytope> polytope;  ///< the proof of the upper end, for JsrMethod::invariant_polytope
  int norm_level = 0;                         ///< for JsrMethod::norm_of_products
  std::size_t vertices = 0;
};

/// A proved upper bound that is known beforehand: the largest 1-norm of a product of `level` matrices, first columns
/// sufficing where the family consists of transition matrices.
struct KnownNorm {
  int level;
  Rational norm;
};

/// Encloses the joint spectral radius. Domain: 1 to 64 square matrices of one size from 1 to 256; seconds > 0. Errors:
/// throws std::invalid_argument. Error: none, both ends are proved in exact arithmetic; where the search for an
/// invariant polytope ends within the time the width is about 1e-15, otherwise as narrow as the time allowed.
/// Cost: one linear program per vertex and matrix. Ref: [GP13, Alg. 1], [Mej20].
JointSpectralRadius joint_spectral_radius(const std::vector<RationalMatrix>& matrices, double seconds,
                                          const std::optional<KnownNorm>& known = std::nullopt);

/// Encloses value^(1/degree). Domain: value >= 0, degree >= 1. Error: relative width below 2^-180.
Enclosure root_enclosure(const Rational& value, int degree);

}  // namespace subcert
