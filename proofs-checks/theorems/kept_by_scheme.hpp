#pragma once
/// Answers that are computed once, for the sources of this floor.

#include "patience.hpp"

#include <subcert/analysis/symbol/support/parallel.hpp>

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace subcert::theorems {

/// What was found for a key, kept for the next call, at a place that stays. One thread computes for a key, others wait
/// for it; where it throws nothing is kept.
template <class Key, class Value>
class Kept {
 public:
  template <class Compute>
  const Value& operator()(const Key& key, const Compute& compute) {
    Slot& slot = [&]() -> Slot& {
      const std::lock_guard lock(mutex_);
      return known_[key];
    }();
    std::call_once(slot.once, [&] { slot.value.emplace(compute()); });
    return *slot.value;
  }

 private:
  struct Slot {
    std::once_flag once;
    std::optional<Value> value;
  };

  std::mutex mutex_;
  std::map<Key, Slot> known_;
};

/// What a function says of specifications, kept for the next call. Several threads may ask.
template <class Value>
class KeptByScheme {
 public:
  explicit KeptByScheme(Value (*compute)(const std::string&)) : compute_(compute) {}

  const Value& operator()(const std::string& scheme) {
    return known_(scheme, [&] {
      next_step(scheme);
      return compute_(scheme);
    });
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
  Kept<std::string, Value> known_;
};

}  // namespace subcert::theorems
