#include "dilation.hpp"

#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>
#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/polynomials/real_roots.hpp>
#include <subcert/analysis/symbol/polynomials/root_modulus.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>

namespace subcert {
namespace {

constexpr long largest_entry = 64, most_classes = 1 << 18;

RationalMatrix to_matrix(const std::vector<LatticePoint>& rows) {
  RationalMatrix result(rows.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < rows.size(); ++j) result(i, j) = rows[i][j];
  return result;
}

/// The sixth power of the modulus of its zeros, if they have one modulus. Domain: irreducible over the rationals, of
/// degree 3 at most. Of degree 2 it has two conjugate zeros, or real ones x and -x; one of degree 3 with a real zero r
/// and |z| = |r| for the others has r^3 = -p(0), so r is a zero of x^3 + p(0), and p is that polynomial.
std::optional<Rational> sixth_power_of_modulus(const LaurentPolynomial& f) {
  const long degree = f.highest();
  const Rational last = abs(f.coefficient(0) / f.coefficient(degree)), middle = f.coefficient(1);
  if (degree == 2 && middle != 0 && middle * middle >= 4 * f.coefficient(0) * f.coefficient(2)) return std::nullopt;
  if (degree == 3 && (middle != 0 || f.coefficient(2) != 0)) return std::nullopt;
  return power(last, 6 / degree);
}

/// See Dilation::isotropic_subspaces.
std::vector<IsotropicSubspace> isotropic_subspaces(const RationalMatrix& matrix,
                                                   const LaurentPolynomial& characteristic) {
  if (!(value_at(squarefree_part(characteristic), matrix) == RationalMatrix(matrix.rows(), matrix.rows()))) return {};
  struct Part {
    LaurentPolynomial polynomial = 1;
    Rational classes = 1;
  };
  std::map<Rational, Part> parts;
  for (const auto& [factor, multiplicity] : irreducible_factors(characteristic)) {
    const auto modulus = sixth_power_of_modulus(factor);
    if (!modulus) return {};
    Part& part = parts[*modulus];
    part.polynomial = part.polynomial * factor;
    part.classes *= power(abs(factor.coefficient(0)), multiplicity);
  }
  std::vector<IsotropicSubspace> result;
  for (const auto& [modulus, part] : parts) {
    IsotropicSubspace subspace{{}, numerator(part.classes).convert_to<long>()};
    for (const std::vector<Rational>& vector : kernel(value_at(part.polynomial, matrix))) {
      Integer common = 1;
      for (const Rational& x : vector) common = lcm(common, denominator(x));
      subspace.basis.emplace_back();
      for (const Rational& x : vector)
        subspace.basis.back().push_back(numerator(Rational(common * x)).convert_to<long>());
    }
    result.push_back(std::move(subspace));
  }
  return result;
}

}  // namespace

LatticePoint operator+(LatticePoint a, const LatticePoint& b) {
  for (std::size_t v = 0; v < a.size(); ++v) a[v] += b[v];
  return a;
}

LatticePoint operator-(LatticePoint a, const LatticePoint& b) {
  for (std::size_t v = 0; v < a.size(); ++v) a[v] -= b[v];
  return a;
}

std::vector<LatticePoint> times(const std::vector<LatticePoint>& a, const std::vector<LatticePoint>& b) {
  std::vector<LatticePoint> result(a.size(), LatticePoint(a.size(), 0));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < a.size(); ++j)
      for (std::size_t k = 0; k < a.size(); ++k) result[i][j] += a[i][k] * b[k][j];
  return result;
}

LatticePoint times(const std::vector<LatticePoint>& rows, const LatticePoint& point) {
  LatticePoint result(rows.size(), 0);
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < point.size(); ++j) result[i] += rows[i][j] * point[j];
  return result;
}

Rational monomial_at(const std::vector<Rational>& point, const LatticePoint& exponents) {
  Rational result = 1;
  for (std::size_t v = 0; v < exponents.size(); ++v)
    if (exponents[v] > 0) result *= point[v] == 0 ? Rational(0) : power(point[v], exponents[v]);
  return result;
}

std::vector<LatticePoint> points_of_box(const LatticePoint& low, const LatticePoint& high) {
  std::vector<LatticePoint> result;
  for (LatticePoint at = low; at.back() <= high.back();) {
    result.push_back(at);
    for (std::size_t v = 0; v < at.size() && ++at[v] > high[v] && v + 1 < at.size(); ++v) at[v] = low[v];
  }
  return result;
}

std::vector<LatticePoint> exponents_up_to(std::size_t variables, long degree) {
  std::vector<LatticePoint> result;
  for (long d = 0; d <= degree; ++d)
    for (LatticePoint& exponents : exponents_of_degree(variables, d)) result.push_back(std::move(exponents));
  return result;
}

std::vector<LatticePoint> exponents_of_degree(std::size_t variables, long degree) {
  if (variables == 1) return {{degree}};
  std::vector<LatticePoint> result;
  for (long first = 0; first <= degree; ++first)
    for (LatticePoint rest : exponents_of_degree(variables - 1, degree - first)) {
      rest.insert(rest.begin(), first);
      result.push_back(std::move(rest));
    }
  return result;
}

