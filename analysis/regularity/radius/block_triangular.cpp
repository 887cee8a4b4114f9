#include "block_triangular.hpp"

#include <subcert/analysis/symbol/flint.hpp>
#include <subcert/analysis/symbol/real_roots.hpp>

#include <flint/fmpz_lll.h>
#include <flint/nmod_mat.h>
#include <flint/nmod_poly.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>
#include <random>
#include <stdexcept>

namespace subcert {
namespace {

using Clock = std::chrono::steady_clock;
using Family = std::vector<RationalMatrix>;
using Vector = std::vector<Rational>;

constexpr ulong prime = 2'305'843'009'213'693'951;  // 2^61 - 1
constexpr int attempts = 8;
constexpr int factors_per_attempt = 3;

class ModMatrix {
 public:
  ModMatrix(std::size_t rows, std::size_t columns) {
    nmod_mat_init(value_, static_cast<slong>(rows), static_cast<slong>(columns), prime);
  }
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

std::optional<ulong> modulo_prime(const Rational& value) {
  const Integer modulus(prime);
  const Integer den = denominator(value) % modulus;
  if (den == 0) return std::nullopt;
  Integer num = numerator(value) % modulus;
  if (num < 0) num += modulus;
  const auto d = den.convert_to<unsigned long>(), n = num.convert_to<unsigned long>();
  nmod_t mod;
  nmod_init(&mod, prime);
  return nmod_div(n, d, mod);
}

std::optional<ModFamily> modulo_prime(const Family& family) {
  ModFamily result;
  for (const RationalMatrix& matrix : family) {
    ModMatrix reduced(matrix.rows(), matrix.columns());
    for (std::size_t i = 0; i < matrix.rows(); ++i)
      for (std::size_t j = 0; j < matrix.columns(); ++j) {
        const auto entry = modulo_prime(matrix(i, j));
        if (!entry) return std::nullopt;
        reduced(i, j) = *entry;
      }
    result.push_back(std::move(reduced));
  }
  return result;
}

ModFamily transposed(const ModFamily& family) {
  ModFamily result;
  for (const ModMatrix& matrix : family) {
    result.emplace_back(matrix.columns(), matrix.rows());
    nmod_mat_transpose(result.back().get(), matrix.get());
  }
  return result;
}

/// How a vector of a spun basis arises from an earlier one; the first is the start.
struct Step {
  std::size_t parent;
  std::size_t letter;
};

/// The smallest invariant subspace that holds the vector, modulo the prime: a basis of words applied to it.
std::vector<Step> spin(const ModFamily& family, const ModVector& start) {
  const std::size_t n = start.size();
  const nmod_t mod = family.front().modulus();
  std::vector<ModVector> basis, echelon;
  std::vector<std::size_t> pivots;
  std::vector<Step> steps;
  const auto add = [&](const ModVector& vector, const Step& step) {
    ModVector rest = vector;
    for (std::size_t k = 0; k < echelon.size(); ++k)
      if (const ulong factor = rest[pivots[k]]; factor != 0)
        for (std::size_t i = 0; i < n; ++i) rest[i] = nmod_sub(rest[i], nmod_mul(factor, echelon[k][i], mod), mod);
    const auto pivot = std::find_if(rest.begin(), rest.end(), [](ulong x) { return x != 0; });
    if (pivot == rest.end()) return;
    pivots.push_back(static_cast<std::size_t>(pivot - rest.begin()));
    const ulong inverse = nmod_inv(*pivot, mod);
    for (ulong& x : rest) x = nmod_mul(x, inverse, mod);
    echelon.push_back(std::move(rest));
    basis.push_back(vector);
    steps.push_back(step);
  };
  add(start, {0, 0});
  for (std::size_t k = 0; k < basis.size() && basis.size() < n; ++k)
    for (std::size_t t = 0; t < family.size() && basis.size() < n; ++t) {
      ModVector image(n, 0);
      for (std::size_t i = 0; i < n; ++i) {
        ulong sum = 0;
        for (std::size_t j = 0; j < n; ++j)
          if (basis[k][j] != 0) sum = nmod_add(sum, nmod_mul(family[t](i, j), basis[k][j], mod), mod);
        image[i] = sum;
      }
      add(image, {k, t});
    }
  return steps;
}

/// An element of the algebra: a sum of small multiples of words.
struct Element {
  struct Summand {
    long factor;
    std::vector<std::size_t> word;
  };
  std::vector<Summand> summands;
};

/// First the matrices themselves, then ever longer random sums of words. Deterministic.
Element element(std::size_t count, int attempt, std::mt19937_64& random) {
  const auto below = [&random](std::size_t bound) { return static_cast<std::size_t>(random() % bound); };
  if (static_cast<std::size_t>(attempt) < std::min<std::size_t>(count, 2))
    return {{{1, {static_cast<std::size_t>(attempt)}}}};
  Element result;
  for (int k = 0; k < 2 + attempt / 2; ++k) {
    std::vector<std::size_t> word(1 + below(3));
    for (std::size_t& letter : word) letter = below(count);
    const long factor = static_cast<long>(below(4)) - 2;
    result.summands.push_back({factor >= 0 ? factor + 1 : factor, word});
  }
  return result;
}

/// The element in any kind of matrix.
template <class Matrix, class Multiply, class AddMultiple>
Matrix evaluate(const Element& element, const std::vector<Matrix>& family, const Multiply& multiply,
                const AddMultiple& add_multiple) {
  Matrix sum(family.front().rows(), family.front().columns());
  for (const Element::Summand& summand : element.summands) {
    Matrix product = family[summand.word.front()];
    for (std::size_t k = 1; k < summand.word.size(); ++k) product = multiply(product, family[summand.word[k]]);
    add_multiple(sum, product, summand.factor);
  }
  return sum;
}

ModMatrix multiply(const ModMatrix& a, const ModMatrix& b) {
  ModMatrix result(a.rows(), b.columns());
  nmod_mat_mul(result.get(), a.get(), b.get());
  return result;
}

ModMatrix evaluate(const Element& element, const ModFamily& family) {
  return evaluate(element, family, multiply, [](ModMatrix& sum, const ModMatrix& product, long factor) {
    const ulong scale = factor >= 0 ? static_cast<ulong>(factor) : prime - static_cast<ulong>(-factor);
    nmod_mat_scalar_addmul_ui(sum.get(), sum.get(), product.get(), scale);
  });
}

RationalMatrix evaluate(const Element& element, const Family& family) {
  return evaluate(
      element, family, [](const RationalMatrix& a, const RationalMatrix& b) { return a * b; },
      [](RationalMatrix& sum, const RationalMatrix& product, long factor) {
        for (std::size_t i = 0; i < sum.rows(); ++i)
          for (std::size_t j = 0; j < sum.columns(); ++j) sum(i, j) += factor * product(i, j);
      });
}

enum class ModularAnswer { irreducible, reducible, unknown };

/// Norton's criterion modulo the prime: for an element theta and an irreducible factor f of its characteristic
/// polynomial whose kernel has the dimension deg f, the family is irreducible if one vector of the kernel of f(theta)
/// spins to the whole space, and one of that of the transposes.
ModularAnswer decide_modulo_prime(const ModFamily& family) {
  const std::size_t n = family.front().rows();
  const ModFamily dual = transposed(family);
  std::mt19937_64 random(1);
  ModularAnswer answer = ModularAnswer::unknown;
  for (int attempt = 0; attempt < attempts && answer == ModularAnswer::unknown; ++attempt) {
    const ModMatrix theta = evaluate(element(family.size(), attempt, random), family);
    nmod_poly_t characteristic;
    nmod_poly_init(characteristic, prime);
    nmod_mat_charpoly(characteristic, theta.get());
    nmod_poly_factor_t factors;
    nmod_poly_factor_init(factors);
    nmod_poly_factor(factors, characteristic);
    std::vector<slong> order;
    for (slong i = 0; i < factors->num; ++i) order.push_back(i);
    std::sort(order.begin(), order.end(),
              [&](slong a, slong b) { return factors->p[a].length < factors->p[b].length; });
    if (order.size() > factors_per_attempt) order.resize(factors_per_attempt);
    for (const slong index : order) {
      const nmod_poly_struct* f = factors->p + index;
      ModMatrix value(n, n), kernel(n, n);
      for (slong k = f->length - 1; k >= 0; --k) {
        value = multiply(value, theta);
        for (std::size_t i = 0; i < n; ++i) value(i, i) = nmod_add(value(i, i), f->coeffs[k], theta.modulus());
      }
      const slong nullity = nmod_mat_nullspace(kernel.get(), value.get());
      const auto column = [n](const ModMatrix& matrix) {
        ModVector vector(n);
        for (std::size_t i = 0; i < n; ++i) vector[i] = matrix(i, 0);
        return vector;
      };
      const bool whole = spin(family, column(kernel)).size() == n;
      ModMatrix value_dual(n, n), kernel_dual(n, n);
      nmod_mat_transpose(value_dual.get(), value.get());
      nmod_mat_nullspace(kernel_dual.get(), value_dual.get());
      if (!whole || spin(dual, column(kernel_dual)).size() < n) {
        answer = ModularAnswer::reducible;
        break;
      }
      if (nullity == f->length - 1) {
        answer = ModularAnswer::irreducible;
        break;
      }
    }
    nmod_poly_factor_clear(factors);
    nmod_poly_clear(characteristic);
  }
  return answer;
}

RationalMatrix value_at(const LaurentPolynomial& f, const RationalMatrix& theta) {
  RationalMatrix value(theta.rows(), theta.columns());
  for (long k = f.highest(); k >= 0; --k) {
    value = value * theta;
    for (std::size_t i = 0; i < value.rows(); ++i) value(i, i) += f.coefficient(k);
  }
  return value;
}

/// The multiple with integer entries that have no factor in common.
std::vector<Integer> primitive(const Vector& vector) {
  Integer den = 1, content = 0;
  for (const Rational& x : vector) den = lcm(den, denominator(x));
  std::vector<Integer> result;
  for (const Rational& x : vector) {
    result.push_back(numerator(x) * (den / denominator(x)));
    content = gcd(content, result.back());
  }
  if (content > 1)
    for (Integer& x : result) x /= content;
  return result;
}

Vector rational(const std::vector<Integer>& vector) { return Vector(vector.begin(), vector.end()); }

/// The vectors of a subspace, as independent rows.
using Subspace = std::vector<Vector>;

/// The orthogonal complement.
Subspace annihilator(const Subspace& rows) {
  RationalMatrix matrix(rows.size(), rows.front().size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < rows[i].size(); ++j) matrix(i, j) = rows[i][j];
  return kernel(matrix);
}

/// Short vectors that span the same subspace.
Subspace reduced(const Subspace& rows) {
  // The complement of the complement has the echelon basis, whose numbers are no larger than the subspace demands.
  const Subspace complement = annihilator(rows);
  const Subspace echelon = complement.empty() ? rows : annihilator(complement);
  fmpz_mat_t lattice;
  fmpz_mat_init(lattice, static_cast<slong>(echelon.size()), static_cast<slong>(echelon.front().size()));
  for (std::size_t i = 0; i < echelon.size(); ++i) {
    const std::vector<Integer> integers = primitive(echelon[i]);
    for (std::size_t j = 0; j < integers.size(); ++j)
      flint::set(fmpz_mat_entry(lattice, static_cast<slong>(i), static_cast<slong>(j)), integers[j]);
  }
  fmpz_lll_t context;
  fmpz_lll_context_init_default(context);
  fmpz_lll(lattice, nullptr, context);
  Subspace result(echelon.size(), Vector(echelon.front().size()));
  for (std::size_t i = 0; i < result.size(); ++i)
    for (std::size_t j = 0; j < result[i].size(); ++j)
      result[i][j] = flint::to_integer(fmpz_mat_entry(lattice, static_cast<slong>(i), static_cast<slong>(j)));
  fmpz_mat_clear(lattice);
  return result;
}

/// The span of a start vector under the family, if modulo the prime it is a proper subspace.
std::optional<Subspace> proper_span(const Family& family, const ModFamily& mod_family, const Vector& start) {
  const std::vector<Integer> integers = primitive(start);
  ModVector reduced_start;
  for (const Integer& x : integers) reduced_start.push_back(*modulo_prime(Rational(x)));
  const std::vector<Step> steps = spin(mod_family, reduced_start);
  if (steps.empty() || steps.size() == start.size()) return std::nullopt;
  Subspace rows{rational(integers)};
  for (std::size_t k = 1; k < steps.size(); ++k)
    rows.push_back(rational(primitive(family[steps[k].letter] * rows[steps[k].parent])));
  return reduced(rows);
}

struct Found {
  std::optional<Subspace> subspace;  ///< candidate for an invariant one, to be verified
  bool irreducible = false;
};

class Reducer {
 public:
  explicit Reducer(double seconds)
      : end_(Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds))) {}

