#include "multivariate_regularity.hpp"
#include "value_space.hpp"
#include "vector_operators.hpp"

#include <subcert/analysis/limit/field_values.hpp>
#include <subcert/analysis/radii/joint/modular_meataxe.hpp>
#include <subcert/analysis/radii/schedule.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <cmath>

namespace subcert {
namespace {

using namespace vectors;

constexpr int most_orders = 24;  // of differences

using Doubles = std::vector<double>;  // row by row

Doubles doubles(const RationalMatrix& matrix) {
  Doubles result;
  for (std::size_t i = 0; i < matrix.rows(); ++i)
    for (std::size_t j = 0; j < matrix.columns(); ++j) result.push_back(matrix(i, j).convert_to<double>());
  return result;
}

/// sum + a x a^T, for matrices of n rows.
void add_congruent(Doubles& sum, const Doubles& a, const Doubles& x, std::size_t n) {
  Doubles product(n * n, 0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k)
      if (const double factor = a[i * n + k]; factor != 0)
        for (std::size_t j = 0; j < n; ++j) product[i * n + j] += factor * x[k * n + j];
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t k = 0; k < n; ++k) sum[i * n + j] += product[i * n + k] * a[j * n + k];
}

/// About the exponent in the mean of squares, which is at least that in the maximum: only to choose the order of the
/// differences by. Polynomials make it at most that order.
double rough_exponent(const MatrixFamily& family, std::size_t dimension) {
  constexpr int rounds = 40, last = 10;
  const std::size_t n = family.size();
  std::vector<Doubles> matrices;
  for (const RationalMatrix& matrix : family) matrices.push_back(doubles(matrix));
  Doubles x(n * n, 0);
  for (std::size_t i = 0; i < n; ++i) x[i * n + i] = 1;
  double growth = 0;  // logarithm of that in the last rounds
  for (int round = 0; round < rounds; ++round) {
    Doubles next(n * n, 0);
    for (const Doubles& a : matrices) add_congruent(next, a, x, n);
    double trace = 0, before = 0;
    for (std::size_t i = 0; i < n; ++i) {
      trace += next[i * n + i];
      before += x[i * n + i];
    }
    if (!(trace > 0) || !std::isfinite(trace)) return most_orders;
    if (round >= rounds - last) growth += std::log(trace / before) / last;
    for (double& entry : next) entry /= trace;
    x = std::move(next);
  }
  const double classes = std::log(static_cast<double>(family.count()));
  return -(growth - classes) / 2 / (classes / static_cast<double>(dimension));
}

/// The differences of the least order that is above the exponent, as far as can be told before it is known.
std::optional<DifferenceSpace> space_above_exponent(const Parts& parts, const std::vector<LatticeSequence>& solutions,
                                                    const Deadline& deadline) {
  const LatticeMask& mask = parts.mask;
  constexpr double clear = 1e-3;
  std::optional<DifferenceSpace> result;
  for (int order = 1; order <= most_orders; ++order) {
    auto space = value_space(mask, solutions, order);
    if (!space || space->family.size() > largest_space) break;
    result = std::move(space);
    const RealFamily family = on_functions(operators_of(*result, parts), parts.root);
    if (rough_exponent(family.matrices, mask.dilation().variables()) < order - clear || deadline.expired()) break;
  }
  return result;
}

/// What a family on a space of differences of this order tells of the exponent.
struct Told {
  Enclosure exponent;
  JointSpectralRadius radius;
  NormProof norms;
};
Told exponent_of(const Operators& operators, long number, int order, const Dilation& dilation, const Budget& budget,
                 int bits) {
  Told result;
  result.norms = norms_of(on_functions(operators, number),
                          {budget.deadline.after(schedule::vector::norms), budget.memory});
  result.radius = radius_of(operators, number, budget, result.norms);
  if (!operators.root) sharpen(result.radius, operators.family, bits + bits_of_powers, budget.deadline);
  result.exponent = exponent_of_radius(result.radius.radius, dilation.classes(), dilation.variables(),
                                       bits + bits_of_powers);
  // Differences of an order say nothing about exponents from that order on.
  if (result.exponent.upper && *result.exponent.upper >= order) result.exponent.upper.reset();
  if (result.exponent.lower && *result.exponent.lower > order) result.exponent.lower = order;
  return result;
}

/// A space modulo its largest invariant subspace of sequences whose component is 0.
struct Observed {
  std::vector<RationalMatrix> operators;  // in the coordinates that the rows are; none where the component is 0
  std::vector<radius::Vector> rows;       // a reduced basis of the span of all functionals u -> (T_w u)_k
};

/// Nothing where its numbers are not recognised modulo a prime.
std::optional<Observed> observed(const DifferenceSpace& space, const Parts& parts, std::size_t component) {
  const std::vector<RationalMatrix> all = operators_of(space, parts).matrices();
  const MatrixFamily family = transposed(MatrixFamily(all));
  const std::vector<std::size_t> rational = parts.parts_of(component);
  std::map<LatticePoint, radius::Vector> functionals;
  for (std::size_t k = 0; k < space.basis.size(); ++k)
    for (const auto& [point, value] : space.basis[k])
      if (std::ranges::find(rational, static_cast<std::size_t>(point.back())) != rational.end())
        functionals.try_emplace(point, space.basis.size(), 0).first->second[k] = value;
  if (functionals.empty()) return Observed{};
  const auto modular = radius::modulo_prime(family);
  if (!modular) return std::nullopt;
  std::vector<radius::ModVector> starts;
  for (const auto& [point, functional] : functionals)
    starts.push_back(radius::modulo_prime(radius::primitive(functional)));
  const auto rows = span_of_words(*modular, starts).recognised();
  if (!rows) return std::nullopt;
  if (rows->size() == space.basis.size()) return Observed{all, *rows};
  // The rows are reduced: what a vector of their span has in the first columns of rows are its coordinates.
  std::vector<std::size_t> pivots;
  for (const radius::Vector& row : *rows)
    pivots.push_back(
        static_cast<std::size_t>(std::ranges::find_if(row, [](const Rational& x) { return x != 0; }) - row.begin()));
  const auto coordinates = [&](radius::Vector x) -> std::optional<radius::Vector> {
    radius::Vector result;
    for (std::size_t r = 0; r < rows->size(); ++r) {
      const Rational factor = x[pivots[r]] / (*rows)[r][pivots[r]];
      result.push_back(factor);
      if (factor != 0)
        for (std::size_t k = 0; k < x.size(); ++k) x[k] -= factor * (*rows)[r][k];
    }
    const bool inside = std::ranges::all_of(x, [](const Rational& entry) { return entry == 0; });
    return inside ? std::optional(std::move(result)) : std::nullopt;
  };
  for (const auto& [point, functional] : functionals)
    if (!coordinates(functional)) return std::nullopt;
  Observed result{{}, *rows};
  for (const RationalMatrix& matrix : family) {
    RationalMatrix& restricted = result.operators.emplace_back(rows->size(), rows->size());
    for (std::size_t r = 0; r < rows->size(); ++r) {
      const auto image = coordinates(matrix * (*rows)[r]);
      if (!image) return std::nullopt;
      for (std::size_t j = 0; j < rows->size(); ++j) restricted(r, j) = (*image)[j];
    }
  }
  return result;
}

/// A proof by diagonal blocks, of which there may be one.
BlockProof in_blocks(const MatrixFamily& family, const JointSpectralRadius& radius) {
  if (const BlockProof* blocks = radius.by_blocks()) return *blocks;
  return {{{family.size()}, RationalMatrix::identity(family.size()), family.matrices(), {{}}}, {radius}, 0};
}

/// That of a subspace and that of the rest, in a basis for these operators of which the first columns are the subspace.
BlockProof joined(const Operators& operators, const RationalMatrix& basis, const BlockProof& first,
                  const BlockProof& rest) {
  BlockProof result = first;
  RationalMatrix change(basis.rows(), basis.rows());
  std::size_t start = 0;
  for (const BlockProof* one : {&first, &rest}) {
    const RationalMatrix& own = one->triangular.basis;
    for (std::size_t i = 0; i < own.rows(); ++i)
      for (std::size_t k = 0; k < own.rows(); ++k) change(start + i, start + k) = own(i, k);
    start += own.rows();
  }
  BlockTriangular& triangular = result.triangular;
  triangular.sizes.insert(triangular.sizes.end(), rest.triangular.sizes.begin(), rest.triangular.sizes.end());
  triangular.irreducible.insert(triangular.irreducible.end(), rest.triangular.irreducible.begin(),
                                rest.triangular.irreducible.end());
  triangular.groups.clear();
  triangular.basis = operators.root ? with_root_columns(basis * change, *operators.root) : basis * change;
  triangular.triangular.clear();
  if (!operators.root)
    for (const RationalMatrix& matrix : operators.family)
      triangular.triangular.push_back(solve(triangular.basis, matrix * triangular.basis));
  result.blocks.insert(result.blocks.end(), rest.blocks.begin(), rest.blocks.end());
  result.leading = first.blocks.size() + rest.leading;
  return result;
}

/// `quotient`: the radius on what is observed. Nothing where that of the rest is not proved to be below 1.
std::optional<ComponentProof> component_proof(const DifferenceSpace& space, const Parts& parts, const Observed& seen,
                                              const JointSpectralRadius& quotient, const Budget& budget) {
  const std::size_t size = space.family.size(), observable = seen.rows.size(), unobservable = size - observable;
  if (unobservable == 0) return ComponentProof{space, 0, quotient};
  // The kernel of the rows, and a vector for each row on which it is 1 and the others 0.
  RationalMatrix rows(observable, size), basis(size, size);
  for (std::size_t r = 0; r < observable; ++r)
    for (std::size_t k = 0; k < size; ++k) rows(r, k) = seen.rows[r][k];
  const auto unseen = kernel(rows);
  for (std::size_t c = 0; c < unobservable; ++c)
    for (std::size_t k = 0; k < size; ++k) basis(k, c) = unseen[c][k];
  const std::vector<std::size_t> pivots = pivot_columns(rows);
  for (std::size_t r = 0; r < observable; ++r) basis(pivots[r], unobservable + r) = 1 / rows(r, pivots[r]);
  const Operators operators = operators_of(space, parts);
  std::vector<RationalMatrix> first;
  for (const RationalMatrix& matrix : operators.matrices()) {
    const RationalMatrix image = solve(basis, matrix * basis);
    RationalMatrix& corner = first.emplace_back(unobservable, unobservable);
    for (std::size_t i = 0; i < unobservable; ++i)
      for (std::size_t k = 0; k < unobservable; ++k) corner(i, k) = image(i, k);
  }
  const Operators unseen_part = operators_of(std::move(first), parts);
  const NormProof norms = norms_of(on_functions(unseen_part, parts.root),
                                   {budget.deadline.after(schedule::vector::norms), budget.memory});
  const JointSpectralRadius hidden = radius_of(unseen_part, parts.root, budget, norms, 1 - power(Rational(2), -20));
  if (!(hidden.proved_upper() < 1)) return std::nullopt;
  ComponentProof result{space, parts.root > 0 ? unobservable / 2 : unobservable, quotient};
  result.radius.proof = joined(operators, basis, in_blocks(unseen_part.family, hidden),
                               in_blocks(operators_of(seen.operators, parts).family, quotient));
  return result;
}

/// Whether the product that attains the radius of the whole space attains it on this quotient, too.
bool has_radius_of(const Told& whole, const MatrixFamily& space, const MatrixFamily& quotient,
                   const Deadline& deadline) {
  if (!whole.radius.exact.is_yes()) return false;
  const ProductEvidence& product = whole.radius.product;
  const ProductEvidence here = prove_product(quotient, product.word, deadline);
  return here.exact && product.exact ? *here.exact == *product.exact
                                     : radius::is_dominated(quotient, here, space, product, deadline);
}

/// By differences of higher orders, until one is above the exponent. `whole`: what the space tells of the worst. What
/// is asked for by itself gets its proof.
ComponentRegularity regularity_of_component(const Parts& parts, const std::vector<LatticeSequence>& solutions,
                                            const DifferenceSpace& first, const Told& whole, std::size_t component,
                                            const Budget& budget, int bits, std::optional<ComponentProof>* proof) {
  ComponentRegularity result{
      {}, {Truth::unknown, "its differences span no space that is small enough"}, false, component};
  std::optional<DifferenceSpace> space = first;
  while (space && space->family.size() <= largest_space) {
    const auto found = observed(*space, parts, component);
    if (!found) return result;
    if (found->rows.empty()) return {{}, {Truth::no, "the component is 0"}, true, component};
    const bool is_whole = space->order == first.order &&
                          (found->rows.size() == first.family.size() ||
                           (parts.root == 0 && !proof &&
                            has_radius_of(whole, first.family, found->operators, budget.deadline)));
    Told told = is_whole ? whole
                         : exponent_of(operators_of(found->operators, parts), parts.root, space->order,
                                       parts.mask.dilation(), budget, bits);
    if (proof) *proof = component_proof(*space, parts, *found, told.radius, budget);
    if (told.exponent.lower && whole.exponent.lower && *told.exponent.lower < *whole.exponent.lower)
      told.exponent.lower = whole.exponent.lower;  // that of the worst function
    result = {told.exponent, told.radius.exact, false, component};
    if (result.exponent.upper || budget.deadline.expired() || space->order >= most_orders) break;
    space = value_space(parts.mask, solutions, space->order + 1);
  }
  return result;
}

/// By differences of this order.
std::optional<Enclosure> sobolev_exponent_by(const DifferenceSpace& space, const Parts& parts, const Deadline& deadline,
                                             int bits) {
  try {
    const auto found = mean_square_radius(operators_of(space, parts), parts.root, bits + bits_of_powers, deadline);
    if (!found) return std::nullopt;
    Enclosure result = exponent_of_radius(*found, space.dilation.classes(), space.dilation.variables(),
                                          bits + bits_of_powers);
    if (result.upper && *result.upper >= space.order) result = Enclosure::at_least(space.order);
    return result;
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::size && error.kind() != ErrorKind::domain) throw;
    return std::nullopt;  // blocks that are too large
  }
}

