#pragma once
/// The Hoelder exponent of a scheme of any number of variables: one question, one answer.

#include "holder_regularity.hpp"
#include "multivariate_regularity.hpp"

namespace subcert {

/// What is asked for beside the exponent. Levels, proof and rounding are of one variable alone, as holder_regularity.
struct RegularityOptions {
  int bits = default_bits;
  int levels = 16;
  HolderProof proof = HolderProof::shortest;
  std::optional<MaskRounding> rounding = {};
  std::optional<QuadraticMask> quadratic = {};  ///< what is meant by a mask of matrices that is rounded
  std::optional<std::size_t> component = {};  ///< of a mask of matrices: the function, from 0, whose exponent is asked
  std::optional<std::vector<Rational>> integral = {};  ///< of a mask of matrices: that of the solution that is meant
  bool hermite = false;                                ///< a mask of matrices is that of a Hermite scheme
};

/// What is proved, and by which kind of evidence: one of the two is there.
struct Regularity {
  std::optional<HolderRegularity> curve;          ///< of a mask of one variable that is its own factor
  std::optional<MultivariateRegularity> surface;  ///< of all others

  int sum_rules() const { return curve ? curve->bounds.sum_rules : surface->sum_rules; }
  const Decision& converges() const { return curve ? curve->converges : surface->converges; }
  const Decision& stable() const { return curve ? curve->stable : surface->stable; }
  /// Contains the exponent of a scheme that is proved to converge; no ends where nothing is proved.
  Enclosure exponent() const { return curve ? curve->proved_exponent() : surface->exponent; }
  /// Whether a product attains the radius that the exponent is from, and whether that is as narrow as it gets.
  const Decision& exact() const { return curve ? curve->deciding().radius.exact : surface->exact; }
  bool is_closed() const { return curve ? curve->deciding().radius.is_closed() : surface->is_closed(); }
  /// Of the transition operators of the mask itself; null where the exponent is that of factors.
  const JointSpectralRadius* radius() const {
    return curve ? &curve->radius : surface->radius ? &*surface->radius : nullptr;
  }
};

/// Domain, errors and cost: holder_regularity of a curve(), else multivariate_regularity.
Regularity regularity_of(const LatticeMask& mask, const Budget& budget, const RegularityOptions& options = {});

}  // namespace subcert
