#include "outlier_remainder.hpp"

#include <subcert/analysis/symbol/balls.hpp>
#include <subcert/analysis/symbol/error.hpp>

#include <cstdlib>
#include <vector>

namespace subcert {
namespace {

constexpr int most_iterations = 1000;

void require_window(int points, int degree) {
  require(degree >= 0 && degree <= 3 && points > degree + 1 && points <= 64,
          "outlier remainder: need 0 <= degree <= 3 and degree + 1 < points <= 64, got {} and {}", degree, points);
}

// Twice the positions about the centre of the window: outputs stand at -1/2 and 1/2.
long twice_position(int points, int r) { return 2L * r - (points - 1); }

/// The reweighted fits of the datum 1 at one place, as values of the polynomial at the nodes. A fitted value that is 0
/// has a weight without bound for delta -> 0, and stays 0: such nodes are zeros of all further fits.
class OutlierFits {
 public:
  OutlierFits(int points, int degree, int place, slong bits)
      : points_(points), terms_(degree + 1), place_(place), bits_(bits) {
    fit(std::vector<Ball>(static_cast<std::size_t>(points), Ball(1, bits)));
    std::vector<long> kept;
    for (int r = 0; r < points; ++r)
      if (r != place && ordinary_value(r) == 0) kept.push_back(twice_position(points, r));
    zeros_ = kept;
    for (const long zero : zeros_) values_[static_cast<std::size_t>((zero + points - 1) / 2)] = Ball(0, bits);
  }

  /// One more fit. False: a value cannot be told from 0.
  bool step() {
    std::vector<Ball> weights;
    for (int r = 0; r < points_; ++r) {
      const Ball& value = values_[static_cast<std::size_t>(r)];
      const Ball residual = r == place_ ? 1 - value : abs(value);
      const bool zero = is_zero(r);
      if (!zero && !Ball(0, bits_).is_less(residual)) return false;
      weights.push_back(zero ? Ball(0, bits_) : 1 / residual);
    }
    fit(weights);
    return true;
  }

  Ball largest_output() const { return max(abs(outputs_[0]), abs(outputs_[1])); }

 private:
  bool is_zero(int r) const {
    return std::find(zeros_.begin(), zeros_.end(), twice_position(points_, r)) != zeros_.end();
  }

  /// Powers of x times a polynomial with the zeros that are kept.
  std::vector<Ball> basis_at(const Rational& x) const {
    Rational value = 1;
    for (const long zero : zeros_) value *= x - zero;
    std::vector<Ball> result;
    for (int j = static_cast<int>(zeros_.size()); j < terms_; ++j, value *= x / points_)
      result.emplace_back(value, bits_);
    return result;
  }

  /// The value at node r of the ordinary fit, exactly: the polynomial kernel by orthogonal polynomials.
  Rational ordinary_value(int r) const {
    std::vector<std::vector<Rational>> q;
    Rational sum = 0;
    for (int j = 0; j < terms_; ++j) {
      std::vector<Rational>& row = q.emplace_back();
      for (int s = 0; s < points_; ++s) row.push_back(power(Rational(twice_position(points_, s)), j));
      const auto dot = [&](const std::vector<Rational>& a, const std::vector<Rational>& b) {
        Rational result = 0;
        for (std::size_t s = 0; s < a.size(); ++s) result += a[s] * b[s];
        return result;
      };
      for (int k = 0; k < j; ++k) {
        const std::vector<Rational>& other = q[static_cast<std::size_t>(k)];
        const Rational factor = dot(q.back(), other) / dot(other, other);
        for (std::size_t s = 0; s < other.size(); ++s) q.back()[s] -= factor * other[s];
      }
      sum += q.back()[static_cast<std::size_t>(r)] * q.back()[static_cast<std::size_t>(place_)] /
             dot(q.back(), q.back());
    }
    return sum;
  }

