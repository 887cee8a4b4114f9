// A polynomial p with |p(x_s)| <= 1 at the places s of a set F fits some data that are in [-1, 1] outside of the set A
// of outliers exactly where some dual vector u has u_s = -1 where p(x_s) > 1, u_s = 1 where p(x_s) < -1, s not in A:
// at all other places the datum may be p(x_s) itself, or be on either side. The largest p(c) is found at polynomials
// that are 1 or -1 at D + 1 places outside of A, with the signs of the Lagrange polynomials at c (docs/l1.md).

#include "robustness.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/l1_scheme.hpp>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <stdexcept>

namespace subcert::data {
namespace {

using Places = std::vector<int>;

bool contains(const Places& places, int r) { return std::find(places.begin(), places.end(), r) != places.end(); }

/// All subsets of 0, ..., count - 1 of one size.
std::vector<Places> subsets(int count, int size) {
  std::vector<bool> chosen(static_cast<std::size_t>(count), false);
  std::fill_n(chosen.begin(), size, true);
  std::vector<Places> result;
  do {
    Places& places = result.emplace_back();
    for (int r = 0; r < count; ++r)
      if (chosen[static_cast<std::size_t>(r)]) places.push_back(r);
  } while (std::prev_permutation(chosen.begin(), chosen.end()));
  return result;
}

Rational lagrange(const Places& nodes, int b, const Rational& x) {
  Rational value = 1;
  for (const int j : nodes)
    if (j != b) value *= (x - j) / Rational(b - j);
  return value;
}

/// The polynomial that is 1 or -1 at the nodes, as l_b(c) is positive or not.
struct Extreme {
  Places nodes;
  Rational value;           // at an output c
  std::vector<int> beyond;  // 1 where it exceeds 1, -1 where it is below -1
};

/// Those up to the centre, from the first datum on; the others are their mirror images.
std::vector<Rational> outputs_before_centre(int points, int arity) {
  std::vector<Rational> places;
  for (int phase = 0; 2 * phase < arity; ++phase)
    places.push_back(Rational(points - 1, 2) + output_place(arity, phase));
  return places;
}

class Outliers {
 public:
  Outliers(int points, int degree, int arity) : points_(points), degree_(degree), zeros_(subsets(points, degree)) {
    for (const Places& zeros : zeros_) {
      std::vector<long>& values = vanishing_.emplace_back();
      for (int r = 0; r < points; ++r)
        values.push_back(
            std::accumulate(zeros.begin(), zeros.end(), 1L, [&](long value, int zero) { return value * (r - zero); }));
    }
    for (const Rational& c : outputs_before_centre(points, arity))
      for (const Places& nodes : subsets(points, degree + 1)) extremes_.push_back(extreme(nodes, c));
    std::stable_sort(extremes_.begin(), extremes_.end(),
                     [](const Extreme& a, const Extreme& b) { return a.value > b.value; });
  }

  /// The largest modulus of all outputs; nothing where there is none.
  std::optional<Rational> largest(const Places& outliers) const {
    if (breaks_down(outliers)) return std::nullopt;
    Places mirrored;
    for (const int r : outliers) mirrored.push_back(points_ - 1 - r);
    return std::max(largest_at_first(outliers), largest_at_first(mirrored));
  }

 private:
  Extreme extreme(const Places& nodes, const Rational& c) const {
    Extreme result{nodes, 0, {}};
    std::vector<int> signs;
    for (const int b : nodes) {
      const Rational value = lagrange(nodes, b, c);
      signs.push_back(value > 0 ? 1 : -1);
      result.value += abs(value);
    }
    for (int r = 0; r < points_; ++r) {
      Rational value = 0;
      for (std::size_t k = 0; k < nodes.size(); ++k) value += signs[k] * lagrange(nodes, nodes[k], r);
      result.beyond.push_back(value > 1 ? 1 : value < -1 ? -1 : 0);
    }
    return result;
  }