Dilation::Dilation(std::vector<LatticePoint> rows, std::vector<LatticePoint> digits) : rows_(std::move(rows)) {
  const std::size_t size = rows_.size();
  require(size >= 1 && size <= 3, "dilation: need a matrix of 1 to 3 rows, got {}", size);
  for (const LatticePoint& row : rows_) {
    require(row.size() == size, "dilation: need a square matrix, got a row of {} entries among {} rows", row.size(),
            size);
    for (const long entry : row)
      require(std::abs(entry) <= largest_entry, "dilation: need entries from -{0} to {0}, got {1}", largest_entry,
              entry);
  }
  const RationalMatrix matrix = to_matrix(rows_);
  const LaurentPolynomial characteristic = characteristic_polynomial(matrix);
  const std::string text = subcert::to_text(rows_);
  determinant_ = numerator(characteristic.coefficient(0)).convert_to<long>() * (size % 2 == 0 ? 1 : -1);
  require(determinant_ != 0 && *largest_root_modulus(characteristic.reversed()).largest.upper < 1,
          "dilation: need eigenvalues larger than 1 in modulus, all of them, got {}", text);
  require(std::abs(determinant_) <= most_classes, "dilation: need |det M| <= {}, got {} for {}", most_classes,
          std::abs(determinant_), text);
  isotropic_subspaces_ = subcert::isotropic_subspaces(matrix, characteristic);

  const RationalMatrix inverse = solve(matrix, RationalMatrix::identity(size));
  for (std::size_t i = 0; i < size; ++i) {
    adjugate_.emplace_back();
    for (std::size_t j = 0; j < size; ++j)
      adjugate_.back().push_back(numerator(Rational(inverse(i, j) * determinant_)).convert_to<long>());
  }

  if (digits.empty()) {
    // The points of M [0, 1)^s lie in the box of the partial sums of the entries of each row.
    LatticePoint low(size, 0), high(size, 0);
    for (std::size_t i = 0; i < size; ++i)
      for (const long entry : rows_[i]) (entry < 0 ? low : high)[i] += entry;
    for (const LatticePoint& at : points_of_box(low, high)) {
      const LatticePoint scaled = times(adjugate_, at);
      if (std::all_of(scaled.begin(), scaled.end(), [this](long c) {
            return determinant_ > 0 ? c >= 0 && c < determinant_ : c <= 0 && c > determinant_;
          }))
        digits.push_back(at);
    }
  }
  require(digits.size() == static_cast<std::size_t>(std::abs(determinant_)),
          "dilation: need {} digits, one of each class modulo {}, got {}", std::abs(determinant_), text, digits.size());
  for (const LatticePoint& digit : digits) {
    require(digit.size() == size, "dilation: need digits of {} numbers, got one of {}", size, digit.size());
    const auto [at, inserted] = digit_of_class_.emplace(class_of(digit), digits_.size());
    require(inserted, "dilation: need digits of different classes modulo {}, got numbers {} and {} of one class", text,
            at->second + 1, digits_.size() + 1);
    digits_.push_back(digit);
  }
}

Dilation Dilation::multiple(int variables, int factor) {
  require(factor >= 2, "mask: need arity >= 2, got {}", factor);
  std::vector<LatticePoint> rows;
  for (int i = 0; i < variables; ++i) {
    rows.emplace_back(static_cast<std::size_t>(variables), 0);
    rows.back()[static_cast<std::size_t>(i)] = factor;
  }
  return Dilation(std::move(rows));
}

std::optional<int> Dilation::factor() const {
  for (std::size_t i = 0; i < rows_.size(); ++i)
    for (std::size_t j = 0; j < rows_.size(); ++j)
      if (rows_[i][j] != (i == j ? rows_[0][0] : 0)) return std::nullopt;
  return static_cast<int>(rows_[0][0]);
}

LatticePoint Dilation::operator*(const LatticePoint& point) const { return times(rows_, point); }

LatticePoint Dilation::class_of(const LatticePoint& point) const {
  LatticePoint result = times(adjugate_, point);
  for (long& c : result) c = modulo(c, std::abs(determinant_));
  return result;
}

Dilation::Division Dilation::divide(const LatticePoint& point) const {
  const std::size_t digit = digit_of_class_.at(class_of(point));
  LatticePoint quotient = times(adjugate_, point - digits_[digit]);
  for (long& c : quotient) c /= determinant_;
  return {std::move(quotient), digit};
}

std::vector<Rational> Dilation::inverse_times(const std::vector<Rational>& point) const {
  std::vector<Rational> result(rows_.size(), 0);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    for (std::size_t j = 0; j < rows_.size(); ++j) result[i] += adjugate_[i][j] * point[j];
    result[i] /= determinant_;
  }
  return result;
}

std::string to_text(const std::vector<LatticePoint>& points) {
  std::string text;
  for (const LatticePoint& row : points) {
    text += text.empty() ? "[" : ";";
    for (std::size_t j = 0; j < row.size(); ++j) text += (j ? "," : "") + std::to_string(row[j]);
  }
  return text + "]";
}

std::string Dilation::to_text() const { return subcert::to_text(rows_); }

}  // namespace subcert
