#include "parts.hpp"

namespace subcert::experiments::dyn_2015 {

Measures measures() {
  Measures all = functions();
  all.insert(all.end(), {{"mse", expected_errors},
                         {"fig15", alpha_curve},
                         {"fig17", star},
                         {"fig19", torus},
                         {"fig21", mechanical_part}});
  return all;
}

}  // namespace subcert::experiments::dyn_2015
