#pragma once
/// Polynomials with vectors for coefficients, on cells and their parts, with bounds of what rounding does.

#include "outward.hpp"

namespace subcert::outward {

/// A polynomial in u with vectors for coefficients, one after the other, and bounds for the 1-norms of their errors.
struct VectorPolynomial {
  std::vector<double> coefficients;
  std::vector<double> errors;
  std::vector<double> norms;  // above the 1-norms of the coefficients, where they are needed
};

/// p((u + delta) / arity) for polynomials p in u: matrix of the coefficients, row i holds what enters u^i.
class Recentring {
 public:
  Recentring(int arity, int digit, std::size_t size) : size_(size), entries_(size * size, 0.0) {
    const Rational delta = Rational(2 * digit + 1 - arity) / 2;
    for (std::size_t j = 0; j < size; ++j) {
      Rational term = power(Rational(arity), -static_cast<long>(j));  // binomial(j, i) delta^(j-i) / arity^j
      for (std::size_t i = j;; --i) {
        entries_[i * size + j] = to_double(term);
        if (i == 0) break;
        term *= delta * Rational(static_cast<long>(i)) / Rational(static_cast<long>(j - i + 1));
      }
    }
  }
  double operator()(std::size_t i, std::size_t j) const { return entries_[i * size_ + j]; }

 private:
  std::size_t size_;
  std::vector<double> entries_;
};

}  // namespace subcert::outward
