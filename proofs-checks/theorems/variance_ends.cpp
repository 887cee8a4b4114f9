#include "variance_ends.hpp"

#include "proofs.hpp"

#include <subcert/analysis/symbol/parallel.hpp>
#include <subcert/analysis/variance/variance_range.hpp>

#include <map>
#include <mutex>
#include <string>

namespace subcert::theorems {
namespace {

using Key = std::pair<int, int>;

struct Memory {
  std::mutex mutex;
  std::map<Key, VarianceEnds> known;
};

Memory& memory() {
  static Memory result;
  return result;
}

VarianceEnds compute_ends(int n, int degree) {
  const VarianceRange range = variance_range(primal_mask(n, degree));
  VarianceEnds ends{range.minimum, range.maximum, std::nullopt};
  if (range.slope && range.slope_reason.empty()) ends.slope = range.slope;
  return ends;
}

bool is_known(const Key& key) {
  const std::lock_guard lock(memory().mutex);
  return memory().known.contains(key);
}

}  // namespace

const VarianceEnds& variance_ends(int n, int degree) {
  const Key key(n, degree);
  if (!is_known(key)) {
    VarianceEnds ends = compute_ends(n, degree);
    const std::lock_guard lock(memory().mutex);
    memory().known.emplace(key, std::move(ends));
  }
  const std::lock_guard lock(memory().mutex);
  return memory().known.at(key);
}

void prepare_variance_ends(int first, int last, const std::vector<int>& degrees, int threads) {
  std::vector<Key> keys;
  for (int n = last; n >= first; --n)
    for (int degree : degrees)
      if (!is_known({n, degree})) keys.emplace_back(n, degree);
  parallel_for_each(keys.size(), threads, [&](std::size_t i) { variance_ends(keys[i].first, keys[i].second); });
}

}  // namespace subcert::theorems