/// By differences of this order and, where they are not above the exponent, of higher ones.
std::optional<Enclosure> sobolev_exponent(const DifferenceSpace& first, const Parts& parts,
                                          const std::vector<LatticeSequence>& solutions, const Deadline& deadline,
                                          int bits) {
  std::optional<Enclosure> result = sobolev_exponent_by(first, parts, deadline, bits);
  for (int order = first.order + 1; result && !result->upper && order <= most_orders && !deadline.expired(); ++order) {
    const auto space = value_space(parts.mask, solutions, order);
    if (!space || space->family.size() > largest_space) break;
    const auto next = sobolev_exponent_by(*space, parts, deadline, bits);
    if (!next) break;
    result = next;
  }
  return result;
}

/// Whether the solutions are continuous, by the exponent of the worst.
Decision are_continuous(const Enclosure& exponent, std::size_t solutions) {
  if (exponent.lower && *exponent.lower > 0) return {Truth::yes, "the differences of its values shrink"};
  if (exponent.upper && *exponent.upper <= 0)
    return solutions == 1 ? Decision{Truth::no, "the differences of its values do not shrink"}
                          : Decision{Truth::unknown, "not all solutions are continuous"};
  return {Truth::unknown, "not decided within the budget"};
}

/// Those of the solutions that are meant.
std::vector<LatticeSequence> asked_for(const Parts& parts, std::vector<LatticeSequence> solutions,
                                       const std::optional<std::vector<Rational>>& integral) {
  if (!integral) return solutions;
  require(integral->size() == parts.mask.components() &&
              std::ranges::any_of(*integral, [](const Rational& x) { return x != 0; }),
          "regularity: need an integral of {} numbers that are not all 0", parts.components());
  std::vector<LatticeSequence> result = with_integral(parts.mask, solutions, *integral);
  if (parts.root == 0 || result.empty()) return result;
  // times the square root: x + sqrt(root) y becomes root y + sqrt(root) x
  std::vector<Rational> multiple(integral->begin() + static_cast<long>(parts.components()), integral->end());
  for (Rational& number : multiple) number *= parts.root;
  multiple.insert(multiple.end(), integral->begin(), integral->begin() + static_cast<long>(parts.components()));
  result.push_back(with_integral(parts.mask, solutions, multiple).front());
  return result;
}

