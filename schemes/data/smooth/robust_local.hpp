#pragma once
/// Local polynomials with bisquare steps: fits that outliers do not move.

#include "local_polynomial.hpp"
#include "noise.hpp"

#include <vector>

namespace subcert::data {

/// The middle value, or the mean of both. Domain: not empty.
double median(std::vector<double> values);

/// A local fit repeated with the weights of its residuals.
struct RobustFit {
  std::vector<double> values;      ///< at the outputs
  std::vector<double> deviations;  ///< standard deviations by the sandwich formula; none for fewer data than degrees
  NoiseEstimate noise;             ///< what the sandwich takes for the noise
  double path = 0;                 ///< SmoothedData::path
  std::vector<double> pseudodata;  ///< fits plus residuals cut off by the bisquare function: data without outliers
};

/// Fits once, and then method.robust times: r_i the residuals times the roots of their prior weights, S six times the
/// median of |r|, the prior weight of a datum is multiplied by (1 - (r/S)^2)^2, by 1 where |r| <= 0.001 S and by 0
/// where |r| > 0.999 S, as lowess and R's loess do. Where the median vanishes beside the mean, this stands for it. The
/// sandwich takes each datum's influence as psi(r_i) / mean of psi', psi the bisquare function. Domain: a complete
/// method with its width in spacings. Errors and cost: as LocalSmoother::values, for each step. Ref: [Cle79], [Hub64];
/// docs/smoothing.md, section 12.
RobustFit robust_fit(const LocalPolynomial& method, const DataSites& sites, const SmoothingOptions& options,
                     const std::vector<double>& data, int threads);

}  // namespace subcert::data
