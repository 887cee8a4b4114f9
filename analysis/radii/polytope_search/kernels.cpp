#include "kernels.hpp"

#include <cmath>

namespace subcert::polytope::kernels {

// The sums may be reordered: a search needs no reproducible last bit.
#pragma GCC push_options
#pragma GCC optimize("O3,associative-math,no-signed-zeros,no-trapping-math,no-math-errno")
namespace portable {
#include "kernels_body.inc"
}  // namespace portable
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define SUBCERT_WIDE_KERNELS
#pragma GCC target("avx2,fma")
namespace wide {
#include "kernels_body.inc"
}  // namespace wide
#endif
#pragma GCC pop_options

#ifdef SUBCERT_WIDE_KERNELS
namespace {
const bool use_wide = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
}  // namespace
#define SUBCERT_DISPATCH(call) return use_wide ? wide::call : portable::call
#else
#define SUBCERT_DISPATCH(call) return portable::call
#endif

void multiply(const double* a, std::size_t rows, std::size_t columns, const double* x, double* out) {
  SUBCERT_DISPATCH(multiply(a, rows, columns, x, out));
}

void multiply_transposed(const double* a, std::size_t rows, std::size_t columns, const double* x, double* out) {
  SUBCERT_DISPATCH(multiply_transposed(a, rows, columns, x, out));
}

void add_product(const double* a, std::size_t rows, std::size_t inner, const double* b, std::size_t columns,
                 double* out) {
  SUBCERT_DISPATCH(add_product(a, rows, inner, b, columns, out));
}

void rank_one(double* a, std::size_t rows, std::size_t columns, const double* u, const double* v) {
  SUBCERT_DISPATCH(rank_one(a, rows, columns, u, v));
}

double dot(const double* a, const double* b, std::size_t n) { SUBCERT_DISPATCH(dot(a, b, n)); }

float price_block(const float* block, std::size_t even, std::size_t odd, const float* y, float* out) {
  SUBCERT_DISPATCH(price_block(block, even, odd, y, out));
}

float price_complex_block(const float* block, std::size_t even, std::size_t odd, bool flip, const float* y,
                          float* out) {
  SUBCERT_DISPATCH(price_complex_block(block, even, odd, flip, y, out));
}

}  // namespace subcert::polytope::kernels
