#include "scheme_convergence.hpp"

#include "value_space.hpp"
#include "vector_operators.hpp"

#include <subcert/analysis/radii/schedule.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace subcert {
namespace {

using namespace vectors;

void add(LatticeSequence& to, const Rational& factor, const LatticeSequence& x) {
  for (const auto& [point, value] : x) to[point] += factor * value;
  std::erase_if(to, [](const auto& entry) { return entry.second == 0; });
}

/// factor * a - b.
LatticeSequence combination(const Rational& factor, const LatticeSequence& a, const LatticeSequence& b) {
  LatticeSequence result;
  add(result, factor, a);
  add(result, -1, b);
  return result;
}

/// The functional that reads one number of the datum at 0.
LatticeSequence reading(const LatticeMask& mask, std::size_t component) {
  LatticePoint point(mask.dilation().variables(), 0);
  if (mask.components() > 1) point.push_back(static_cast<long>(component));
  return {{std::move(point), 1}};
}

/// What has to vanish in the limit, with data of the next level times `factor`: how this number differs from its
/// neighbours, and from those that it is refined to.
void add_differences(std::vector<LatticeSequence>& to, const LatticeMask& mask, std::size_t component,
                     const Rational& factor) {
  const LatticeSequence x = reading(mask, component);
  for (const LatticeSequence& difference : differences_of_delta(mask.dilation().variables(), 1))
    to.push_back(convolution(difference, x));
  for (const LatticeSequence& next : transitions(mask, x)) to.push_back(combination(factor, next, x));
}

/// Sequences that long words make small, if `contract` is yes: the space that they span, absent where it is 0.
struct Shrinking {
  Decision contract;
  std::optional<DifferenceSpace> space = std::nullopt;
};

/// Whether the products of the operators, times `factor` each, tend to 0 on what the sequences lead to.
Decision contracts(const DifferenceSpace& space, const Parts& parts, const Rational& factor, const Budget& budget) {
  const Rational bound = 1 / factor;
  const Operators operators = operators_of(space, parts);
  const NormProof norms = norms_of(on_functions(operators, parts.root),
                                   {budget.deadline.after(schedule::vector::norms), budget.memory});
  if (norms.norm < power(bound, norms.level))
    return {Truth::yes, fmt::format("products of {} matrices are small", norms.level)};
  const Rational target = bound * (1 - power(Rational(2), -20));
  const JointSpectralRadius radius = radius_of(operators, parts.root, budget, norms, target);
  if (radius.radius.upper && *radius.radius.upper < bound) return {Truth::yes, "their joint spectral radius is small"};
  if (radius.radius.lower && *radius.radius.lower >= bound)
    return {Truth::no, fmt::format("by the product {}", fmt::join(radius.product.word, ""))};
  return {Truth::unknown, "not decided within the budget"};
}

Shrinking shrinking(const Parts& parts, const std::vector<LatticeSequence>& starts, const Rational& factor,
                    const Budget& budget) {
  try {
    auto space = space_of_long_words(parts.mask, starts, 1);
    if (!space)
      return vanish_under_long_words(parts.mask, starts)
                 ? Shrinking{{Truth::yes, "they vanish"}}
                 : Shrinking{{Truth::unknown, "its differences span no space that is found"}};
    if (space->family.size() > largest_space)
      return {{Truth::unknown, fmt::format("its differences span a space of dimension {}", space->family.size())}};
    Decision contract = contracts(*space, parts, factor, budget);
    return {std::move(contract), std::move(space)};
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::size) throw;
    return {{Truth::unknown, error.what()}};
  }
}

/// A basis of the y for which the sums of P_k y over every class are y, so that the data y, y, ... are kept.
std::vector<std::vector<Rational>> kept_constants(const Parts& parts) {
  const LatticeMask& mask = parts.mask;
  const std::size_t size = mask.components();
  RationalMatrix equations(size * static_cast<std::size_t>(mask.dilation().classes()), size);
  for (const LatticeMask::Term& term : mask.terms())
    equations(mask.dilation().divide(term.exponents).digit * size + term.column, term.row) += term.coefficient;
  for (std::size_t i = 0; i < equations.rows(); ++i) equations(i, i % size) -= 1;
  std::vector<std::vector<Rational>> kept = kernel(equations);
  if (kept.empty() || parts.root == 0) return kept;
  for (std::vector<Rational>& y : kept)  // of the transposed doubled matrices, q and then p
    std::rotate(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(size / 2), y.end());
  return basis_over_field(kept, parts.root);
}

