#pragma once
/// Bounds for all families of matrices near one. Inner header.

#include "joint_spectral_radius.hpp"

namespace subcert::radius {

/// What products of so many factors, or determinants of that size, change by at most where factors or columns with
/// norms up to `norm` change by `error`: SPEC.md, section 7.
Rational change_of_product(const Rational& norm, const Rational& error, long factors);

/// What is known of all families near one, beside their distance.
struct NearbyFamilies {
  bool have_symmetries = false;  ///< those of the one
  bool are_transitions = false;  ///< transition matrices of masks of one variable
};

/// All families whose entries differ from those of one by at most a number.
class RoundedFamily {
 public:
  /// Domain: distance > 0.
  RoundedFamily(MatrixFamily family, const Rational& distance, const NearbyFamilies& known = {});

  /// In the 1-norm, of products of so many matrices.
  Rational change_of_products(long length) const { return change_of_product(norm_, error_, length); }

  /// Encloses the joint spectral radii of all of them. `known`: an upper bound of all. `exact` where one product
  /// attains each of them; then they are within 2^-bits, relatively, if the distance allows it. Domain: as
  /// joint_spectral_radius. Cost: likewise, by a polytope of the whole matrices.
  JointSpectralRadius radius(const NormProof& known, const Budget& budget, int bits = default_bits) const;

 private:
  /// By a polytope of the very radius; otherwise `exact` says what is missing.
  JointSpectralRadius attained(const Budget& budget, int bits) const;
  void include_errors(PolytopeProof& polytope) const;

  MatrixFamily family_;
  Rational distance_;
  NearbyFamilies known_;
  Rational norm_;   // the largest 1-norm of a matrix
  Rational error_;  // of a matrix, in that norm
};

}  // namespace subcert::radius
