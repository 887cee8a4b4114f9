#include "variance_ends.hpp"

#include <subcert/analysis/variance/variance_range.hpp>
#include <subcert/schemes/specification.hpp>

#include <map>
#include <mutex>
#include <string>

namespace subcert::theorems {

const VarianceEnds& variance_ends(int n, int degree) {
  static std::mutex mutex;
  static std::map<std::pair<int, int>, VarianceEnds> known;
  const std::lock_guard lock(mutex);
  const auto found = known.find({n, degree});
  if (found != known.end()) return found->second;
  const std::string scheme = "primal:n=" + std::to_string(n) + ",d=" + std::to_string(degree);
  const VarianceRange range = variance_range(make_scheme(scheme).mask);
  VarianceEnds ends{range.minimum, range.maximum, std::nullopt};
  if (range.slope && range.slope_reason.empty()) ends.slope = range.slope;
  return known.emplace(std::pair(n, degree), ends).first->second;
}

}  // namespace subcert::theorems