  void fit(const std::vector<Ball>& weights) {
    const std::size_t terms = basis_at(0).size();
    std::vector<std::vector<Ball>> system(terms, std::vector<Ball>(terms + 1, Ball(0, bits_)));
    std::vector<std::vector<Ball>> nodes;
    for (int r = 0; r < points_; ++r) {
      nodes.push_back(basis_at(twice_position(points_, r)));
      const Ball& weight = weights[static_cast<std::size_t>(r)];
      for (std::size_t i = 0; i < terms; ++i) {
        for (std::size_t j = 0; j < terms; ++j) system[i][j].add_product(weight * nodes.back()[i], nodes.back()[j]);
        if (r == place_) system[i][terms] = weight * nodes.back()[i];
      }
    }
    for (std::size_t k = 0; k < terms; ++k)  // Gauss and Jordan; the matrix is positive definite
      for (std::size_t i = 0; i < terms; ++i) {
        if (i == k) continue;
        const Ball factor = system[i][k] / system[k][k];
        for (std::size_t j = k; j <= terms; ++j) system[i][j] = system[i][j] - factor * system[k][j];
      }
    const auto value = [&](const std::vector<Ball>& basis) {
      Ball sum(0, bits_);
      for (std::size_t k = 0; k < terms; ++k) sum.add_product(system[k][terms] / system[k][k], basis[k]);
      return sum;
    };
    values_.clear();
    for (const auto& node : nodes) values_.push_back(value(node));
    outputs_ = {value(basis_at(Rational(-1, 2))), value(basis_at(Rational(1, 2)))};
  }

  int points_, terms_, place_;
  slong bits_;
  std::vector<long> zeros_;
  std::vector<Ball> values_, outputs_;
};

/// Calls seen(m, remainder) for m = 0, 1, ... until it returns true. False where a value cannot be told from 0.
template <class Seen>
bool follow(int points, int degree, slong bits, Seen seen) {
  std::vector<OutlierFits> fits;
  for (int place = 0; place < (points + 1) / 2; ++place) fits.emplace_back(points, degree, place, bits);
  for (int m = 0; m <= most_iterations; ++m) {
    Ball largest(0, bits);
    for (OutlierFits& one : fits) {
      if (m > 0 && !one.step()) return false;
      largest = max(largest, one.largest_output());
    }
    if (!largest.is_finite()) return false;
    if (seen(m, largest)) return true;
  }
  return false;
}

constexpr slong precisions[] = {256, 2048};

bool next_subset(std::vector<int>& subset, int count) {
  for (std::size_t k = subset.size(); k-- > 0;)
    if (subset[k] + static_cast<int>(subset.size() - k) < count) {
      ++subset[k];
      for (std::size_t j = k + 1; j < subset.size(); ++j) subset[j] = subset[j - 1] + 1;
      return true;
    }
  return false;
}

}  // namespace

std::optional<Enclosure> outlier_remainder(int points, int degree, int iterations) {
  require_window(points, degree);
  require(iterations >= 0 && iterations <= most_iterations, "outlier remainder: need 0 <= iterations <= {}, got {}",
          most_iterations, iterations);
  for (const slong bits : precisions) {
    std::optional<Enclosure> result;
    follow(points, degree, bits, [&](int m, const Ball& remainder) {
      if (m == iterations) result = remainder.enclosure();
      return m == iterations;
    });
    if (result) return result;
  }
  return std::nullopt;
}

std::optional<int> iterations_for_remainder(int points, int degree, const Rational& remainder) {
  require_window(points, degree);
  if (outlier_factor(points, degree) >= 1) return std::nullopt;
  for (const slong bits : precisions) {
    int result = 0;
    if (follow(points, degree, bits, [&](int m, const Ball& left) {
          result = m;
          return left.is_at_most(Ball(remainder, bits));
        }))
      return result;
  }
  return std::nullopt;
}

Rational outlier_factor(int points, int degree) {
  require_window(points, degree);
  std::vector<int> zeros;
  for (int k = 0; k < degree; ++k) zeros.push_back(k);
  Rational largest = 0;
  do {  // |p(x_r)| is convex in p, and the ball of the sum has its vertices at such p
    long sum = 0, most = 0;
    for (int r = 0; r < points; ++r) {
      long value = 1;
      for (const int zero : zeros) value *= r - zero;
      sum += std::abs(value);
      most = std::max(most, std::abs(value));
    }
    largest = std::max(largest, Rational(most) / Rational(sum - most));
  } while (next_subset(zeros, points));
  return largest;
}

}  // namespace subcert
