#include "regular_cells.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>
#include <subcert/analysis/symbol/polynomials/laurent_polynomial.hpp>

#include <algorithm>
#include <cstdlib>
#include <set>

namespace subcert::vertex {
namespace {

/// The mask of divided differences along e, m a(z) / (1 + z^e + ... + z^((m-1)e)), where that is a polynomial.
std::optional<LatticeMask> divided_along(const LatticeMask& mask, const LatticePoint& e) {
  const int m = mask.arity();
  std::vector<Monomial> ones;
  for (long k = 0; k < m; ++k) ones.push_back({1, {k * e[0], k * e[1]}});
  const auto quotient = mask.symbol().exact_quotient(MultivariatePolynomial(2, ones));
  if (!quotient) return std::nullopt;
  return LatticeMask(*quotient * MultivariatePolynomial(2, Rational(m)), m);
}

using Entry = std::pair<std::size_t, long>;
using SparseVector = std::vector<Entry>;

/// The operators v(x) = B_d v(y), x = (y + d)/m, of v(x) = (phi(x - k))_k: column p of B_d has a_{d + p - mk} at k.
class CellOperators {
 public:
  /// Entries in units of 2^-44, each within `error` units of an exact one.
  struct Product {
    std::vector<std::vector<long>> rows;
    Rational error = 0;
  };
  static constexpr long one = 1L << 44;

  CellOperators(const LatticeMask& mask, const std::vector<LatticePoint>& window) : size_(window.size()) {
    const long m = mask.arity();
    Integer common = 1;
    for (const Monomial& term : mask.symbol().terms()) common = lcm(common, denominator(term.coefficient));
    // Longer numerators would be too long for the sums.
    const Integer scale = std::min(common, Integer(1) << 40);
    scale_ = scale.convert_to<long>();
    for (const LatticePoint& d : points_of_box({0, 0}, {m - 1, m - 1})) {
      columns_.emplace_back();
      for (const LatticePoint& p : window) {
        columns_.back().emplace_back();
        Rational sum = 0;
        for (std::size_t k = 0; k < size_; ++k) {
          const Rational a = mask.symbol().coefficient(
              {d[0] + p[0] - m * window[k][0], d[1] + p[1] - m * window[k][1]});
          if (a == 0) continue;
          const Integer entry = to_integer(Rational(a * Rational(scale)), Rounding::nearest);
          columns_.back().back().push_back({k, entry.convert_to<long>()});
          sum += abs(a) + power(Rational(2), -40);
        }
        most_ = std::max(most_, sum);
        widest_ = std::max(widest_, columns_.back().back().size());
      }
    }
    rounded_ = scale == common ? Rational(0) : Rational(Rational(static_cast<long>(widest_)) * power(Rational(2), -40));
  }

  std::size_t letters() const { return columns_.size(); }
  Product identity() const {
    Product result{std::vector<std::vector<long>>(size_, std::vector<long>(size_, 0))};
    for (std::size_t i = 0; i < size_; ++i) result.rows[i][i] = one;
    return result;
  }
  Product times(const Product& product, std::size_t letter) const {
    Product result{std::vector<std::vector<long>>(size_, std::vector<long>(size_, 0))};
    for (std::size_t row = 0; row < size_; ++row)
      for (std::size_t p = 0; p < size_; ++p) {
        Wide sum = 0;
        for (const auto& [k, entry] : columns_[letter][p]) sum += static_cast<Wide>(product.rows[row][k]) * entry;
        result.rows[row][p] = static_cast<long>(sum / scale_);
      }
    // In whole units: exact ones would have as many digits as the product has factors.
    result.error = to_integer(product.error * most_ + 1 + rounded_ * Rational(largest(product)), Rounding::up);
    return result;
  }
  /// Whether what is made of it fits.
  static bool fits(const Product& product) { return largest(product) < 1L << 52; }
  /// A bound of |product vector|_1.
  Rational norm(const Product& product, const SparseVector& vector) const {
    Wide sum = 0;
    long length = 0;
    for (const Entry& entry : vector) length += std::abs(entry.second);
    for (const std::vector<long>& row : product.rows) {
      Wide value = 0;
      for (const auto& [i, entry] : vector) value += static_cast<Wide>(row[i]) * entry;
      sum += value < 0 ? -value : value;
    }
    constexpr long half = 1L << 32;
    const Rational exact = Rational(static_cast<long>(sum / half)) * Rational(half) +
                           Rational(static_cast<long>(sum % half));
    return (exact + Rational(static_cast<long>(size_) * length) * product.error) / Rational(one);
  }

 private:
  __extension__ using Wide = __int128;

  static long largest(const Product& product) {
    long most = 0;
    for (const std::vector<long>& row : product.rows)
      for (const long value : row) most = std::max(most, std::abs(value));
    return most;
  }

