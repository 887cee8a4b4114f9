#include "vector_refinement.hpp"

#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

namespace subcert::data {
namespace {

constexpr const char* beyond_doubles = "refine: need numbers within the range of doubles; take fewer levels";

/// n (n - 1) ... (n - k + 1) x^(n - k), the k-th derivative of x^n.
Rational monomial(int n, int k, const Rational& x) {
  if (k > n) return 0;
  Rational result = power(x, n - k);
  for (int factor = n; factor > n - k; --factor) result *= factor;
  return result;
}

/// Where linear polynomials have to stand to be kept, in the mean of the residue classes.
Rational hermite_centre(const LatticeMask& mask) {
  Rational sum = 0;
  for (const LatticeMask::Term& term : mask.terms()) {
    if (term.column != 0 || term.row > 1) continue;
    sum += term.coefficient * (term.row == 0 ? term.exponents[0] : -mask.arity());
  }
  return sum / mask.arity();
}

/// Whether x^n and its derivatives are kept, where all of lower degree are.
bool keeps_monomial(const LatticeMask& mask, const Rational& centre, int n) {
  const int arity = mask.arity();
  const std::size_t size = mask.components();
  std::vector<Rational> sums(size * static_cast<std::size_t>(arity), 0);
  for (const LatticeMask::Term& term : mask.terms()) {
    const long k = term.exponents[0], residue = modulo(k, static_cast<long>(arity));
    sums[static_cast<std::size_t>(residue) * size + term.column] += term.coefficient *
                                                                    monomial(n, static_cast<int>(term.row),
                                                                             Rational((residue - k) / arity));
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const int derivative = static_cast<int>(i % size);
    const Rational place = (Rational(i / size) - centre) / arity;
    if (sums[i] != power(Rational(arity), -derivative) * monomial(n, derivative, place)) return false;
  }
  return true;
}

/// The range of the indices of each residue class.
std::vector<AxisStencils::Class> classes_of(const LatticeMask& mask) {
  const long arity = mask.arity();
  std::vector<std::optional<AxisStencils::Class>> found(static_cast<std::size_t>(arity));
  for (const LatticeMask::Term& term : mask.terms()) {
    const long k = term.exponents[0];
    auto& one = found[static_cast<std::size_t>(modulo(k, arity))];
    one = one ? AxisStencils::Class{std::min(one->lowest, k), std::max(one->highest, k)} : AxisStencils::Class{k, k};
  }
  std::vector<AxisStencils::Class> classes;
  for (long residue = 0; residue < arity; ++residue)
    classes.push_back(found[static_cast<std::size_t>(residue)].value_or(AxisStencils::Class{residue, residue}));
  return classes;
}

/// Makes of a step on derivatives per unit of the spacing one on those per unit of the parameter: from data `from`
/// apart to data `to` apart. Weights beyond the range of doubles are refused.
void rescale(AxisRefinement<Rational>& rows, const Rational& from, const Rational& to) {
  const Rational largest = Rational(std::numeric_limits<double>::max()) / 2;
  std::vector<Rational> in{1}, out{1};  // the k-th powers
  while (in.size() < rows.components) {
    in.push_back(in.back() * from);
    out.push_back(out.back() / to);
  }
  const auto scale = [&](Rational& weight, std::size_t row, std::size_t at) {
    weight *= out[row % rows.components] * in[at % rows.components];
    if (abs(weight) > largest) fail(ErrorKind::size, "{}", beyond_doubles);
  };
  for (auto* list : {&rows.head, &rows.tail})
    for (std::size_t row = 0; row < list->size(); ++row)
      for (std::size_t k = 0; k < (*list)[row].at.size(); ++k) scale((*list)[row].weights[k], row, (*list)[row].at[k]);
  for (std::size_t row = 0; row < rows.phases.size(); ++row)
    for (std::size_t k = 0; k < rows.phases[row].weights.size(); ++k) scale(rows.phases[row].weights[k], row, k);
}

void require_boundary(VectorForm form, const Axis& axis, Boundary boundary) {
  if (axis.closed || boundary == Boundary::shrink || boundary == Boundary::periodic) return;
  require(form == VectorForm::hermite && boundary == Boundary::regression,
          "refine: need boundary {}shrink or periodic, or closed data, for {}, got {}",
          form == VectorForm::hermite ? "regression, " : "",
          form == VectorForm::hermite ? "a Hermite scheme" : "vectors", to_text(boundary));
}

}  // namespace

HermiteReproduction hermite_reproduction(const LatticeMask& mask) {
  HermiteReproduction result{hermite_centre(mask)};
  while (keeps_monomial(mask, result.centre, result.degree + 1)) ++result.degree;
  return result;
}

AxisRule axis_rule(const LatticeMask& mask, VectorForm form) {
  require(mask.dimension() == 1, "refine: need a curve for a scheme of vectors, got one of {} variables",
          mask.dimension());
  const bool hermite = form == VectorForm::hermite;
  const auto size = static_cast<int>(mask.components());
  const long arity = mask.arity();
  const HermiteReproduction kept = hermite ? hermite_reproduction(mask) : HermiteReproduction{0, -1};
  require(
      !hermite || kept.degree >= 0,
      "refine: need a Hermite scheme that keeps the value 1 with derivatives 0, got one that does not; its matrices "
      "are the P_k of D^(n+1) f'_i = sum over j of P_(i-aj) D^n f_j");
  const std::vector<AxisStencils::Class> classes = classes_of(mask);
  AxisRule rule{{classes, kept.centre, kept.degree, size}, {}, size};
  for (const AxisStencils::Class& one : classes)
    rule.weights.resize(rule.weights.size() + mask.components(),
                        std::vector<Rational>(
                            (static_cast<std::size_t>((one.highest - one.lowest) / arity) + 1) * mask.components(), 0));
  for (const LatticeMask::Term& term : mask.terms()) {
    const auto residue = static_cast<std::size_t>(modulo(term.exponents[0], arity));
    const auto datum = static_cast<std::size_t>((classes[residue].highest - term.exponents[0]) / arity);
    rule.weights[residue * mask.components() + term.column][datum * mask.components() + term.row] = term.coefficient;
  }
  return rule;
}

template <class Number>
GridData<Number> refine_vectors(const GridData<Number>& data, const LatticeMask& mask, VectorForm form,
                                const RefineOptions& options, const Rational& spacing) {
  require(data.is_canonical() && data.axes.size() == 1 && data.dimension % mask.components() == 0,
          "refine: need a curve of points with a multiple of {} numbers, got {}", mask.components(), data.dimension);
  require(options.levels >= 0, "refine: need levels >= 0, got {}", options.levels);
  require(spacing > 0, "refine: need spacing > 0, got {}", to_text(spacing));
  require_refinement_boundary(options.boundary);
  require_boundary(form, data.axes[0], options.boundary);
  AxisRefiner refiner(axis_rule(mask, form), options.boundary);
  require_refinable(data.values.size(), mask.arity(), options.levels);
  GridData<Number> result = data;
  Rational from = spacing;
  for (int level = 0; level < options.levels; ++level) {
    AxisRefinement<Rational> rows = refiner.step(result.axes[0]);
    const Rational to = from / mask.arity();
    if (form == VectorForm::hermite) rescale(rows, from, to);
    from = to;
    result = apply_along(result, 0, converted<Number>(rows), options.threads);
  }
  if constexpr (std::is_same_v<Number, double>)
    if (!std::ranges::all_of(result.values, [](double value) { return std::isfinite(value); }))
      fail(ErrorKind::size, "{}", beyond_doubles);
  return result;
}

template GridData<double> refine_vectors<double>(const GridData<double>&, const LatticeMask&, VectorForm,
                                                 const RefineOptions&, const Rational&);
template GridData<Rational> refine_vectors<Rational>(const GridData<Rational>&, const LatticeMask&, VectorForm,
                                                     const RefineOptions&, const Rational&);

}  // namespace subcert::data
