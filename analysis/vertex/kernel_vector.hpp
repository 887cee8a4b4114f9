#pragma once
/// Kernels of matrices over the fields of proofs at vertices. Inner header.

#include "cosine_field.hpp"

#include <optional>
#include <vector>

namespace subcert::vertex {

/// The kernel of a matrix of rank n - 1, its first entry that is not 0 being 1; nothing where none is found. In balls:
/// for each singular matrix in them. Cost: linear systems, one where the first entry is not 0.
std::optional<std::vector<Ball>> kernel_vector(const std::vector<std::vector<Ball>>& matrix, const BallField& field);
std::optional<std::vector<CosineField::Number>> kernel_vector(std::vector<std::vector<CosineField::Number>> matrix,
                                                              const CosineField& field);

/// Where products of a matrix end: N^size is no smaller than all later powers, N^(size - 1) is.
struct NilpotentPart {
  std::size_t size;  ///< of the largest Jordan block of 0; 0 where the matrix is regular
  /// What N^(size - 1) makes of the kernel of N^size where that is a line, its first entry that is not 0 being 1; else
  /// empty.
  std::vector<CosineField::Number> last;
};

/// Exact. Cost: powers of the matrix, and an elimination of each.
NilpotentPart nilpotent_part(const std::vector<std::vector<CosineField::Number>>& matrix, const CosineField& field);

}  // namespace subcert::vertex
