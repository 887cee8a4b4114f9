#pragma once
/// Finitely many masks, one for each level.

#include <subcert/analysis/radii/joint/joint_spectral_radius.hpp>
#include <subcert/analysis/symbol/masks/level_masks.hpp>

#include <optional>
#include <utility>
#include <vector>

namespace subcert {

/// f_{k+1} = S_k f_k with S_k by one of the masks, and which of them may follow which. Canonical: one arity, a sum rule
/// for all; most_rules >= 1; numbers of masks; of `period` and `follows` one is empty.
struct MaskList {
  std::vector<Mask> masks;
  std::vector<std::size_t> period = {};                           ///< these again and again, the coarsest level first
  std::vector<std::pair<std::size_t, std::size_t>> follows = {};  ///< mask `second` may follow mask `first`
  std::optional<int> most_rules = {};                             ///< of which use is made
};

/// Whether some sequence goes on for ever.
bool has_sequence(const MaskList& list);

/// The same sequences with equal masks that the same sequences may follow as one; in a period the list itself. Domain:
/// canonical. Errors: throws Error.
MaskList without_twins(const MaskList& list);

/// The least exponent of all sequences.
struct ExponentOfList {
  int sum_rules = 0;                  ///< that all masks have, and of which use is made
  Enclosure exponent;                 ///< no ends where no convergence is proved; the upper one is that of `sequence`
  Decision exact;                     ///< both ends are proved to be one number, which `exponent` encloses
  Decision stable;                    ///< of the shifts of `sequence`, for the upper end
  std::vector<std::size_t> sequence;  ///< the masks of the leading product, again and again
  MatrixFamily family;                ///< whose radius it is from
  JointSpectralRadius radius;
  MaskList list;  ///< whose matrices these are: without_twins
};

/// By the joint spectral radius r of the transition matrices for divided differences of the order m of the common sum
/// rules, on one window, along the successions: all limits have exponents of at least m - log_a r, and those of the
/// sequence of the leading product have no larger one where their shifts are stable. Masks in a period are one mask of
/// arity a^L; equal masks that the same sequences may follow are one mask. Domain: canonical; a^L at most 64. Errors:
/// throws Error. Cost: a joint spectral radius. Ref: docs/levels.md.
ExponentOfList exponent_of(const MaskList& list, const Budget& budget);

}  // namespace subcert