  /// The basis, its columns block by block, in which the family is triangular; appends to sizes and irreducible.
  RationalMatrix run(const Family& family, BlockTriangular& result) {
    const std::size_t n = family.front().rows();
    Found found = n == 1 ? Found{std::nullopt, true} : look(family);
    if (found.subspace)
      if (auto split = split_off(family, *found.subspace)) {
        const std::size_t d = found.subspace->size();
        const RationalMatrix lower = run(split->sub, result), upper = run(split->quotient, result);
        RationalMatrix inner(n, n);
        for (std::size_t i = 0; i < n; ++i)
          for (std::size_t j = 0; j < n; ++j)
            if ((i < d) == (j < d)) inner(i, j) = i < d ? lower(i, j) : upper(i - d, j - d);
        return split->basis * inner;
      }
    result.sizes.push_back(n);
    result.irreducible.push_back(found.irreducible
                                     ? Decision{Truth::yes, n == 1 ? "of size 1" : "by Norton's criterion"}
                                     : Decision{Truth::unknown, "no invariant subspace was found"});
    return RationalMatrix::identity(n);
  }

 private:
  struct Split {
    RationalMatrix basis;
    Family sub, quotient;
  };

  bool late() const { return Clock::now() > end_; }

  Found look(const Family& family) const {
    const auto mod_family = modulo_prime(family);
    if (!mod_family || late()) return {};
    // An invariant subspace over the rationals gives one of the same dimension modulo every prime that divides no
    // denominator.
    if (decide_modulo_prime(*mod_family) == ModularAnswer::irreducible) return {std::nullopt, true};
    return look_over_rationals(family, *mod_family);
  }

