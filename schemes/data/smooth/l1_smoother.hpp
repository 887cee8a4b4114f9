#pragma once
/// Smoothing by data-dependent schemes of local l1 regression, at any positions.

#include "linear_smoother.hpp"
#include "noise.hpp"

#include <subcert/schemes/specification.hpp>

#include <vector>

namespace subcert::data {

/// Levels below the output grid at which data-dependent schemes, whose limits are not known, are interpolated.
constexpr int finer_levels = 6;

/// The limit, nearly: the values `finer_levels` below the outputs, interpolated linearly. Where data are uniform and
/// all weights 1 this is refine(). Else the first refinement fits at the places of its rule on the grid of the spacing:
/// to as many data as the rule has, missing ones left out, about the index that has this place; it minimises the sum of
/// (w r^2 + delta)^(1/2), w the prior weights. The refinements after it know neither weights nor positions.
class L1Smoother {
 public:
  /// Domain: a scheme for curves, derivative 0, boundary regression, reflect or periodic; fits that are not exact where
  /// positions or weights are given; with `periodic` a length that is a multiple of the spacing. Errors: throws a
  /// domain error; a data error for fewer data than points.
  L1Smoother(const DataDependentScheme& scheme, DataSites sites, const SmoothingOptions& options);

  std::size_t outputs() const { return places_.size(); }
  /// Values at the outputs. Cost: a fit for each value, at each level.
  std::vector<double> values(const std::vector<double>& data, int threads) const;

  struct Spread {
    std::vector<double> deviations;
    NoiseEstimate noise;
  };
  /// Standard deviations of values at the outputs where the data are the values plus residuals drawn again, as often as
  /// options.resamples says, with the seed of the options. Residuals are as much larger as smoothing makes those of
  /// normal noise smaller. Ref: [ET93].
  Spread bootstrap(const std::vector<double>& data, int threads) const;

 private:
  bool plain() const { return sites_.weights.empty() && sites_.positions.empty(); }
  std::vector<double> values(const std::vector<double>& data, const std::vector<Rational>& places, int binary,
                             int threads) const;
  std::vector<double> residuals(const std::vector<double>& data, const std::vector<double>& fits) const;

  DataDependentScheme scheme_;
  DataSites sites_;
  SmoothingOptions options_;
  std::size_t grid_;  // points of level 0
  std::vector<Rational> places_, data_places_;
};

}  // namespace subcert::data
