#include "gram_function.hpp"

#include <subcert/analysis/radii/joint/cost.hpp>
#include <subcert/analysis/radii/joint/modular_meataxe.hpp>

#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/symbol/masks/lattice_symmetry.hpp>
#include <subcert/analysis/symbol/masks/torus.hpp>
#include <subcert/analysis/symbol/polynomials/real_roots.hpp>
#include <subcert/analysis/symbol/polynomials/root_modulus.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <set>

namespace subcert {
namespace {

constexpr std::size_t most_gram_points = 1 << 16, most_orbits = 1200;

/// The operator (T g)_k = sum over l of c_{Mk - l} g_l, c the autocorrelation of the mask over |det M|, on sequences
/// that are constant on the orbits of a group of symmetries of c.
class TransferOperator {
 public:
  /// On a window that holds the support of every word of some length on sequences supported on `start`.
  TransferOperator(const LatticeMask& mask, const std::vector<LatticePoint>& start)
      : mask_(mask.symbol() * mask.symbol().reversed() *
                  MultivariatePolynomial(mask.dimension(), Rational(1, mask.dilation().classes())),
              Dilation(mask.dilation().rows())),
        group_(symmetries_along(lattice_symmetries(mask_.symbol()), mask_.dilation())),
        zero_(mask_.dilation().divide(LatticePoint(mask_.dilation().variables(), 0)).digit),
        window_(mask_, closed(start), most_gram_points, zero_) {
    for (std::size_t place = 0; place < window_.size(); ++place) {
      const LatticePoint first = representative(window_.points()[place]);
      const auto [at, inserted] = orbit_of_.emplace(first, orbits_.size());
      if (inserted) orbits_.emplace_back();
      orbits_[at->second].push_back(window_.points()[place]);
    }
    if (orbits_.size() > most_orbits)
      fail(ErrorKind::size, "transfer operator: need at most {} orbits of lattice points, got {}", most_orbits,
           orbits_.size());
  }

  std::size_t size() const { return orbits_.size(); }
  const std::vector<LatticePoint>& orbit(std::size_t index) const { return orbits_[index]; }

  /// On the values of the orbits; nothing past the deadline.
  std::optional<RationalMatrix> matrix(const Deadline& deadline) const {
    std::map<LatticePoint, Rational> coefficients;
    for (const auto& term : mask_.symbol().terms()) coefficients.emplace(term.exponents, term.coefficient);
    RationalMatrix result(size(), size());
    for (std::size_t row = 0; row < size(); ++row) {
      if (deadline.expired()) return std::nullopt;
      const LatticePoint image = mask_.dilation() * orbits_[row].front();
      for (const auto& [exponents, coefficient] : coefficients)
        if (const auto column = orbit_of_.find(representative(image - exponents)); column != orbit_of_.end())
          result(row, column->second) += coefficient;
    }
    return result;
  }

  /// The images of the unit vectors under the symmetries.
  std::set<LatticePoint> unit_directions() const {
    std::set<LatticePoint> result;
    for (const LatticePoint& unit : exponents_of_degree(mask_.dilation().variables(), 1))
      for (const LatticeMap& map : group_) result.insert(map(unit));
    return result;
  }
  /// The values on the orbits of T^n g, for the least n that leads sequences on `start` into the window. Domain: g
  /// constant on orbits.
  std::vector<Rational> led_in(LatticeSequence g) const {
    for (int step = 0; step < window_.steps(); ++step) g = transitions(mask_, g)[zero_];
    std::vector<Rational> result(size());
    for (std::size_t k = 0; k < size(); ++k)
      if (const auto at = g.find(orbits_[k].front()); at != g.end()) result[k] = at->second;
    return result;
  }

 private:
  LatticePoint representative(const LatticePoint& point) const {
    LatticePoint result = point;
    for (const LatticeMap& map : group_) result = std::max(result, map(point));
    return result;
  }
  std::vector<LatticePoint> closed(const std::vector<LatticePoint>& start) const {
    std::vector<LatticePoint> result;
    for (const LatticePoint& point : start)
      for (const LatticeMap& map : group_) result.push_back(map(point));
    return result;
  }