  /// Whether a polynomial p other than 0 is as good as 0 for the data p at the outliers and 0 elsewhere. A convex
  /// function of p on the p with sum 1 over the others has its largest value at one with D zeros there.
  bool breaks_down(const Places& outliers) const {
    if (points_ - static_cast<int>(outliers.size()) <= degree_) return true;
    return std::any_of(vanishing_.begin(), vanishing_.end(), [&](const std::vector<long>& values) {
      long balance = 0;
      for (int r = 0; r < points_; ++r)
        balance += (contains(outliers, r) ? 1 : -1) * std::abs(values[static_cast<std::size_t>(r)]);
      return balance >= 0;
    });
  }

  /// Whether some dual vector has the signs against `beyond`, but at outliers: the Farkas condition at the polynomials
  /// with D zeros at the other places.
  bool has_dual(const Places& outliers, const std::vector<int>& beyond) const {
    const auto fixed = [&](int r) { return contains(outliers, r) ? 0 : beyond[static_cast<std::size_t>(r)]; };
    for (std::size_t i = 0; i < zeros_.size(); ++i) {
      if (std::any_of(zeros_[i].begin(), zeros_[i].end(), [&](int zero) { return fixed(zero) != 0; })) continue;
      long sum = 0, room = 0;
      for (int r = 0; r < points_; ++r) {
        const long value = vanishing_[i][static_cast<std::size_t>(r)];
        const int sign = fixed(r);
        sum += sign * value;
        if (sign == 0) room += std::abs(value);
      }
      if (std::abs(sum) > room) return false;
    }
    return true;
  }

  Rational largest_at_first(const Places& outliers) const {
    for (const Extreme& candidate : extremes_) {
      if (std::any_of(outliers.begin(), outliers.end(), [&](int r) { return contains(candidate.nodes, r); })) continue;
      if (has_dual(outliers, candidate.beyond)) return candidate.value;
    }
    throw std::logic_error("robustness: no polynomial is a fit");
  }

  int points_, degree_;
  std::vector<Places> zeros_;
  std::vector<std::vector<long>> vanishing_;  // [i][r]: at r, the monic polynomial with zeros_[i]
  std::vector<Extreme> extremes_;             // the largest values first
};

/// Polynomials differ from the minimiser of a cell by q, and F grows at least by the sum over its zeros b of
/// |q(b)| + u_b q(b), u_b the dual value: least, for a given q(c), where q vanishes at all of them but one.
std::optional<Rational> sharpness_of(const piecewise::Rule& rule, const std::vector<Rational>& places) {
  if (!rule.is_function()) return std::nullopt;
  std::optional<Rational> least;
  for (const piecewise::Piece& piece : rule.pieces) {
    Places nodes;
    for (std::size_t r = 0; r < piece.signs.size(); ++r)
      if (piece.signs[r] == 0) nodes.push_back(static_cast<int>(r));
    for (const int b : nodes) {
      Rational dual = 0;
      for (std::size_t r = 0; r < piece.signs.size(); ++r)
        dual -= piece.signs[r] * lagrange(nodes, b, static_cast<long>(r));
      for (const Rational& c : places) {
        const Rational value = abs(lagrange(nodes, b, c));
        if (value != 0 && (!least || 1 - abs(dual) < *least * value)) least = (1 - abs(dual)) / value;
      }
    }
  }
  return least;
}

}  // namespace

LeastAbsoluteRobustness least_absolute_robustness(int points, int degree, int arity) {
  require(degree >= 0 && degree <= 3 && points >= degree + 2 && points <= 12,
          "least_absolute_robustness: need 0 <= degree <= 3 and degree + 2 <= points <= 12, got {} and {}", degree,
          points);
  require(arity >= 2, "least_absolute_robustness: need arity >= 2, got {}", arity);
  const Outliers window(points, degree, arity);
  LeastAbsoluteRobustness result;
  for (int i = 0; i < points; ++i) {
    result.one.push_back(window.largest({i}));
    for (int j = i + 1; j < points; ++j) {
      const std::optional<Rational> both = window.largest({i, j});
      if (!both)
        result.two_break.emplace_back(i, j);
      else if (!result.two || *both > *result.two)
        result.two = both;
    }
  }
  if (const auto rule = least_absolute_rule(points, degree, arity, 5000))
    result.sharpness = sharpness_of(*rule, outputs_before_centre(points, arity));
  return result;
}

}  // namespace subcert::data
