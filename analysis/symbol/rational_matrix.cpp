#include "rational_matrix.hpp"

#include "balls.hpp"

#include <stdexcept>
#include <string>

namespace subcert {
namespace {

class FlintMatrix {
 public:
  FlintMatrix(std::size_t rows, std::size_t columns) {
    fmpq_mat_init(value_, static_cast<slong>(rows), static_cast<slong>(columns));
  }
  explicit FlintMatrix(const RationalMatrix& matrix) : FlintMatrix(matrix.rows(), matrix.columns()) {
    for (std::size_t i = 0; i < matrix.rows(); ++i)
      for (std::size_t j = 0; j < matrix.columns(); ++j) flint::set(entry(i, j), matrix(i, j));
  }
  FlintMatrix(const FlintMatrix&) = delete;
  FlintMatrix& operator=(const FlintMatrix&) = delete;
  ~FlintMatrix() { fmpq_mat_clear(value_); }

  fmpq_mat_struct* get() { return value_; }
  fmpq* entry(std::size_t i, std::size_t j) {
    return fmpq_mat_entry(value_, static_cast<slong>(i), static_cast<slong>(j));
  }
  RationalMatrix matrix() {
    RationalMatrix result(static_cast<std::size_t>(fmpq_mat_nrows(value_)),
                          static_cast<std::size_t>(fmpq_mat_ncols(value_)));
    for (std::size_t i = 0; i < result.rows(); ++i)
      for (std::size_t j = 0; j < result.columns(); ++j) result(i, j) = flint::to_rational(entry(i, j));
    return result;
  }

 private:
  fmpq_mat_t value_;
};

/// Brings a matrix to reduced echelon form; the pivot columns, one for each of the first rows.
std::vector<std::size_t> reduce(FlintMatrix& matrix) {
  const auto rank = static_cast<std::size_t>(fmpq_mat_rref(matrix.get(), matrix.get()));
  std::vector<std::size_t> pivots;
  for (std::size_t column = 0; pivots.size() < rank; ++column)
    if (!fmpq_is_zero(matrix.entry(pivots.size(), column))) pivots.push_back(column);
  return pivots;
}

std::string shape(const RationalMatrix& m) { return std::to_string(m.rows()) + " x " + std::to_string(m.columns()); }

}  // namespace

RationalMatrix RationalMatrix::identity(std::size_t size) {
  RationalMatrix result(size, size);
  for (std::size_t i = 0; i < size; ++i) result(i, i) = 1;
  return result;
}

RationalMatrix operator*(const RationalMatrix& a, const RationalMatrix& b) {
  if (a.columns() != b.rows())
    throw std::invalid_argument("matrix product: need matching sizes, got " + shape(a) + " and " + shape(b));
  FlintMatrix left(a), right(b), product(a.rows(), b.columns());
  fmpq_mat_mul(product.get(), left.get(), right.get());
  return product.matrix();
}

std::vector<Rational> operator*(const RationalMatrix& matrix, const std::vector<Rational>& vector) {
  if (matrix.columns() != vector.size())
    throw std::invalid_argument("matrix product: need matching sizes, got " + shape(matrix) + " and " +
                                std::to_string(vector.size()) + " entries");
  std::vector<Rational> result(matrix.rows(), 0);
  for (std::size_t i = 0; i < matrix.rows(); ++i)
    for (std::size_t j = 0; j < matrix.columns(); ++j)
      if (vector[j] != 0 && matrix(i, j) != 0) result[i] += matrix(i, j) * vector[j];
  return result;
}

RationalMatrix transposed(const RationalMatrix& matrix) {
  RationalMatrix result(matrix.columns(), matrix.rows());
  for (std::size_t i = 0; i < matrix.rows(); ++i)
    for (std::size_t j = 0; j < matrix.columns(); ++j) result(j, i) = matrix(i, j);
  return result;
}

LaurentPolynomial characteristic_polynomial(const RationalMatrix& matrix) {
  if (matrix.rows() != matrix.columns())
    throw std::invalid_argument("characteristic_polynomial: need a square matrix, got " + shape(matrix));
  FlintMatrix source(matrix);
  fmpq_poly_t polynomial;
  fmpq_poly_init(polynomial);
  fmpq_mat_charpoly(polynomial, source.get());
  std::vector<Rational> coefficients;
  flint::Quotient value;
  for (slong i = 0; i < fmpq_poly_length(polynomial); ++i) {
    fmpq_poly_get_coeff_fmpq(value.get(), polynomial, i);
    coefficients.push_back(flint::to_rational(value.get()));
  }
  fmpq_poly_clear(polynomial);
  return LaurentPolynomial(coefficients, 0);
}

std::vector<std::vector<Rational>> kernel(const RationalMatrix& matrix) {
  FlintMatrix reduced(matrix);
  const std::vector<std::size_t> pivots = reduce(reduced);
  std::vector<std::vector<Rational>> basis;
  std::size_t next_pivot = 0;
  for (std::size_t column = 0; column < matrix.columns(); ++column) {
    if (next_pivot < pivots.size() && pivots[next_pivot] == column) {
      ++next_pivot;
      continue;
    }
    std::vector<Rational> vector(matrix.columns(), 0);
    vector[column] = 1;
    for (std::size_t row = 0; row < pivots.size(); ++row)
      vector[pivots[row]] = -flint::to_rational(reduced.entry(row, column));
    basis.push_back(std::move(vector));
  }
  return basis;
}

std::vector<std::size_t> pivot_columns(const RationalMatrix& matrix) {
  FlintMatrix reduced(matrix);
  return reduce(reduced);
}

RationalMatrix solve(const RationalMatrix& a, const RationalMatrix& b) {
  if (a.rows() != a.columns() || a.rows() != b.rows())
    throw std::invalid_argument("solve: need a square matrix and as many rows, got " + shape(a) + " and " + shape(b));
  FlintMatrix left(a), right(b), solution(b.rows(), b.columns());
  if (fmpq_mat_solve(solution.get(), left.get(), right.get()) == 0)
    throw std::domain_error("solve: need a non-singular matrix");
  return solution.matrix();
}

RootModulus largest_root_modulus(const LaurentPolynomial& p, int bits) {
  if (p.is_zero()) throw std::domain_error("largest_root_modulus: need a non-zero polynomial, got 0");
  const LaurentPolynomial powers_removed = p.shifted(-p.lowest());
  RootModulus result;
  result.largest = Enclosure::exactly(0);
  if (powers_removed.length() == 1) return result;
  result.has_root_plus_or_minus_one = powers_removed(1) == 0 || powers_removed(-1) == 0;
  const LaurentPolynomial squarefree = *powers_removed.exact_quotient(gcd(powers_removed, powers_removed.derivative()));

  flint::IntegerPolynomial polynomial(squarefree);
  const slong count = fmpz_poly_degree(polynomial.get());
  acb_ptr roots = _acb_vec_init(count);
  arb_fmpz_poly_complex_roots(roots, polynomial.get(), 0,
                              bits + 8);  // the radius, not the width, is held to these bits
  Ball modulus;
  for (slong i = 0; i < count; ++i) {
    acb_abs(modulus.get(), roots + i, bits + 32);
    const Enclosure candidate = modulus.enclosure(256);
    result.largest.lower = std::max(*result.largest.lower, *candidate.lower);
    result.largest.upper = std::max(*result.largest.upper, *candidate.upper);
  }
  _acb_vec_clear(roots, count);
  return result;
}

}  // namespace subcert
