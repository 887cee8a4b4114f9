#pragma once
/// The schemes of Conjectures 7 and 8 of [DHHS15] over ranges of n and d.

#include <string>
#include <vector>

namespace subcert::conjectures {

/// S_n^d, written primal:n=N,d=D.
struct PrimalScheme {
  int d;
  int n;

  std::string specification() const;
  bool operator==(const PrimalScheme& other) const { return d == other.d && n == other.n; }
};

/// The schemes of a range that are really different ones, by d and then n, and why others are left out.
struct PrimalSchemes {
  struct Skipped {
    PrimalScheme scheme;
    PrimalScheme same_as;

    bool beyond_data() const { return scheme.d > 2 * scheme.n - 1; }
    std::string reason() const;
  };
  std::vector<PrimalScheme> schemes;
  std::vector<Skipped> skipped;

  /// One line for each degree and reason, as in "d = 2 with n = 2..20: the same masks as d = 3".
  std::vector<std::string> skipped_lines() const;
};

/// All n with all d, without those of a degree that 2n data do not fix (d > 2n-1; S_n^d is then S_n^{2n-1}), and
/// without those whose mask is the one of the next degree in the list, as for even d, where the fits are symmetric.
/// Domain: n >= 1 and d >= 0, both increasing. Cost: a mask for each even degree and n.
PrimalSchemes distinct_primal_schemes(const std::vector<int>& n, const std::vector<int>& d);

/// One comparison of Conjecture 8: psi of `larger` >= psi of `smaller` everywhere.
struct VariancePair {
  PrimalScheme larger;
  PrimalScheme smaller;
};

/// The comparisons that imply all others by transitivity: neighbouring degrees for each n, neighbouring n for each
/// degree.
std::vector<VariancePair> neighbouring_pairs(const std::vector<PrimalScheme>& schemes);

}  // namespace subcert::conjectures
