
#include "limit_values.hpp"

#include "lattice_solutions.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/symbol/masks/matrix_masks.hpp>
#include <subcert/analysis/symbol/matrices/lifted_solution.hpp>
#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/polynomials/root_modulus.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/transition/transition.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace subcert {
namespace {

constexpr long max_integers = 1500;
constexpr long max_values = 10'000'000;
using limits::most_points;
constexpr int most_values = 1'000'000;  // in a LatticeSequence

/// The points of Z / scale in the closed support of phi, times scale.
IndexRange grid_in_support(const Mask& mask, long scale) {
  const Interval support = limit_support(mask);
  return {ceil_index(support.lower * scale), floor_index(support.upper * scale)};
}

void require_time(bool enough, int level) {
  if (!enough) fail(ErrorKind::undecided, "the exact values on level {} take more than the budget", level);
}

void require_few(double count, int level) {
  if (count > most_values)
    fail(ErrorKind::size, "limit_values: need at most {} values, got more at level {}", most_values, level);
}

/// The lattice points of the box that holds the support. Refuses levels on which their number is far too large.
std::vector<LatticePoint> points_of_support(const LatticeMask& mask, int level) {
  const std::vector<Interval> box = limit_support(mask);
  double count = 1, fine = std::pow(static_cast<double>(mask.dilation().classes()), level);
  LatticePoint low, high;
  for (const Interval& side : box) {
    low.push_back(ceil_index(side.lower));
    high.push_back(floor_index(side.upper));
    count *= static_cast<double>(high.back() - low.back() + 1);
    fine *= side.width().convert_to<double>();
  }
  if (count > static_cast<double>(most_points))
    fail(ErrorKind::size, "limit_values: need at most {} lattice points in the support, got {}", most_points, count);
  require_few(fine / 4, level);
  return points_of_box(low, high);
}

/// V(z) -> a(z) a(z^M) ... a(z^(M^(level-1))) V(z): values of a function at lattice points become those at M^-level i.
LatticeSequence refined(const LatticeMask& mask, LatticeSequence values, int level) {
  std::vector<LatticeMask::Term> terms = mask.terms();
  for (int n = 0; n < level; ++n) {
    LatticeSequence finer = convolution(terms, mask.components(), values);
    require_few(static_cast<double>(finer.size()), n + 1);
    std::erase_if(finer, [](const auto& entry) { return entry.second == 0; });
    values = std::move(finer);
    for (auto& term : terms) term.exponents = mask.dilation() * term.exponents;
  }
  return values;
}

/// C with D^orders[r] (f(M .)) = sum over c of C_{rc} (D^orders[c] f)(M .); `orders` are all of one sum.
RationalMatrix chain_rule(const Dilation& dilation, const std::vector<LatticePoint>& orders) {
  const std::size_t variables = dilation.variables();
  RationalMatrix result(orders.size(), orders.size());
  for (std::size_t row = 0; row < orders.size(); ++row) {
    // The derivative by x_v of f(M .) is the sum over r of M_{rv} D_r f.
    LatticeSequence product{{LatticePoint(variables, 0), 1}};
    for (std::size_t v = 0; v < variables; ++v)
      for (long order = 0; order < orders[row][v]; ++order) {
        LatticeSequence next;
        for (const auto& [exponents, value] : product)
          for (std::size_t r = 0; r < variables; ++r) {
            LatticePoint raised = exponents;
            ++raised[r];
            next[raised] += value * dilation.rows()[r][v];
          }
        product = std::move(next);
      }
    for (std::size_t column = 0; column < orders.size(); ++column) result(row, column) = product[orders[column]];
  }
  return result;
}

/// The polynomial p with simple zeros and p(C^-1) = 0. Domain: diagonalizable.
LaurentPolynomial annihilator_of_inverse(const RationalMatrix& matrix) {
  const LaurentPolynomial p = squarefree_part(characteristic_polynomial(matrix)).reversed();
  return p.shifted(-p.lowest());
}

/// v -> (sum over j of a_{Mk - j} v_j)_k on the window.
RationalMatrix operator_of_zero(const LatticeMask& mask, const LatticeWindow& window) {
  return transition_family(mask, window)[limits::digit_zero(mask.dilation())];
}

LatticeSequence on_points(const LatticeWindow& window, const std::vector<Rational>& values) {
  LatticeSequence result;
  for (std::size_t k = 0; k < window.size(); ++k)
    if (values[k] != 0) result.emplace(window.points()[k], values[k]);
  return result;
}

/// phi(k) = sum over j of a_{Mk - j} phi(j). Domain: 0 is a digit. The level is that of the values which are wanted in
/// the end.
LatticeSequence values_at_lattice_points(const LatticeMask& mask, int level) {
  const std::vector<LatticePoint> points = points_of_support(mask, level);
  if (mask.components() > 1) {
    std::vector<LatticeSequence> solutions = solutions_at_lattice_points(mask);
    require(solutions.size() == 1, "limit_values: need a refinement equation with one solution up to a factor, got {}",
            solutions.size());
    return normalised(std::move(solutions.front()));
  }
  const LatticeWindow window(mask, points, most_points, limits::digit_zero(mask.dilation()));
  const auto values = fixed_vector(operator_of_zero(mask, window));
  require(values.has_value(), "limit_values: need a scheme that converges, got several fixed vectors or none");
  return on_points(window, *values);
}

/// The values at lattice points that become those of the derivative at M^-level i by refinement.
LatticeSequence derivatives_at_lattice_points(const LatticeMask& mask, const LatticeSequence& values, int level,
                                              const LatticePoint& orders, long total) {
  const Dilation& dilation = mask.dilation();
  const std::vector<LatticePoint> all = exponents_of_degree(dilation.variables(), total);
  const RationalMatrix chain = chain_rule(dilation, all), chains = power(chain, level);
  const auto row = static_cast<std::size_t>(std::find(all.begin(), all.end(), orders) - all.begin());
  const std::vector<LatticeSequence> differences = differences_of_delta(dilation.variables(), static_cast<int>(total));
  LatticeSequence start;
  for (std::size_t c = 0; c < all.size(); ++c)
    for (const auto& [k, value] : convolution(differences[c], values)) start[k] += chains(row, c) * value;
  std::vector<LatticePoint> support;
  for (const auto& [point, value] : start) support.push_back(point);
  const auto window = LatticeWindow::closure(mask, support, most_points);
  std::vector<Rational> entries(window.size(), 0);
  for (const auto& [point, value] : start) entries[window.place(point)] = value;
  const RationalMatrix matrix = operator_of_zero(mask, window);
  const LaurentPolynomial p = annihilator_of_inverse(chain);
  RationalMatrix condition = p.coefficient(1) * matrix;  // p(matrix), without products where p is linear
  if (p.highest() > 1)
    condition = value_at(p, matrix);
  else
    for (std::size_t i = 0; i < condition.rows(); ++i) condition(i, i) += p.coefficient(0);
  const auto result = limits::component_in_kernel(condition, entries);
  require(result.has_value(),
          "limit_values: need limits with continuous derivatives of order {}, whose values the refinement equation "
          "determines",
          total);
  return on_points(window, *result);
}

/// Of the solution with these values at lattice points, or of the only one.
LatticeSequence values_of_whole(const LatticeMask& given, const LatticeSequence* known, int level,
                                const LatticePoint& orders) {
  const LatticeMask mask = given.with_dilation(Dilation(given.dilation().rows()));
  const long total = std::accumulate(orders.begin(), orders.end(), 0L);
  LatticeSequence values = known ? *known : values_at_lattice_points(mask, level);
  require(total == 0 || mask.dilation().is_isotropic(),
          "limit_values: need an isotropic dilation for derivatives, got {}", mask.dilation().to_text());
  if (total > 0) values = derivatives_at_lattice_points(mask, values, level, orders, total);
  return refined(mask, std::move(values), level);
}

LatticeSequence product_of_values(const std::vector<Mask>& factors, int level, const LatticePoint& orders) {
  LatticeSequence product{{{}, 1}};
  for (std::size_t v = 0; v < factors.size(); ++v) {
    const LimitValues factor = limit_values(factors[v], level, static_cast<int>(orders[v]));
    require_few(static_cast<double>(product.size() * factor.values.size()), level);
    LatticeSequence next;
    for (const auto& [point, value] : product)
      for (std::size_t i = 0; i < factor.values.size(); ++i)
        if (factor.values[i] != 0) {
          LatticePoint longer = point;
          longer.push_back(factor.first_index + static_cast<long>(i));
          next.emplace(std::move(longer), value * factor.values[i]);
        }
    product = std::move(next);
  }
  return product;
}

/// With an order for each variable, 0 unless given.
LatticePoint checked_orders(const LatticeMask& mask, int level, const LatticePoint& orders) {
  require(level >= 0, "limit_values: need level >= 0, got {}", level);
  const auto variables = static_cast<std::size_t>(mask.dimension());
  require(orders.empty() || orders.size() == variables, "limit_values: need an order for each of {} variables, got {}",
          variables, orders.size());
  for (const long order : orders) require(order >= 0, "limit_values: need orders >= 0, got {}", order);
  return orders.empty() ? LatticePoint(variables, 0) : orders;
}

}  // namespace

