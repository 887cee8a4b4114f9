// A walk from vertex to vertex. All that it asks of the data is the signs of divided differences of order D + 1; zeros
// have the sign that they get from adding e, e^2, e^3, ... to the data, e > 0 small, with which no residual vanishes
// outside of a basis. Built without contraction: the exact signs rest on rounding.

#include "least_absolute_fit.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace subcert::data {
namespace {

constexpr int most_points = 64, most_basic = 4;

/// Factors of the data at count increasing nodes in their divided difference, times the product of all distances: the
/// last is positive, signs alternate, moduli are integers below 2^36.
template <class Number>
void difference_factors(const int* nodes, int count, Number* factors) {
  for (int i = 0; i < count; ++i) {
    long product = (count - 1 - i) % 2 == 0 ? 1 : -1;
    for (int k = 1; k < count; ++k)
      for (int j = 0; j < k; ++j)
        if (j != i && k != i) product *= nodes[k] - nodes[j];
    factors[i] = static_cast<Number>(product);
  }
}

/// The sign of the exact sum, by an expansion whose parts do not overlap [Shewchuk 1997, Grow-Expansion].
int sign_of_sum(const double* terms, int count) {
  std::array<double, 2 * (most_basic + 1)> parts{};
  int used = 0;
  for (int i = 0; i < count; ++i) {
    double carry = terms[i];
    for (int k = 0; k < used; ++k) {
      const double sum = carry + parts[static_cast<std::size_t>(k)];
      const double part = sum - carry;
      parts[static_cast<std::size_t>(k)] = (carry - (sum - part)) + (parts[static_cast<std::size_t>(k)] - part);
      carry = sum;
    }
    parts[static_cast<std::size_t>(used++)] = carry;
  }
  for (int k = used; k-- > 0;)
    if (const double part = parts[static_cast<std::size_t>(k)]; part != 0) return part > 0 ? 1 : -1;
  return 0;
}

/// Signs of divided differences of data below 2^900: factors are integers, so products have exact errors, also where
/// they are denormal.
class DoubleData {
 public:
  using Number = double;
  explicit DoubleData(const double* data) : data_(data) {}
  double operator[](int node) const { return data_[node]; }

  int difference_sign(const int* nodes, int count) const {
    std::array<double, most_basic + 1> factors;
    if (count == 3)
      factors = {static_cast<double>(nodes[2] - nodes[1]), static_cast<double>(nodes[0] - nodes[2]),
                 static_cast<double>(nodes[1] - nodes[0])};
    else
      difference_factors(nodes, count, factors.data());
    double sum = 0, moduli = 0;
    for (int i = 0; i < count; ++i) {
      const double term = factors[static_cast<std::size_t>(i)] * data_[nodes[i]];
      sum += term;
      moduli += std::abs(term);
    }
    constexpr double error = 16 * 0x1p-53;  // more than twice as many roundings as there are
    if (sum > error * moduli) return 1;
    if (sum < -error * moduli) return -1;
    return moduli == 0 ? 0 : exact_sign(nodes, count, factors.data());
  }

 private:
  int exact_sign(const int* nodes, int count, const double* factors) const {
    std::array<double, 2 * (most_basic + 1)> terms;
    for (int i = 0; i < count; ++i) {
      const double product = factors[i] * data_[nodes[i]];
      terms[static_cast<std::size_t>(2 * i)] = std::fma(factors[i], data_[nodes[i]], -product);
      terms[static_cast<std::size_t>(2 * i + 1)] = product;
    }
    return sign_of_sum(terms.data(), 2 * count);
  }

  const double* data_;
};

class RationalData {
 public:
  using Number = Rational;
  explicit RationalData(const std::vector<Rational>& data) : data_(data) {}
  const Rational& operator[](int node) const { return data_[static_cast<std::size_t>(node)]; }

  int difference_sign(const int* nodes, int count) const {
    std::array<long, most_basic + 1> factors;
    difference_factors(nodes, count, factors.data());
    Rational sum = 0;
    for (int i = 0; i < count; ++i) sum += factors[static_cast<std::size_t>(i)] * (*this)[nodes[i]];
    return sum.sign();
  }

 private:
  const std::vector<Rational>& data_;
};

/// The nodes that a polynomial interpolates, in increasing order.
using Basis = std::array<int, most_basic>;

template <class Data>
class Walk {
 public:
  Walk(const Data& data, int points, int degree) : data_(data), points_(points), basic_(degree + 1) {
    for (int k = 0; k < basic_; ++k) basis_[index(k)] = (2 * k + 1) * points / (2 * basic_);
    for (int r = 0; r < points; ++r) sign_[index(r)] = is_basic(r) ? 0 : residual_sign(basis_, r);
  }

