#pragma once
/// Joint spectral subradii, also called lower spectral radii: how slowly products of matrices can grow.

#include "antinorm_proof.hpp"

#include <subcert/analysis/symbol/support/budget.hpp>

namespace subcert {

struct JointSpectralSubradius {
  Enclosure radius;                       ///< bounded
  SlowProduct product;                    ///< of the upper end
  std::optional<AntinormProof> antinorm;  ///< of the lower end, where that is positive
  /// Whether `product` attains the subradius exactly, proved or unknown. The ends are then those of its averaged
  /// spectral radius, which may be nearer to each other than what `antinorm` proves.
  Decision exact;

  /// The ends are within 1e-12 of each other, relatively, or both 0: in practice the search closed with `product` as
  /// spectrum minimizing product.
  bool is_closed() const;
};

/// What is wanted of an enclosure; the work ends as soon as it is there.
struct SubradiusTarget {
  std::optional<Rational> lower, upper;  ///< ends that are good enough
  int bits = 160;                        ///< of the numbers of a proof
};

/// Encloses lim min |A_{w_1} ... A_{w_k}|^(1/k). Domain: a family within FamilyLimits without negative entries. Errors:
/// throws Error otherwise. Error: none, both ends are proved in exact arithmetic; where the search for a polytope
/// closes they are about 2^-bits apart, otherwise as near as the budget allowed. Cost: one linear program per vertex
/// and matrix. Ref: [GP13, Alg. 2]; docs/joint-spectral-radius.md.
JointSpectralSubradius joint_spectral_subradius(const MatrixFamily& family, const Budget& budget,
                                                const SubradiusTarget& target = {});

}  // namespace subcert