Rational LimitValues::at(long index) const {
  const long i = index - first_index;
  return i < 0 || i >= static_cast<long>(values.size()) ? Rational(0) : values[static_cast<std::size_t>(i)];
}

Rational LimitValues::point(std::size_t i) const {
  return Rational(first_index + static_cast<long>(i)) * power(Rational(arity), -level);
}

LimitValues limit_values(const Mask& mask, int level, int order, const Deadline& deadline) {
  require(level >= 0, "limit_values: need level >= 0, got {}", level);
  require(order >= 0, "limit_values: need order >= 0, got {}", order);
  long scale = 1;
  for (int k = 0; k < level; ++k) {
    scale *= mask.arity();
    if (mask.symbol().length() * scale > max_values)
      fail(ErrorKind::size, "limit_values: need at most 10^7 values, got level {} for a mask of length {}", level,
           mask.symbol().length());
  }
  const Mask derived = divided_difference_scheme(mask, order);
  // V_{k+1}(z) = a(z^(arity^k)) V_k(z), where V_k holds the values at level k.
  const ShiftedValues integers = limit_values_at(derived, 0, deadline);
  LaurentPolynomial values(integers.values, integers.first);
  long factor = 1;
  double seconds = 0;  // of the level before, of which a level takes the arity as many
  for (int k = 0; k < level; ++k, factor *= mask.arity()) {
    require_time(seconds * mask.arity() < deadline.remaining(), level);
    const Stopwatch watch;
    values *= derived.symbol().dilated(factor);
    seconds = watch.seconds();
  }
  // phi^(order) is the backward difference of that order, at unit steps, of the derived basic limit function.
  const LaurentPolynomial difference = LaurentPolynomial(1) - LaurentPolynomial::monomial(1, scale);
  values *= difference.pow(order);

  const auto [first, last] = grid_in_support(mask, scale);
  LimitValues result{mask.arity(), level, order, first,
                     std::vector<Rational>(static_cast<std::size_t>(last - first + 1), 0)};
  if (values.is_zero()) return result;
  for (long index = std::max(first, values.lowest()); index <= std::min(last, values.highest()); ++index) {
    require_time(!deadline.expired(), level);
    result.values[static_cast<std::size_t>(index - first)] = values.coefficient(index);
  }
  return result;
}

