#pragma once
/// What certified values for several n say about the rate at which they fall.

#include <subcert/analysis/symbol/numbers/numbers.hpp>

#include <optional>
#include <string>
#include <vector>

namespace subcert::conjectures {

/// Encloses r with first / second = (second_n / first_n)^r, the exponent of the decay n^-r between two n. Domain: 1 <=
/// first_n < second_n; `first` and `second` enclose positive numbers. An end that the enclosures do not give is absent.
Enclosure decay_exponent(int first_n, const Enclosure& first, int second_n, const Enclosure& second);

/// A certified value for each n: the maximum of psi, or of |psi'|.
struct CertifiedMaximum {
  int n;
  Enclosure value;
  bool interpolates = false;  ///< the scheme keeps the data, so that max psi = 1; no sign of a rate
};

/// The index of the n nearest to half the last one, from which rates are observed; of a scheme that does not
/// interpolate, where there is one before the last. Domain: at least two values, n increasing.
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

/// Six digits for people: one number where both ends agree in them, else both ends rounded outward.
std::string shown(const Enclosure& enclosure);

}  // namespace subcert::conjectures
