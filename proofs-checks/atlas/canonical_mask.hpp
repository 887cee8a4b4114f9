#pragma once
/// The one mask that stands for all that have the same limit functions but for a shift and a reflection.

#include <subcert/analysis/symbol/masks/mask.hpp>

#include <optional>
#include <string>

namespace subcert::atlas {

/// The mask b of this arity of which `mask` is k >= 2 steps: a(z) = b(z) b(z^m) ... b(z^(m^(k-1))), b(1) = m, with
/// lowest exponent 0; nothing where there is none. Domain: a power of `arity` as arity of a mask whose coefficients sum
/// to it. Cost: quadratic in the length of b. Proof that both have the same limits: docs/atlas.md.
std::optional<Mask> root_of(const Mask& mask, int arity);

/// Of a mask that is several steps of another one, the latter for the smallest arity that there is; then of it and its
/// mirror image, both with first index 0, the one whose coefficients come first. So masks are the same here if and only
/// if their roots are up to a shift and a reflection.
Mask canonical_mask(const Mask& mask);

/// The same of a mask in one or two variables, of the latter as canonical_surface(). Domain: numbers; one variable or
/// two.
LatticeMask canonical_mask(const LatticeMask& mask);

/// `mask:[1,4,6,4,1]/8@0`, with `,arity=A` unless that is 2, or as `mask2:[[1,2,1],[2,4,2],[1,2,1]]/4@0,0`, with
/// `,dilation=[...]` where that is no multiple of the identity: the text that names an entry.
std::string mask_text(const LatticeMask& canonical);

/// The first 12 hexadecimal digits of the SHA-256 of that text: by it an entry is cited.
std::string entry_id(const LatticeMask& canonical);

/// Whether the text could be one.
bool is_entry_id(const std::string& text);

}  // namespace subcert::atlas