std::vector<Rational> point_at(const Dilation& dilation, const LatticePoint& index, int level) {
  std::vector<Rational> point(index.begin(), index.end());
  for (int n = 0; n < level; ++n) point = dilation.inverse_times(point);
  return point;
}

LatticeSequence limit_values(const LatticeMask& mask, int level, const LatticePoint& orders) {
  const LatticePoint all = checked_orders(mask, level, orders);
  return mask.has_factors() ? product_of_values(mask.factors(), level, all)
                            : values_of_whole(mask, nullptr, level, all);
}

LatticeSequence limit_values(const LatticeMask& mask, const LatticeSequence& values, int level,
                             const LatticePoint& orders) {
  return values_of_whole(mask, &values, level, checked_orders(mask, level, orders));
}

LatticeSequence refined_delta(const LatticeMask& mask, int level) {
  require(level >= 0, "refined_delta: need level >= 0, got {}", level);
  return refined(mask, {{LatticePoint(mask.dilation().variables(), 0), 1}}, level);
}

std::vector<Rational> l2_inner_products(const Mask& mask, const Deadline& deadline) {
  const LaurentPolynomial c = mask.symbol() * mask.symbol().reversed() * LaurentPolynomial(Rational(1, mask.arity()));
  const long last = (c.highest() - 1) / (mask.arity() - 1);  // continuous, so zero at the ends of the support
  if (last > max_integers)
    fail(ErrorKind::size, "l2_inner_products: need at most {} integers in half the support, got {}", max_integers,
         last);
  // w_k = sum over j of c_{arity*k - j} w_j, with w_{-j} = w_j, and the sum of all w_j is 1.
  auto products = fixed_vector(central_matrix(c, mask.arity(), last), 2, deadline);
  require(products.has_value(),
          "l2_inner_products: not determined by the refinement equation; the scheme does not converge");
  return std::move(*products);
}

Rational squared_l2_norm(const Mask& mask, const Deadline& deadline) {
  return l2_inner_products(mask, deadline).front();
}

