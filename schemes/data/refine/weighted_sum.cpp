#include "weighted_sum.hpp"

#include <algorithm>

namespace subcert::data {

#pragma GCC push_options
#pragma GCC optimize("O3")
namespace portable {
#include "weighted_sum_body.inc"
}  // namespace portable
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define SUBCERT_WIDE_SUMS
#pragma GCC target("avx2")
namespace wide {
#include "weighted_sum_body.inc"
}  // namespace wide
#endif
#pragma GCC pop_options

#ifdef SUBCERT_WIDE_SUMS
namespace {
const bool use_wide = __builtin_cpu_supports("avx2") != 0;
}  // namespace
#define SUBCERT_DISPATCH(call) use_wide ? wide::call : portable::call
#else
#define SUBCERT_DISPATCH(call) portable::call
#endif

void weighted_sum(const double* in, std::size_t stride, const double* weights, std::size_t taps, std::size_t length,
                  double* out, bool add) {
  SUBCERT_DISPATCH(weighted_sum(in, stride, weights, taps, length, out, add));
}

void interleave(const double* parts, std::size_t pitch, std::size_t arity, std::size_t groups, std::size_t size,
                double* out) {
  SUBCERT_DISPATCH(interleave(parts, pitch, arity, groups, size, out));
}

}  // namespace subcert::data
