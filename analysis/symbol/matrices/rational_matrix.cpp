#include "rational_matrix.hpp"

#include <subcert/analysis/symbol/polynomials/flint_polynomial.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <flint/fmpz_lll.h>
#include <flint/nmod_mat.h>
#include <flint/nmod_poly.h>
#include <flint/ulong_extras.h>

#include <algorithm>
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

std::string shape(const RationalMatrix& m) { return fmt::format("{} x {}", m.rows(), m.columns()); }

/// Bits of the coefficients times squared size up to which a characteristic polynomial needs no interruption.
constexpr double quick_work = 1e7;

/// The characteristic polynomial of an integer matrix modulo one prime.
class ModularCharacteristic {
 public:
  ModularCharacteristic(flint::WholeMatrix& matrix, ulong prime) {
    nmod_mat_t reduced;
    nmod_mat_init(reduced, matrix.get()->r, matrix.get()->c, prime);
    fmpz_mat_get_nmod_mat(reduced, matrix.get());
    nmod_poly_init(value_, prime);
    nmod_mat_charpoly(value_, reduced);
    nmod_mat_clear(reduced);
  }
  ModularCharacteristic(const ModularCharacteristic&) = delete;
  ModularCharacteristic& operator=(const ModularCharacteristic&) = delete;
  ~ModularCharacteristic() { nmod_poly_clear(value_); }
  const nmod_poly_struct* get() const { return value_; }

 private:
  nmod_poly_t value_;
};

/// Bits that hold every coefficient of the characteristic polynomial, and its sign: each is a sum of minors, at most
/// binomial(n, k) <= 2^n of them, each at most a product of norms of rows.
slong bits_of_characteristic(flint::WholeMatrix& matrix) {
  const slong n = matrix.get()->r;
  slong bits = n + 2;
  for (slong i = 0; i < n; ++i) {
    slong largest = 0;
    for (slong j = 0; j < n; ++j)
      largest = std::max(largest, static_cast<slong>(fmpz_bits(fmpz_mat_entry(matrix.get(), i, j))));
    if (largest > 0) bits += largest + static_cast<slong>(FLINT_BIT_COUNT(static_cast<ulong>(n)) + 1) / 2;
  }
  return bits;
}

}  // namespace

RationalMatrix RationalMatrix::identity(std::size_t size) {
  RationalMatrix result(size, size);
  for (std::size_t i = 0; i < size; ++i) result(i, i) = 1;
  return result;
}

RationalMatrix operator*(const RationalMatrix& a, const RationalMatrix& b) {
  require(a.columns() == b.rows(), "matrix product: need matching sizes, got {} and {}", shape(a), shape(b));
  FlintMatrix left(a), right(b), product(a.rows(), b.columns());
  fmpq_mat_mul(product.get(), left.get(), right.get());
  return product.matrix();
}

RationalMatrix operator*(const Rational& factor, RationalMatrix matrix) {
  for (std::size_t i = 0; i < matrix.rows(); ++i)
    for (std::size_t j = 0; j < matrix.columns(); ++j) matrix(i, j) *= factor;
  return matrix;
}

std::vector<Rational> operator*(const RationalMatrix& matrix, const std::vector<Rational>& vector) {
  require(matrix.columns() == vector.size(), "matrix product: need matching sizes, got {} and {} entries",
          shape(matrix), vector.size());
  std::vector<Rational> result(matrix.rows(), 0);
  for (std::size_t i = 0; i < matrix.rows(); ++i)
    for (std::size_t j = 0; j < matrix.columns(); ++j)
      if (vector[j] != 0 && matrix(i, j) != 0) result[i] += matrix(i, j) * vector[j];
  return result;
}

ComplexVector operator*(const RationalMatrix& matrix, const ComplexVector& vector) {
  std::vector<Rational> re, im;
  for (const RationalComplex& c : vector) {
    re.push_back(c.re);
    im.push_back(c.im);
  }
  re = matrix * re;
  const bool real = std::all_of(im.begin(), im.end(), [](const Rational& c) { return c == 0; });
  im = real ? std::vector<Rational>(re.size(), 0) : matrix * im;
  ComplexVector result;
  for (std::size_t i = 0; i < re.size(); ++i) result.push_back({re[i], im[i]});
  return result;
}

