#pragma once
/// Square matrices of integers, and a test whether symmetric ones are positive. Inner header.

#include <subcert/analysis/radii/polytope_proof/round_family.hpp>

#include <cmath>
#include <optional>
#include <vector>

namespace subcert::quadratic {

/// A square matrix of integers, row by row.
using Integers = std::vector<Integer>;

Integers product(const Integers& a, const Integers& b, std::size_t n);

/// a^T a on and above the diagonal.
Integers gram_matrix(const Integers& a, std::size_t n);

inline double floor_of_root(double x) { return std::floor(std::sqrt(x)); }
inline Integer floor_of_root(const Integer& x) { return sqrt(x); }
inline void floor_divide(double& x, double by) { x = std::floor(x / by); }
inline void floor_divide(Integer& x, const Integer& by) { mpz_fdiv_q(x.get(), x.get(), by.get()); }
inline void subtract_product(double& sum, double a, double b) { sum -= a * b; }
inline void subtract_product(Integer& sum, const Integer& a, const Integer& b) {
  mpz_submul(sum.get(), a.get(), b.get());
}

/// Whether Lemma 17 (proofs-checks/certificates/SPEC.md) shows that s, given on and above the diagonal, is positive
/// semidefinite, with the margin d 2^h + m. Number: Integer, or double where no entry is above 2^50 in modulus: what is
/// rounded then makes a later diagonal entry negative, so that the answer is no.
template <class Number>
bool has_root(std::vector<Number>& s, std::size_t n, const Number& margin) {
  for (std::size_t k = 0; k < n; ++k) {
    Number* row = &s[k * n];
    row[k] -= margin;
    for (std::size_t l = 0; l < k; ++l) {
      const Number factor = s[l * n + k];
      for (std::size_t j = k; j < n; ++j) subtract_product(row[j], factor, s[l * n + j]);
    }
    if (!(row[k] > 0)) return false;
    row[k] = floor_of_root(row[k]);
    for (std::size_t j = k + 1; j < n; ++j) floor_divide(row[j], row[k]);
  }
  return true;
}

/// Whether a symmetric matrix, given on and above the diagonal, is positive semidefinite, by 256 leading bits of its
/// entries.
bool is_positive(Integers s, std::size_t n);
bool is_positive(const RationalMatrix& s);

/// For coordinates x' = to x of the round family lower triangular ones of the family, rounded to 48 bits, in which
/// vectors are as long, nearly, times one number for all. Nothing where one is not regular so.
std::optional<std::vector<Integers>> triangular_coordinates(const std::vector<polytope::Matrix>& to,
                                                            const radius::RoundFamily& round);

}  // namespace subcert::quadratic
