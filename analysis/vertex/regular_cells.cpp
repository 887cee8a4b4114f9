#include "regular_cells.hpp"

#include <subcert/analysis/symbol/polynomials/laurent_polynomial.hpp>

#include <algorithm>
#include <cstdlib>
#include <set>

namespace subcert::vertex {
namespace {

/// 1 + z^e + ... + z^((m-1)e) for a unit vector e.
MultivariatePolynomial ones_along(std::size_t axis, int m) {
  return MultivariatePolynomial::in_variable(2, static_cast<int>(axis), LaurentPolynomial::all_ones(m));
}

/// The operators v(x) = B_d v(y), x = (y + d)/m, of v(x) = (phi(x - k))_k, numerators over one denominator: column p of
/// B_d has a_{d + p - mk} at k.
class CellOperators {
 public:
  using Entry = std::pair<std::size_t, long>;
  using Matrix = std::vector<std::vector<long>>;  // rows

  CellOperators(const LatticeMask& mask, const std::vector<LatticePoint>& window) : m_(mask.arity()) {
    Integer common = 1;
    for (const Monomial& term : mask.symbol().terms()) common = lcm(common, denominator(term.coefficient));
    denominator_ = Rational(common);
    for (const LatticePoint& d : points_of_box({0, 0}, {m_ - 1, m_ - 1})) {
      columns_.emplace_back();
      for (const LatticePoint& p : window) {
        columns_.back().emplace_back();
        for (std::size_t k = 0; k < window.size(); ++k) {
          const Rational a = denominator_ * mask.symbol().coefficient(
                                                {d[0] + p[0] - m_ * window[k][0], d[1] + p[1] - m_ * window[k][1]});
          if (a == 0) continue;
          columns_.back().back().push_back({k, a.convert_to<long>()});
          largest_ = std::max(largest_, abs(a));
        }
        widest_ = std::max(widest_, columns_.back().back().size());
      }
    }
  }

  std::size_t letters() const { return columns_.size(); }
  /// Of products of so many letters the sums of entries that are formed here fit in a long, where this is true.
  bool fits(int letters, std::size_t size) const {
    Rational bound(static_cast<long>(4 * size * size));
    for (int i = 0; i < letters; ++i) bound *= largest_ * Rational(static_cast<long>(widest_));
    return bound < power(Rational(2), 62);
  }
  Matrix times(const Matrix& matrix, std::size_t letter) const {
    Matrix result(matrix.size(), std::vector<long>(matrix.size(), 0));
    for (std::size_t p = 0; p < matrix.size(); ++p)
      for (const auto& [k, entry] : columns_[letter][p])
        for (std::size_t row = 0; row < matrix.size(); ++row) result[row][p] += matrix[row][k] * entry;
    return result;
  }
  const Rational& denominator_of_entries() const { return denominator_; }

 private:
  long m_;
  Rational denominator_, largest_ = 1;
  std::size_t widest_ = 1;
  std::vector<std::vector<std::vector<Entry>>> columns_;
};

/// sup |v| of vectors v(x) = factor^n B_w v(y) in base + span of the `rest`, in which the coefficients of v are those
/// of its entries: |v| <= |B_w base| + max |B_w rest_k| |v| for a full set of words w.
class Contraction {
 public:
  Contraction(const CellOperators& operators, long factor, std::vector<std::vector<long>> rest)
      : operators_(operators), factor_(factor), rest_(std::move(rest)) {}

  std::optional<Rational> bound(const std::vector<std::vector<long>>& bases) {
    const std::size_t size = bases.front().size();
    CellOperators::Matrix identity(size, std::vector<long>(size, 0));
    for (std::size_t i = 0; i < size; ++i) identity[i][i] = 1;
    largest_ = 0;
    return visit(identity, Rational(1), bases, 0) ? std::optional(largest_) : std::nullopt;
  }

 private:
  static constexpr int most_letters = 8;

  static Rational norm(const CellOperators::Matrix& product, const std::vector<long>& vector) {
    long sum = 0;
    for (const std::vector<long>& row : product) {
      long entry = 0;
      for (std::size_t i = 0; i < vector.size(); ++i) entry += row[i] * vector[i];
      sum += std::abs(entry);
    }
    return Rational(sum);
  }

  bool visit(const CellOperators::Matrix& product, const Rational& scale, const std::vector<std::vector<long>>& bases,
             int depth) {
    Rational rate = 0;
    for (const std::vector<long>& vector : rest_) rate = std::max(rate, Rational(scale * norm(product, vector)));
    if (2 * rate <= 1) {
      for (const std::vector<long>& base : bases)
        largest_ = std::max(largest_, Rational(scale * norm(product, base) / (1 - rate)));
      return true;
    }
    if (depth == most_letters || !operators_.fits(depth + 1, product.size())) return false;
    const Rational next = scale * Rational(factor_) / operators_.denominator_of_entries();
    for (std::size_t letter = 0; letter < operators_.letters(); ++letter)
      if (!visit(operators_.times(product, letter), next, bases, depth + 1)) return false;
    return true;
  }

