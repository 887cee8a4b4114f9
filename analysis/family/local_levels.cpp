#include "local_levels.hpp"

#include "property_of_levels.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/transition/transition.hpp>

#include <algorithm>

namespace subcert {
namespace {

constexpr std::size_t most_matrices = 1024;
constexpr double share_of_radius = 0.8, share_of_columns = 0.1;  // of the budget; of that of the radius

/// The masks at the corners of a box.
std::vector<Mask> corners_of(const ParametricMask& mask, const Box& box) {
  std::vector<Mask> result;
  for (unsigned corner = 0; corner < box.corners(); ++corner) result.push_back(mask.at(box.corner(corner)));
  return result;
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

/// The transition matrices for divided differences of an order, with each choice of corners for the new points t - q
/// that have part in them: those of the first corner, and for the others what they add to the coefficients, divided by
/// (1 - z^arity)^order, times (1 - z)^order. Numbers of choices have a digit for each q, the least one for the least q.
class Choices {
 public:
  Choices(const ParametricMask& mask, const std::vector<Mask>& corners, int order)
      : first_(mask.support().first),
        arity_(mask.arity()),
        order_(order),
        window_(mask.support().last - first_ - order * (arity_ - 1), static_cast<int>(arity_)),
        at_first_(divided_difference_scheme(corners.front(), order).symbol()),
        differences_(LaurentPolynomial({Rational(1), Rational(-1)}, 0).pow(order)) {
    const Rational scale = power(Rational(arity_), order);
    const LaurentPolynomial divisor = (LaurentPolynomial(1) - LaurentPolynomial::monomial(1, arity_)).pow(order);
    for (const Mask& corner : corners) {
      const auto quotient = (scale * (corner.symbol() - corners.front().symbol())).exact_quotient(divisor);
      require(quotient.has_value(), "levels: need rules that keep polynomials");
      added_.push_back(*quotient);
    }
  }

  MatrixFamily all() const {
    std::vector<RationalMatrix> result;
    for (long t = 0; t < arity_; ++t) add_matrices(t, result);
    return MatrixFamily(std::move(result));
  }

 private:
  void add_matrices(long t, std::vector<RationalMatrix>& result) const {
    std::vector<long> free;
    for (long q = 0; q < window_.width + order_; ++q)
      if (std::ranges::any_of(added_, [&](const auto& e) {
            return !e.coset(static_cast<int>(arity_), modulo(first_ + t - q, arity_)).is_zero();
          }))
        free.push_back(q);
    std::size_t choices = 1;
    for (std::size_t k = 0; k < free.size(); ++k) {
      choices *= added_.size();
      require(result.size() + choices <= most_matrices, "levels: need at most {} matrices for a value at each point",
              most_matrices);
    }
    for (std::size_t choice = 0; choice < choices; ++choice) result.push_back(matrix(t, free, choice));
  }

  RationalMatrix matrix(long t, const std::vector<long>& free, std::size_t choice) const {
    const auto width = static_cast<std::size_t>(window_.width);
    RationalMatrix result(width, width);
    const auto add = [&](const LaurentPolynomial& coefficients, long shift, const Rational& factor, long k) {
      if (k < 0 || k >= window_.width) return;
      for (long i = 0; i < window_.width; ++i)
        result(static_cast<std::size_t>(i),
               static_cast<std::size_t>(k)) += factor * coefficients.coefficient(first_ + arity_ * i + t - shift);
    };
    for (long k = 0; k < window_.width; ++k) add(at_first_, k, Rational(1), k);
    for (const long q : free) {
      for (long j = 0; j <= order_; ++j) add(added_[choice % added_.size()], q, differences_.coefficient(j), q - j);
      choice /= added_.size();
    }
    return result;
  }

  long first_, arity_;
  int order_;
  TransitionWindow window_;
  LaurentPolynomial at_first_, differences_;  ///< of the divided differences at the first corner; (1 - z)^order
  std::vector<LaurentPolynomial> added_;
};

/// Of the same joint spectral radius: transposed, rows and columns in reverse order.
MatrixFamily reflected(const MatrixFamily& family) {
  const std::size_t size = family.size();
  std::vector<RationalMatrix> result;
  for (const RationalMatrix& matrix : family) {
    RationalMatrix& other = result.emplace_back(size, size);
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t k = 0; k < size; ++k) other(i, k) = matrix(size - 1 - k, size - 1 - i);
  }
  return MatrixFamily(std::move(result));
}

}  // namespace

LocalLevels local_levels(const ParametricMask& mask, const Box& box, const Budget& budget) {
  require(mask.components() == 1, "levels: need a mask of numbers, got matrices of size {}", mask.components());
  require_levels(mask, box);
  require(std::ranges::all_of(mask.sizes(), [](std::size_t size) { return size <= 2; }) &&
              mask.denominators().entries.size() == 1,
          "levels: need coefficients of degree 1 in each letter, for a value at each point");
  const std::vector<Mask> corners = corners_of(mask, box);
  const int order = order_kept(corners);
  const Deadline end = budget.deadline.after(share_of_radius);
  MatrixFamily family = Choices(mask, corners, order).all();
  JointSpectralRadius radius = joint_spectral_radius(family, {end.after(share_of_columns), budget.memory});
  LocalLevels result{order, {}, std::move(family), false, std::move(radius)};
  if (!result.radius.is_closed() && !result.radius.exact.is_yes()) {
    // Norms and polytopes of the ones may be small where those of the others are large, or there are none.
    MatrixFamily other = reflected(result.family);
    JointSpectralRadius of_other = joint_spectral_radius(other, {end, budget.memory});
    if (of_other.proved_upper() < result.radius.proved_upper())
      result = {order, {}, std::move(other), true, std::move(of_other)};
  }
  const Rational lower = order - *log_ratio(*result.radius.radius.upper, mask.arity()).upper;
  if (lower > 0) result.exponent.lower = lower;
  result.exponent.upper = upper_end_of_levels(mask, box, budget);
  return result;
}

}  // namespace subcert
