// Lanes of windows fitted side by side. Built without errno in sqrt and without contraction, so that machines with and
// without wide registers give the same bits.

#include "l1_regression.hpp"
#include "reweighted_step.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace subcert::data {
namespace {

typedef double Lanes __attribute__((vector_size(8 * L1Fitter::lanes), aligned(8 * L1Fitter::lanes), may_alias));

SUBCERT_INLINE void copy(const Lanes* from, std::size_t count, Lanes* to) { std::copy(from, from + count, to); }

struct Shape {
  std::size_t nodes;
  std::size_t outputs;
  std::size_t terms;
  std::size_t dimension;
  const double* at_nodes;
  const double* at_outputs;
  const double* inverse_norms;
};

/// The arrays of a workspace.
struct Arrays {
  Lanes* weights;
  Lanes* at_nodes;
  Lanes* at_outputs;
  Lanes* residuals;
  Lanes* fits;
  Lanes* old_residuals;
  Lanes* old_fits;
};

SUBCERT_INLINE void ordinary_fit(const Shape& s, const Arrays& a) {
  for (std::size_t c = 0; c < s.dimension; ++c) {
    Lanes* const r = a.residuals + c * s.nodes;
    Lanes* const p = a.fits + c * s.outputs;
    for (std::size_t o = 0; o < s.outputs; ++o) p[o] = Lanes{};
    for (std::size_t k = 0; k < s.terms; ++k) {
      const double* const q = s.at_nodes + k * s.nodes;
      const double* const e = s.at_outputs + k * s.outputs;
      Lanes sum{};
      for (std::size_t i = 0; i < s.nodes; ++i) sum += q[i] * r[i];
      sum *= s.inverse_norms[k];
      for (std::size_t i = 0; i < s.nodes; ++i) r[i] -= q[i] * sum;
      for (std::size_t o = 0; o < s.outputs; ++o) p[o] += e[o] * sum;
    }
  }
}

SUBCERT_INLINE void set_weights(const Shape& s, const Arrays& a, double delta) {
  for (std::size_t i = 0; i < s.nodes; ++i) {
    Lanes square = Lanes{} + delta;
    for (std::size_t c = 0; c < s.dimension; ++c) square += a.residuals[c * s.nodes + i] * a.residuals[c * s.nodes + i];
    a.weights[i] = square;
  }
  auto* const w = reinterpret_cast<double*>(a.weights);
  for (std::size_t j = 0; j < s.nodes * L1Fitter::lanes; ++j) w[j] = 1.0 / std::sqrt(w[j]);
}

/// Freezes the lanes that were frozen, and those whose fit moved by at most `tolerance` from now on. True: all are
/// frozen.
SUBCERT_INLINE bool freeze(const Shape& s, const Arrays& a, double tolerance, bool (&frozen)[L1Fitter::lanes]) {
  bool all = true;
  for (std::size_t l = 0; l < L1Fitter::lanes; ++l) {
    if (frozen[l]) {
      for (std::size_t i = 0; i < s.dimension * s.nodes; ++i) a.residuals[i][l] = a.old_residuals[i][l];
      for (std::size_t o = 0; o < s.dimension * s.outputs; ++o) a.fits[o][l] = a.old_fits[o][l];
      continue;
    }
    double moved = 0;
    for (std::size_t i = 0; i < s.dimension * s.nodes; ++i)
      moved = std::max(moved, std::abs(a.residuals[i][l] - a.old_residuals[i][l]));
    frozen[l] = moved <= tolerance;
    all = all && frozen[l];
  }
  return all;
}

SUBCERT_INLINE void fit_lanes(const Shape& s, const Arrays& a, const L1Options& options) {
  ordinary_fit(s, a);
  bool frozen[L1Fitter::lanes] = {};
  for (int iteration = 0; iteration < options.iterations; ++iteration) {
    set_weights(s, a, options.delta);
    for (std::size_t j = s.nodes; j < s.terms * s.nodes; ++j) a.at_nodes[j] = Lanes{} + s.at_nodes[j];
    for (std::size_t j = s.outputs; j < s.terms * s.outputs; ++j) a.at_outputs[j] = Lanes{} + s.at_outputs[j];
    if (options.tolerance > 0) {
      copy(a.residuals, s.dimension * s.nodes, a.old_residuals);
      copy(a.fits, s.dimension * s.outputs, a.old_fits);
    }
    project<Lanes>(
        {s.nodes, s.outputs, s.terms, s.dimension, a.weights, a.at_nodes, a.at_outputs, a.residuals, a.fits}, Lanes{},
        [](const Lanes& norm) __attribute__((always_inline)) { return norm > 0.0 ? 1.0 / norm : Lanes{}; });
    if (options.tolerance > 0 && freeze(s, a, options.tolerance, frozen)) break;
  }
}

/// The frequent shapes with their sizes known to the compiler.
SUBCERT_INLINE void fit_shape(Shape s, const Arrays& a, const L1Options& options) {
  if (s.dimension == 1 && s.terms == 2 && s.outputs == 2) {
    s.dimension = 1;
    s.terms = 2;
    s.outputs = 2;
    fit_lanes(s, a, options);
  } else if (s.dimension == 1) {
    s.dimension = 1;
    fit_lanes(s, a, options);
  } else {
    fit_lanes(s, a, options);
  }
}

void fit_portable(const Shape& s, const Arrays& a, const L1Options& options) { fit_shape(s, a, options); }

#if defined(__x86_64__) && defined(__GNUC__)
#define SUBCERT_WIDE_LANES
[[gnu::target("avx2")]] void fit_wide(const Shape& s, const Arrays& a, const L1Options& options) {
  fit_shape(s, a, options);
}
const bool use_wide_lanes = __builtin_cpu_supports("avx2") != 0;
#endif

}  // namespace

void L1Fitter::fit(const double* data, std::size_t dimension, double* out, Workspace& workspace) const {
  if (exact_) return fit_exactly(data, dimension, out);
  const Shape s{window_.nodes(),  window_.outputs(),  window_.terms(),      dimension,
                at_nodes_.data(), at_outputs_.data(), inverse_norms_.data()};
  const std::size_t counts[] = {s.nodes,
                                s.terms * s.nodes,
                                s.terms * s.outputs,
                                dimension * s.nodes,
                                dimension * s.outputs,
                                dimension * s.nodes,
                                dimension * s.outputs};
  std::size_t total = 1;
  for (std::size_t count : counts) total += count;
  if (workspace.storage_.size() < total * lanes) workspace.storage_.resize(total * lanes);
  const auto address = reinterpret_cast<std::uintptr_t>(workspace.storage_.data());
  auto* next = reinterpret_cast<Lanes*>((address + sizeof(Lanes) - 1) / sizeof(Lanes) * sizeof(Lanes));
  Lanes* parts[std::size(counts)];
  for (std::size_t k = 0; k < std::size(counts); ++k) {
    parts[k] = next;
    next += counts[k];
  }
  const Arrays a{parts[0], parts[1], parts[2], parts[3], parts[4], parts[5], parts[6]};
  std::memcpy(a.residuals, data, dimension * s.nodes * sizeof(Lanes));
#ifdef SUBCERT_WIDE_LANES
  (use_wide_lanes ? fit_wide : fit_portable)(s, a, options_);
#else
  fit_portable(s, a, options_);
#endif
  std::memcpy(out, a.fits, dimension * s.outputs * sizeof(Lanes));
}

}  // namespace subcert::data
