#include "vector_refinement.hpp"

#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <type_traits>

namespace subcert::data {
namespace {

constexpr const char* beyond_doubles = "refine: need numbers within the range of doubles; take fewer levels";

/// x + sqrt(root) y for a root that is known.
struct FieldNumber {
  Rational x = 0, y = 0;
  bool operator==(const FieldNumber& other) const = default;
};
FieldNumber product(const FieldNumber& a, const FieldNumber& b, long root) {
  return {a.x * b.x + root * a.y * b.y, a.x * b.y + a.y * b.x};
}

/// A mask of matrices of `size` rows, by its entries: rational, or as those of a QuadraticMask doubled.
struct FieldMask {
  const LatticeMask& mask;
  std::size_t size;
  long root = 0;

  /// For each entry once: its index, its row and column, and whether it counts times the square root.
  template <class Visit>
  void each(const Visit& visit) const {
    for (const LatticeMask::Term& term : mask.terms())
      if (term.column < size)
        visit(term.exponents[0], term.row % size, term.column,
              term.row < size ? FieldNumber{term.coefficient, 0} : FieldNumber{0, term.coefficient});
  }
};

/// n (n - 1) ... (n - k + 1) x^(n - k), the k-th derivative of x^n.
FieldNumber monomial(int n, int k, const FieldNumber& x, long root) {
  if (k > n) return {};
  FieldNumber result{1};
  for (int factor = n; factor > k; --factor) result = product(result, x, root);
  for (int factor = n; factor > n - k; --factor) result = product(result, {factor}, root);
  return result;
}

/// Where linear polynomials have to stand to be kept, in the mean of the residue classes.
FieldNumber hermite_centre(const FieldMask& mask) {
  const Rational arity = mask.mask.arity();
  FieldNumber sum;
  mask.each([&](long k, std::size_t row, std::size_t column, const FieldNumber& entry) {
    if (column != 0 || row > 1) return;
    const Rational factor = row == 0 ? Rational(k) / arity : Rational(-1);
    sum.x += factor * entry.x;
    sum.y += factor * entry.y;
  });
  return sum;
}

/// Whether x^n and its derivatives are kept, where all of lower degree are.
bool keeps_monomial(const FieldMask& mask, const FieldNumber& centre, int n) {
  const long arity = mask.mask.arity();
  std::vector<FieldNumber> sums(mask.size * static_cast<std::size_t>(arity));
  mask.each([&](long k, std::size_t row, std::size_t column, const FieldNumber& entry) {
    const long residue = modulo(k, arity);
    const FieldNumber moved = monomial(n, static_cast<int>(row), {Rational((residue - k) / arity)}, mask.root);
    FieldNumber& sum = sums[static_cast<std::size_t>(residue) * mask.size + column];
    sum.x += entry.x * moved.x;
    sum.y += entry.y * moved.x;
  });
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const int derivative = static_cast<int>(i % mask.size);
    const FieldNumber place{(Rational(i / mask.size) - centre.x) / arity, -centre.y / arity};
    const Rational unit = power(Rational(arity), -derivative);
    if (sums[i] != product({unit}, monomial(n, derivative, place, mask.root), mask.root)) return false;
  }
  return true;
}

int kept_degree(const FieldMask& mask, const FieldNumber& centre) {
  int degree = -1;
  while (keeps_monomial(mask, centre, degree + 1)) ++degree;
  return degree;
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

HermiteReproduction hermite_reproduction(const LatticeMask& mask, const std::optional<QuadraticMask>& meant) {
  const FieldMask rounded{mask, mask.components()};
  const FieldNumber centre = hermite_centre(rounded);
  if (!meant) return {centre.x, kept_degree(rounded, centre)};
  const FieldMask entries{meant->doubled, meant->components(), meant->root};
  return {centre.x, kept_degree(entries, hermite_centre(entries))};
}

AxisRule axis_rule(const LatticeMask& mask, VectorForm form, const std::optional<QuadraticMask>& meant) {
  require(mask.dimension() == 1, "refine: need a curve for a scheme of vectors, got one of {} variables",
          mask.dimension());
  const bool hermite = form == VectorForm::hermite;
  const auto size = static_cast<int>(mask.components());
  const long arity = mask.arity();
  const HermiteReproduction kept = hermite ? hermite_reproduction(mask, meant) : HermiteReproduction{0, -1};
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

namespace {

void require_one_kind(const LevelMasks& masks) {
  for (const auto* list : {&masks.first, &masks.again})
    for (const LatticeMask& mask : *list)
      require(mask.components() == masks.at(0).components() && mask.dilation() == masks.at(0).dilation(),
              "refine: need matrices of one size and of one arity for levels that differ");
}

template <class Number>
GridData<Number> refine_levels(const GridData<Number>& data, const LevelMasks& masks, VectorForm form,
                               const RefineOptions& options, const Rational& spacing,
                               const std::optional<QuadraticMask>& meant) {
  require_one_kind(masks);
  const std::size_t size = masks.at(0).components();
  const int arity = masks.at(0).arity();
  require(data.is_canonical() && data.axes.size() == 1 && data.dimension % size == 0,
          "refine: need a curve of points with a multiple of {} numbers, got {}", size, data.dimension);
  require(options.levels >= 0, "refine: need levels >= 0, got {}", options.levels);
  require(spacing > 0, "refine: need spacing > 0, got {}", to_text(spacing));
  require_refinement_boundary(options.boundary);
  require_boundary(form, data.axes[0], options.boundary);
  std::map<std::size_t, AxisRefiner> refiners;  // by the number of the mask
  const auto refiner_at = [&](std::size_t level) -> AxisRefiner& {
    const std::size_t number = masks.number_at(level);
    const auto found = refiners.find(number);
    if (found != refiners.end()) return found->second;
    return refiners.emplace(number, AxisRefiner(axis_rule(masks.mask(number), form, meant), options.boundary))
        .first->second;
  };
  refiner_at(0);
  require_refinable(data.values.size(), arity, options.levels);
  GridData<Number> result = data;
  Rational from = spacing;
  for (int level = 0; level < options.levels; ++level) {
    AxisRefinement<Rational> rows = refiner_at(static_cast<std::size_t>(level)).step(result.axes[0]);
    const Rational to = from / arity;
    if (form == VectorForm::hermite) rescale(rows, from, to);
    from = to;
    result = apply_along(result, 0, converted<Number>(rows), options.threads);
  }
  if constexpr (std::is_same_v<Number, double>)
    if (!std::ranges::all_of(result.values, [](double value) { return std::isfinite(value); }))
      fail(ErrorKind::size, "{}", beyond_doubles);
  return result;
}

}  // namespace

template <class Number>
GridData<Number> refine_vectors(const GridData<Number>& data, const LatticeMask& mask, VectorForm form,
                                const RefineOptions& options, const Rational& spacing,
                                const std::optional<QuadraticMask>& meant) {
  return refine_levels(data, {{}, {mask}}, form, options, spacing, meant);
}

template <class Number>
GridData<Number> refine_vectors(const GridData<Number>& data, const LevelMasks& masks, VectorForm form,
                                const RefineOptions& options, const Rational& spacing) {
  return refine_levels(data, masks, form, options, spacing, std::nullopt);
}

template GridData<double> refine_vectors<double>(const GridData<double>&, const LatticeMask&, VectorForm,
                                                 const RefineOptions&, const Rational&,
                                                 const std::optional<QuadraticMask>&);
template GridData<Rational> refine_vectors<Rational>(const GridData<Rational>&, const LatticeMask&, VectorForm,
                                                     const RefineOptions&, const Rational&,
                                                     const std::optional<QuadraticMask>&);
template GridData<double> refine_vectors<double>(const GridData<double>&, const LevelMasks&, VectorForm,
                                                 const RefineOptions&, const Rational&);
template GridData<Rational> refine_vectors<Rational>(const GridData<Rational>&, const LevelMasks&, VectorForm,
                                                     const RefineOptions&, const Rational&);

}  // namespace subcert::data
