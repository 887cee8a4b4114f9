#include "modular_meataxe.hpp"

#include <flint/nmod_poly.h>

#include <algorithm>
#include <optional>
#include <tuple>

namespace subcert::radius {
namespace {

constexpr ulong prime = 2'305'843'009'213'693'951;  // 2^61 - 1

constexpr long largest_part = 1L << 29;  // of the fractions that are recognised modulo the prime

nmod_t prime_field() {
  nmod_t mod;
  nmod_init(&mod, prime);
  return mod;
}

std::optional<ulong> residue_of(const Rational& value) {
  const Integer modulus(prime);
  const Integer den = denominator(value) % modulus;
  if (den == 0) return std::nullopt;
  Integer num = numerator(value) % modulus;
  if (num < 0) num += modulus;
  const auto d = den.convert_to<unsigned long>(), n = num.convert_to<unsigned long>();
  return nmod_div(n, d, prime_field());
}

ModMatrix evaluate(const AlgebraElement& element, const ModFamily& family) {
  ModMatrix sum(family.front().rows(), family.front().columns());
  for (const AlgebraElement::Summand& summand : element.summands) {
    ModMatrix product = family[summand.word.front()];
    for (std::size_t k = 1; k < summand.word.size(); ++k) product = product * family[summand.word[k]];
    const ulong scale = summand.factor >= 0 ? static_cast<ulong>(summand.factor)
                                            : prime - static_cast<ulong>(-summand.factor);
    nmod_mat_scalar_addmul_ui(sum.get(), sum.get(), product.get(), scale);
  }
  return sum;
}

/// The irreducible factors of the characteristic polynomial, the shortest first.
class CharacteristicFactors {
 public:
  explicit CharacteristicFactors(const ModMatrix& matrix) {
    nmod_poly_factor_init(factors_);
    nmod_poly_t characteristic;
    nmod_poly_init(characteristic, prime);
    nmod_mat_charpoly(characteristic, matrix.get());
    nmod_poly_factor(factors_, characteristic);
    nmod_poly_clear(characteristic);
    for (slong i = 0; i < factors_->num; ++i) {
      sorted_.push_back(factors_->p + i);
      if (factors_->exp[i] == 1 && factors_->p[i].length == 2)
        simple_roots_.push_back(nmod_neg(factors_->p[i].coeffs[0], factors_->p[i].mod));
    }
    std::sort(sorted_.begin(), sorted_.end(), [](const auto* a, const auto* b) { return a->length < b->length; });
  }
  CharacteristicFactors(const CharacteristicFactors&) = delete;
  CharacteristicFactors& operator=(const CharacteristicFactors&) = delete;
  ~CharacteristicFactors() { nmod_poly_factor_clear(factors_); }
  const std::vector<const nmod_poly_struct*>& sorted() const { return sorted_; }
  /// Zeros of simple factors of degree 1.
  const std::vector<ulong>& simple_roots() const { return simple_roots_; }

