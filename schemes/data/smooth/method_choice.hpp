#pragma once
/// Which method smooths data with the smallest expected squared error.

#include "local_polynomial.hpp"
#include "noise.hpp"
#include "scheme_smoother.hpp"
#include "uniform_grid.hpp"

#include <subcert/schemes/specification.hpp>

#include <functional>
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

/// The risks of all columns, added. With Selection::cross_validation the mean squared error of predicting a datum from
/// the others, less the variance of the noise, is the total. Domain: a smoother with an output at each datum and
/// derivative 0, made with the sites of the samples; noise[c] belongs to columns[c]. Of data with derivatives the error
/// is that at the data of one order, as_observed by the smoother. Ref: [Mal73], [DHHS15, eq. (16)], [CW79].
RiskEstimate estimate_risk(const LinearSmoother& smoother, const Samples& samples,
                           const std::vector<NoiseEstimate>& noise, Selection selection = Selection::risk,
                           int order = 0);

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
  std::optional<std::pair<double, double>> range = {};  ///< in which risk.total() lies most likely; of derivatives
};

/// The smallest expected squared error first, of equal ones that with fewer points. Errors: throws a data error for
/// none.
std::vector<SmoothingCandidate> ranked(std::vector<SmoothingCandidate> candidates);

/// Adds the candidate with its risk, where each of its windows has data for a fit; false where not.
bool add_candidate(std::vector<SmoothingCandidate>& candidates, SmoothingCandidate candidate,
                   const std::function<RiskEstimate()>& risk);

/// Takes the error that all estimates have in common out of them, as far as it shows: the least bias^2 is subtracted
/// from all where it is negative, or at most `spread`, which noise alone may make it.
void raise_biases(std::vector<SmoothingCandidate>& candidates, double spread = 0);

/// A candidate of one number more in a list that grows by about a fifth.
inline std::size_t next_points(std::size_t points) { return points + 1 + points / 5; }

/// The primal least squares schemes of degree 1, 3 and 5 with 2n points, at most half as many as data and at most
/// 2 max_n, with the estimated risks, the smallest first. n = (degree + 1) / 2 interpolates. Domain: at least 4 data,
/// uniform; `options` says how they continue. Errors: throws a data error where gaps leave no scheme a fit; else as
/// SchemeSmoother. Schemes that gaps leave without a fit are left out.
std::vector<SmoothingCandidate> rank_schemes(const Samples& samples, const std::vector<NoiseEstimate>& noise,
                                             const SmoothingOptions& options, int max_n = 20);

/// Local polynomials of these degrees and the weight of the pattern, from one datum more than the degree to all data in
/// a window, each number about a fifth larger than the one before; without those whose variance alone is larger than
/// the smallest risk. For windows of more than 64 data the risk is that of windows of 32 to 64 means of neighbours.
/// Domain and errors: as above, but for uniform. Cost: some hundred operations for each datum, however wide the
/// windows.
std::vector<SmoothingCandidate> rank_windows(const LocalPolynomial& pattern, const std::vector<int>& degrees,
                                             const Samples& samples, const std::vector<NoiseEstimate>& noise,
                                             const SmoothingOptions& options);

/// For the derivative of options.derivative: the same windows by the expected squared error of the derivative, and of
/// the derivatives with respect to the index. The bias is that on pilots: up to 16 local polynomials, of the three odd
/// degrees above `derivative`, whose windows rank_windows() puts first, with weights by their risks; what the noise of
/// a pilot adds is subtracted, by noise that is drawn with a seed. The risk is the geometric mean over the pilots, the
/// range theirs, wider by the root of two at both ends. Domain: 1 <= derivative, degrees from `derivative` on. Ref:
/// docs/smoothing.md, section 5.
std::vector<SmoothingCandidate> rank_derivatives(const LocalPolynomial& pattern, const std::vector<int>& degrees,
                                                 const Samples& samples, const std::vector<NoiseEstimate>& noise,
                                                 const SmoothingOptions& options);

struct MethodChoice {
  SmoothingMethod method;
  std::vector<SmoothingCandidate> candidates;  ///< ranked; the first is the method. No bias is negative: where the
                                               ///< smallest estimate was, it is subtracted from all of them

  /// Whether no candidate of the chosen degree has more points, though there are more data.
  bool widest_tried() const;
  std::size_t data = 0;
};

/// Errors: throws a data error for columns whose squares, of which the noise is made, leave the range of doubles.
void require_squares(const Samples& samples);

/// The first of the ranked candidates: rank_schemes() and from there on windows of local polynomials of degree 1, 3 and
/// 5; local polynomials of degree 1 and 3 where data are not uniform; with a pattern its windows; for a derivative
/// rank_derivatives(), of degrees one and three above it. Of several columns the risks are added, each in units of the
/// variance of its data about their mean. Windows of a pattern with robust steps are those for the
/// pseudodata of a robust fit. The noise is estimated where it is not known. Errors: throws a data error for fewer than
/// 4 data or none that neighbour two others, and as require_squares(), a domain error for a derivative above 16; else
/// as those.
MethodChoice choose_method(const Samples& samples, const SmoothingOptions& options,
                           const std::optional<LocalPolynomial>& pattern = std::nullopt, int threads = 1);

}  // namespace subcert::data
