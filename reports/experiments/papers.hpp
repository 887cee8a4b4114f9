#pragma once
/// What the experiments of each paper measure.

#include "experiment.hpp"

namespace subcert::experiments {

namespace dyn_2015 {
Measures measures();
}
namespace mustafa_li_2015 {
Measures measures();
}
namespace mustafa_hameed {
Measures measures();
}
namespace mustafa_bari_2016 {
Measures measures();
}

}  // namespace subcert::experiments
