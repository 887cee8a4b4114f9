#pragma once
/// Functions on [0, 100] from noisy samples, reconstructed by several methods.

#include "measures.hpp"

#include <subcert/reports/experiments/experiment.hpp>
#include <subcert/reports/experiments/local_polynomial.hpp>

namespace subcert::experiments::dyn_2015 {

struct TestFunction {
  std::string name;
  std::string formula;
  double (*value)(double);
};

/// Local linear and local cubic regression among the methods; the others are specifications of schemes.
inline const std::string local_linear = "local:degree=1", local_cubic = "local:degree=3";

/// "LLR", "Chaikin", "S_5^3".
std::string method_name(const std::string& method);

/// Samples at 0, h, ..., 100; outputs four times as dense.
class FunctionTrial {
 public:
  static constexpr int loudest = 1, quietest = 20;  ///< decibel

  /// Domain: h divides 100, at least 8 samples.
  FunctionTrial(const TestFunction& function, double h, const std::vector<std::string>& methods);

  /// The relative errors: the measure is the method, the subject the level of noise, "1", ..., "20".
  Measured errors(const ExperimentOptions& options) const;

  /// Samples, truth and reconstructions for sample 0 of the noise.
  struct Shown {
    std::vector<double> data, truth;
    std::vector<std::vector<double>> reconstructions;
  };
  Shown shown(double decibel, std::uint64_t seed) const;

 private:
  std::vector<double> noise(std::uint64_t seed, std::size_t run) const;
  double deviation(double decibel) const;

  /// A reconstruction of samples + sigma * noise.
  class Reconstruction;

  std::vector<std::string> methods_;
  std::vector<double> samples_, truth_;
  std::vector<std::optional<DenseMatrix>> schemes_;  // by method, as the next
  std::vector<std::optional<LocalPolynomialRegression>> regressions_;
};

}  // namespace subcert::experiments::dyn_2015