namespace {

constexpr std::size_t longest_orbit = 64;
constexpr long most_integers = 1500;

Integer floor_of(const Rational& x) { return to_integer(x, Rounding::down); }

/// The integers k with x + k in the closed support.
IndexRange shifts(const Interval& support, const Rational& x) {
  return {-floor_of(x - support.lower).convert_to<long>(), floor_of(support.upper - x).convert_to<long>()};
}

/// phi(x + k) = sum over l of matrix(k, l) phi(y + l), where arity * x = m + y.
RationalMatrix step(const Mask& mask, const Interval& support, const Rational& x, const Rational& y) {
  const long m = numerator(Rational(mask.arity() * x - y)).convert_to<long>();
  return transition_block(mask.symbol(), mask.arity(), m, shifts(support, x), shifts(support, y));
}

}  // namespace

ShiftedValues limit_values_at(const Mask& mask, const Rational& x, const Deadline& deadline) {
  const Interval support = limit_support(mask);
  const IndexRange integers = shifts(support, 0);
  if (integers.last - integers.first >= most_integers)
    fail(ErrorKind::size, "limit_values: need at most {} integers in the support, got {}", most_integers,
         integers.last - integers.first + 1);
  std::vector<Rational> orbit{x - Rational(floor_of(x))};
  std::size_t cycle = 0;  // orbit[cycle], ... repeat
  for (;;) {
    const Rational scaled = mask.arity() * orbit.back();
    const Rational next = scaled - Rational(floor_of(scaled));
    const auto seen = std::find(orbit.begin(), orbit.end(), next);
    if (seen != orbit.end()) {
      cycle = static_cast<std::size_t>(seen - orbit.begin());
      break;
    }
    if (orbit.size() == longest_orbit)
      fail(ErrorKind::size, "limit_values: need a point with a cycle of at most {} points, got {}", longest_orbit,
           to_text(x));
    orbit.push_back(next);
  }
  const auto following = [&](std::size_t i) { return i + 1 < orbit.size() ? orbit[i + 1] : orbit[cycle]; };
  RationalMatrix product = step(mask, support, orbit[cycle], following(cycle));
  for (std::size_t i = cycle + 1; i < orbit.size(); ++i)
    product = product * step(mask, support, orbit[i], following(i));
  auto values = fixed_vector(std::move(product), 1, deadline);
  require(
      values.has_value(),
      "limit_values: the values are not determined by the refinement equation; the scheme, or the divided difference "
      "scheme of this order, does not converge");
  for (std::size_t i = cycle; i-- > 0;) *values = step(mask, support, orbit[i], orbit[i + 1]) * *values;
  return {shifts(support, orbit[0]).first - floor_of(x).convert_to<long>(), std::move(*values)};
}

namespace {

/// The solution with the sum of weights in place of the last equation, where that follows from the others.
std::optional<std::vector<Rational>> regular_solution(const RationalMatrix& matrix,
                                                      const std::vector<Rational>& weights, const Deadline& deadline) {
  const std::size_t last = matrix.rows() - 1;
  RationalMatrix regular = matrix;
  std::vector<Rational> right(matrix.rows(), 0);
  right[last] = 1;
  for (std::size_t j = 0; j <= last; ++j) regular(last, j) = weights[j];
  auto solution = lifted_solution(regular, right, deadline);
  if (!solution) return std::nullopt;
  Rational rest = 0;
  for (std::size_t j = 0; j <= last; ++j) rest += matrix(last, j) * (*solution)[j];
  return rest == 0 ? std::move(solution) : std::nullopt;
}

}  // namespace

std::optional<std::vector<Rational>> fixed_vector(RationalMatrix matrix, const std::vector<Rational>& weights,
                                                  const Deadline& deadline) {
  for (std::size_t i = 0; i < matrix.rows(); ++i) matrix(i, i) -= 1;
  if (matrix.rows() > 0)
    if (auto solution = regular_solution(matrix, weights, deadline)) return solution;
  if (deadline.expired())
    fail(ErrorKind::undecided, "the exact solution of {} refinement equations takes more than the budget",
         matrix.rows());
  auto basis = kernel(matrix);
  if (basis.size() != 1) return std::nullopt;
  std::vector<Rational> result = std::move(basis.front());
  Rational sum = 0;
  for (std::size_t i = 0; i < result.size(); ++i) sum += weights[i] * result[i];
  if (sum == 0) return std::nullopt;
  for (Rational& x : result) x /= sum;
  return result;
}

std::optional<std::vector<Rational>> fixed_vector(RationalMatrix matrix, const Rational& weight,
                                                  const Deadline& deadline) {
  std::vector<Rational> weights(matrix.rows(), weight);
  if (!weights.empty()) weights.front() = 1;
  return fixed_vector(std::move(matrix), weights, deadline);
}

}  // namespace subcert
