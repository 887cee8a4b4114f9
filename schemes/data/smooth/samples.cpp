#include "samples.hpp"

#include <subcert/schemes/data/refine/axis_refinement.hpp>

namespace subcert::data {

std::vector<double> Samples::rounded_weights() const {
  std::vector<double> rounded;
  for (const Rational& weight : weights) rounded.push_back(nearest_double(weight));
  return rounded;
}

}  // namespace subcert::data