std::vector<LatticeSequence> all_differences(const LatticeMask& mask) {
  std::vector<LatticeSequence> result;
  for (std::size_t c = 0; c < mask.components(); ++c) add_differences(result, mask, c, 1);
  return result;
}

Decision parts_converge(const Parts& parts, const Budget& budget) {
  if (kept_constants(parts).empty())
    return {Truth::no, "no vector but 0 is kept by the sums of the P_k over all classes, so limits could only be 0"};
  Decision found = shrinking(parts, all_differences(parts.mask), 1, budget).contract;
  if (found.is_yes()) return {Truth::yes, "the differences of its data shrink: " + found.reason};
  if (found.is_no()) return {Truth::no, "the differences of its data do not shrink: " + found.reason};
  return found;
}

/// The sum of weights[d] T_d, of which the powers on a sequence have a limit.
struct WeightedSum {
  const LatticeMask& mask;
  const std::vector<Rational>& weights;

  LatticeSequence operator()(const LatticeSequence& x) const {
    LatticeSequence result;
    const std::vector<LatticeSequence> moved = transitions(mask, x);
    for (std::size_t d = 0; d < moved.size(); ++d) add(result, weights[d], moved[d]);
    return result;
  }
  /// 1 - this, on the space.
  RationalMatrix rest_on(const DifferenceSpace& space) const {
    RationalMatrix result = RationalMatrix::identity(space.basis.size());
    for (std::size_t d = 0; d < weights.size(); ++d)
      for (std::size_t i = 0; i < result.rows(); ++i)
        for (std::size_t j = 0; j < result.rows(); ++j) result(i, j) -= weights[d] * space.family[d](i, j);
    return result;
  }
};

/// The coordinates of x; nothing where it is not in the space.
std::optional<RationalMatrix> coordinates(const DifferenceSpace& space, LatticeSequence x) {
  RationalMatrix result(space.basis.size(), 1);
  for (std::size_t c = 0; c < space.basis.size(); ++c)
    if (const auto at = x.find(space.pivots[c]); at != x.end()) result(c, 0) = at->second;
  for (std::size_t c = 0; c < space.basis.size(); ++c) add(x, -result(c, 0), space.basis[c]);
  return x.empty() ? std::optional(std::move(result)) : std::nullopt;
}

/// The limit of its powers on x. Domain: long words lead what it changes x by into the space, where its powers tend to
/// 0. Nothing where these words are too long.
std::optional<LatticeSequence> limit_of_powers(const WeightedSum& sum, const std::optional<DifferenceSpace>& space,
                                               LatticeSequence x) {
  constexpr int most_steps = 64;
  for (int step = 0; step < most_steps; ++step) {
    LatticeSequence next = sum(x);
    const LatticeSequence change = combination(1, next, x);
    if (change.empty()) return x;
    if (const auto known = space ? coordinates(*space, change) : std::nullopt) {
      // x + change + sum(change) + ...
      const RationalMatrix rest = solve(sum.rest_on(*space), *known);
      for (std::size_t c = 0; c < space->basis.size(); ++c) add(x, rest(c, 0), space->basis[c]);
      return x;
    }
    x = std::move(next);
  }
  return std::nullopt;
}

/// The values at the integers of the limits of derivative k from the unit data, and their integrals between these.
struct Limits {
  LatticeSequence values, integrals;
};

std::optional<Limits> limits_of(const LatticeMask& mask, std::size_t derivative,
                                const std::optional<DifferenceSpace>& space) {
  const auto arity = static_cast<std::size_t>(mask.arity());
  const Rational factor = power(Rational(mask.arity()), static_cast<long>(derivative));
  std::vector<Rational> at_zero(arity, 0);
  at_zero[0] = factor;
  const std::vector<Rational> mean(arity, factor / mask.arity());
  auto values = limit_of_powers({mask, at_zero}, space, reading(mask, derivative));
  auto integrals = limit_of_powers({mask, mean}, space, reading(mask, derivative));
  if (!values || !integrals) return std::nullopt;
  return Limits{*std::move(values), *std::move(integrals)};
}

/// Whether each limit is the derivative of the one before, and the first is not 0.
Decision are_derivatives(const std::vector<Limits>& limits) {
  if (limits.front().values.empty()) return {Truth::no, "all limits are 0"};
  const LatticeSequence from_left_to_right{{{-1}, 1}, {{0}, -1}};
  for (std::size_t k = 0; k + 1 < limits.size(); ++k)
    if (convolution(from_left_to_right, limits[k].values) != limits[k + 1].integrals)
      return {Truth::no, fmt::format("limit {} is not the derivative of limit {}", k + 1, k)};
  return {Truth::yes, limits.size() == 2 ? "with the derivative"
                                         : fmt::format("with the derivatives up to order {}", limits.size() - 1)};
}

}  // namespace

