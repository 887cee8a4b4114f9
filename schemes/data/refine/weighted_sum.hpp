#pragma once
/// The inner loop of linear refinement in double precision.

#include <cstddef>

namespace subcert::data {

/// out[x] = sum over k < taps of weights[k] * in[k * stride + x], for 0 <= x < length; `add` adds it to out[x]. The
/// sums run from k = 0 upwards without contraction, so every machine gives the same bits. Domain: taps >= 1; `out`
/// overlaps nothing. Cost: one pass for up to 8 taps, one more for every 8.
void weighted_sum(const double* in, std::size_t stride, const double* weights, std::size_t taps, std::size_t length,
                  double* out, bool add = false);

/// out[(g * arity + phase) * size + c] = part[phase][g * size + c]: merges `arity` blocks of `groups` points of `size`
/// coordinates, part[phase] = parts + phase * pitch.
void interleave(const double* parts, std::size_t pitch, std::size_t arity, std::size_t groups, std::size_t size,
                double* out);

}  // namespace subcert::data
