#include "parts.hpp"

#include <subcert/reports/experiments/papers.hpp>

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

NamePairs pairs(const std::vector<Method>& first, const std::vector<Method>& second) {
  NamePairs result;
  for (std::size_t i = 0; i < first.size(); ++i) result.emplace_back(first[i].name, second[i].name);
  return result;
}

std::vector<Experiment> all() {
  return {linear_polynomials(), polynomial_reproduction(), data_without_noise(), noisy_function(), noisy_curve(),
          noisy_surface()};
}

}  // namespace subcert::experiments::mustafa_hameed