Decision vector_scheme_converges(const LatticeMask& mask, const Budget& budget) {
  return parts_converge({mask}, budget);
}

Decision vector_scheme_converges(const QuadraticMask& mask, const Budget& budget) {
  return parts_converge({mask.doubled, mask.root}, budget);
}

namespace {

SchemeDifferences differences_of_parts(const Parts& parts, const Budget& budget) {
  SchemeDifferences result{kept_constants(parts)};
  if (result.kept.empty()) return result;
  result.space = space_of_long_words(parts.mask, all_differences(parts.mask), 1);
  const std::size_t size = result.space ? result.space->family.size() : 0;
  require(size > 0 && size <= largest_space,
          "scheme: need differences that span a space of dimension 1 to {}, got {} (0 where none is found)",
          largest_space, size);
  const Operators operators = operators_of(*result.space, parts);
  const NormProof norms = norms_of(on_functions(operators, parts.root),
                                   {budget.deadline.after(schedule::vector::norms), budget.memory});
  result.radius = radius_of(operators, parts.root, budget, norms, 1 - power(Rational(2), -20));
  return result;
}

}  // namespace

SchemeDifferences scheme_differences(const LatticeMask& mask, const Budget& budget) {
  return differences_of_parts({mask}, budget);
}

SchemeDifferences scheme_differences(const QuadraticMask& mask, const Budget& budget) {
  return differences_of_parts({mask.doubled, mask.root}, budget);
}

namespace {

/// Limits over a field are numbers x + sqrt(root) y: the sums that they are, and so what is solved for, are of the
/// matrices over the field, and equal numbers have equal parts.
Decision hermite_parts_converge(const LatticeMask& mask, long root, const Budget& budget) {
  require(mask.dimension() == 1, "hermite_scheme_converges: need one variable, got {}", mask.dimension());
  const LatticeMask same = mask.with_dilation(with_zero_first(mask.dilation()));
  const Parts parts{same, root};
  Decision open{Truth::yes, ""};
  std::vector<Limits> limits;
  for (std::size_t k = 0; k < parts.components(); ++k) {
    const Rational factor = power(Rational(mask.arity()), static_cast<long>(k));
    std::vector<LatticeSequence> starts;
    for (const std::size_t part : parts.parts_of(k)) add_differences(starts, same, part, factor);
    const Shrinking found = shrinking(
        parts, starts, factor,
        {budget.deadline.after(1.0 / static_cast<double>(parts.components() - k)), budget.memory});
    if (found.contract.is_no())
      return {Truth::no, fmt::format("the data of derivative {} do not converge: {}", k, found.contract.reason)};
    if (!found.contract.is_yes() && open.is_yes())
      open = {Truth::unknown, fmt::format("derivative {}: {}", k, found.contract.reason)};
    if (!open.is_yes()) continue;
    auto known = limits_of(same, k, found.space);
    if (known)
      limits.push_back(*std::move(known));
    else
      open = {Truth::unknown, "its limits at the integers were not found"};
  }
  return open.is_yes() ? are_derivatives(limits) : open;
}

}  // namespace

Decision hermite_scheme_converges(const LatticeMask& mask, const Budget& budget) {
  return hermite_parts_converge(mask, 0, budget);
}

Decision hermite_scheme_converges(const QuadraticMask& mask, const Budget& budget) {
  return hermite_parts_converge(mask.doubled, mask.root, budget);
}

HermiteOrder hermite_order(const MultivariateRegularity& found, const Decision& converges, std::size_t data) {
  const int least = static_cast<int>(data) - 1;
  if (!converges.is_yes()) return {-1, {converges.is_no() ? Truth::no : Truth::unknown, converges.reason}};
  HermiteOrder result{least, {Truth::unknown, "the exponent of the limits is not known"}};
  if (!found.exponent.lower) return result;
  const Enclosure& exponent = found.exponent;
  while (*exponent.lower > result.order + 1) ++result.order;
  if (exponent.upper && *exponent.upper <= result.order + 1)
    result.next = {Truth::no, fmt::format("the exponent is at most {}", result.order + 1)};
  return result;
}

}  // namespace subcert
