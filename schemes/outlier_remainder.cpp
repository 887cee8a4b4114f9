#include "outlier_remainder.hpp"

#include <subcert/analysis/symbol/numbers/balls.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/l1_scheme.hpp>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <vector>

namespace subcert {
namespace {

constexpr int most_iterations = 1000;

void require_window(int points, int degree) {
  require(degree >= 0 && degree <= 3 && points > degree + 1 && points <= 64,
          "outlier remainder: need 0 <= degree <= 3 and degree + 1 < points <= 64, got {} and {}", degree, points);
}

bool next_subset(std::vector<int>& subset, int count) {
  for (std::size_t k = subset.size(); k-- > 0;)
    if (subset[k] + static_cast<int>(subset.size() - k) < count) {
      ++subset[k];
      for (std::size_t j = k + 1; j < subset.size(); ++j) subset[j] = subset[j - 1] + 1;
      return true;
    }
  return false;
}

std::vector<int> first_subset(int size) {
  std::vector<int> result(static_cast<std::size_t>(size));
  std::iota(result.begin(), result.end(), 0);
  return result;
}

/// The reweighted fits of the datum 1 at one place, as values of the polynomial at the nodes. By the formula of Cauchy
/// and Binet a weighted fit is the mean of the interpolating polynomials of all sets of D + 1 nodes, weighted by the
/// square of their Vandermonde determinant and the product of the weights there, or as well of the moduli of residuals
/// at all other nodes. So residuals that cannot be told from 0 do no harm, and those that are 0 stay so, as for delta
/// -> 0.
class OutlierFits {
 public:
  OutlierFits(int points, int degree, int arity, int place, slong bits)
      : points_(points), arity_(arity), place_(place), bits_(bits) {
    std::vector<int> nodes = first_subset(degree + 1);
    do {
      Rational square = 1;
      for (const int a : nodes)
        for (const int b : nodes)
          if (a != b) square *= std::abs(a - b);
      Set& set = sets_.emplace_back(Set{nodes, Ball(square, bits), {}});
      if (std::find(nodes.begin(), nodes.end(), place) == nodes.end()) continue;
      for (int r = 0; r < points + arity; ++r) {
        Rational value = square;
        for (const int b : nodes)
          if (b != place) value *= (position(r) - b) / Rational(place - b);
        set.values.emplace_back(value, bits);
      }
    } while (next_subset(nodes, points));
    fit(std::vector<Ball>(static_cast<std::size_t>(points), Ball(1, bits)));
  }

  void step() {
    std::vector<Ball> residuals;
    for (int r = 0; r < points_; ++r)
      residuals.push_back(r == place_ ? rest_ : abs(values_[static_cast<std::size_t>(r)]));
    fit(residuals);
  }

  Ball largest_output() const {
    Ball largest(0, bits_);
    for (auto value = values_.begin() + points_; value != values_.end(); ++value) largest = max(largest, abs(*value));
    return largest;
  }

 private:
  struct Set {
    std::vector<int> nodes;
    Ball square;               // of the determinant
    std::vector<Ball> values;  // the square times the interpolating polynomial; empty: that is 0
  };

  /// Of the nodes, then of the outputs.
  Rational position(int r) const {
    return r < points_ ? Rational(r) : Rational(points_ - 1, 2) + output_place(arity_, r - points_);
  }

  void fit(const std::vector<Ball>& residuals) {
    Ball with(0, bits_), without(0, bits_);
    std::vector<Ball> sums(static_cast<std::size_t>(points_ + arity_), Ball(0, bits_));
    for (const Set& set : sets_) {
      Ball weight(1, bits_);
      for (int r = 0; r < points_; ++r)
        if (std::find(set.nodes.begin(), set.nodes.end(), r) == set.nodes.end())
          weight *= residuals[static_cast<std::size_t>(r)];
      (set.values.empty() ? without : with).add_product(weight, set.square);
      for (std::size_t k = 0; k < set.values.size(); ++k) sums[k].add_product(weight, set.values[k]);
    }
    const Ball total = with + without;
    rest_ = without / total;
    values_.clear();
    for (const Ball& sum : sums) values_.push_back(sum / total);
  }

  int points_, arity_, place_;
  slong bits_;
  std::vector<Set> sets_;
  Ball rest_;                 // 1 less the value at the place of the datum
  std::vector<Ball> values_;  // at the nodes, then at the outputs
};

/// Whether the sets of nodes are few enough for the fits of all places.
bool is_small(int points, int degree) {
  long sets = 1;
  for (int k = 0; k <= degree; ++k) sets = sets * (points - k) / (k + 1);
  return sets <= 5000;
}

/// Calls seen(m, remainder) for m = 0, 1, ... until it returns true. False where the precision does not do.
template <class Seen>
bool follow(int points, int degree, int arity, slong bits, Seen seen) {
  if (!is_small(points, degree)) return false;
  std::vector<OutlierFits> fits;
  for (int place = 0; place < (points + 1) / 2; ++place) fits.emplace_back(points, degree, arity, place, bits);
  for (int m = 0; m <= most_iterations; ++m) {
    Ball largest(0, bits);
    for (OutlierFits& one : fits) {
      if (m > 0) one.step();
      largest = max(largest, one.largest_output());
    }
    if (!largest.is_finite()) return false;
    if (seen(m, largest)) return true;
  }
  return false;
}

constexpr slong precisions[] = {256, 2048};

}  // namespace

std::optional<Enclosure> outlier_remainder(int points, int degree, int iterations, int arity) {
  require_window(points, degree);
  require(iterations >= 0 && iterations <= most_iterations, "outlier remainder: need 0 <= iterations <= {}, got {}",
          most_iterations, iterations);
  require(arity >= 2, "outlier remainder: need arity >= 2, got {}", arity);
  for (const slong bits : precisions) {
    std::optional<Enclosure> result;
    follow(points, degree, arity, bits, [&](int m, const Ball& remainder) {
      if (m == iterations) result = remainder.enclosure();
      return m == iterations;
    });
    if (result) return result;
  }
  return std::nullopt;
}

std::optional<int> iterations_for_remainder(int points, int degree, const Rational& remainder, int arity) {
  require_window(points, degree);
  require(arity >= 2, "outlier remainder: need arity >= 2, got {}", arity);
  if (outlier_factor(points, degree) >= 1) return std::nullopt;
  for (const slong bits : precisions) {
    int result = 0;
    if (follow(points, degree, arity, bits, [&](int m, const Ball& left) {
          result = m;
          return left.is_at_most(Ball(remainder, bits));
        }))
      return result;
  }
  return std::nullopt;
}

Rational outlier_factor(int points, int degree) {
  require_window(points, degree);
  std::vector<int> zeros = first_subset(degree);
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
