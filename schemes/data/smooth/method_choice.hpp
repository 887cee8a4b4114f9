#pragma once
/// Which method smooths data with the smallest expected squared error.

#include "local_polynomial.hpp"
#include "noise.hpp"
#include "scheme_smoother.hpp"
#include "uniform_grid.hpp"

#include <subcert/schemes/specification.hpp>

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace subcert::data {

/// The mean over the data of the expected squared error at the data, in its two parts: both weighted by the prior
/// weights.
struct RiskEstimate {
  double bias_squared = 0;  ///< unbiased estimate, so it may come out negative
  double variance = 0;      ///< noise variance times the exact mean of the variance factors
  double total() const { return bias_squared + variance; }
};

/// The risks of all columns, added. Domain: a smoother with an output at each datum and derivative 0, made with
/// the sites of the samples; noise[c] belongs to columns[c]. Ref: [Mal73], [DHHS15, eq. (16)].
RiskEstimate estimate_risk(const LinearSmoother& smoother, const Samples& samples,
                           const std::vector<NoiseEstimate>& noise);

/// What smooths data: the limit of a scheme of one variable, local polynomials, or data-dependent refinement.
using SmoothingMethod = std::variant<Scheme, LocalPolynomial, DataDependentScheme>;

/// `primal:n=5` and all other schemes of one variable, `local:...`, `l1:...`. Errors: throws a usage error.
SmoothingMethod make_smoothing_method(std::string_view specification);
std::string to_text(const SmoothingMethod& method);

struct SmoothingCandidate {
  std::size_t points;  ///< of the longest fit
  int degree;
  std::string specification;
  RiskEstimate risk;
};

/// The primal least squares schemes of degree 1, 3 and 5 with 2n points, at most half as many as data and at most
/// 2 max_n, with the estimated risks, the smallest first. n = (degree + 1) / 2 interpolates. Domain: at least 4 data,
/// uniform; `options` says how they continue. Errors: throws a data error where gaps leave no scheme a fit; else as
/// SchemeSmoother. Schemes that gaps leave without a fit are left out.
std::vector<SmoothingCandidate> rank_schemes(const Samples& samples, const std::vector<NoiseEstimate>& noise,
                                             const SmoothingOptions& options, int max_n = 20);

/// Local polynomials of this degree and weight, with up to `max_points` data in a window, each number about a fifth
/// larger than the one before. Domain and errors: as above, but for uniform.
std::vector<SmoothingCandidate> rank_windows(const LocalPolynomial& pattern, const Samples& samples,
                                             const std::vector<NoiseEstimate>& noise, const SmoothingOptions& options,
                                             std::size_t max_points = 401);

/// The first of the ranked candidates whose limits are proved to have the derivatives asked for.
struct MethodChoice {
  SmoothingMethod method;
  std::vector<SmoothingCandidate> candidates;  ///< ranked
  std::size_t chosen = 0;

  /// Whether no candidate of the chosen degree has more points.
  bool widest_tried() const;
};

/// Chooses among rank_schemes() or, with a pattern and where data are not uniform, rank_windows(). The noise is
/// estimated where it is not known. Errors: throws a data error for fewer than 4 data or none that neighbour two
/// others, a domain error where no candidate is smooth enough; else as those.
MethodChoice choose_method(const Samples& samples, const SmoothingOptions& options,
                           const std::optional<LocalPolynomial>& pattern = std::nullopt);

}  // namespace subcert::data