  Found look_over_rationals(const Family& family, const ModFamily& mod_family) const {
    Family dual;
    for (const RationalMatrix& matrix : family) dual.push_back(transposed(matrix));
    const ModFamily mod_dual = transposed(mod_family);
    std::mt19937_64 random(1);
    for (int attempt = 0; attempt < attempts; ++attempt) {
      const RationalMatrix theta = evaluate(element(family.size(), attempt, random), family);
      auto factors = irreducible_factors(characteristic_polynomial(theta));
      std::sort(factors.begin(), factors.end(),
                [](const auto& a, const auto& b) { return a.polynomial.length() < b.polynomial.length(); });
      if (factors.size() > factors_per_attempt + 1) factors.resize(factors_per_attempt + 1);
      for (const PolynomialFactor& factor : factors) {
        if (late()) return {};
        const RationalMatrix value = value_at(factor.polynomial, theta);
        const Subspace right = kernel(value), left = kernel(transposed(value));
        for (std::size_t k = 0; k < std::min<std::size_t>(right.size(), 3); ++k)
          if (auto rows = proper_span(family, mod_family, right[k])) return {std::move(rows), false};
        for (std::size_t k = 0; k < std::min<std::size_t>(left.size(), 3); ++k)
          if (const auto rows = proper_span(dual, mod_dual, left[k])) return {reduced(annihilator(*rows)), false};
        if (static_cast<long>(right.size()) == factor.polynomial.highest()) return {std::nullopt, true};
      }
    }
    return {};
  }