MultivariateRegularity regularity_of_parts(const Parts& parts, const Budget& budget, const VectorQuestion& question) {
  const int bits = question.bits;
  const std::optional<std::size_t>& component = question.component;
  const LatticeMask& mask = parts.mask;
  const Dilation& dilation = mask.dilation();
  require(dilation.is_isotropic(),
          "regularity: need a dilation that is similar to a multiple of an orthogonal matrix for a mask of matrices, "
          "got {}",
          dilation.to_text());
  require(!component || *component < parts.components(), "regularity: need a component from 1 to {}",
          parts.components());
  MultivariateRegularity result;
  FunctionVector& vector = result.vector.emplace();
  vector.root = parts.root;
  vector.integral = question.integral;
  result.stable = {Truth::unknown, "not needed for the exponent, which is from values of phi"};
  result.converges = {Truth::unknown, "this is about the solutions of the refinement equation"};
  const std::vector<LatticeSequence> all = solutions_at_lattice_points(mask),
                                     solutions = asked_for(parts, all, question.integral);
  if (!all.empty()) {
    std::vector<std::vector<Rational>> integrals;
    for (const LatticeSequence& one : all) integrals.push_back(integral_of_solution(mask, one));
    vector.integrals = basis_over_field(integrals, parts.root);
  }
  vector.solutions = parts.root > 0 ? solutions.size() / 2 : solutions.size();
  if (vector.solutions == 1)
    vector.values = question.integral ? solutions.front()
                    : parts.root == 0 ? normalised(solutions.front())
                                      : normalised(solutions.front(), parts.components(), parts.root);
  if (solutions.empty()) {
    result.exact = {Truth::no, "there is no continuous solution"};
    vector.continuous = {Truth::no, all.empty() ? "the refinement equation has no solution but 0 at lattice points"
                                                : "no solution at lattice points is of one with this integral"};
    return result;
  }
  result.exact = vector.continuous = {Truth::unknown, "the differences of the values span no space that is found"};
  result.space = space_above_exponent(parts, solutions, budget.deadline.after(schedule::vector::spaces));
  if (!result.space) return result;
  const Budget whole{budget.deadline.after(schedule::vector::whole), budget.memory};
  const auto tell = [&](const DifferenceSpace& space) {
    return exponent_of(operators_of(space, parts), parts.root, space.order, dilation, whole, bits);
  };
  Told told = tell(*result.space);
  // What floating point took for an order above the exponent may be none.
  while (!told.exponent.upper && result.space->order < most_orders && !whole.deadline.expired()) {
    auto next = value_space(mask, solutions, result.space->order + 1);
    if (!next || next->family.size() > largest_space) break;
    result.space = std::move(next);
    told = tell(*result.space);
  }
  const DifferenceSpace& space = *result.space;
  result.exact = told.radius.exact;
  vector.continuous = are_continuous(told.exponent, vector.solutions);
  if (vector.continuous.is_yes()) {
    result.exponent = told.exponent;
    if (!component)
      result.sobolev = sobolev_exponent(space, parts, solutions, budget.deadline.after(schedule::vector::sobolev),
                                        bits);
    const std::size_t first = component.value_or(0), last = component.value_or(parts.components() - 1);
    for (std::size_t c = first; c <= last; ++c) {
      const double share = 1.0 / static_cast<double>(last + 1 - c);
      vector.components.push_back(regularity_of_component(parts, solutions, space, told, c,
                                                          {budget.deadline.after(share), budget.memory}, bits,
                                                          component ? &vector.proof : nullptr));
    }
  }
  result.bound = HolderBound{
      told.norms.level, told.norms.norm,
      exponent_of_radius(root_enclosure(told.norms.norm, told.norms.level), dilation.classes(), dilation.variables())};
  result.radius = std::move(told.radius);
  if (component && !vector.components.empty()) {
    result.exponent = vector.components.front().exponent;
    result.exact = vector.components.front().exact;
  }
  return result;
}

}  // namespace

MultivariateRegularity vector_regularity(const LatticeMask& mask, const Budget& budget,
                                         const VectorQuestion& question) {
  return regularity_of_parts({mask}, budget, question);
}

MultivariateRegularity vector_regularity(const QuadraticMask& mask, const Budget& budget,
                                         const VectorQuestion& question) {
  return regularity_of_parts({mask.doubled, mask.root}, budget, question);
}

}  // namespace subcert
