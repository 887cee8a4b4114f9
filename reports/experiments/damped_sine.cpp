#include "damped_sine.hpp"

#include "plane_panel.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace subcert::experiments {

double damped_sine(double x) { return std::sin(3 * x) * std::exp(-x / 3); }

namespace damped {

std::vector<double> samples() {
  std::vector<double> result;
  for (std::size_t u = 0; u < count; ++u) result.push_back(damped_sine(position(static_cast<double>(u))));
  return result;
}

double range() {
  double least = INFINITY, largest = -INFINITY;
  for (std::size_t i = 0; i <= (count - 1) << levels; ++i) {
    const double value = damped_sine(position(std::ldexp(static_cast<double>(i), -levels)));
    least = std::min(least, value);
    largest = std::max(largest, value);
  }
  return largest - least;
}

void add_outliers(std::mt19937_64& engine, std::vector<double>& data, std::size_t outliers) {
  for (const std::size_t i : chosen_indices(engine, outliers, data.size())) {
    const double height = 4 + 4 * uniform(engine);
    data[i] += uniform(engine) < 0.5 ? -height : height;
  }
}

OutlierCase with_outliers(std::size_t outliers, double sigma) {
  return {{data::Axis::of(count)},
          1,
          levels,
          [=](std::mt19937_64& engine) {
            OutlierSample sample{samples(), {}};
            const auto noise = normal_noise(engine, count);
            for (std::size_t i = 0; i < count; ++i) sample.without[i] += sigma * noise[i];
            sample.with = sample.without;
            add_outliers(engine, sample.with, outliers);
            return sample;
          },
          [](double u, double) {
            return std::array<double, 3>{damped_sine(position(u)), 0, 0};
          }};
}

formats::Panel panel(const std::string& title, const std::string& specification, const OutlierSample& sample,
                     int refinements) {
  const Batch fine = refined(specification, {{data::Axis::of(count)}, 1, {sample.with}}, refinements);
  PanelParts parts{title, {}, {}, {}, {}, specification.rfind("l1", 0) == 0};
  for (std::size_t u = 0; u < count; ++u) {
    const bool is_outlier = sample.with[u] != sample.without[u];
    (is_outlier ? parts.outliers : parts.data).emplace_back(position(static_cast<double>(u)), sample.with[u]);
  }
  for (std::size_t i = 0; i <= (count - 1) * 4; ++i) {
    const double x = position(static_cast<double>(i) / 4);
    parts.truth.emplace_back(x, damped_sine(x));
  }
  const auto at = parameters(fine.axes[0]);
  for (std::size_t i = 0; i < at.size(); ++i) parts.curve.emplace_back(position(at[i]), fine.sets[0][i]);
  return plane_panel(parts);
}

formats::Figure figure(const std::string& id, const std::string& title, const std::string& caption,
                       const std::vector<Method>& methods, const OutlierSample& sample) {
  formats::Figure result{id, title, caption, 3, {}};
  for (const Method& method : methods) result.panels.push_back(panel(method.name, method.specification, sample));
  return result;
}

namespace {

/// The mean square of f_1 on [0, length].
double mean_square_from_zero(double length) {
  constexpr int steps = 10000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) sum += std::pow(damped_sine((i + 0.5) * length / steps), 2);
  return sum / steps;
}

}  // namespace

std::string setup() {
  return "f_1(x) = sin(3x) e^(-x/3). The paper names neither interval nor spacing; here x = -5, -4.9, ..., 5, where "
         "the mean "
         "square of f_1 is " +
         short_number(mean_square(samples())) + ". (On [0, 2 pi] it would be " +
         short_number(mean_square_from_zero(2 * std::numbers::pi)) +
         ", the error of the zero function, and five of the six errors in Table 1 are larger.) An outlier adds a "
         "number of "
         "random sign and of a modulus uniform in [4, 8] to a random datum, which makes the errors of the least "
         "squares "
         "schemes about as large as printed. Curves after 5 refinements, 6 reweighted fits with delta = 1e-8, rules at "
         "the "
         "ends by regression. Error: mean squared distance from f_1 at the points of the curve; response: the largest "
         "distance by which the outliers move a point of the curve.";
}

}  // namespace damped
}  // namespace subcert::experiments
