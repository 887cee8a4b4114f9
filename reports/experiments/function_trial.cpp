#include "function_trial.hpp"

#include <subcert/schemes/data/runtime/parallel.hpp>

#include <cmath>

namespace subcert::experiments {
namespace {

constexpr int level = 2;  // outputs at the multiples of h/4

std::vector<double> sampled(const TestFunction& function, double step, std::size_t count) {
  std::vector<double> result;
  for (std::size_t i = 0; i < count; ++i) result.push_back(function.value(step * static_cast<double>(i)));
  return result;
}

}  // namespace

std::string method_name(const std::string& method) {
  if (method == local_linear) return "LLR";
  if (method == local_cubic) return "local cubic";
  if (method == "bspline:degree=2") return "Chaikin";
  if (method == "bspline:degree=3") return "cubic B-spline";
  return scheme_name(method);
}

class FunctionTrial::Reconstruction {
 public:
  Reconstruction(const FunctionTrial& trial, std::size_t method, const std::vector<double>& noise) {
    if (trial.regressions_[method])
      regression_.emplace(*trial.regressions_[method], trial.samples_, noise);
    else {
      of_samples_ = *trial.schemes_[method] * trial.samples_;
      of_noise_ = *trial.schemes_[method] * noise;
    }
  }
  std::vector<double> operator()(double sigma) {
    if (regression_) return (*regression_)(sigma);
    std::vector<double> result(of_samples_);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] += sigma * of_noise_[i];
    return result;
  }

 private:
  std::optional<RegressionOfSum> regression_;
  std::vector<double> of_samples_, of_noise_;
};

FunctionTrial::FunctionTrial(const TestFunction& function, double h, const std::vector<std::string>& methods) {
  const auto count = static_cast<std::size_t>(std::lround(100 / h)) + 1, outputs = ((count - 1) << level) + 1;
  samples_ = sampled(function, h, count);
  truth_ = sampled(function, std::ldexp(h, -level), outputs);
  std::vector<double> positions;
  for (std::size_t i = 0; i < outputs; ++i) positions.push_back(std::ldexp(static_cast<double>(i), -level));
  for (const std::string& method : methods) {
    schemes_.emplace_back();
    regressions_.emplace_back();
    if (method == local_linear || method == local_cubic)
      regressions_.back().emplace(method == local_linear ? 1 : 3, count, positions);
    else
      schemes_.back() = limit_matrix(method, count, data::Boundary::regression, level);
  }
}

std::vector<double> FunctionTrial::noise(std::uint64_t seed, std::size_t run) const {
  auto engine = generator(seed, run);
  return normal_noise(engine, samples_.size());
}

double FunctionTrial::deviation(double decibel) const { return noise_deviation(mean_square(samples_), decibel); }

FunctionTrial::Errors FunctionTrial::errors(const ExperimentOptions& options) const {
  Errors errors(schemes_.size(),
                std::vector<std::vector<double>>(quietest - loudest + 1, std::vector<double>(options.runs)));
  const std::array<Coordinate, 1> truth{truth_};
  runtime::parallel_for_each(options.runs, options.jobs, [&](std::size_t run) {
    const auto sample = noise(options.seed, run);
    for (std::size_t m = 0; m < schemes_.size(); ++m) {
      Reconstruction reconstruction(*this, m, sample);
      for (int decibel = loudest; decibel <= quietest; ++decibel) {
        const std::array<Coordinate, 1> values{reconstruction(deviation(decibel))};
        errors[m][static_cast<std::size_t>(decibel - loudest)][run] = relative_error(values, truth);
      }
    }
  });
  return errors;
}

FunctionTrial::Shown FunctionTrial::shown(double decibel, std::uint64_t seed) const {
  const auto sample = noise(seed, 0);
  Shown result{samples_, truth_, {}};
  for (std::size_t i = 0; i < sample.size(); ++i) result.data[i] += deviation(decibel) * sample[i];
  for (std::size_t m = 0; m < schemes_.size(); ++m)
    result.reconstructions.push_back(Reconstruction(*this, m, sample)(deviation(decibel)));
  return result;
}

}  // namespace subcert::experiments
