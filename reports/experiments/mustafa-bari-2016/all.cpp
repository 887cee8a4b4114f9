#include "parts.hpp"

#include <subcert/reports/experiments/papers.hpp>

namespace subcert::experiments::mustafa_bari_2016 {

std::vector<Experiment> all() { return {limit_functions(), refined_polygons(), car_profile(), vase(), ring()}; }

}  // namespace subcert::experiments::mustafa_bari_2016