RationalMatrix from_columns(const std::vector<std::vector<Rational>>& columns, std::size_t rows) {
  RationalMatrix result(rows, columns.size());
  for (std::size_t c = 0; c < columns.size(); ++c)
    for (std::size_t r = 0; r < rows; ++r) result(r, c) = columns[c][r];
  return result;
}

RationalMatrix transposed(const RationalMatrix& matrix) {
  RationalMatrix result(matrix.columns(), matrix.rows());
  for (std::size_t i = 0; i < matrix.rows(); ++i)
    for (std::size_t j = 0; j < matrix.columns(); ++j) result(j, i) = matrix(i, j);
  return result;
}

RationalMatrix power(const RationalMatrix& matrix, long exponent) {
  RationalMatrix result = RationalMatrix::identity(matrix.rows()), square = matrix;
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 == 1) result = result * square;
    if (exponent > 1) square = square * square;
  }
  return result;
}

RationalMatrix second_compound(const RationalMatrix& matrix) {
  const std::size_t n = matrix.rows();
  RationalMatrix result(n * (n - 1) / 2, n * (n - 1) / 2);
  for (std::size_t i = 0, row = 0; i < n; ++i)
    for (std::size_t k = i + 1; k < n; ++k, ++row)
      for (std::size_t j = 0, column = 0; j < n; ++j)
        for (std::size_t l = j + 1; l < n; ++l, ++column)
          result(row, column) = matrix(i, j) * matrix(k, l) - matrix(i, l) * matrix(k, j);
  return result;
}

Rational one_norm(const RationalMatrix& matrix) {
  Rational most = 0;
  for (std::size_t j = 0; j < matrix.columns(); ++j) {
    Rational sum = 0;
    for (std::size_t i = 0; i < matrix.rows(); ++i) sum += abs(matrix(i, j));
    most = std::max(most, sum);
  }
  return most;
}

std::optional<long> binary_exponent(const RationalMatrix& matrix) {
  Rational largest = 0;
  for (std::size_t i = 0; i < matrix.rows(); ++i)
    for (std::size_t j = 0; j < matrix.columns(); ++j) largest = std::max(largest, Rational(abs(matrix(i, j))));
  return largest == 0 ? std::nullopt : std::optional(binary_exponent(largest));
}

RationalMatrix value_at(const LaurentPolynomial& p, const RationalMatrix& matrix) {
  return *value_at(p, matrix, Deadline::never());
}

std::optional<RationalMatrix> value_at(const LaurentPolynomial& p, const RationalMatrix& matrix,
                                       const Deadline& deadline) {
  RationalMatrix value(matrix.rows(), matrix.rows());
  if (p.is_zero()) return value;
  for (long k = p.highest(); k >= 0; --k) {
    if (deadline.expired()) return std::nullopt;
    value = value * matrix;
    for (std::size_t i = 0; i < value.rows(); ++i) value(i, i) += p.coefficient(k);
  }
  return value;
}

int largest_jordan_block(const RationalMatrix& matrix, const LaurentPolynomial& p) {
  const RationalMatrix value = value_at(p, matrix);
  RationalMatrix repeated = value;
  for (std::size_t size = 0, nullity = 0;; ++size) {
    const std::size_t next = kernel(repeated).size();
    if (next == nullity) return static_cast<int>(size);
    nullity = next;
    repeated = repeated * value;
  }
}

Rational determinant(const RationalMatrix& matrix) {
  require(matrix.rows() == matrix.columns(), "determinant: need a square matrix, got {}", shape(matrix));
  FlintMatrix flint_matrix(matrix);
  flint::Quotient result;
  fmpq_mat_det(result.get(), flint_matrix.get());
  return flint::to_rational(result.get());
}

std::optional<LaurentPolynomial> determinant(const std::function<RationalMatrix(const Rational&)>& matrix_at,
                                             long degree, const Deadline& deadline) {
  std::vector<Rational> nodes, values;
  for (long k = 0; k <= degree; ++k) {
    if (deadline.expired()) return std::nullopt;
    nodes.emplace_back(k - degree / 2);
    values.push_back(determinant(matrix_at(nodes.back())));
  }
  return interpolation(nodes, std::move(values));
}

