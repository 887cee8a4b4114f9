#pragma once
/// Averaged growth of products of a family.

#include <subcert/analysis/symbol/matrices/matrix_family.hpp>

namespace subcert {

struct PRadius {
  Enclosure radius;
  std::size_t size;  ///< of the matrix whose spectral radius is the p-th power
};

/// Whether p_radius knows a formula: p even, no entry negative, or no entry below the diagonal.
bool has_p_radius(const MatrixFamily& family, int p);

/// The p-radius: the limit of (average of |A_{w_1} ... A_{w_k}|^p over all m^k words)^(1/(pk)). Domain: has_p_radius; 1
/// <= p <= 64; at most 256 forms of degree p, binom(n+p-1, p), for each diagonal block. Errors: throws Error otherwise.
/// Error: relative width below 2^-bits. Nothing where the deadline comes first. Cost: one characteristic polynomial of
/// that size, and the balls of its zeros. Ref: [Zho98]; docs/joint-spectral-radius.md.
std::optional<PRadius> p_radius(const MatrixFamily& family, int p, int bits, const Deadline& deadline);

}  // namespace subcert
