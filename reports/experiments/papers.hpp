#pragma once
/// The experiments of each paper, in its order.

#include "experiment.hpp"

namespace subcert::experiments {

namespace dyn_2015 {
std::vector<Experiment> all();
}
namespace mustafa_li_2015 {
std::vector<Experiment> all();
}
namespace mustafa_hameed {
std::vector<Experiment> all();
}
namespace mustafa_bari_2016 {
std::vector<Experiment> all();
}

}  // namespace subcert::experiments
