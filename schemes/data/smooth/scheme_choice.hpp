#pragma once
/// Which scheme smooths data with the smallest expected squared error.

#include "noise.hpp"
#include "samples.hpp"
#include "smoothing.hpp"

#include <subcert/schemes/specification.hpp>

#include <string>
#include <vector>

namespace subcert::data {

/// The mean over the data of the expected squared error at the data, in its two parts: both weighted by the prior
/// weights.
struct RiskEstimate {
  double bias_squared = 0;  ///< unbiased estimate, so it may come out negative
  double variance = 0;      ///< noise variance times the exact mean of the variance factors
  double total() const { return bias_squared + variance; }
};

/// The risks of all columns, added. Domain: a smoother of level 0 and derivative 0, made with the weights of the
/// samples; noise[c] belongs to columns[c]. Ref: [Mal73], [DHHS15, eq. (16)].
RiskEstimate estimate_risk(const LinearSmoother& smoother, const Samples& samples,
                           const std::vector<NoiseEstimate>& noise);

struct SmoothingCandidate {
  int n;
  int degree;
  std::string specification;
  RiskEstimate risk;
};

/// The primal least squares schemes of degree 1, 3 and 5 with 2n points, at most half as many as data and at most
/// 2 max_n, with the estimated risks, the smallest first. n = (degree + 1) / 2 interpolates. Domain: at least 4 data;
/// `options` says how they continue. Errors: throws a data error where gaps leave no scheme a fit; else as
/// LinearSmoother. Schemes that gaps leave without a fit are left out.
std::vector<SmoothingCandidate> rank_schemes(const Samples& samples, const std::vector<NoiseEstimate>& noise,
                                             const SmoothingOptions& options, int max_n = 20);

/// The first of the ranked candidates whose limits are proved to have the derivatives asked for.
struct SchemeChoice {
  Scheme scheme;
  std::vector<SmoothingCandidate> candidates;  ///< as rank_schemes gives them
  std::size_t chosen = 0;

  /// Whether no candidate of the chosen degree has more points.
  bool widest_tried() const;
};

/// Chooses among rank_schemes(), with the noise estimated from the samples. Errors: throws a data error for fewer than
/// 4 data or none that neighbour two others, a domain error where no candidate is smooth enough; else as rank_schemes.
SchemeChoice choose_scheme(const Samples& samples, const SmoothingOptions& options);

}  // namespace subcert::data