  /// The families of the subspace and of the quotient, if the subspace is invariant.
  static std::optional<Split> split_off(const Family& family, const Subspace& rows) {
    const std::size_t n = family.front().rows(), d = rows.size();
    // Columns: the subspace, then the unit vectors of the coordinates that are free in its complement.
    RationalMatrix wide(n, d + n);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < d; ++j) wide(i, j) = rows[j][i];
      wide(i, d + i) = 1;
    }
    const std::vector<std::size_t> columns = pivot_columns(wide);
    if (columns.size() != n || columns[d - 1] != d - 1) return std::nullopt;
    Split result{RationalMatrix(n, n), {}, {}};
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i) result.basis(i, j) = wide(i, columns[j]);
    for (const RationalMatrix& matrix : family) {
      const RationalMatrix image = solve(result.basis, matrix * result.basis);
      RationalMatrix sub(d, d), quotient(n - d, n - d);
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
          if (i >= d && j < d && image(i, j) != 0) return std::nullopt;
          if (i < d && j < d) sub(i, j) = image(i, j);
          if (i >= d && j >= d) quotient(i - d, j - d) = image(i, j);
        }
      result.sub.push_back(std::move(sub));
      result.quotient.push_back(std::move(quotient));
    }
    return result;
  }

  Clock::time_point end_;
};

}  // namespace

