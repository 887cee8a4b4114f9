#pragma once
/// The function of the experiments on curves in [MLZD15, sec. 2.5], sampled with outliers: f_1(x) = sin(3x) e^(-x/3).

#include "parts.hpp"

namespace subcert::experiments::mustafa_li_2015 {

double damped_sine(double x);

namespace damped {

constexpr int levels = 3;

/// What the paper leaves open: `count` data from -end to end, and outliers of a modulus from `height` to twice that.
struct Setting {
  double end = 5;
  std::size_t count = 101;
  double height = 4;

  double step() const { return 2 * end / static_cast<double>(count - 1); }
  /// Datum u stands here.
  double position(double u) const { return -end + u * step(); }
  /// Normal noise of this deviation, and outliers of random sign.
  NoisyData with_outliers(std::size_t outliers, double sigma) const;
  /// What the texts and bounds of its experiments name: "mean square" of the samples and "mean square from 0" of f_1 on
  /// [0, 2 pi]; "seen", the square of 1/100 of the range of the samples.
  std::map<std::string, double> numbers() const;
};

/// By the choices `half interval`, `data` and `heights`.
Setting setting(const Run& run);

/// The data as taken, which of them are outliers, f_1 and the curve of a scheme: blue for l1 schemes, else red.
formats::Panel panel(const OutlierSample& sample, const Method& method);

/// A panel for each method.
formats::Figure figure(const std::string& id, const std::string& title, const std::string& caption, int columns,
                       const std::vector<Method>& methods, const OutlierSample& sample);

}  // namespace damped

/// As damped::panel for any data of one axis, with the truth at `density` points for each datum; parameter u of a
/// function is drawn at origin + scale * u. Domain: density >= 1, scale > 0.
formats::Panel outlier_panel(const NoisyData& data, const OutlierSample& sample, const Method& method, int density,
                             const Rational& origin = 0, const Rational& scale = 1);

}  // namespace subcert::experiments::mustafa_li_2015
