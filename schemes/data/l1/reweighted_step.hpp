#pragma once
/// One weighted least squares step, for exact numbers and for lanes of doubles alike.

#include <cstddef>

#if defined(__GNUC__)
#define SUBCERT_INLINE [[gnu::always_inline]] inline
#else
#define SUBCERT_INLINE inline
#endif

namespace subcert::data {

/// Arrays of one window; [k][i] means position k * nodes + i (or k * outputs + i).
template <class Number>
struct StepArrays {
  std::size_t nodes;
  std::size_t outputs;
  std::size_t terms;
  std::size_t dimension;
  const Number* weights;  ///< [i]
  Number* at_nodes;       ///< [k][i] basis, made orthogonal for the weights
  Number* at_outputs;     ///< [k][o]
  Number* residuals;      ///< [c][i], projected
  Number* fits;           ///< [c][o], increased by the projections
};

/// Takes the weighted projection onto the polynomials out of the residuals and adds its values at the outputs to the
/// fits. Modified Gram and Schmidt in the weighted inner product: only sums of squares are divided by, and the
/// correction of a fit is computed from its residuals. `inverse(x)` is 1/x, or 0 for x = 0. Precondition: the basis
/// polynomial 0 is 1. Ref: [Hig02, sec. 19.8, 20.3].
template <class Number, class Inverse>
SUBCERT_INLINE void project(const StepArrays<Number>& a, const Number& zero, const Inverse& inverse) {
  for (std::size_t k = 0; k < a.terms; ++k) {
    Number* const q = a.at_nodes + k * a.nodes;
    Number* const e = a.at_outputs + k * a.outputs;
    Number norm = zero;
    if (k == 0)
      for (std::size_t i = 0; i < a.nodes; ++i) norm = norm + a.weights[i];
    else
      for (std::size_t i = 0; i < a.nodes; ++i) norm = norm + a.weights[i] * (q[i] * q[i]);
    const Number scale = inverse(norm);
    for (std::size_t c = 0; c < a.dimension; ++c) {
      Number* const r = a.residuals + c * a.nodes;
      Number* const p = a.fits + c * a.outputs;
      Number sum = zero;
      if (k == 0) {
        for (std::size_t i = 0; i < a.nodes; ++i) sum = sum + a.weights[i] * r[i];
        sum = sum * scale;
        for (std::size_t i = 0; i < a.nodes; ++i) r[i] = r[i] - sum;
        for (std::size_t o = 0; o < a.outputs; ++o) p[o] = p[o] + sum;
      } else {
        for (std::size_t i = 0; i < a.nodes; ++i) sum = sum + a.weights[i] * q[i] * r[i];
        sum = sum * scale;
        for (std::size_t i = 0; i < a.nodes; ++i) r[i] = r[i] - sum * q[i];
        for (std::size_t o = 0; o < a.outputs; ++o) p[o] = p[o] + sum * e[o];
      }
    }
    for (std::size_t l = k + 1; l < a.terms; ++l) {
      Number* const next = a.at_nodes + l * a.nodes;
      Number* const next_e = a.at_outputs + l * a.outputs;
      Number sum = zero;
      if (k == 0) {
        for (std::size_t i = 0; i < a.nodes; ++i) sum = sum + a.weights[i] * next[i];
        sum = sum * scale;
        for (std::size_t i = 0; i < a.nodes; ++i) next[i] = next[i] - sum;
        for (std::size_t o = 0; o < a.outputs; ++o) next_e[o] = next_e[o] - sum;
      } else {
        for (std::size_t i = 0; i < a.nodes; ++i) sum = sum + a.weights[i] * q[i] * next[i];
        sum = sum * scale;
        for (std::size_t i = 0; i < a.nodes; ++i) next[i] = next[i] - sum * q[i];
        for (std::size_t o = 0; o < a.outputs; ++o) next_e[o] = next_e[o] - sum * e[o];
      }
    }
  }
}

}  // namespace subcert::data
