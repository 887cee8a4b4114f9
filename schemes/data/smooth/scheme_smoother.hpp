#pragma once
/// The limit of a subdivision scheme from data, with its exact variance.

#include "adic_limit.hpp"
#include "linear_smoother.hpp"

#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/schemes/local_regression.hpp>

#include <optional>

namespace subcert::data {

/// What smoothing by one scheme needs, whatever the data: one may serve many smoothers.
class SmoothingKernel {
 public:
  /// `first_fit`: the first refinement fits at the positions and with the prior weights of the data, which needs
  /// `rules`, those of `mask`. Domain: the scheme converges (for derivatives: proved_smoothness), reproduces constants,
  /// and its parametrization is arity-adic. Errors: throws a domain error that says which of these fails; else as
  /// limit_values.
  SmoothingKernel(const Mask& mask, const std::optional<LocalRegression>& rules, const SmoothingOptions& options,
                  bool first_fit);

  /// The data that one rule of the scheme combines at most, and the degree it reproduces: what Boundary::regression
  /// fits.
  ExtensionRule extension(Boundary kind) const;

 private:
  friend class SchemeSmoother;
  /// The output whole * scale + phase combines the data of level 0 or, after a first fit, 1, from f * whole + first to
  /// f * whole + last, f = fine_; the datum f * whole + j with phi at base - j arity^(its level).
  struct Phase {
    long first;
    long last;
    long base;
  };
  std::pair<long, long> reach_of(const Rational& position) const;
  std::pair<std::size_t, long> rule_of(long index) const;

  Mask mask_;
  std::optional<LocalRegression> rules_;  // of the first fit
  int reproduction_degree_;
  Rational shift_;
  LimitValues phi_;
  long fine_;        // data of level 0 or 1 for each spacing
  Rational factor_;  // of derivatives, to the index of the data
  long grid_;        // values of phi for each datum
  std::size_t scale_;
  std::vector<double> phi_rounded_;
  std::vector<Phase> phases_;
  std::pair<long, long> reach_;             // of the data that the outputs of the spacing 0 combine
  std::vector<std::vector<double>> nodes_;  // of each rule, from its position
  std::optional<AdicLimit> limit_;          // of outputs at given places
};

/// The datum i stands at its position + parametrization of the scheme, so that linear data are reproduced. With prior
/// weights or positions the first refinement fits with them, and those after it do not know them; a weight 0 leaves the
/// datum out. The datum of level 1 that would stand at the index u of uniform data is fitted at its place to as many
/// data as its rule has, about the index that has this place. Outputs at given places are those at the nearest
/// arity-adic numbers of AdicLimit, 2^-51 spacings away at most.
class SchemeSmoother : public LinearSmoother {
 public:
  /// Domain and errors: as SmoothingKernel, with a first fit where the sites have weights or positions; as
  /// LinearSmoother; uniform data where outputs stand at them.
  SchemeSmoother(const Mask& mask, const DataSites& sites, const SmoothingOptions& options,
                 const std::optional<LocalRegression>& rules = std::nullopt);
  /// With a kernel that was made with the same level and derivative, and with a first fit where these sites need one.
  SchemeSmoother(std::shared_ptr<const SmoothingKernel> kernel, DataSites sites, const SmoothingOptions& options);

  SmoothingRow row(std::size_t output) const override;

 private:
  /// Where the window of a datum of level 1 lies, and which of its data have weight.
  template <class Number>
  struct Window {
    std::size_t rule;
    Number place;                   ///< of the fit
    long first;                     ///< datum
    std::vector<Number> weights;    ///< of all points of the rule
    std::vector<std::size_t> kept;  ///< the points with weight
  };
  template <class Number>
  class Rows;
  std::unique_ptr<RowMaker<double>> row_maker() const override;
  template <class Number>
  Window<Number> window_of(long index) const;
  template <class Number>
  std::vector<Number> fit_of(const Window<Number>& window) const;
  template <class Number>
  Combination<Number> level_datum(long index) const;

  std::shared_ptr<const SmoothingKernel> kernel_;
};

}  // namespace subcert::data
