#include "parts.hpp"

namespace subcert::experiments::mustafa_bari_2016 {

Measures measures() {
  return {{"aary-fig1", limit_functions},
          {"aary-fig2", refined_polygons},
          {"aary-fig3", car_profile},
          {"aary-fig4", vase},
          {"aary-fig5", ring}};
}

}  // namespace subcert::experiments::mustafa_bari_2016
