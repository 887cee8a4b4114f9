#include "parts.hpp"

#include <subcert/reports/experiments/papers.hpp>

namespace subcert::experiments::dyn_2015 {

std::vector<Experiment> all() {
  std::vector<Experiment> result{expected_errors()};
  for (Experiment& figure : function_experiments()) result.push_back(std::move(figure));
  for (const auto part : {alpha_curve, star, torus, mechanical_part_scan}) result.push_back(part());
  return result;
}

}  // namespace subcert::experiments::dyn_2015
