#include "variance_ends.hpp"

#include <subcert/analysis/variance/variance_range.hpp>
#include <subcert/schemes/specification.hpp>

#include <atomic>
#include <future>
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
  const std::string scheme = "primal:n=" + std::to_string(n) + ",d=" + std::to_string(degree);
  const VarianceRange range = variance_range(make_scheme(scheme).mask);
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
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i; (i = next++) < keys.size();) variance_ends(keys[i].first, keys[i].second);
  };
  std::vector<std::future<void>> others;
  for (int i = 1; i < threads; ++i) others.push_back(std::async(std::launch::async, work));
  work();
  for (std::future<void>& other : others) other.get();
}

}  // namespace subcert::theorems
