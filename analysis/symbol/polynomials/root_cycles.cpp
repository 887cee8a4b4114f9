#include "root_cycles.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <numeric>

namespace subcert {
namespace {

/// e, a e, a^2 e, ... modulo n, up to their signs, if e is the least of these and their negatives.
std::vector<long> half_cycle(long e, long n, long a) {
  std::vector<long> result;
  for (long x = e; result.empty() || (x != e && x != n - e); x = a * x % n) {
    if (x < e || n - x < e) return {};
    result.push_back(x);
  }
  return result;
}

}  // namespace

std::optional<std::vector<RootCycle>> root_cycles(long a, long most) {
  require(a >= 2, "root_cycles: need a >= 2, got {}", a);
  std::vector<RootCycle> result;
  if (most >= 1 && a % 2 == 1) result.push_back({2, {1}, 1});
  // A cycle of 2 j numbers is one of n-th roots of unity, n = a^j - 1 or a^j + 1.
  long power = a;
  for (long j = 1; 2 * j <= most; ++j, power *= a) {
    if (power > 1L << 20) return std::nullopt;
    for (const long n : {power - 1, power + 1})
      for (long e = 1; 2 * e < n; ++e) {
        std::vector<long> half = half_cycle(e, n, a);
        if (static_cast<long>(half.size()) != j) continue;
        const long common = std::gcd(e, n);
        for (long& x : half) x /= common;
        result.push_back({n / common, std::move(half), 2 * j});
      }
  }
  return result;
}

}  // namespace subcert
