#pragma once
/// Answers that are computed once, for the sources of this floor.

#include "patience.hpp"

#include <subcert/analysis/symbol/support/parallel.hpp>

#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace subcert::theorems {

/// What was found for a key, kept for the next call, at a place that stays. One thread computes at a time; where that
/// throws nothing is kept.
template <class Key, class Value>
class Kept {
 public:
  template <class Compute>
  const Value& operator()(const Key& key, const Compute& compute) {
    const std::lock_guard lock(mutex_);
    const auto found = known_.find(key);
    return found != known_.end() ? found->second : known_.emplace(key, compute()).first->second;
  }

 private:
  std::mutex mutex_;
  std::map<Key, Value> known_;
};

/// What a function says of specifications, kept for the next call. Several threads may ask.
template <class Value>
class KeptByScheme {
 public:
  explicit KeptByScheme(Value (*compute)(const std::string&)) : compute_(compute) {}

  const Value& operator()(const std::string& scheme) {
    {
      const std::lock_guard lock(mutex_);
      if (const auto found = known_.find(scheme); found != known_.end()) return found->second;
    }
    next_step(scheme);
    Value value = compute_(scheme);
    const std::lock_guard lock(mutex_);
    return known_.try_emplace(scheme, std::move(value)).first->second;
  }

  /// Asks for all of them, the last ones, which cost most, first.
  void prepare(const std::vector<std::string>& schemes, int threads) {
    const Patience* patience = PatienceScope::current();
    parallel_tasks(schemes.size(), threads, [&](std::size_t i) {
      const PatienceScope scope(patience);
      (*this)(schemes[schemes.size() - 1 - i]);
    });
  }

 private:
  Value (*compute_)(const std::string&);
  std::mutex mutex_;
  std::map<std::string, Value> known_;
};

}  // namespace subcert::theorems
