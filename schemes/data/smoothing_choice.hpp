#pragma once
/// How noisy data are, and which scheme smooths them with the smallest expected squared error.

#include "smoothing.hpp"

#include <string>
#include <vector>

namespace subcert::data {

/// Variance of the noise of data with prior weight 1. Computed from sums of squares in `terms` second differences,
/// which linear trends do not enter; distributed nearly as chi squared with `degrees_of_freedom` where the noise is
/// normal.
struct NoiseEstimate {
  double variance = 0;
  double degrees_of_freedom = 0;
  std::size_t terms = 0;
};

/// Domain: as many prior weights as data, or none; a weight 0 means missing. Without three neighbouring data the
/// estimate has no terms. Ref: [GSJ86].
NoiseEstimate estimate_noise(const std::vector<double>& data, const std::vector<double>& prior_weights = {});

/// The mean over the data of the expected squared error at the data, in its two parts: both weighted by the prior
/// weights.
struct RiskEstimate {
  double bias_squared = 0;  ///< unbiased estimate, so it may come out negative
  double variance = 0;      ///< noise variance times the exact mean of the variance factors
  double total() const { return bias_squared + variance; }
};

/// One column of the data is one function; the risks of several are added. Domain: level 0, derivative 0; noise[c]
/// belongs to columns[c]; the smoother was made with `prior_weights`. Ref: [Mal73], [DHHS15, eq. (16)].
RiskEstimate estimate_risk(const LinearSmoother& smoother, const std::vector<std::vector<double>>& columns,
                           const std::vector<NoiseEstimate>& noise, const std::vector<double>& prior_weights = {},
                           double constant = 0);

struct SmoothingCandidate {
  int n;
  int degree;
  std::string specification;
  RiskEstimate risk;
};

/// The primal least squares schemes of degree 1, 3 and 5 with 2n points, at most half as many as data and at most
/// 2 max_n, with the estimated risks, the smallest first. n = (degree + 1) / 2 interpolates. Domain: at least 4 data.
/// Errors: as LinearSmoother; schemes that gaps in the data leave without a fit are left out.
std::vector<SmoothingCandidate> rank_schemes(const std::vector<std::vector<double>>& columns,
                                             const std::vector<NoiseEstimate>& noise, Extension extension,
                                             const std::vector<Rational>& prior_weights = {}, double constant = 0,
                                             int max_n = 20);

}  // namespace subcert::data