 private:
  nmod_poly_factor_t factors_;
  std::vector<const nmod_poly_struct*> sorted_;
  std::vector<ulong> simple_roots_;
};

ModMatrix value_at(const nmod_poly_struct& f, const ModMatrix& theta) {
  ModMatrix value(theta.rows(), theta.rows());
  for (slong k = f.length - 1; k >= 0; --k) {
    value = value * theta;
    for (std::size_t i = 0; i < value.rows(); ++i) value(i, i) = nmod_add(value(i, i), f.coeffs[k], theta.modulus());
  }
  return value;
}

/// The nullity, and the first vector of the kernel.
std::pair<slong, ModVector> kernel_vector(const ModMatrix& matrix) {
  const std::size_t n = matrix.rows();
  ModMatrix kernel(n, n);
  const slong nullity = nmod_mat_nullspace(kernel.get(), matrix.get());
  ModVector vector(n);
  for (std::size_t i = 0; i < n; ++i) vector[i] = kernel(i, 0);
  return {nullity, vector};
}

ModMatrix transposed(const ModMatrix& matrix) {
  ModMatrix result(matrix.columns(), matrix.rows());
  nmod_mat_transpose(result.get(), matrix.get());
  return result;
}

}  // namespace

ModMatrix::ModMatrix(std::size_t rows, std::size_t columns) {
  nmod_mat_init(value_, static_cast<slong>(rows), static_cast<slong>(columns), prime);
}

ModMatrix operator*(const ModMatrix& a, const ModMatrix& b) {
  ModMatrix result(a.rows(), b.columns());
  nmod_mat_mul(result.get(), a.get(), b.get());
  return result;
}

ModVector operator*(const ModMatrix& a, const ModVector& x) {
  const nmod_t mod = a.modulus();
  ModVector result(a.rows(), 0);
  for (std::size_t i = 0; i < a.rows(); ++i)
    for (std::size_t j = 0; j < a.columns(); ++j)
      if (x[j] != 0) result[i] = nmod_add(result[i], nmod_mul(a(i, j), x[j], mod), mod);
  return result;
}

ModVector value_times(const LaurentPolynomial& p, const ModMatrix& matrix, const ModVector& x) {
  const nmod_t field = prime_field();
  ModVector result(x.size(), 0);
  for (long k = p.highest(); k >= 0; --k) {
    result = matrix * result;
    const ulong coefficient = *residue_of(p.coefficient(k));
    for (std::size_t i = 0; i < x.size(); ++i)
      result[i] = nmod_add(result[i], nmod_mul(coefficient, x[i], field), field);
  }
  return result;
}

std::optional<ModMatrix> inverse(const ModMatrix& matrix) {
  ModMatrix result(matrix.rows(), matrix.rows());
  if (nmod_mat_inv(result.get(), matrix.get()) == 0) return std::nullopt;
  return result;
}

std::vector<ulong> simple_eigenvalues(const ModFamily& family, const AlgebraElement& element) {
  std::vector<ulong> result = CharacteristicFactors(evaluate(element, family)).simple_roots();
  if (result.size() > factors_per_attempt) result.resize(factors_per_attempt);
  return result;
}

std::optional<ModVector> eigenvector(const ModFamily& family, const AlgebraElement& element, ulong eigenvalue) {
  ModMatrix theta = evaluate(element, family);
  for (std::size_t i = 0; i < theta.rows(); ++i) theta(i, i) = nmod_sub(theta(i, i), eigenvalue, theta.modulus());
  auto [nullity, vector] = kernel_vector(theta);
  if (nullity != 1) return std::nullopt;
  return vector;
}

std::optional<ModFamily> modulo_prime(const MatrixFamily& family) {
  ModFamily result;
  for (const RationalMatrix& matrix : family) {
    ModMatrix reduced(matrix.rows(), matrix.columns());
    for (std::size_t i = 0; i < matrix.rows(); ++i)
      for (std::size_t j = 0; j < matrix.columns(); ++j) {
        const auto entry = residue_of(matrix(i, j));
        if (!entry) return std::nullopt;
        reduced(i, j) = *entry;
      }
    result.push_back(std::move(reduced));
  }
  return result;
}

ModVector modulo_prime(const std::vector<Integer>& vector) {
  ModVector result;
  for (const Integer& x : vector) result.push_back(*residue_of(Rational(x)));
  return result;
}

ModFamily transposed(const ModFamily& family) {
  ModFamily result;
  for (const ModMatrix& matrix : family) result.push_back(transposed(matrix));
  return result;
}

std::optional<Rational> small_fraction(ulong value) {
  Integer a(prime), b(value), x = 0, y = 1;
  while (b > largest_part) {
    const Integer q = a / b;
    std::tie(a, b) = std::pair(b, Integer(a - q * b));
    std::tie(x, y) = std::pair(y, Integer(x - q * y));
  }
  if (y == 0 || abs(y) > largest_part) return std::nullopt;
  return Rational(b) / Rational(y);
}

bool ModSpace::add(ModVector vector) {
  const nmod_t mod = prime_field();
  for (std::size_t k = 0; k < rows_.size(); ++k)
    if (const ulong factor = vector[pivots_[k]]; factor != 0)
      for (std::size_t i = pivots_[k]; i < vector.size(); ++i)
        vector[i] = nmod_sub(vector[i], nmod_mul(factor, rows_[k][i], mod), mod);
  const auto pivot = std::find_if(vector.begin(), vector.end(), [](ulong x) { return x != 0; });
  if (pivot == vector.end()) return false;
  pivots_.push_back(static_cast<std::size_t>(pivot - vector.begin()));
  const ulong inverse = nmod_inv(*pivot, mod);
  for (ulong& x : vector) x = nmod_mul(x, inverse, mod);
  rows_.push_back(std::move(vector));
  return true;
}

std::optional<Subspace> ModSpace::recognised() const {
  if (rows_.empty()) return Subspace();
  ModMatrix echelon(rows_.size(), rows_.front().size());
  for (std::size_t i = 0; i < echelon.rows(); ++i)
    for (std::size_t j = 0; j < echelon.columns(); ++j) echelon(i, j) = rows_[i][j];
  nmod_mat_rref(echelon.get());
  Subspace result(echelon.rows(), Vector(echelon.columns()));
  for (std::size_t i = 0; i < echelon.rows(); ++i)
    for (std::size_t j = 0; j < echelon.columns(); ++j) {
      const auto value = small_fraction(echelon(i, j));
      if (!value) return std::nullopt;
      result[i][j] = *value;
    }
  return result;
}

ModSpace span_of_words(const ModFamily& family, const std::vector<ModVector>& starts) {
  ModSpace space;
  std::vector<ModVector> fresh = starts;
  while (!fresh.empty()) {
    const ModVector vector = std::move(fresh.back());
    fresh.pop_back();
    if (!space.add(vector)) continue;
    for (const ModMatrix& matrix : family) fresh.push_back(matrix * vector);
  }
  return space;
}

ModSpace reached_by_long_words(const ModFamily& family, ModSpace space) {
  for (;;) {
    ModSpace next;
    for (const ModVector& row : space.rows())
      for (const ModMatrix& matrix : family) next.add(matrix * row);
    if (next.size() == space.size()) return space;
    space = std::move(next);
  }
}

std::vector<SpinStep> spin(const ModFamily& family, const ModVector& start) {
  ModSpace space;
  std::vector<ModVector> basis;
  std::vector<SpinStep> steps;
  const auto add = [&](ModVector vector, const SpinStep& step) {
    if (!space.add(vector)) return;
    basis.push_back(std::move(vector));
    steps.push_back(step);
  };
  add(start, {0, 0});
  for (std::size_t k = 0; k < basis.size() && basis.size() < start.size(); ++k)
    for (std::size_t t = 0; t < family.size() && basis.size() < start.size(); ++t) add(family[t] * basis[k], {k, t});
  return steps;
}

AlgebraElement algebra_element(std::size_t count, int attempt, std::mt19937_64& random) {
  const auto below = [&random](std::size_t bound) { return static_cast<std::size_t>(random() % bound); };
  if (static_cast<std::size_t>(attempt) < std::min<std::size_t>(count, 2))
    return {{{1, {static_cast<std::size_t>(attempt)}}}};
  AlgebraElement result;
  for (int k = 0; k < 2 + attempt / 2; ++k) {
    std::vector<std::size_t> word(1 + below(3));
    for (std::size_t& letter : word) letter = below(count);
    const long factor = static_cast<long>(below(4)) - 2;
    result.summands.push_back({factor >= 0 ? factor + 1 : factor, word});
  }
  return result;
}

ModularAnswer decide_modulo_prime(const ModFamily& family, const Deadline& deadline) {
  const std::size_t n = family.front().rows();
  const ModFamily dual = transposed(family);
  std::mt19937_64 random(1);
  for (int attempt = 0; attempt < meataxe_attempts; ++attempt) {
    if (deadline.expired()) break;
    const ModMatrix theta = evaluate(algebra_element(family.size(), attempt, random), family);
    const CharacteristicFactors factors(theta);
    for (std::size_t k = 0; k < factors.sorted().size() && k < factors_per_attempt; ++k) {
      if (deadline.expired()) break;
      const nmod_poly_struct& f = *factors.sorted()[k];
      const ModMatrix value = value_at(f, theta);
      const auto [nullity, vector] = kernel_vector(value);
      if (spin(family, vector).size() < n || spin(dual, kernel_vector(transposed(value)).second).size() < n)
        return ModularAnswer::reducible;
      if (nullity == f.length - 1) return ModularAnswer::irreducible;
    }
  }
  return ModularAnswer::unknown;
}

}  // namespace subcert::radius