std::vector<RationalMatrix> BlockTriangular::block(std::size_t index) const {
  std::size_t start = 0;
  for (std::size_t k = 0; k < index; ++k) start += sizes.at(k);
  Family result;
  for (const RationalMatrix& matrix : triangular) {
    RationalMatrix block(sizes.at(index), sizes[index]);
    for (std::size_t i = 0; i < sizes[index]; ++i)
      for (std::size_t j = 0; j < sizes[index]; ++j) block(i, j) = matrix(start + i, start + j);
    result.push_back(std::move(block));
  }
  return result;
}

BlockTriangular block_triangularise(const std::vector<RationalMatrix>& matrices, double seconds) {
  const auto fail = [](const std::string& what) { throw std::invalid_argument("block_triangularise: need " + what); };
  if (matrices.empty() || matrices.front().rows() < 1) fail("at least one matrix of size 1 or more");
  const std::size_t n = matrices.front().rows();
  for (const RationalMatrix& m : matrices)
    if (m.rows() != n || m.columns() != n) fail("square matrices of one size");
  if (!(seconds > 0)) fail("seconds > 0");
  BlockTriangular result{{}, RationalMatrix::identity(n), {}, {}};
  result.basis = Reducer(seconds).run(matrices, result);
  if (result.sizes.size() == 1) {
    result.triangular = matrices;
    return result;
  }
  for (const RationalMatrix& matrix : matrices) {
    result.triangular.push_back(solve(result.basis, matrix * result.basis));
    std::size_t start = 0, block = 0;
    for (std::size_t j = 0; j < n; ++j) {
      if (j == start + result.sizes[block]) start += result.sizes[block++];
      for (std::size_t i = start + result.sizes[block]; i < n; ++i)
        if (result.triangular.back()(i, j) != 0) throw std::logic_error("block_triangularise: not triangular");
    }
  }
  return result;
}

}  // namespace subcert
