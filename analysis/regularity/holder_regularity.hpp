#pragma once
/// The Hoelder exponent, enclosed with proof.

#include "holder_bound.hpp"
#include "stability.hpp"

#include <subcert/analysis/radii/joint/joint_spectral_radius.hpp>
#include <subcert/analysis/radii/joint/single_radius.hpp>

#include <memory>

namespace subcert {

/// How the derivative of the largest order kappa = `derivative` below the exponent s is continuous: its modulus is at
/// most a multiple of h^(s - kappa) |log h|^at_most, and not of a lower power of the logarithm than at_least. The
/// exponent is attained where both are 0. An absent end is not known. Where the shifts are not proved stable, s is the
/// lower end of the exponent and at_least is 0. Ref: docs/single-radius.md, section 4.
struct LogarithmicFactor {
  int at_least = 0;
  std::optional<int> at_most;
  std::optional<int> derivative;
  std::string reason;
};

struct ReducedRegularity;

struct HolderRegularity {
  HolderBounds bounds;         ///< by norms of the difference scheme, level by level
  SingleRadius single;         ///< whether one spectral radius is enough
  JointSpectralRadius radius;  ///< of the transition matrices of the divided difference scheme of order sum_rules
  Decision converges;          ///< by the exponent, by a product that is too large, or as converges() decides
  Decision stable;             ///< of the integer shifts; the upper end is claimed only where it is yes
  /// Contains the Hoelder exponent of the limits; the lower end holds where it is positive, and then proves
  /// convergence. With stable shifts the upper end is never absent: it is at most the number of sum rules. With
  /// others it is that of the reduced mask.
  Enclosure exponent;
  LogarithmicFactor logarithm;
  /// Where the shifts are not stable, or only a reduced mask has a certificate: what is known of that one, from which
  /// the exponent is.
  std::shared_ptr<const ReducedRegularity> reduced;

  /// Of a scheme that is proved to converge, `exponent` without what is negative; else no ends: a bound that is not
  /// positive proves nothing, not even convergence.
  Enclosure proved_exponent() const;
  /// What the exponent of a scheme that converges is from: this, or that of the reduced mask.
  const HolderRegularity& deciding() const;
};

struct ReducedRegularity {
  ReducedMask mask;
  HolderRegularity regularity;
};

inline const HolderRegularity& HolderRegularity::deciding() const { return reduced ? reduced->regularity : *this; }

/// What is to be proved: the exponent by whichever argument is shortest, or so that there is a certificate, for which a
/// reduced mask may be needed.
enum class HolderProof { shortest, certificate };

/// Domain: coset sums 1; levels >= 1; at most 256 rows in the transition matrices (larger masks keep the bounds by
/// norms). `bits`: the exponent is narrower than 2^-bits where a product is proved to attain the radius. `rounding`:
/// what is proved holds for all masks that are meant, and nothing is exact; larger masks are refused. Errors: throws
/// Error. Error: none, both ends are proved; see joint_spectral_radius for the width. Ref: [Rio92], [FM13], [JW93],
/// [GP13].
HolderRegularity holder_regularity(const Mask& mask, int levels, const Budget& budget,
                                   HolderProof proof = HolderProof::shortest,
                                   const std::optional<MaskRounding>& rounding = std::nullopt, int bits = default_bits);

/// Whether the limits have so many continuous derivatives. An exponent above the order says yes, one below it no; and
/// with stable shifts also one that is equal to it, as a derivative makes the radius smaller (docs/families.md), and an
/// order that is the number of sum rules (SPEC.md, theorem 23).
/// Domain: `regularity` of a mask; an integer order >= 0.
Truth has_derivatives(const HolderRegularity& regularity, const Rational& order);

}  // namespace subcert
