#pragma once
/// Finitely many masks, one for each level.

#include <subcert/analysis/family/parametric_family.hpp>
#include <subcert/analysis/radii/joint/joint_spectral_radius.hpp>
#include <subcert/analysis/regularity/multivariate_regularity.hpp>
#include <subcert/analysis/symbol/masks/level_masks.hpp>
#include <subcert/analysis/symbol/masks/polynomial_data.hpp>

#include <optional>
#include <utility>
#include <vector>

namespace subcert {

/// f_{k+1} = S_k f_k with S_k by one of the masks, and which of them may follow which. Canonical: masks of one
/// variable, one arity and one number of components; of numbers a sum rule for all, of matrices A_k, P_k transposed,
/// constant data that all keep (kept_polynomials); most_rules >= 1, of numbers alone; numbers of masks; of `period` and
/// `follows` one is empty.
struct MaskList {
  std::vector<LatticeMask> masks;
  std::vector<std::size_t> period = {};                           ///< these again and again, the coarsest level first
  std::vector<std::pair<std::size_t, std::size_t>> follows = {};  ///< mask `second` may follow mask `first`
  std::optional<int> most_rules = {};                             ///< of which use is made
  bool hermite = false;  ///< matrices: of values and derivatives, D^(n+1) f_{n+1} = S_n D^n f_n
};

/// What all masks of matrices keep. Domain: a list of such masks.
PolynomialData kept_polynomials(const MaskList& list);

/// T_0, T_1, ... of masks of matrices on what annihilates the data that all keep, times a^m for m of them, along the
/// successions as in exponent_of. Domain: canonical, of matrices, without a period. Errors: throws Error.
MatrixFamily matrices_along(const MaskList& list);
/// The same sequences without a period: each mask as often as in the period, and each is followed by the next one.
/// Domain: a list with a period.
MaskList in_turn(const MaskList& list);
/// The space of these matrices. Domain: a list of masks of matrices. Errors: throws Error.
AnnihilatingSpace annihilating_space(const MaskList& list);

/// Whether some sequence goes on for ever.
bool has_sequence(const MaskList& list);

/// The same sequences with equal masks that the same sequences may follow as one; in a period the list itself. Domain:
/// canonical. Errors: throws Error.
MaskList without_twins(const MaskList& list);

/// What is known of masks of matrices beside the exponent.
struct VectorList {
  std::vector<int> alone;          ///< the number of sum rules of each mask by itself
  bool keeps_derivatives = false;  ///< the data that all keep are values and derivatives
  /// Positive: words of n levels make O(a^(-ns)) of what annihilates the data that all keep, for each s below.
  std::optional<Rational> decay = {};
  std::optional<LatticeMask> one = {};                   ///< the masks of the leading sequence as one
  std::optional<MultivariateRegularity> functions = {};  ///< of its refinement equation
  std::optional<HermiteOrder> hermite = {};              ///< of its scheme, where the list is of such
};

/// The least exponent of all sequences.
struct ExponentOfList {
  int sum_rules = 0;                  ///< that all masks have, and of which use is made
  Enclosure exponent;                 ///< no ends where no convergence is proved; the upper one is that of `sequence`
  Decision exact;                     ///< both ends are proved to be one number, which `exponent` encloses
  Decision stable;                    ///< of the shifts of `sequence`, for the upper end; of numbers
  std::vector<std::size_t> sequence;  ///< the masks of the leading product, again and again
  MatrixFamily family;                ///< whose radius it is from
  JointSpectralRadius radius;
  MaskList list;                           ///< whose matrices these are: without_twins
  std::optional<VectorList> vectors = {};  ///< of masks of matrices

  /// Whether there is one sequence of masks, that of `vectors`.
  bool is_one_sequence() const { return !list.period.empty() || list.masks.size() == 1; }
};

/// By the joint spectral radius r of the transition matrices for divided differences of the order m of the common sum
/// rules, on one window, along the successions: all limits have exponents of at least m - log_a r, and those of the
/// sequence of the leading product have no larger one where their shifts are stable. Masks in a period are one mask of
/// arity a^L; equal masks that the same sequences may follow are one mask. Of masks of matrices the T_t on what
/// annihilates the data that all keep, times a^m for m of them; the exponent is at least min(m, m - log_a r), and the
/// upper end is that of the refinable functions of the leading sequence, which need not be stable. One sequence has
/// their exponent, where it converges. Domain: canonical; a^L at most 64. Errors: throws Error. Cost: a joint spectral
/// radius, of matrices one more for the functions. Ref: docs/levels.md.
ExponentOfList exponent_of(const MaskList& list, const Budget& budget);

}  // namespace subcert
