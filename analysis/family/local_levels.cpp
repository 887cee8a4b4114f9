#include "local_levels.hpp"

#include "property_of_levels.hpp"

#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>

namespace subcert {
namespace {

constexpr std::size_t most_matrices = 1024;

/// The masks at the corners of a box.
std::vector<Mask> corners_of(const ParametricMask& mask, const Box& box) {
  std::vector<Mask> result;
  for (unsigned corner = 0; corner < box.corners(); ++corner) result.push_back(mask.at(box.corner(corner)));
  return result;
}

/// The rule of the new point n: sum over j of a_{n - arity j} z^j.
LaurentPolynomial rule(const Mask& mask, long n) {
  return mask.symbol().coset(mask.arity(), modulo(n, mask.arity())).reversed().shifted(floor_divide(n, mask.arity()));
}

/// The largest m for which all rules take each polynomial of lower degree to its value at (n + shift)/arity, at all
/// corners.
int order_kept(const std::vector<Mask>& corners) {
  const PolynomialReproduction first = polynomial_reproduction(corners.front());
  int order = first.approximation_order();
  for (const Mask& mask : corners) {
    const PolynomialReproduction other = polynomial_reproduction(mask);
    order = std::min(order, other.parametrization == first.parametrization ? other.approximation_order() : 1);
  }
  return order;
}

/// Matrices from the divided differences of a window to those of the finer ones within it.
class Rules {
 public:
  Rules(const ParametricMask& mask, const std::vector<Mask>& corners, int order)
      : corners_(corners), arity_(mask.arity()), order_(order), depends_(static_cast<std::size_t>(arity_)) {
    require(arity_ >= 2, "levels: need arity >= 2, got {}", arity_);
    for (const Mask& corner : corners)
      for (long n = 0; n < arity_; ++n)
        if (rule(corner, n) != rule(corners.front(), n)) depends_[static_cast<std::size_t>(n)] = true;
    const IndexRange support = mask.support();
    // The differences n from first_ to last_ + arity - 1 are of differences from first_ to last_.
    first_ = floor_divide(-support.last, arity_ - 1) + 1;
    while (-floor_divide(support.last - first_, arity_) < first_) --first_;
    last_ = first_;
    while (floor_divide(last_ + arity_ - 1 + order - support.first, arity_) - order > last_) ++last_;
  }

  MatrixFamily all() const {
    std::vector<RationalMatrix> result;
    for (long t = 0; t < arity_; ++t) add_matrices(t, result);
    return MatrixFamily(std::move(result));
  }

 private:
  /// With each choice of corners for the new points that have part in the differences.
  void add_matrices(long t, std::vector<RationalMatrix>& result) const {
    std::vector<long> free;
    for (long n = first_ + t; n <= last_ + t + order_; ++n)
      if (depends_[static_cast<std::size_t>(modulo(n, arity_))]) free.push_back(n);
    std::size_t choices = 1;
    for (std::size_t k = 0; k < free.size(); ++k) {
      choices *= corners_.size();
      require(result.size() + choices <= most_matrices, "levels: need at most {} matrices for a value at each point",
              most_matrices);
    }
    for (std::size_t choice = 0; choice < choices; ++choice) result.push_back(matrix(t, free, choice));
  }

  RationalMatrix matrix(long t, const std::vector<long>& free, std::size_t choice) const {
    std::vector<LaurentPolynomial> rules;
    for (long n = first_ + t; n <= last_ + t + order_; ++n) {
      std::size_t corner = 0;
      if (std::ranges::find(free, n) != free.end()) {
        corner = choice % corners_.size();
        choice /= corners_.size();
      }
      rules.push_back(rule(corners_[corner], n));
    }
    // Differences of rules that keep polynomials are combinations of differences: sum over j of c_j z^j (z - 1)^order.
    for (int k = 0; k < order_; ++k) {
      for (std::size_t n = 0; n + 1 < rules.size(); ++n) rules[n] = rules[n + 1] - rules[n];
      rules.pop_back();
    }
    const LaurentPolynomial difference = LaurentPolynomial({Rational(-1), Rational(1)}, 0).pow(order_),
                            scale = power(Rational(arity_), order_);
    const auto width = static_cast<std::size_t>(last_ - first_ + 1);
    RationalMatrix result(width, width);
    for (std::size_t n = 0; n < width; ++n) {
      if (rules[n].is_zero()) continue;
      const auto combination = (scale * rules[n]).exact_quotient(difference);
      require(combination.has_value() && combination->lowest() >= first_ && combination->highest() <= last_,
              "levels: need rules that keep polynomials");
      for (std::size_t j = 0; j < width; ++j) result(n, j) = combination->coefficient(first_ + static_cast<long>(j));
    }
    return result;
  }

  const std::vector<Mask>& corners_;
  long arity_;
  int order_;
  std::vector<bool> depends_;  ///< whether the rule of this class has letters
  long first_, last_;          ///< the window
};

}  // namespace

LocalLevels local_levels(const ParametricMask& mask, const Box& box, const Budget& budget) {
  require(mask.components() == 1, "levels: need a mask of numbers, got matrices of size {}", mask.components());
  require_levels(mask, box);
  require(std::ranges::all_of(mask.sizes(), [](std::size_t size) { return size <= 2; }) &&
              mask.denominators().entries.size() == 1,
          "levels: need coefficients of degree 1 in each letter, for a value at each point");
  const std::vector<Mask> corners = corners_of(mask, box);
  const int order = order_kept(corners);
  MatrixFamily family = Rules(mask, corners, order).all();
  JointSpectralRadius radius = joint_spectral_radius(family, {budget.deadline.after(0.8), budget.memory});
  LocalLevels result{order, {}, std::move(family), std::move(radius)};
  const Rational lower = order - *log_ratio(*result.radius.radius.upper, mask.arity()).upper;
  if (lower > 0) result.exponent.lower = lower;
  result.exponent.upper = upper_end_of_levels(mask, box, budget);
  return result;
}

}  // namespace subcert
