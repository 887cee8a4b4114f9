#pragma once
/// Invariant subspaces of matrices modulo a prime: spinning and Norton's criterion. Inner header.

#include "subspace.hpp"

#include <subcert/analysis/symbol/matrices/matrix_family.hpp>

#include <flint/nmod_mat.h>

#include <random>

namespace subcert::radius {

constexpr int meataxe_attempts = 8;     // elements of the algebra that are tried
constexpr int factors_per_attempt = 3;  // factors of the characteristic polynomial of each

/// A matrix modulo 2^61 - 1.
class ModMatrix {
 public:
  ModMatrix(std::size_t rows, std::size_t columns);
  ModMatrix(ModMatrix&& other) noexcept : ModMatrix(0, 0) { nmod_mat_swap(value_, other.value_); }
  ModMatrix& operator=(ModMatrix&& other) noexcept {
    nmod_mat_swap(value_, other.value_);
    return *this;
  }
  ModMatrix(const ModMatrix& other) : ModMatrix(other.rows(), other.columns()) { nmod_mat_set(value_, other.value_); }
  ModMatrix& operator=(const ModMatrix&) = delete;
  ~ModMatrix() { nmod_mat_clear(value_); }

  nmod_mat_struct* get() { return value_; }
  const nmod_mat_struct* get() const { return value_; }
  std::size_t rows() const { return static_cast<std::size_t>(value_->r); }
  std::size_t columns() const { return static_cast<std::size_t>(value_->c); }
  ulong& operator()(std::size_t i, std::size_t j) { return nmod_mat_entry(value_, i, j); }
  ulong operator()(std::size_t i, std::size_t j) const { return nmod_mat_entry(value_, i, j); }
  nmod_t modulus() const { return value_->mod; }

 private:
  nmod_mat_t value_;
};

using ModVector = std::vector<ulong>;
using ModFamily = std::vector<ModMatrix>;

/// Nothing where the prime divides a denominator.
std::optional<ModFamily> modulo_prime(const MatrixFamily& family);
/// Domain: an integer vector.
ModVector modulo_prime(const std::vector<Integer>& vector);
ModFamily transposed(const ModFamily& family);

/// The fraction with small parts that a number modulo the prime stands for, if there is one.
std::optional<Rational> small_fraction(ulong value);

/// A space of vectors modulo the prime. Canonical: echelon form.
class ModSpace {
 public:
  std::size_t size() const { return rows_.size(); }
  const std::vector<ModVector>& rows() const { return rows_; }
  /// Whether the vector was not in the space, which then grows.
  bool add(ModVector vector);
  /// The space over the rationals whose reduced echelon basis is that of this one modulo the prime; nothing where its
  /// numbers are not recognised.
  std::optional<Subspace> recognised() const;

 private:
  std::vector<ModVector> rows_;
  std::vector<std::size_t> pivots_;
};

/// The smallest invariant subspace that holds the vectors.
ModSpace span_of_words(const ModFamily& family, const std::vector<ModVector>& starts);
/// The part of an invariant subspace that words of every length reach.
ModSpace reached_by_long_words(const ModFamily& family, ModSpace space);

/// How a vector of a spun basis arises from an earlier one; the first is the start.
struct SpinStep {
  std::size_t parent;
  std::size_t letter;
};

/// The smallest invariant subspace that holds the vector, modulo the prime: a basis of words applied to it.
std::vector<SpinStep> spin(const ModFamily& family, const ModVector& start);

/// An element of the algebra: a sum of small multiples of words.
struct AlgebraElement {
  struct Summand {
    long factor;
    std::vector<std::size_t> word;
  };
  std::vector<Summand> summands;
};

/// First the matrices themselves, then ever longer random sums of words. Deterministic.
AlgebraElement algebra_element(std::size_t count, int attempt, std::mt19937_64& random);

/// Products modulo the prime. Domain: matching sizes.
ModMatrix operator*(const ModMatrix& a, const ModMatrix& b);
ModVector operator*(const ModMatrix& a, const ModVector& x);
/// p(matrix) x. Domain: a square matrix, integer coefficients, lowest exponent 0 or more.
ModVector value_times(const LaurentPolynomial& p, const ModMatrix& matrix, const ModVector& x);
/// Nothing for a singular matrix.
std::optional<ModMatrix> inverse(const ModMatrix& matrix);

/// The eigenvalues of an element that are simple zeros of its characteristic polynomial, a few of them.
std::vector<ulong> simple_eigenvalues(const ModFamily& family, const AlgebraElement& element);
/// The eigenvector, determined up to a factor; nothing where the eigenspace has another dimension than 1.
std::optional<ModVector> eigenvector(const ModFamily& family, const AlgebraElement& element, ulong eigenvalue);

enum class ModularAnswer { irreducible, reducible, unknown };

/// Norton's criterion modulo the prime: for an element theta and an irreducible factor f of its characteristic
/// polynomial whose kernel has the dimension deg f, the family is irreducible if one vector of the kernel of f(theta)
/// spins to the whole space, and one of that of the transposes. Unknown once the deadline passes.
ModularAnswer decide_modulo_prime(const ModFamily& family, const Deadline& deadline);

}  // namespace subcert::radius
