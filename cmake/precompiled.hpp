#pragma once
// What almost every source reads, parsed once a build. Every source still includes what it uses.

#include <subcert/analysis/symbol/masks/mask.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <fmt/core.h>
#include <gmp.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>
