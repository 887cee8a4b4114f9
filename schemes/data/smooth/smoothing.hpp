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
    /// Of the path of great arcs through the rows, each divided by its norm, with its data in units of their noise; up
    /// to signs. Rows of zeros are left out.
    double path = 0;
  };
  /// All rows on the data, composed and applied in double precision; rows that are translates of each other are made
  /// once. Errors: as row(). Cost: outputs times the width of a row.
  Smoothed apply(const std::vector<double>& data) const;

 private:
  /// Where the window of a datum of level 1 lies, and which of its data have weight.
  template <class Number>
  struct Window {
    std::size_t rule;
    long first;                     ///< datum
    std::vector<Number> weights;    ///< of all points of the rule
    std::vector<std::size_t> kept;  ///< the points with weight
  };
  template <class Number>
  Window<Number> window_of(long index) const;
  std::pair<std::size_t, long> rule_of(long index) const;
  SmoothingRow limit_row(std::size_t output) const;
  Combination refined_datum(long index) const;
  const std::vector<Rational>& fit_of(const Window<Rational>& window) const;
  std::pair<long, long> reach(std::size_t output, const Rational& scale) const;
  SmoothingRow to_row(const Combination& combination) const;

  /// The output whole * scale_ + phase combines, with f = 1 or, with prior weights, arity, the data of level 0 or 1
  /// from f * whole + first to f * whole + last; the datum f * whole + j with phi at base - j arity^(its level).
  struct Phase {
    long first;
    long last;
    long base;
  };
  class RoundedData;
  class PathLength;
  void prepare_rounded_rows();
  std::size_t interior_end(std::size_t whole) const;
  /// Calls one(row, output), or many(rows, shift, begin, end) for the outputs of the positions begin, ..., end - 1:
  /// rows[phase] acts on the data from its `first` + shift on at `begin`, and one further for each position; in order.
  template <class One, class Many>
  void visit_rounded_rows(const One& one, const Many& many) const;
  RoundedCombination rounded_refined_datum(long index) const;
  RoundedRow rounded_row(std::size_t output, RoundedData& data) const;

  Mask mask_;
  SmoothingOptions options_;
  std::optional<LocalRegression> rules_;
  Rational shift_;
  LimitValues phi_;
  ExtendedData data_;
  std::size_t scale_;                  // arity^level
  std::vector<double> prior_weights_;  // of all data, 1 where none are given
  std::vector<double> phi_rounded_;
  std::vector<Phase> phases_;
  long lowest_ = 0;                             // of the data that the outputs of the position 0 combine
  long highest_ = 0;                            // likewise
  std::vector<std::vector<double>> nodes_;      // of each rule, from its position; with prior weights alone
  std::vector<std::size_t> same_weight_until_;  // [i]: the first after i with another weight; likewise
  mutable std::map<std::pair<std::size_t, std::vector<Rational>>, std::vector<Rational>> fits_;
};

/// The data that one rule of the scheme combines at most, and the degree it reproduces: what Boundary::regression fits.
ExtensionRule extension_rule(const Mask& mask, Boundary kind);

}  // namespace subcert::data
