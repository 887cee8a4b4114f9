#pragma once
/// Conjectures 7 and 8 of [DHHS15] over ranges of n and d: which schemes, which comparisons, and what certified
/// enclosures of the variance curve psi say about them.

#include <subcert/analysis/symbol/numbers.hpp>

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace subcert::reports {

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

/// Encloses r with first / second = (second_n / first_n)^r, the exponent of the decay n^-r between two n. Domain: 1 <=
/// first_n < second_n; `first` and `second` enclose positive numbers. An end that the enclosures do not give is absent.
Enclosure decay_exponent(int first_n, const Enclosure& first, int second_n, const Enclosure& second);

/// A certified value for each n: the maximum of psi, or of |psi'|.
struct CertifiedMaximum {
  int n;
  Enclosure value;
};

/// The index of the n nearest to half the last one, from which rates are observed. Domain: at least two values, n
/// increasing.
std::size_t rate_start(const std::vector<CertifiedMaximum>& values);

/// What the values for one degree say about the claim "the maximum behaves like n^-power". A finite range proves
/// nothing about all n; the finding speaks of the range.
struct DecayFinding {
  int power;
  int first_n = 0, last_n = 0;
  Enclosure largest;   ///< the largest n^power * value of the range: the constant of the upper bound
  Enclosure smallest;  ///< the smallest
  /// The decay exponent from n = rate_from, the one nearest to half the last, to last_n; nothing for a single n.
  int rate_from = 0;
  std::optional<Enclosure> exponent;
  /// yes: the exponent is above power - 1/2, so n^power * value does not grow like a root of n.
  Decision upper_bound;
  /// yes: the exponent is within 1/2 of the power; no: it is farther away.
  Decision rate;

  /// `what` is the text for the maximum, as in "max psi".
  std::string sentence(const std::string& what) const;
};

/// Domain: at least one value, n increasing.
DecayFinding decay_finding(int power, const std::vector<CertifiedMaximum>& values);

/// One comparison of Conjecture 8: psi of `larger` >= psi of `smaller` everywhere.
struct VariancePair {
  PrimalScheme larger;
  PrimalScheme smaller;
};

/// The comparisons that imply all others by transitivity: neighbouring degrees for each n, neighbouring n for each
/// degree.
std::vector<VariancePair> neighbouring_pairs(const std::vector<PrimalScheme>& schemes);

/// Six digits for people: one number where both ends agree in them, else both ends rounded outward.
std::string shown(const Enclosure& enclosure);

/// Enclosures with exact ends, for journals: {"lower": "p/q", "upper": "p/q"}, an absent end left out.
nlohmann::ordered_json exact_json(const Enclosure& enclosure);
/// Errors: throws a domain error for anything else.
Enclosure enclosure_from(const nlohmann::ordered_json& json);

}  // namespace subcert::reports