  LatticeMask mask_;  // c
  std::vector<LatticeMap> group_;
  std::size_t zero_;  // the digit
  LatticeWindow window_;
  std::map<LatticePoint, std::size_t> orbit_of_;  // by representative
  std::vector<std::vector<LatticePoint>> orbits_;
};

/// -log radius / 2 to the base by which the dilation expands.
MultivariateSobolev sobolev_of(const Enclosure& radius, const Dilation& dilation, std::size_t dimension) {
  const int classes = static_cast<int>(dilation.classes());
  const Rational factor(-static_cast<long>(dilation.variables()), 2);
  return {radius,
          {factor * *log_ratio(*radius.upper, classes).upper, factor * *log_ratio(*radius.lower, classes).lower},
          dimension};
}

LatticeSequence integral_multiple(LatticeSequence sequence) {
  std::vector<Rational> values;
  for (const auto& [point, value] : sequence) values.push_back(value);
  std::size_t next = 0;
  const std::vector<Integer> multiples = radius::primitive(values);
  for (auto& [point, value] : sequence) value = multiples[next++];
  return sequence;
}

/// The sum over the directions e of 2 - z^e - z^-e, times g.
LatticeSequence second_differences(const LatticeSequence& g, const std::set<LatticePoint>& directions) {
  LatticeSequence result;
  for (const auto& [point, value] : g)
    for (const LatticePoint& direction : directions) {
      result[point] += 2 * value;
      result[point + direction] -= value;
      result[point - direction] -= value;
    }
  std::erase_if(result, [](const auto& entry) { return entry.second == 0; });
  return result;
}

/// Whether p(matrix) x = 0, in integers; false past the deadline. Domain: integer coefficients.
bool annihilates(const LaurentPolynomial& p, const RationalMatrix& matrix, const std::vector<Integer>& x,
                 const Deadline& deadline) {
  const std::size_t n = x.size();
  const Integer scale = common_denominator(matrix);
  const std::vector<Integer> entries = integer_multiple(matrix, scale);
  std::vector<Integer> value(n);
  Integer power = 1;
  for (long k = p.highest(); k >= 0; --k, power *= scale) {
    if (deadline.expired()) return false;
    std::vector<Integer> next(n);
    const Integer factor = numerator(p.coefficient(k)) * power;
    for (std::size_t i = 0; i < n; ++i) {
      add_product(next[i], factor, x[i]);
      for (std::size_t j = 0; j < n; ++j) add_product(next[i], entries[i * n + j], value[j]);
    }
    value = std::move(next);
  }
  return std::all_of(value.begin(), value.end(), [](const Integer& entry) { return entry.is_zero(); });
}

/// The polynomial of least degree with p(matrix) x = 0: the shortest divisor of the characteristic polynomial that does
/// so modulo a prime, confirmed over the rationals. (A shorter one than that would be shorter modulo the prime as
/// well.)
std::optional<LaurentPolynomial> minimal_polynomial(const RationalMatrix& matrix, const std::vector<Rational>& x,
                                                    const Deadline& deadline) {
  const auto modular = radius::modulo_prime(MatrixFamily{matrix});
  const auto characteristic = characteristic_polynomial(matrix, deadline);
  if (!modular || !characteristic) return std::nullopt;
  const std::vector<Integer> integral = radius::primitive(x);
  const radius::ModVector start = radius::modulo_prime(integral);
  std::vector<PolynomialFactor> factors = irreducible_factors(*characteristic);
  const auto product_of = [&factors] {
    LaurentPolynomial product = 1;
    for (const PolynomialFactor& factor : factors) product *= factor.polynomial.pow(factor.multiplicity);
    return product;
  };
  for (PolynomialFactor& factor : factors)
    for (bool vanishes = true; vanishes && factor.multiplicity > 0;) {
      --factor.multiplicity;
      const radius::ModVector value = radius::value_times(product_of(), modular->front(), start);
      vanishes = std::all_of(value.begin(), value.end(), [](ulong entry) { return entry == 0; });
      if (!vanishes) ++factor.multiplicity;
    }
  LaurentPolynomial result = product_of();
  return annihilates(result, matrix, integral, deadline) ? std::optional(std::move(result)) : std::nullopt;
}

/// Rows: sums over the orbits of the monomials of even degree below `order`; the others vanish by symmetry.
RationalMatrix even_moments(const TransferOperator& transfer, std::size_t variables, int order) {
  std::vector<LatticePoint> monomials;
  for (int degree = 0; degree < order; degree += 2)
    for (LatticePoint& exponents : exponents_of_degree(variables, degree)) monomials.push_back(std::move(exponents));
  RationalMatrix result(monomials.size(), transfer.size());
  for (std::size_t i = 0; i < monomials.size(); ++i)
    for (std::size_t k = 0; k < transfer.size(); ++k)
      for (const LatticePoint& point : transfer.orbit(k))
        result(i, k) += monomial_at({point.begin(), point.end()}, monomials[i]);
  return result;
}

}  // namespace

std::optional<LatticeSequence> gram_function(const LatticeMask& mask, const Deadline& deadline) {
  const std::size_t variables = mask.dilation().variables();
  const TransferOperator transfer(mask, {LatticePoint(variables, 0)});
  auto system = transfer.matrix(deadline);
  if (!system || !radius::has_time_for_elimination(*system, deadline)) return std::nullopt;
  std::vector<Rational> sizes;
  for (std::size_t k = 0; k < transfer.size(); ++k) sizes.emplace_back(static_cast<long>(transfer.orbit(k).size()));
  const auto values = fixed_vector(std::move(*system), sizes);
  if (!values) return std::nullopt;
  LatticeSequence gram;
  for (std::size_t k = 0; k < transfer.size(); ++k)
    for (const LatticePoint& point : transfer.orbit(k))
      if ((*values)[k] != 0) gram.emplace(point, (*values)[k]);
  return gram;
}

Decision has_stable_shifts(const LatticeSequence& gram, const Budget& budget) {
  std::vector<MultivariatePolynomial::Monomial> terms;
  for (const auto& [point, value] : gram) terms.push_back({value, point});
  const MultivariatePolynomial bracket(static_cast<int>(gram.begin()->first.size()), terms);
  if (const auto zero = zero_on_torus(bracket))
    return {Truth::no, "the sum of <phi, phi(. - k)> e^(ikx) vanishes at x = " + *zero};
  Decision positive = is_positive_on_torus(bracket, budget);
  if (positive.is_yes()) positive.reason = "the sum of <phi, phi(. - k)> e^(ikx) is positive: " + positive.reason;
  return positive;
}

std::optional<MultivariateSobolev> sobolev_regularity(const LatticeMask& mask, int sum_rules,
                                                      const Deadline& deadline) {
  const Dilation& dilation = mask.dilation();
  require(sum_rules >= 1, "sobolev_regularity: need at least one sum rule, got {}", sum_rules);
  require(dilation.is_isotropic(), "sobolev_regularity: need an isotropic dilation, got {}", dilation.to_text());
  const std::size_t variables = dilation.variables();
  // The support of (sum over v of 2 - z_v - 1/z_v)^sum_rules.
  std::vector<LatticePoint> start;
  for (const LatticePoint& point : exponents_up_to(variables, sum_rules))
    for (unsigned signs = 0; signs < 1U << variables; ++signs) {
      start.push_back(point);
      for (std::size_t v = 0; v < variables; ++v)
        if (signs >> v & 1) start.back()[v] = -point[v];
    }
  const TransferOperator transfer(mask, start);
  const auto whole = transfer.matrix(deadline);
  if (!whole) return std::nullopt;
  const auto basis = kernel(even_moments(transfer, variables, 2 * sum_rules));
  if (basis.empty() || !radius::has_time_for_elimination(*whole, deadline)) return std::nullopt;
  const std::vector<std::size_t> pivots = free_columns(basis);
  RationalMatrix matrix(basis.size(), basis.size());
  for (std::size_t c = 0; c < basis.size(); ++c) {
    const std::vector<Rational> image = *whole * basis[c];
    for (std::size_t r = 0; r < basis.size(); ++r) matrix(r, c) = image[pivots[r]];
  }
  const auto characteristic = characteristic_polynomial(matrix, deadline);
  if (!characteristic || !radius::has_time_for_roots(*characteristic, deadline)) return std::nullopt;
  return sobolev_of(largest_root_modulus(*characteristic).largest, dilation, basis.size());
}

std::optional<MultivariateSobolev> sobolev_regularity(const LatticeMask& mask, const LatticeSequence& gram,
                                                      const Deadline& deadline) {
  constexpr int largest_order = 32;
  const Rational slack = power(Rational(10), -9);
  const auto directions = TransferOperator(mask, {LatticePoint(mask.dilation().variables(), 0)}).unit_directions();
  LatticeSequence differences = integral_multiple(gram);  // huge denominators would cost common divisors
  for (int order = 1; order <= largest_order; ++order) {
    differences = second_differences(differences, directions);
    std::vector<LatticePoint> start;
    for (const auto& [point, value] : differences) start.push_back(point);
    const TransferOperator transfer(mask, start);
    const auto matrix = transfer.matrix(deadline);
    if (!matrix || !radius::has_time_for_elimination(*matrix, deadline)) return std::nullopt;
    const auto polynomial = minimal_polynomial(*matrix, transfer.led_in(differences), deadline);
    if (!polynomial || !radius::has_time_for_roots(*polynomial, deadline)) return std::nullopt;
    MultivariateSobolev found = sobolev_of(largest_root_modulus(*polynomial).largest, mask.dilation(),
                                           static_cast<std::size_t>(polynomial->highest()));
    // Differences of order m say nothing about exponents from m on.
    if (*found.exponent.upper < order - slack) return found;
  }
  return std::nullopt;
}

}  // namespace subcert
