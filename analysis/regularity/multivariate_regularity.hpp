#pragma once
/// The Hoelder exponent in several variables, enclosed with proof.

#include "gram_function.hpp"
#include "holder_bound.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/radii/joint/joint_spectral_radius.hpp>
#include <subcert/analysis/symbol/masks/matrix_masks.hpp>

namespace subcert {

/// -log radius to the base classes^(1/dimension), by which a dilation expands an isotropic subspace; ends at or below 0
/// give no end. Error: none where the power `dimension` of the radius is one of the classes, otherwise as log_ratio.
Enclosure exponent_of_radius(const Enclosure& radius, long classes, std::size_t dimension, int bits = default_bits);

/// Differences of a scheme that shrink, as the radius is below 1: with an isotropic dilation the scheme converges.
struct ShrinkingDifferences {
  DifferenceSpace space;
  JointSpectralRadius radius;  ///< perhaps without a product
};

/// How smooth one function of a vector is.
struct ComponentRegularity {
  Enclosure exponent;  ///< of its Hoelder exponent; without upper end and `exact` where it is 0
  Decision exact;
  bool is_zero = false;
  std::size_t component = 0;
};

/// What tells the exponent of one function: the operators on the space modulo the largest invariant subspace of
/// sequences that do not show it.
struct ComponentProof {
  DifferenceSpace space;
  std::size_t unobservable = 0;  ///< the dimension of that subspace, with a square root over its field
  /// On the space; the proof has the blocks of that subspace first, which are below 1, and all else is of the others.
  JointSpectralRadius radius;
};

/// HC^order of a Hermite scheme on r data: values and derivatives of data converge to those of a function that has
/// `order` >= r - 1 continuous derivatives.
struct HermiteOrder {
  int order = -1;  ///< the largest that is proved; -1 where convergence with r - 1 derivatives is not
  Decision next;   ///< whether it is one more
};

/// What is known of a vector of functions beside its exponent, that of the worst function in it.
struct FunctionVector {
  /// At most so many solutions are continuous and of compact support, up to linear combinations, of those that have a
  /// multiple of the integral that was asked for. Where it is more than one, all that is said is about all of them.
  std::size_t solutions = 0;
  /// A basis of the integrals of all solutions, those asked for or not; over a field with a square root the multiples
  /// of 1 and then those of the root. Reduced: each is 1 at a place where the others are 0.
  std::vector<std::vector<Rational>> integrals = {};
  std::optional<std::vector<Rational>> integral = std::nullopt;  ///< that was asked for
  /// The values at lattice points where there is one solution: those of the integral that was asked for, or else
  /// normalised(). With a root of twice as many components, the parts x and then y of x + sqrt(root) y.
  std::optional<LatticeSequence> values = std::nullopt;
  long root = 0;        ///< the number whose square root the matrices hold; 0 where they are rational
  Decision continuous;  ///< of all of them; no where there is none
  std::vector<ComponentRegularity> components;
  /// Of the function that was asked for, where a proof was found.
  std::optional<ComponentProof> proof = std::nullopt;
  std::optional<HermiteOrder> hermite = std::nullopt;  ///< of a Hermite scheme
};

struct MultivariateRegularity {
  int sum_rules = 0;  ///< of a mask of numbers
  /// Nothing without sum rules, or where it grows past its limit. Its dilation may be g M with a symmetry g of the
  /// mask.
  std::optional<DifferenceSpace> space;
  std::optional<HolderBound> bound;           ///< by norms of products of the transition operators on the space
  std::optional<JointSpectralRadius> radius;  ///< of the transition operators on the space
  /// Where the space is one of differences of phi, of which convergence does not follow: with its digits, if found.
  std::optional<ShrinkingDifferences> shrinking;
  Decision exact;  ///< whether a product attains the radius
  Decision converges;
  Decision stable;  ///< of the integer shifts
  /// Contains the Hoelder exponent of the limit phi; absent where no positive lower end is proved. Where the shifts are
  /// not proved stable it comes from the differences of phi, and the upper end is absent if these give no space.
  Enclosure exponent;
  std::optional<Enclosure> sobolev;      ///< contains the Sobolev exponent
  std::optional<LatticeSequence> gram;   ///< inner products of the shifts, where the scheme converges
  std::optional<FunctionVector> vector;  ///< of a mask of matrices, always; then the space is one of values

  /// The enclosure is as narrow as it gets.
  bool is_closed() const;
};

/// Which of the functions of a refinement equation are meant.
struct VectorQuestion {
  int bits = default_bits;
  /// From 0: the exponent is that of this function alone, and no other is looked at.
  std::optional<std::size_t> component = std::nullopt;
  /// Not 0: that of the solution in every component; over a field with a square root as FunctionVector::integrals.
  std::optional<std::vector<Rational>> integral = std::nullopt;
};

/// Of a mask of matrices: the exponent of the continuous solution of the refinement equation, for which neither sum
/// rules nor stability are needed (docs/vectors.md). Domain: an isotropic dilation. Errors, error and cost: as below.
MultivariateRegularity vector_regularity(const LatticeMask& mask, const Budget& budget,
                                         const VectorQuestion& question = {});

/// The same of matrices over a quadratic field. What is said of a radius, that it is of rounded matrices, is proved of
/// those that are meant. No Sobolev exponent where a block has more than 8 functions.
/// Proof: docs/vectors.md.
MultivariateRegularity vector_regularity(const QuadraticMask& mask, const Budget& budget,
                                         const VectorQuestion& question = {});

/// Of the one that is meant, where there is such.
inline MultivariateRegularity vector_regularity(const LatticeMask& mask, const std::optional<QuadraticMask>& meant,
                                                const Budget& budget, const VectorQuestion& question = {}) {
  return meant ? vector_regularity(*meant, budget, question) : vector_regularity(mask, budget, question);
}

/// By factors, whatever their arities, the smallest of their exponents, without space, radius and inner products. Else,
/// where the dilation is not isotropic, the smallest of the exponents along its isotropic subspaces, whose space and
/// radius are given. Domain: any mask with factors, or with a dilation that has such subspaces. Errors: throws Error
/// otherwise. Error: none, both ends are proved. Cost: as joint_spectral_radius on the space of differences. Proof:
/// docs/surfaces.md. Ref: [Jia98], [Jia99], [CP19].
MultivariateRegularity multivariate_regularity(const LatticeMask& mask, const Budget& budget, int bits = default_bits);

/// A lower end of the exponent of at least `exponent`, with as short a proof as is found, by differences of an order
/// above it; nothing where none is. Domain: numbers, an isotropic dilation, exponent > 0. Cost: a radius that is
/// bounded, far less than what tells the exponent where there is room.
std::optional<MultivariateRegularity> regularity_of_at_least(const LatticeMask& mask, const Rational& exponent,
                                                             const Budget& budget);

}  // namespace subcert
