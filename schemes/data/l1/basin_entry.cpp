#include "basin_entry.hpp"

#include "l1_basin.hpp"
#include "l1_refinement.hpp"
#include "reweighted_step.hpp"

#include <subcert/analysis/symbol/numbers/balls.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

namespace subcert::data {
namespace {

constexpr slong precision = 256;

std::vector<Ball> flat(const std::vector<std::vector<Rational>>& rows) {
  std::vector<Ball> result;
  for (const std::vector<Rational>& row : rows)
    for (const Rational& entry : row) result.emplace_back(entry, precision);
  return result;
}

/// The fits of one window in balls.
class BallFitter {
 public:
  BallFitter(const L1Scheme& scheme, const Rational& delta)
      : window_(l1_window(scheme)),
        iterations_(scheme.options.iterations),
        delta_(delta, precision),
        at_nodes_(flat(window_.at_nodes())),
        at_outputs_(flat(window_.at_outputs())) {}

  std::size_t points() const { return window_.nodes(); }
  std::size_t outputs() const { return window_.outputs(); }

  std::vector<Ball> fit(const std::vector<Ball>& data) const {
    std::vector<Ball> residuals = data, fits(window_.outputs(), Ball(0, precision)),
                      weights(window_.nodes(), Ball(1, precision));
    for (int m = 0; m <= iterations_; ++m) {
      if (m > 0)
        for (std::size_t r = 0; r < weights.size(); ++r) weights[r] = 1 / sqrt(residuals[r] * residuals[r] + delta_);
      std::vector<Ball> nodes = at_nodes_, outputs = at_outputs_;
      project<Ball>({window_.nodes(), window_.outputs(), window_.terms(), 1, weights.data(), nodes.data(),
                     outputs.data(), residuals.data(), fits.data()},
                    Ball(0, precision), [](const Ball& norm) { return 1 / norm; });
    }
    return fits;
  }

 private:
  RegressionWindow window_;
  int iterations_;
  Ball delta_;
  std::vector<Ball> at_nodes_, at_outputs_;
};

bool is_zero(const std::vector<Ball>& data) {
  for (const Ball& datum : data)
    if (arb_is_zero(datum.get()) == 0) return false;
  return true;
}

/// The values from the first to the last that depend on the data; the data begin with so many zeros.
/// Nothing where the time does not suffice.
std::optional<std::vector<Ball>> refined(const BallFitter& fitter, const std::vector<Ball>& data,
                                         const Deadline& deadline) {
  const std::size_t points = fitter.points();
  std::vector<Ball> padded(points - 1, Ball(0, precision)), result;
  padded.insert(padded.end(), data.begin(), data.end());
  padded.insert(padded.end(), points - 1, Ball(0, precision));
  for (auto window = padded.begin(); window + static_cast<long>(points) <= padded.end(); ++window) {
    if (deadline.expired()) return std::nullopt;
    const std::vector<Ball> own(window, window + static_cast<long>(points));
    const std::vector<Ball> values = is_zero(own) ? std::vector<Ball>(fitter.outputs(), Ball(0, precision))
                                                  : fitter.fit(own);
    result.insert(result.end(), values.begin(), values.end());
  }
  return result;
}

/// Whether all differences of this order are at most a bound, zeros before and after the data.
bool have_differences(std::vector<Ball> data, int order, const Ball& bound) {
  data.insert(data.begin(), static_cast<std::size_t>(order), Ball(0, precision));
  data.insert(data.end(), static_cast<std::size_t>(order), Ball(0, precision));
  for (int k = 0; k < order; ++k) {
    for (std::size_t j = 0; j + 1 < data.size(); ++j) data[j] = data[j + 1] - data[j];
    data.pop_back();
  }
  for (const Ball& difference : data)
    if (!abs(difference).is_at_most(bound)) return false;
  return true;
}

}  // namespace

std::optional<int> basin_entry(const L1Scheme& scheme, const std::vector<Rational>& data, int most_levels,
                               const Deadline& deadline) {
  const L1Options& options = scheme.options;
  require(scheme.points.size() == 1 && !options.exact && options.tolerance == 0,
          "basin entry: need fits on curves, not exact ones, all of them made");
  require(options.iterations >= 0 && options.iterations <= 100, "basin entry: need 0 <= iterations <= 100, got {}",
          options.iterations);
  require(most_levels >= 0 && most_levels <= 16, "basin entry: need 0 <= most_levels <= 16, got {}", most_levels);
  const std::optional<L1Basin> basin = l1_basin(scheme.points[0], scheme.degree, scheme.arity);
  if (!basin) return std::nullopt;
  const Rational delta = Rational(options.delta);
  const Ball bound = Ball(basin->radius, precision) * sqrt(Ball(delta, precision));
  const BallFitter fitter(scheme, delta);
  std::vector<Ball> values;
  for (const Rational& datum : data) values.emplace_back(datum, precision);
  for (int level = 0; level <= most_levels; ++level) {
    if (level > 0) {
      std::optional<std::vector<Ball>> next = refined(fitter, values, deadline);
      if (!next) return std::nullopt;
      values = std::move(*next);
    }
    if (have_differences(values, scheme.degree + 1, bound)) return level;
  }
  return std::nullopt;
}

}  // namespace subcert::data