  std::size_t size_;
  long scale_;
  Rational most_ = 1, rounded_;  ///< the largest sum of moduli of a column, and of their errors
  std::size_t widest_ = 1;
  std::vector<std::vector<SparseVector>> columns_;
};

/// sup |v| of vectors v(x) = factor^n B_w v(y) in base + span of the `rest`, in which the coefficients of v are those
/// of its entries: |v| <= |B_w base| + max |B_w rest_k| |v| for a full set of words w.
class Contraction {
 public:
  Contraction(const CellOperators& operators, long factor, std::vector<SparseVector> rest)
      : operators_(operators), factor_(factor), rest_(std::move(rest)) {}

  /// With the smallest rates that few words reach.
  std::optional<Rational> bound(const SparseVector& base) {
    for (const Rational& rate : {Rational(1) / 2, Rational(3) / 4}) {
      largest_ = 0;
      words_ = 0;
      if (visit(operators_.identity(), Rational(1), base, rate)) return largest_;
    }
    return std::nullopt;
  }

 private:
  bool visit(const CellOperators::Product& product, const Rational& scale, const SparseVector& base,
             const Rational& wanted) {
    Rational rate = 0;
    for (const SparseVector& vector : rest_) rate = std::max(rate, Rational(scale * operators_.norm(product, vector)));
    if (rate <= wanted) {
      largest_ = std::max(largest_, Rational(scale * operators_.norm(product, base) / (1 - rate)));
      return true;
    }
    if (++words_ > most_words || !operators_.fits(product)) return false;
    const Rational next = scale * Rational(factor_);
    for (std::size_t letter = 0; letter < operators_.letters(); ++letter)
      if (!visit(operators_.times(product, letter), next, base, wanted)) return false;
    return true;
  }

  static constexpr long most_words = 3000;
  const CellOperators& operators_;
  long factor_;
  std::vector<SparseVector> rest_;
  Rational largest_ = 0;
  long words_ = 0;
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

bool has_bounded_second_derivatives(const LatticeMask& mask) {
  const auto is_bounded = [&](const LatticePoint& e, const LatticePoint& f) {
    const auto once = divided_along(mask, e), twice = once ? divided_along(*once, f) : std::nullopt;
    return twice && operator_norm(*twice) <= 1;
  };
  const std::vector<LatticePoint> directions{{1, 0}, {0, 1}, {1, 1}, {1, -1}};
  std::vector<std::vector<Rational>> forms;  // by x^2, xy, y^2
  for (std::size_t i = 0; i < directions.size(); ++i)
    for (std::size_t j = i; j < directions.size(); ++j) {
      const LatticePoint &e = directions[i], &f = directions[j];
      if (is_bounded(e, f)) forms.push_back({e[0] * f[0], e[0] * f[1] + e[1] * f[0], e[1] * f[1]});
    }
  return !forms.empty() && kernel(transposed(from_columns(forms, 3))).empty();
}

bool is_positive(const LatticeMask& mask) {
  const std::vector<Monomial> terms = mask.symbol().terms();
  return std::all_of(terms.begin(), terms.end(), [](const Monomial& term) { return term.coefficient > 0; });
}

std::optional<LatticeMask> derivative_mask(const LatticeMask& mask, std::size_t axis) {
  const auto result = divided_along(mask, axis == 0 ? LatticePoint{1, 0} : LatticePoint{0, 1});
  if (!result) return std::nullopt;
  const std::vector<Rational> sums = coset_sums(*result);
  const bool is_affine = std::all_of(sums.begin(), sums.end(), [](const Rational& sum) { return sum == 1; });
  return is_affine ? result : std::nullopt;
}

std::optional<Rational> sum_bound(const LatticeMask& mask, const std::vector<LatticePoint>& window) {
  if (is_positive(mask)) return Rational(1);
  const std::size_t o = window.size() / 2;
  std::vector<SparseVector> rest;
  for (std::size_t k = 0; k < window.size(); ++k)
    if (k != o) rest.push_back({{k, 1}, {o, -1}});
  return Contraction(CellOperators(mask, window), 1, rest).bound({{o, 1}});
}

std::optional<Rational> derivative_bound(const LatticeMask& mask, const std::vector<LatticePoint>& window,
                                         std::size_t axis) {
  // Three points o, o + e_1, o + e_2 of the window, about its middle.
  const std::size_t size = window.size();
  const LatticePoint corner = window[size / 2];
  const auto index_of = [&](const LatticePoint& point) {
    return static_cast<std::size_t>(std::find(window.begin(), window.end(), point) - window.begin());
  };
  const std::size_t o = index_of(corner),
                    along[] = {index_of(corner + LatticePoint{1, 0}), index_of(corner + LatticePoint{0, 1})};
  if (std::max(along[0], along[1]) >= size) return std::nullopt;
  std::vector<SparseVector> rest;
  for (std::size_t k = 0; k < size; ++k) {
    if (k == o || k == along[0] || k == along[1]) continue;
    const LatticePoint step = window[k] - corner;
    rest.push_back({{k, 1}, {o, step[0] + step[1] - 1}, {along[0], -step[0]}, {along[1], -step[1]}});
  }
  return Contraction(CellOperators(mask, window), mask.arity(), rest).bound({{along[axis], 1}, {o, -1}});
}

}  // namespace subcert::vertex