  /// To a least polynomial. True: it is the only one, as every dual value at the basis is inside (-1, 1).
  bool descend() {
    for (;;) {
      int leaving = -1;
      double worst = 1;
      bool inside = true;
      for (int k = 0; k < basic_; ++k) {
        const long dual = dual_value(k), one = std::abs(scale(k));
        inside = inside && std::abs(dual) < one;
        if (std::abs(dual) <= one) continue;
        const double size = static_cast<double>(std::abs(dual)) / static_cast<double>(one);
        if (size > worst) {
          worst = size;
          leaving = k;
        }
      }
      if (leaving < 0) return inside;
      descend_from(leaving);
    }
  }

  /// From one of the least polynomials to that whose leading coefficient is the largest (side = 1), smallest (-1). A
  /// least polynomial has the residuals that the dual values at the end of the descent allow.
  void go_to_end(int side) {
    for (int k = 0; k < basic_; ++k) {
      const long dual = dual_value(k), one = scale(k);
      sign_[index(basis_[index(k)])] = std::abs(dual) < std::abs(one) ? 0 : (dual < 0) == (one < 0) ? 1 : -1;
    }
    for (int k = 0; k < basic_; ++k) {
      const int allowed = -sign_[index(basis_[index(k)])];  // of the change of the polynomial at the node
      if (allowed * (scale(k) > 0 ? 1 : -1) * side <= 0) continue;
      collect(k, allowed);
      replace(k, *std::min_element(crossed_.begin(), crossed_.begin() + crossings_,
                                   [&](int r, int s) { return sooner(k, r, s); }));
      k = -1;
    }
  }

  const Basis& basis() const { return basis_; }

