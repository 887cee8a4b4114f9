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

}  // namespace subcert::vertex