LaurentPolynomial characteristic_polynomial(const RationalMatrix& matrix) {
  require(matrix.rows() == matrix.columns(), "characteristic_polynomial: need a square matrix, got {}", shape(matrix));
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

Integer common_denominator(const RationalMatrix& matrix) {
  Integer result = 1;
  for (std::size_t i = 0; i < matrix.rows(); ++i)
    for (std::size_t j = 0; j < matrix.columns(); ++j) result = lcm(result, denominator(matrix(i, j)));
  return result;
}

std::vector<Integer> integer_multiple(const RationalMatrix& matrix, const Integer& factor) {
  std::vector<Integer> result;
  for (std::size_t i = 0; i < matrix.rows(); ++i)
    for (std::size_t j = 0; j < matrix.columns(); ++j)
      result.push_back(numerator(matrix(i, j)) * (factor / denominator(matrix(i, j))));
  return result;
}

std::optional<LaurentPolynomial> characteristic_polynomial(const RationalMatrix& matrix, const Deadline& deadline) {
  const std::size_t n = matrix.rows();
  require(n == matrix.columns(), "characteristic_polynomial: need a square matrix, got {}", shape(matrix));
  const Integer common = common_denominator(matrix);
  const std::vector<Integer> entries = integer_multiple(matrix, common);
  flint::WholeMatrix integers(n, n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) flint::set(integers.entry(i, j), entries[i * n + j]);
  slong bits = bits_of_characteristic(integers);
  if (deadline.expired()) return std::nullopt;
  if (static_cast<double>(bits) * static_cast<double>(n * n) < quick_work) return characteristic_polynomial(matrix);
  flint::IntegerPolynomial polynomial;
  flint::Whole modulus(1);
  for (ulong prime = ulong{1} << 60; bits > 0; bits -= 60) {
    if (deadline.expired()) return std::nullopt;
    prime = n_nextprime(prime, 1);
    const ModularCharacteristic residue(integers, prime);
    fmpz_poly_CRT_ui(polynomial.get(), polynomial.get(), modulus.get(), residue.get(), 1);
    fmpz_mul_ui(modulus.get(), modulus.get(), prime);
  }
  // det(x - M/d) = d^-n det(d x - M).
  std::vector<Rational> coefficients(n + 1);
  Integer scale = 1;
  for (std::size_t k = n + 1; k-- > 0; scale *= common)
    coefficients[k] = Rational(flint::to_integer(polynomial.get()->coeffs + k), scale);
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

std::vector<std::size_t> free_columns(const std::vector<std::vector<Rational>>& kernel) {
  std::vector<std::size_t> result;
  for (const std::vector<Rational>& vector : kernel) {
    result.push_back(vector.size() - 1);
    while (vector[result.back()] == 0) --result.back();
  }
  return result;
}

std::vector<std::size_t> pivot_columns(const RationalMatrix& matrix) {
  FlintMatrix reduced(matrix);
  return reduce(reduced);
}

RationalMatrix solve(const RationalMatrix& a, const RationalMatrix& b) {
  require(a.rows() == a.columns() && a.rows() == b.rows(),
          "solve: need a square matrix and as many rows, got {} and {}", shape(a), shape(b));
  FlintMatrix left(a), right(b), solution(b.rows(), b.columns());
  require(fmpq_mat_solve(solution.get(), left.get(), right.get()) != 0, "solve: need a non-singular matrix");
  return solution.matrix();
}

namespace {

void fill(flint::WholeMatrix& matrix, const std::vector<std::vector<Integer>>& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < rows[i].size(); ++j) flint::set(matrix.entry(i, j), rows[i][j]);
}

std::vector<std::vector<Integer>> first_rows(flint::WholeMatrix& matrix, std::size_t count) {
  std::vector<std::vector<Integer>> result(count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < static_cast<std::size_t>(matrix.get()->c); ++j)
      result[i].push_back(flint::to_integer(matrix.entry(i, j)));
  return result;
}

}  // namespace

std::vector<std::vector<Integer>> reduced_lattice(const std::vector<std::vector<Integer>>& rows) {
  flint::WholeMatrix lattice(rows.size(), rows.front().size());
  fill(lattice, rows);
  fmpz_lll_t context;
  fmpz_lll_context_init_default(context);
  fmpz_lll(lattice.get(), nullptr, context);
  return first_rows(lattice, rows.size());
}

std::vector<std::vector<Integer>> lattice_basis(const std::vector<std::vector<Integer>>& rows) {
  flint::WholeMatrix lattice(rows.size(), rows.front().size());
  fill(lattice, rows);
  const auto rank = static_cast<std::size_t>(fmpz_mat_rank(lattice.get()));
  fmpz_mat_hnf(lattice.get(), lattice.get());
  return first_rows(lattice, rank);
}

}  // namespace subcert
