#include "block_triangular.hpp"

#include "cost.hpp"
#include "modular_meataxe.hpp"
#include "subspace.hpp"

#include <subcert/analysis/radii/schedule.hpp>
#include <subcert/analysis/symbol/polynomials/real_roots.hpp>

#include <algorithm>
#include <stdexcept>

namespace subcert {
namespace radius {
namespace {

RationalMatrix evaluate(const AlgebraElement& element, const MatrixFamily& family) {
  RationalMatrix sum(family.size(), family.size());
  for (const AlgebraElement::Summand& summand : element.summands) {
    const RationalMatrix product = Rational(summand.factor) *
                                   family.product(std::vector<int>(summand.word.begin(), summand.word.end()));
    for (std::size_t i = 0; i < sum.rows(); ++i)
      for (std::size_t j = 0; j < sum.columns(); ++j) sum(i, j) += product(i, j);
  }
  return sum;
}

Vector rational(const std::vector<Integer>& vector) { return Vector(vector.begin(), vector.end()); }

/// The span of a start vector under the family, if modulo the prime it is a proper subspace.
std::optional<Subspace> proper_span(const MatrixFamily& family, const ModFamily& mod_family, const Vector& start,
                                    const Deadline& deadline) {
  const std::vector<Integer> integers = primitive(start);
  const std::vector<SpinStep> steps = spin(mod_family, modulo_prime(integers));
  if (steps.empty() || steps.size() == start.size()) return std::nullopt;
  Subspace rows{rational(integers)};
  for (std::size_t k = 1; k < steps.size(); ++k) {
    if (deadline.expired()) return std::nullopt;
    rows.push_back(rational(primitive(family[steps[k].letter] * rows[steps[k].parent])));
  }
  return with_short_vectors(rows);
}

struct Found {
  std::optional<Subspace> subspace;  ///< candidate for an invariant one, to be verified
  bool irreducible = false;
};

class Reducer {
 public:
  explicit Reducer(const Deadline& deadline) : deadline_(deadline) {}

  /// The basis, its columns block by block, in which the family is triangular; appends to sizes and irreducible.
  RationalMatrix run(const MatrixFamily& family, BlockTriangular& result) {
    const std::size_t n = family.size();
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
    MatrixFamily sub, quotient;
  };

  Found look(const MatrixFamily& family) const {
    const auto mod_family = modulo_prime(family);
    if (!mod_family || deadline_.expired()) return {};
    // An invariant subspace over the rationals gives one of the same dimension modulo every prime that divides no
    // denominator.
    if (decide_modulo_prime(*mod_family, deadline_) == ModularAnswer::irreducible) return {std::nullopt, true};
    return look_over_rationals(family, *mod_family);
  }

  Found look_over_rationals(const MatrixFamily& family, const ModFamily& mod_family) const {
    const MatrixFamily dual = transposed(family);
    const ModFamily mod_dual = transposed(mod_family);
    std::mt19937_64 random(1);
    for (int attempt = 0; attempt < meataxe_attempts; ++attempt) {
      const RationalMatrix theta = evaluate(algebra_element(family.count(), attempt, random), family);
      const auto characteristic = characteristic_polynomial(theta, deadline_);
      if (!characteristic || !has_time_for_roots(*characteristic, deadline_)) return {};
      auto factors = irreducible_factors(*characteristic);
      std::sort(factors.begin(), factors.end(),
                [](const auto& a, const auto& b) { return a.polynomial.length() < b.polynomial.length(); });
      if (factors.size() > factors_per_attempt + 1) factors.resize(factors_per_attempt + 1);
      for (const PolynomialFactor& factor : factors) {
        const auto value = value_at(factor.polynomial, theta, deadline_);
        if (!value || !has_time_for_elimination(*value, deadline_)) return {};
        const Subspace right = kernel(*value), left = kernel(transposed(*value));
        for (std::size_t k = 0; k < std::min<std::size_t>(right.size(), 3); ++k)
          if (auto rows = proper_span(family, mod_family, right[k], deadline_)) return {std::move(rows), false};
        for (std::size_t k = 0; k < std::min<std::size_t>(left.size(), 3); ++k)
          if (const auto rows = proper_span(dual, mod_dual, left[k], deadline_))
            return {with_short_vectors(annihilator(*rows)), false};
        if (deadline_.expired()) return {};
        if (static_cast<long>(right.size()) == factor.polynomial.highest()) return {std::nullopt, true};
      }
    }
    return {};
  }

  /// The families of the subspace and of the quotient, if the subspace is invariant.
  std::optional<Split> split_off(const MatrixFamily& family, const Subspace& rows) const {
    const std::size_t n = family.size(), d = rows.size();
    // Columns: the subspace, then the unit vectors of the coordinates that are free in its complement.
    RationalMatrix wide(n, d + n);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < d; ++j) wide(i, j) = rows[j][i];
      wide(i, d + i) = 1;
    }
    if (!has_time_for_elimination(wide, deadline_)) return std::nullopt;
    const std::vector<std::size_t> columns = pivot_columns(wide);
    if (columns.size() != n || columns[d - 1] != d - 1) return std::nullopt;
    RationalMatrix basis(n, n);
    std::vector<RationalMatrix> subs, quotients;
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i) basis(i, j) = wide(i, columns[j]);
    for (const RationalMatrix& matrix : family) {
      const RationalMatrix product = matrix * basis;
      if (!has_time_for_elimination(product, deadline_)) return std::nullopt;
      const RationalMatrix image = solve(basis, product);
      RationalMatrix sub(d, d), quotient(n - d, n - d);
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
          if (i >= d && j < d && image(i, j) != 0) return std::nullopt;
          if (i < d && j < d) sub(i, j) = image(i, j);
          if (i >= d && j >= d) quotient(i - d, j - d) = image(i, j);
        }
      subs.push_back(std::move(sub));
      quotients.push_back(std::move(quotient));
    }
    return Split{std::move(basis), std::move(subs), std::move(quotients)};
  }

  Deadline deadline_;
};

}  // namespace
}  // namespace radius

MatrixFamily BlockTriangular::block(std::size_t index) const {
  std::size_t start = 0;
  for (std::size_t k = 0; k < index; ++k) start += sizes.at(k);
  std::vector<RationalMatrix> result;
  for (const RationalMatrix& matrix : triangular) {
    RationalMatrix block(sizes.at(index), sizes[index]);
    for (std::size_t i = 0; i < sizes[index]; ++i)
      for (std::size_t j = 0; j < sizes[index]; ++j) block(i, j) = matrix(start + i, start + j);
    result.push_back(std::move(block));
  }
  if (!groups.empty()) return {std::move(result), groups.at(index)};
  return result;
}

BlockTriangular block_triangularise(const MatrixFamily& family, const Deadline& deadline) {
  const std::size_t n = family.size();
  BlockTriangular result{{}, RationalMatrix::identity(n), {}, {}};
  result.basis = radius::Reducer(deadline).run(family, result);
  if (result.sizes.size() == 1) {
    result.triangular = family.matrices();
    return result;
  }
  // What was found is worth a moment more.
  if (!radius::has_time_for_elimination(result.basis, deadline.later(schedule::family::grace_of_basis)))
    return {{n}, RationalMatrix::identity(n), family.matrices(), {{Truth::unknown, "no time was left to verify it"}}};
  for (const RationalMatrix& matrix : family) {
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
