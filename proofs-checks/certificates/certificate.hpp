#pragma once
/// Certificates: the proofs of the search, written so that subcert-check can follow them. Format: SPEC.md beside this.

#include "claim.hpp"

#include <subcert/analysis/family/exponent_curve.hpp>
#include <subcert/analysis/family/limit_of_levels.hpp>
#include <subcert/analysis/family/local_levels.hpp>
#include <subcert/analysis/family/property_of_levels.hpp>
#include <subcert/analysis/radii/subradius/joint_spectral_subradius.hpp>
#include <subcert/analysis/regularity/frequency/frequency_bound.hpp>
#include <subcert/analysis/regularity/regularity.hpp>

#include <optional>
#include <string>
#include <vector>

namespace subcert {

struct Scheme;

/// Lines that belong together.
struct CertificateSection {
  std::string lines;
  /// What stands in their place where only bounds are proved; nothing: the same lines.
  std::optional<std::string> of_bounds = {};
};

struct Certificate {
  CertificateClaim claim;
  std::vector<CertificateSection> sections;  ///< what follows the head
  ClaimedEnds bounds = {};                   ///< what is proved without what says what the number is
  std::string missing = {};                  ///< why the number is exact and that is not said; or empty

  std::string text() const;
  /// That of the bounds alone: where the checker does not accept what says what the number is, as an image may lie too
  /// near to the boundary.
  Certificate of_bounds() const;
};

/// Proves bounds of the Hoelder exponent for this mask, or with `rounding` for all masks that are meant. Domain:
/// `found` is that of the mask and the rounding. Shifts that are not stable: by the reduced mask. Errors: throws
/// Error where nothing positive is proved from below.
Certificate exponent_certificate(const Mask& mask, const HolderRegularity& found,
                                 const std::optional<MaskRounding>& rounding = std::nullopt);

/// Proves the lower end. Domain: the bound is that of the mask. Errors: throws Error where nothing positive is proved,
/// or the matrices of the mask are larger than what the checkers read.
Certificate frequency_certificate(const Mask& mask, const std::optional<FrequencyBound>& bound);

/// Bounds of the exponent in several variables; without an upper end where the shifts are not proved stable. Domain:
/// `regularity` is that of the mask. Errors: throws Error where nothing positive is proved from below.
Certificate surface_certificate(const LatticeMask& mask, const MultivariateRegularity& regularity);

/// That f'_i = sum over j of A_{i-aj}^T f_j converges, or that it does not; with `hermite` that the scheme is HC^k for
/// the largest k that is proved, or not HC^(r-1) for data of r components. Errors: throws
/// Error for other masks than those of one variable with an arity, where the scheme keeps no constants, or as a Hermite
/// scheme not the data of polynomials up to the degree r - 1, and where nothing is decided. Cost: a joint spectral
/// radius. Proof: SPEC.md, theorem 47.
Certificate vector_scheme_certificate(const LatticeMask& mask, bool hermite, const Budget& budget);
/// The same of matrices with a square root: SPEC.md, section 6.9.
Certificate vector_scheme_certificate(const QuadraticMask& mask, bool hermite, const Budget& budget);
/// That f'_i = sum over j of A_{i-Mj}^T f_j converges, or that it does not, for any isotropic dilation and whatever
/// constants it keeps. Errors: throws Error where nothing is decided. Cost: a joint spectral radius until it is known
/// on which side of 1 it is. Proof: SPEC.md, theorem 72.
Certificate convergence_certificate(const LatticeMask& mask, const Budget& budget);
Certificate convergence_certificate(const QuadraticMask& mask, const Budget& budget);
/// Whether vector_scheme_certificate is the one about a scheme of matrices: of a Hermite scheme, and of one variable
/// where one vector of constants up to a factor is kept. Otherwise it is convergence_certificate.
bool is_told_by_polynomials(const Scheme& scheme);
/// The one of these that is about the scheme. Errors: also throws Error for schemes of numbers.
Certificate scheme_certificate(const Scheme& scheme, const Budget& budget);

/// The same of matrices with a square root. Domain: `regularity` is that of the mask. Errors: throws Error where
/// nothing positive is proved from below. Proof: SPEC.md, theorems 60, 61 and 63.
Certificate field_certificate(const QuadraticMask& mask, const MultivariateRegularity& regularity);

/// The one or the other. `quadratic`: what is meant where `mask` is rounded. Errors: of a tensor product, whose
/// certificate is about the mask, throws Error for what is proved by factors.
Certificate exponent_certificate(const LatticeMask& mask, const Regularity& regularity,
                                 const std::optional<MaskRounding>& rounding = std::nullopt,
                                 const std::optional<QuadraticMask>& quadratic = std::nullopt);

/// Of one piece of a range: for all values of the parameter from `low` to `high` the property holds, or for none.
struct RangeCertificate {
  Rational low, high;
  Truth holds;
  Certificate certificate;
};

/// Proves each decided piece of a range. The claim of a proved one is exponent > order, of a refuted one exponent <
/// order, with order 0 for convergence; stability has no bounds, and smoothness of an order from the number of sum
/// rules on is refuted between the values that have more of them. Where the polynomial vanishes that proves stability
/// of a range, single values have certificates of their own. Where the ends of a piece are not included, the
/// certificate stays away from them by `margin`. None for properties that are decided by signs or a spectral radius. Of
/// masks of matrices pieces of HC^k and of convergence, and proved ones of exponents.
/// Domain: `range` is that of the mask and the property; margin > 0.
std::vector<RangeCertificate> range_certificates(const ParametricMask& mask, char letter, const RangeProperty& property,
                                                 const PropertyRange& range, const Rational& margin);

/// That the property holds for every sequence of values of the box, one for each level; nothing where that is not
/// proved. With `followed`: that it holds for those levels, from which level on, and that their values come into the
/// box; without it where that is not proved. Domain: one letter; `levels` is that of the mask, the property and the
/// box, and so is `followed`.
std::optional<Certificate> levels_certificate(const ParametricMask& mask, char letter, const RangeProperty& property,
                                              const Box& box, const PropertyOfLevels& levels,
                                              const FollowedLevels* followed = nullptr);

/// What is known of the exponent where the values of a recurrence tend to a number, of all levels from the first one on
/// and of late ones; nothing where nothing positive is proved. Domain: one letter; `followed` is that of the mask and
/// the box. Cost: the exponent of a mask. Proof: SPEC.md, theorems 70 and 71.
std::optional<Certificate> limit_certificate(const ParametricMask& mask, char letter, const Box& box,
                                             const FollowedLevels& followed, const Budget& budget);

/// That all choices of values of the box have at least the lower end of the exponent; nothing where nothing positive is
/// proved. Domain: one letter; `found` is that of the mask and the box.
std::optional<Certificate> each_point_certificate(const ParametricMask& mask, char letter, const Box& box,
                                                  const LocalLevels& found);

/// As certificates name a list.
ListSubject list_subject(const MaskList& list);

/// That all sequences of the masks have at least the lower end of the exponent, unless they are in a period; and of the
/// sequence that bounds it from above, if one does, what its exponent is. Of masks of matrices of that sequence alone:
/// the exponent of its functions, and that its scheme converges. None where nothing positive is proved.
/// Domain: `found` is that of the list. Cost: the exponent of one mask of arity a^L.
std::vector<Certificate> list_certificates(const MaskList& list, const ExponentOfList& found, const Budget& budget);

/// Proves the envelopes piece by piece, the lower one less 10^-12. `holds` of each: whether it proves convergence. Of
/// masks of matrices the lower one alone.
std::vector<RangeCertificate> curve_certificates(const ParametricMask& mask, char letter, const ExponentCurve& curve);

/// Proves bounds of the joint spectral radius of these matrices. Domain: `radius` is that of the family.
Certificate radius_certificate(const MatrixFamily& family, const JointSpectralRadius& radius);

/// Proves bounds of the joint spectral subradius of these matrices. Domain: `radius` is that of the family.
Certificate subradius_certificate(const MatrixFamily& family, const JointSpectralSubradius& radius);

/// The matrices as the checker reads them.
std::string matrices_text(const MatrixFamily& family);

}  // namespace subcert