  /// Whether the polynomial of the other basis is the same.
  bool interpolates(const Basis& other) const {
    return std::all_of(other.begin(), other.begin() + basic_,
                       [&](int r) { return is_basic(r) || difference_sign(basis_, r) == 0; });
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  bool is_basic(int r) const {
    return std::find(basis_.begin(), basis_.begin() + basic_, r) != basis_.begin() + basic_;
  }

  /// Product of the distances of x from the basis without its k-th node: the k-th Lagrange polynomial times scale(k).
  long product(int k, int x) const {
    long value = 1;
    for (int j = 0; j < basic_; ++j)
      if (j != k) value *= x - basis_[index(j)];
    return value;
  }
  long scale(int k) const { return product(k, basis_[index(k)]); }

  /// The dual value at the k-th node, times scale(k).
  long dual_value(int k) const {
    long sum = 0;
    for (int r = 0; r < points_; ++r)
      if (!is_basic(r)) sum -= sign_[index(r)] * product(k, r);
    return sum;
  }

  int difference_sign(const Basis& basis, int r) const {
    std::array<int, most_basic + 1> nodes;
    int k = 0;
    for (; k < basic_ && basis[index(k)] < r; ++k) nodes[index(k)] = basis[index(k)];
    nodes[index(k)] = r;
    for (; k < basic_; ++k) nodes[index(k + 1)] = basis[index(k)];
    return data_.difference_sign(nodes.data(), basic_ + 1);
  }

  /// Of the datum at r less the polynomial of the basis; never 0.
  int residual_sign(const Basis& basis, int r) const {
    int difference = difference_sign(basis, r);
    if (difference == 0) difference = basic_ % 2 == 0 ? 1 : -1;  // of the factor at the first node
    const auto above = std::count_if(basis.begin(), basis.begin() + basic_, [&](int b) { return b > r; });
    return above % 2 == 0 ? difference : -difference;
  }

  /// The basis with r in the place of its k-th node.
  Basis replaced(int k, int r) const {
    Basis result = basis_;
    for (; k + 1 < basic_ && result[index(k + 1)] < r; ++k) result[index(k)] = result[index(k + 1)];
    for (; k > 0 && result[index(k - 1)] > r; --k) result[index(k)] = result[index(k - 1)];
    result[index(k)] = r;
    return result;
  }

  /// The nodes whose residuals become 0 while the polynomial moves at its k-th node alone, up or down by `direction`.
  void collect(int k, int direction) {
    crossings_ = 0;
    const bool positive = scale(k) > 0;
    for (int r = 0; r < points_; ++r)
      if (!is_basic(r) && sign_[index(r)] * ((product(k, r) > 0) == positive ? 1 : -1) == direction)
        crossed_[index(crossings_++)] = r;
  }

  /// Whether the residual at r becomes 0 before that at s.
  bool sooner(int k, int r, int s) const { return r != s && residual_sign(replaced(k, r), s) == sign_[index(s)]; }

  void replace(int k, int r) { basis_ = replaced(k, r); }

  void descend_from(int k) {
    const long dual = dual_value(k), one = scale(k);
    const int direction = (dual < 0) == (one < 0) ? -1 : 1;
    collect(k, direction);
    std::sort(crossed_.begin(), crossed_.begin() + crossings_, [&](int r, int s) { return sooner(k, r, s); });
    long slope = std::abs(one) - std::abs(dual);
    int passed = 0;
    for (; (slope += 2 * std::abs(product(k, crossed_[index(passed)]))) < 0; ++passed)
      sign_[index(crossed_[index(passed)])] *= -1;
    sign_[index(basis_[index(k)])] = -direction;
    sign_[index(crossed_[index(passed)])] = 0;
    replace(k, crossed_[index(passed)]);
  }

  const Data& data_;
  int points_, basic_;
  Basis basis_{};
  std::array<int, most_points> sign_;  // of residuals outside of the basis
  std::array<int, most_points> crossed_;
  int crossings_ = 0;
};

/// Adds the share of the polynomial through the data at the basis, at x.
template <class Data, class Number = typename Data::Number>
void add_value(const Data& data, const Basis& basis, int basic, const Number& x, const Number& share, Number& value) {
  const Number first = data[basis[0]];
  Number sum = 0;
  for (int k = 1; k < basic; ++k) {
    const int node = basis[static_cast<std::size_t>(k)];
    Number above = 1;
    long below = 1;
    for (int j = 0; j < basic; ++j) {
      if (j == k) continue;
      above *= x - Number(basis[static_cast<std::size_t>(j)]);
      below *= node - basis[static_cast<std::size_t>(j)];
    }
    sum += above / static_cast<Number>(below) * (data[node] - first);
  }
  value += share * (first + sum);
}

template <class Data, class Number = typename Data::Number>
bool fit_data(const Data& data, int points, int degree, const std::vector<Number>& at, Number* out) {
  Walk<Data> walk(data, points, degree);
  const bool inside = walk.descend();
  const auto add = [&](const Basis& basis, const Number& share) {
    for (std::size_t o = 0; o < at.size(); ++o) add_value(data, basis, degree + 1, at[o], share, out[o]);
  };
  std::fill_n(out, at.size(), Number(0));
  if (inside) {
    add(walk.basis(), Number(1));
    return true;
  }
  Walk<Data> other = walk;
  walk.go_to_end(1);
  other.go_to_end(-1);
  if (walk.interpolates(other.basis())) {
    add(walk.basis(), Number(1));
    return true;
  }
  add(walk.basis(), Number(1) / 2);
  add(other.basis(), Number(1) / 2);
  return false;
}

}  // namespace

LeastAbsoluteFitter::LeastAbsoluteFitter(int points, int degree, std::vector<Rational> outputs)
    : points_(points), degree_(degree), outputs_(std::move(outputs)) {
  if (degree < 0 || degree >= most_basic || points <= degree || points > most_points)
    fail(ErrorKind::domain, "LeastAbsoluteFitter: need 0 <= degree <= 3 and degree < points <= 64, got {} and {}",
         degree, points);
  for (const Rational& output : outputs_) at_.push_back(static_cast<double>(output));
}

bool LeastAbsoluteFitter::fit(const double* data, double* out) const {
  double largest = 0;
  bool finite = true;
  for (int r = 0; r < points_; ++r) {
    finite = finite && std::isfinite(data[r]);
    largest = std::max(largest, std::abs(data[r]));
  }
  require(finite, "LeastAbsoluteFitter: need finite data");
  if (largest < 0x1p900) return fit_data(DoubleData(data), points_, degree_, at_, out);
  const LeastAbsoluteFit<Rational> exact = fit(std::vector<Rational>(data, data + points_));
  std::transform(exact.values.begin(), exact.values.end(), out,
                 [](const Rational& value) { return nearest_double(value); });
  return exact.unique;
}

LeastAbsoluteFit<Rational> LeastAbsoluteFitter::fit(const std::vector<Rational>& data) const {
  require(data.size() == static_cast<std::size_t>(points_), "LeastAbsoluteFitter: need {} data, got {}", points_,
          data.size());
  LeastAbsoluteFit<Rational> result{std::vector<Rational>(outputs_.size()), false};
  result.unique = fit_data(RationalData(data), points_, degree_, outputs_, result.values.data());
  return result;
}

}  // namespace subcert::data
