#pragma once
/// Linear smoothing: the limit of a subdivision scheme from data on a uniform grid, with its exact variance.

#include "extension.hpp"

#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/schemes/local_regression.hpp>

namespace subcert::data {

/// Outputs that one smoother may have.
constexpr std::size_t most_smoothed_values = 4'000'000;

/// Throws a size error where (count - 1) * scale + 1 outputs would pass most_smoothed_values. Domain: count >= 1.
void require_smoothable(std::size_t count, std::size_t scale);

struct SmoothingOptions {
  Boundary boundary = Boundary::regression;
  int level = 0;        ///< outputs at the multiples of arity^-level of the spacing
  int derivative = 0;   ///< of the limit, with respect to the index of the data
  double constant = 0;  ///< beyond the ends, for Boundary::constant
};

/// The limit, or its derivative, at position = output / arity^level in units of the spacing: a combination of the data.
struct SmoothingRow {
  std::size_t first = 0;  ///< the first datum with a weight below
  std::vector<Rational> weights;
  Rational outside = 0;   ///< weight of the constant of Boundary::constant
  Rational variance = 0;  ///< for independent noise of variance 1 / (prior weight): sum of weights^2 / prior weight
};

/// The linear map from data to values of the limit. The datum i stands at i + parametrization of the scheme, so that
/// linear data are reproduced. With prior weights the first refinement fits with them, and those after it do not know
/// them; a weight 0 leaves the datum out.
class LinearSmoother {
 public:
  /// Domain: the scheme converges (for derivatives: proved_smoothness), reproduces constants, and its parametrization
  /// is arity-adic; `rules` are those of `mask` and needed for prior weights. Errors: throws a domain error
  /// that says which of these fails; else as limit_values, ExtendedData
  /// and require_smoothable.
  LinearSmoother(const Mask& mask, std::size_t count, const SmoothingOptions& options,
                 const std::optional<LocalRegression>& rules = std::nullopt, std::vector<Rational> prior_weights = {});

  std::size_t outputs() const;
  Rational position(std::size_t output) const;
  /// Exact. Errors: throws a data error where prior weights leave too few data for a fit, and names the datum.
  SmoothingRow row(std::size_t output) const;

  /// A SmoothingRow in double precision.
  struct RoundedRow {
    std::size_t first = 0;
    std::vector<double> weights;
    double outside = 0;
    double variance = 0;
  };
  /// All rows, composed in double precision; equal rows are made once. Errors: as row(). Cost: as apply().
  std::vector<RoundedRow> rounded_rows() const;

  struct Smoothed {
    std::vector<double> values;
    std::vector<double> variances;  ///< as SmoothingRow::variance
    std::vector<double> leverages;  ///< [i]: the weight of datum i in the value at i
  };
  /// All rows on the data, composed and applied in double precision; equal rows are made once. Errors: as row().
  /// Cost: outputs times the width of a row.
  Smoothed apply(const std::vector<double>& data) const;

 private:
  /// Where the window of a datum of level 1 lies, and which of its data have weight.
  struct Window {
    std::size_t rule;
    long first;                     ///< datum
    long group;                     ///< the rule's position counts from this datum
    std::vector<Rational> weights;  ///< of all points of the rule
    std::vector<std::size_t> kept;  ///< the points with weight
  };
  Window window_of(long index) const;
  SmoothingRow limit_row(std::size_t output) const;
  Combination refined_datum(long index) const;
  const std::vector<Rational>& fit_of(const Window& window) const;
  bool is_interior(std::size_t output) const;
  std::pair<long, long> reach(std::size_t output, const Rational& scale) const;
  SmoothingRow to_row(const Combination& combination) const;

  /// Calls visit(row, output, shift) for all rows in order; the row acts on the data from row.first + shift on.
  template <class Visit>
  void visit_rounded_rows(const Visit& visit) const;
  RoundedCombination rounded_refined_datum(long index) const;
  const RoundedCombination& rounded_datum(long index) const;
  RoundedRow rounded_row(std::size_t output) const;

  Mask mask_;
  SmoothingOptions options_;
  std::optional<LocalRegression> rules_;
  Rational shift_;
  LimitValues phi_;
  ExtendedData data_;
  std::size_t scale_;                  // arity^level
  std::vector<double> prior_weights_;  // of all data, 1 where none are given
  mutable std::map<std::pair<std::size_t, std::vector<Rational>>, std::vector<Rational>> fits_;
  mutable std::map<long, RoundedCombination> rounded_;
};

/// The data that one rule of the scheme combines at most, and the degree it reproduces: what Boundary::regression fits.
ExtensionRule extension_rule(const Mask& mask, Boundary kind);

}  // namespace subcert::data
