#pragma once
// The experiments of each kind, in the order of their papers.

#include "experiment.hpp"

namespace subcert::experiments {

namespace functions {
std::vector<Experiment> all();
}
namespace plane_curves {
std::vector<Experiment> all();
}
namespace torus {
std::vector<Experiment> all();
}
namespace part_scan {
std::vector<Experiment> all();
}
namespace expected_errors {
std::vector<Experiment> all();
}
namespace nonlinear_polynomials {
std::vector<Experiment> all();
}
namespace nonlinear_quiet {
std::vector<Experiment> all();
}
namespace nonlinear_noise {
std::vector<Experiment> all();
}
namespace nonlinear_surface {
std::vector<Experiment> all();
}
namespace aary_limit_functions {
std::vector<Experiment> all();
}
namespace aary_curves {
std::vector<Experiment> all();
}
namespace aary_car {
std::vector<Experiment> all();
}
namespace aary_surfaces {
std::vector<Experiment> all();
}

namespace l1_functions {
std::vector<Experiment> all();
}
namespace l1_limits {
std::vector<Experiment> all();
}
namespace l1_iterations {
std::vector<Experiment> all();
}
namespace l1_spiral {
std::vector<Experiment> all();
}
namespace l1_impulses {
std::vector<Experiment> all();
}
namespace l1_surfaces {
std::vector<Experiment> all();
}
namespace l1_band {
std::vector<Experiment> all();
}
/// Those of [MLZD15] in the order of the paper.
std::vector<Experiment> l1_experiments();

}  // namespace subcert::experiments
