#pragma once
// Families of matrices, and masks. Section numbers refer to ../certificates/SPEC.md, which proves each step.

#include "arithmetic.hpp"

namespace subcert_check {

bool is_nonnegative(const Vector& x);

/// Square matrices of one size, one after another, each column by column; all entries over one denominator > 0.
struct Family {
  std::size_t size = 1;
  Vector entries;
  mpz_class denominator = 1;

  std::size_t count() const { return entries.size() / (size * size); }
  std::span<const mpz_class> matrix(std::size_t t) const { return {&entries.at(t * size * size), size * size}; }
  void transpose();
  /// Transposes each matrix, and takes its rows and columns in reverse order.
  void reflect();
  /// The letters of the matrices; of equal matrices the first one's stands for all.
  std::vector<std::size_t> letters() const;
};

/// The matrices with these entries.
Family clear_denominators(std::size_t size, const Rationals& values);

/// Reads matrices row by row, each row after the head.
Family read_family(Reader& reader, const std::string& head, std::size_t count, std::size_t size);

/// Coefficients on a box of lattice points, the first variable running fastest, over one denominator > 0: the boxes of
/// all powers of a parameter, one after another, from the power 0 on; all of that over a polynomial in the parameter.
/// Each coefficient is a number, or a square matrix, row by row.
struct Mask {
  std::vector<std::size_t> sizes;  // along the variables
  Vector first;                    // the lowest point
  std::size_t components = 0;      // the size of the matrices, 0 for numbers
  std::size_t powers = 1;
  Vector coefficients;
  mpz_class denominator;
  Vector divisor{1};  // as many coefficients as powers

  std::size_t points() const { return coefficients.size() / powers; }
};

/// The coefficients of w^0, w^1, ... in a sum of terms c, w, w^k, c*w, c*w^k. `letter`: w, or 0 for numbers only.
Rationals parse_polynomial(std::string_view text, char letter);

/// [c0,c1,...]/D@first, or nested lists, the last variable outermost, or [c0,c1,...]/(q)@first with a polynomial q in
/// the parameter. `letter`: of the parameter, 0 where there is none.
Mask parse_mask(std::string_view text, char letter);

/// [[[1,0],[0,1]],...]/D@first: nested lists as above, with a matrix, row by row, in place of each number.
Mask parse_matrix_mask(std::string_view text, char letter);

/// Rejects unless a mask of numbers sums to the arity, for all values of a parameter.
void check_sum(const Mask& mask, unsigned arity);

/// The family of section 4.1: divides the symbol by sigma, `sum_rules` times. Of a mask with a parameter: for each
/// matrix those of all powers, one after another. On a window of at least that width.
Family transition_family(const Mask& mask, unsigned arity, std::size_t sum_rules, std::size_t width = 1);

/// Rejects unless a mask of matrices of one variable has A_0 = diag(1, 1/arity, 1/arity^2, ...), if it has A_0, and
/// A_k = 0 for the other multiples k of the arity. One without A_0 keeps no constant data. `data`: the size of A_0, of
/// which a doubled mask has two.
void check_interpolation(const Mask& mask, std::size_t data, unsigned arity);

/// Condition (i) of Theorem 4, for a mask without a parameter.
void check_no_leading_factors(const Mask& mask, unsigned arity);

/// All masks whose coefficients differ from the given ones by at most `distance`, with so many sum rules; or only those
/// among them that are their own mirror images.
struct Rounding {
  mpq_class distance;
  std::size_t sum_rules;
  bool symmetric;
};

/// At least x > 0, with 128 binary digits.
mpq_class few_digits_up(const mpq_class& x);

/// EPS,M or EPS,M,symmetric
Rounding parse_rounding(std::string_view text);

/// What the errors of the coefficients make of the entries of the transition matrices.
mpq_class entry_error(const Mask& mask, unsigned arity, const Rounding& rounding);

/// At least the change of a product of so many factors with norms up to `norm`, errors up to `error`: their number
/// times error times (norm + error)^(number - 1). Also that of a determinant by its columns. Rounded up.
mpq_class change_of_product(const mpq_class& norm, const mpq_class& error, std::size_t factors);

/// The largest 1-norm of a matrix of the family.
mpq_class largest_column_sum(const Family& family);

/// What errors of the entries add to the norms of products of so many matrices.
mpq_class change_of(const Family& family, const mpq_class& entry_error, std::size_t level);

}  // namespace subcert_check
