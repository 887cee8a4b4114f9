#include "families.hpp"
namespace subcert { std::vector<Experiment> surface_experiments() { return {}; } }