  const CellOperators& operators_;
  long factor_;
  std::vector<std::vector<long>> rest_;
  Rational largest_ = 0;
};

}  // namespace

std::vector<LatticePoint> window_of(const LatticeMask& mask) {
  const std::vector<Interval> support = limit_support(mask);
  LatticePoint low, high;
  for (const Interval& side : support) {
    low.push_back(to_integer(-side.upper, subcert::Rounding::down).convert_to<long>() + 1);
    high.push_back(to_integer(1 - side.lower, subcert::Rounding::up).convert_to<long>() - 1);
  }
  // A point matters only if it does for a window of the next level, which all values in the smaller squares come from.
  const std::vector<LatticePoint> box = points_of_box(low, high);
  std::set<LatticePoint> window(box.begin(), box.end());
  const long m = mask.arity();
  for (;;) {
    std::set<LatticePoint> next;
    for (const LatticePoint& d : points_of_box({0, 0}, {m - 1, m - 1}))
      for (const LatticePoint& p : window)
        for (const Monomial& term : mask.symbol().terms()) {
          const long x = d[0] + p[0] - term.exponents[0], y = d[1] + p[1] - term.exponents[1];
          if (x % m == 0 && y % m == 0 && window.count({x / m, y / m}) > 0) next.insert({x / m, y / m});
        }
    if (next == window) return {window.begin(), window.end()};
    window = std::move(next);
  }
}

bool is_positive(const LatticeMask& mask) {
  const std::vector<Monomial> terms = mask.symbol().terms();
  return std::all_of(terms.begin(), terms.end(), [](const Monomial& term) { return term.coefficient > 0; });
}

std::optional<LatticeMask> positive_derivative(const LatticeMask& mask, std::size_t axis) {
  const int m = mask.arity();
  const auto quotient = mask.symbol().exact_quotient(ones_along(axis, m));
  if (!quotient) return std::nullopt;
  const LatticeMask result(*quotient * MultivariatePolynomial(2, Rational(m)), m);
  const std::vector<Rational> sums = coset_sums(result);
  const bool is_affine = std::all_of(sums.begin(), sums.end(), [](const Rational& sum) { return sum == 1; });
  return is_affine && is_positive(result) ? std::optional(result) : std::nullopt;
}

std::optional<SumBounds> sum_bounds(const LatticeMask& mask, const std::vector<LatticePoint>& window) {
  const CellOperators operators(mask, window);
  const auto index_of = [&](const LatticePoint& point) {
    return static_cast<std::size_t>(std::find(window.begin(), window.end(), point) - window.begin());
  };
  // Three points o, o + e_1, o + e_2 of the window, about its middle.
  const LatticePoint corner = window[window.size() / 2];
  const std::size_t o = index_of(corner), along[] = {index_of(corner + LatticePoint{1, 0}),
                                                     index_of(corner + LatticePoint{0, 1})};
  if (std::max(along[0], along[1]) >= window.size()) return std::nullopt;
  const auto unit = [&](std::size_t at) {
    std::vector<long> result(window.size(), 0);
    result[at] = 1;
    return result;
  };
  std::vector<std::vector<long>> first, second;
  for (std::size_t k = 0; k < window.size(); ++k) {
    const LatticePoint step = window[k] - corner;
    first.push_back(unit(k));
    first.back()[o] -= 1;
    second.push_back(unit(k));
    second.back()[o] -= 1 - step[0] - step[1];
    for (std::size_t v = 0; v < 2; ++v) second.back()[along[v]] -= step[v];
  }
  SumBounds result{1, {}};
  if (!is_positive(mask)) {
    const auto bound = Contraction(operators, 1, first).bound({unit(o)});
    if (!bound) return std::nullopt;
    result.value = *bound;
  }
  for (const std::size_t at : along) {
    std::vector<long> base = unit(at);
    base[o] -= 1;
    const auto bound = Contraction(operators, mask.arity(), second).bound({base});
    if (!bound) return std::nullopt;
    result.derivatives.push_back(*bound);
  }
  return result;
}

std::vector<Rational> parameter_shift(const LatticeMask& mask) {
  const long m = mask.arity();
  std::vector<Rational> result(2, 0);
  for (const Monomial& term : mask.symbol().terms())
    for (std::size_t v = 0; v < 2; ++v) result[v] += term.coefficient * Rational(term.exponents[v]);
  for (Rational& shift : result) shift /= Rational(m * m * (m - 1));
  return result;
}

}  // namespace subcert::vertex
