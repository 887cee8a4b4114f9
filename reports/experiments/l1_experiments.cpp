#include "families.hpp"

#include <algorithm>

namespace subcert::experiments {

std::vector<Experiment> l1_experiments() {
  std::vector<Experiment> result;
  for (const auto& family : {l1_functions::all, l1_limits::all, l1_iterations::all, l1_spiral::all, l1_impulses::all,
                             l1_surfaces::all, l1_band::all}) {
    const auto more = family();
    result.insert(result.end(), more.begin(), more.end());
  }
  const std::vector<std::string> order{"l1-fig1", "l1-fig2", "l1-exp1",     "l1-exp2",    "l1-fig4",
                                       "l1-exp3", "l1-exp4", "l1-surface1", "l1-surface2"};
  std::sort(result.begin(), result.end(), [&](const Experiment& a, const Experiment& b) {
    return std::find(order.begin(), order.end(), a.id) < std::find(order.begin(), order.end(), b.id);
  });
  return result;
}

}  // namespace subcert::experiments
