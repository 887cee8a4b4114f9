// Sequences on Z^s, and the transition operators of a mask on them: section 5 of ../certificates/SPEC.md.
#pragma once

#include "dilation.hpp"
#include "scheme.hpp"

#include <set>

namespace subcert_check {

constexpr unsigned long prime = 4'294'967'291;  // 2^32 - 5

void drop_zeros(Sequence& x);

/// The operators T_d of a mask of numbers or of matrices, and a dilation. What sequences may take of memory counts as
/// work.
class Transition {
 public:
  Transition(const Mask& mask, const Dilation& dilation, Arithmetic& arithmetic);

  /// One of each class of Z^s / M Z^s.
  void read_digits(Reader& reader);

  std::size_t variables() const { return dilation_.variables; }
  std::size_t components() const { return components_; }
  const mpz_class& denominator() const { return denominator_; }
  std::size_t classes() const { return static_cast<std::size_t>(std::abs(determinant_)); }
  const Matrix& adjugate() const { return adjugate_; }
  /// Row times the number of components plus column is the component.
  const Sequence& mask() const { return mask_; }
  const std::vector<Point>& digits() const { return digits_; }
  Arithmetic& arithmetic() const { return arithmetic_; }

  /// Equal for points whose difference is in M Z^s, and 0 there.
  Point class_of(const Point& point) const;
  std::size_t digit_of(const Point& point) const { return digit_of_class_.at(class_of(point)); }
  /// M^-1 times a point of M Z^s.
  Point divide(const Point& point) const;

  /// T_d x for all digits, times the denominator of the mask.
  std::vector<Sequence> of(const Sequence& x) const { return of(mask_, x); }
  /// Of another mask.
  std::vector<Sequence> of(const Sequence& mask, const Sequence& x) const;

  /// The value there, 0 if it is new.
  mpz_class& entry(Sequence& x, const Place& place, std::size_t limbs = 1) const;
  void add_product(Sequence& sum, const Place& place, const mpz_class& x, const mpz_class& y) const;
  void set(Sequence& x, const Place& place, const mpz_class& value) const;
  /// The sums of x_k k^nu for all |nu| < m, one after another, beginning with nu = 0.
  Vector moments(const Sequence& x, std::size_t m) const;
  /// All nabla^mu start, |mu| = the order.
  std::set<Sequence> differences(const Sequence& start, std::size_t order) const;

 private:
  Point adjugate_times(const Point& point) const;

  Dilation dilation_;
  std::size_t components_;  // 1 for numbers
  mpz_class denominator_;
  std::int64_t determinant_;
  Matrix adjugate_;
  Arithmetic& arithmetic_;
  Sequence mask_;
  std::vector<Point> digits_;
  std::map<Point, std::size_t> digit_of_class_;
};

/// A vector of a basis; the vectors after it, and in the basis of a space all others, are 0 at its pivot.
struct Row {
  Place pivot;
  Sequence values;
};

/// Over the rationals, or modulo the prime.
class Elimination {
 public:
  Elimination(const Transition& sequences, bool modular) : sequences_(sequences), modular_(modular) {}

  /// Makes x zero at the pivots by subtracting multiples of the rows; x may be multiplied by a number.
  void reduce(Sequence& x, const std::vector<Row>& rows) const;
  /// One row more, unless x is a combination of the rows.
  void add(std::vector<Row>& rows, Sequence x) const;

 private:
  void reduce_modulo_prime(Sequence& x) const;

  const Transition& sequences_;
  bool modular_;
};

/// Section 5.9: reads what tells the integral of a solution from the sums of its values. Rejects unless the solution
/// with these values has a multiple of this integral, other than 0. `root`: of a doubled mask, section 5.13, whose
/// functionals come with their multiples by the root.
std::vector<Vector> read_functionals(const Transition& operators, const Sequence& values, const Rationals& integral,
                                     Reader& reader, const mpz_class* root = nullptr);

/// Section 5.9: rejects unless the continuous solutions of compact support of the refinement equation are the multiples
/// of one; or with functionals, unless there is only one that has their values. `solutions`: the dimension of their
/// values over the rationals, 2 over a quadratic field.
void check_unique(const Transition& operators, const std::vector<Vector>& functionals, std::size_t solutions);

}  // namespace subcert_check
