#include "parts.hpp"

namespace subcert::experiments::mustafa_hameed {
namespace {

Method regression_method(const std::string& letter, int points, int degree, bool grid) {
  const std::string side = std::to_string(points), power = std::to_string(degree);
  return {letter + "_" + side + "^" + power, "l1:points=" + side + (grid ? "x" + side : "") + ",d=" + power};
}

}  // namespace

Method l1_method(int points, int degree, bool grid) { return regression_method("D", points, degree, grid); }

Method least_squares_method(int points, int degree, bool grid) {
  Method result = regression_method("S", points, degree, grid);
  result.specification += ",iterations=0";
  return result;
}

std::vector<Method> l1_methods(const std::vector<int>& windows, const std::vector<int>& degrees, bool grid) {
  std::vector<Method> result;
  for (const int degree : degrees)
    for (const int points : windows) result.push_back(l1_method(points, degree, grid));
  return result;
}

Measures measures() {
  return {{"nonlinear-fig1", linear_polynomials}, {"nonlinear-fig3", polynomial_reproduction},
          {"nonlinear-fig7", data_without_noise}, {"nonlinear-fig8", noisy_function},
          {"nonlinear-fig9", noisy_curve},        {"nonlinear-surface", noisy_surface}};
}

}  // namespace subcert::experiments::mustafa_hameed
