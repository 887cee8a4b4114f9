#pragma once
/// The families of binary least squares schemes, for the sources of this floor.

#include "kernel/uniform_symbol.hpp"

#include <string>
#include <vector>

namespace subcert::theorems {

/// One family S_n^d; N = 2n + offset is the mean number of points of its two rules.
struct SchemeFamily {
  std::string id;  ///< as in specifications
  std::string title;
  Evaluation evaluation;
  Rational offset;
  bool odd;  ///< 2n+1 points

  Rational size(int n) const { return 2 * n + offset; }
  /// The first n at which degree d is reached: before it the scheme has a smaller degree.
  int least_n(int degree) const { return odd ? (degree + 1) / 2 : (degree + 2) / 2; }
  std::string scheme(int n, int degree) const {
    return id + ":n=" + std::to_string(n) + ",d=" + std::to_string(degree);
  }
  std::vector<std::string> schemes(int first, int last, int degree) const {
    std::vector<std::string> result;
    for (int n = first; n <= last; ++n) result.push_back(scheme(n, degree));
    return result;
  }
};

const std::vector<SchemeFamily>& scheme_families();

/// Errors: throws a domain error.
const SchemeFamily& scheme_family(const std::string& id);

}  // namespace subcert::theorems
