#pragma once
/// Seeded drawings for tests of texts.

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace subcert {

class Draw {
 public:
  long number(long low, long high) { return std::uniform_int_distribution<long>(low, high)(engine_); }
  bool coin() { return number(0, 1) == 1; }
  std::string one_of(const std::vector<std::string>& words) {
    return words[static_cast<std::size_t>(number(0, static_cast<long>(words.size()) - 1))];
  }
  template <class T>
  void shuffle(std::vector<T>& list) {
    std::shuffle(list.begin(), list.end(), engine_);
  }

 private:
  std::mt19937 engine_{20261126};
};

}  // namespace subcert
