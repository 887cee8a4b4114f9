#include "scheme_refinement.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/as_written.hpp>
#include <subcert/schemes/data/l1/l1_refinement.hpp>
#include <subcert/schemes/data/refine/vector_refinement.hpp>
#include <subcert/schemes/data/smooth/uniform_grid.hpp>

namespace subcert::data {
namespace {

/// How a scheme of vectors reads the numbers of a point.
struct Columns {
  const std::string& specification;
  std::size_t size;  ///< of a vector
  bool hermite;

  /// Whether points of so many coordinates begin with their position.
  bool have_positions(std::size_t dimension) const { return hermite && dimension > size && dimension % size == 1; }
};

/// Of a scheme of vectors, else nothing.
std::optional<Columns> columns_of(const AnyScheme& scheme) {
  if (const auto* linear = std::get_if<Scheme>(&scheme); linear && linear->mask.components() > 1)
    return Columns{linear->specification, linear->mask.components(), linear->form == VectorForm::hermite};
  if (const auto* levels = std::get_if<LevelDependentScheme>(&scheme); levels && levels->form)
    return Columns{levels->specification, levels->masks.at(0).components(), levels->form == VectorForm::hermite};
  return std::nullopt;
}

/// The coordinates from `first` to before `last`.
GridData<double> part(const GridData<double>& data, std::size_t first, std::size_t last) {
  GridData<double> result{{}, last - first, data.axes};
  result.values.reserve(data.points() * result.dimension);
  for (std::size_t i = 0; i < data.points(); ++i)
    for (std::size_t c = first; c < last; ++c) result.values.push_back(data.values[i * data.dimension + c]);
  return result;
}

/// With the position in front of each point.
GridData<double> with_positions(const GridData<double>& data, const UniformGrid& grid) {
  const Axis& axis = data.axes[0];
  const GridPositions positions(grid.origin + grid.spacing * axis.first, grid.spacing * axis.step, 1);
  GridData<double> result{{}, data.dimension + 1, data.axes};
  result.values.reserve(data.points() * result.dimension);
  for (std::size_t i = 0; i < data.points(); ++i) {
    result.values.push_back(positions.at(i));
    for (std::size_t c = 0; c < data.dimension; ++c) result.values.push_back(data.values[i * data.dimension + c]);
  }
  return result;
}

GridData<double> refined_columns(const GridData<double>& data, const AnyScheme& scheme, const Columns& columns,
                                 const RefineOptions& options) {
  require_columns(scheme, data, [](std::optional<std::size_t> i) {
    return i ? "refine, point " + std::to_string(*i + 1) : std::string("refine");
  });
  const auto refined = [&](const GridData<double>& numbers, const Rational& spacing) {
    if (const auto* levels = std::get_if<LevelDependentScheme>(&scheme))
      return refine_vectors(numbers, levels->masks, *levels->form, options, spacing);
    const auto& one = std::get<Scheme>(scheme);
    return refine_vectors(numbers, one.mask, *one.form, options, spacing, one.quadratic);
  };
  if (!columns.have_positions(data.dimension)) return refined(data, 1);
  const UniformGrid grid = uniform_grid(part(data, 0, 1).values);
  return with_positions(refined(part(data, 1, data.dimension), grid.spacing), grid);
}

}  // namespace

AnyScheme make_data_scheme(std::string_view specification) {
  if (is_l1_specification(specification_as_written(specification))) return make_any_scheme(specification);
  return make_refinable_scheme(specification);
}

GridData<double> refine(const GridData<double>& data, const AnyScheme& scheme, const RefineOptions& options) {
  if (const auto columns = columns_of(scheme)) return refined_columns(data, scheme, *columns, options);
  if (continues_data(options.boundary))
    return SlabRefinement(data, *refinement_steps(data.axes, data.dimension, scheme, options)).whole();
  if (const auto* l1 = std::get_if<DataDependentScheme>(&scheme)) return refine(data, l1->rules, options);
  if (const auto* levels = std::get_if<LevelDependentScheme>(&scheme)) return refine(data, levels->masks, options);
  return refine(data, std::get<Scheme>(scheme).mask, options);
}

std::optional<SliceSteps> refinement_steps(const std::vector<Axis>& axes, std::size_t dimension,
                                           const AnyScheme& scheme, const RefineOptions& options) {
  if (const auto* l1 = std::get_if<DataDependentScheme>(&scheme))
    return refinement_steps(axes, dimension, l1->rules, options);
  if (columns_of(scheme)) return std::nullopt;
  if (const auto* levels = std::get_if<LevelDependentScheme>(&scheme))
    return refinement_steps(axes, dimension, levels->masks, options);
  return refinement_steps(axes, dimension, std::get<Scheme>(scheme).mask, options);
}

void require_columns(const AnyScheme& scheme, const GridData<double>& data,
                     const std::function<std::string(std::optional<std::size_t>)>& place) {
  const auto read = columns_of(scheme);
  if (!read) return;
  const std::size_t columns = data.dimension;
  if (!read->have_positions(columns)) {
    if (columns % read->size != 0)
      fail(ErrorKind::data, "{}: expected a multiple of {} columns for {}, {}; found {}", place({}), read->size,
           read->specification,
           read->hermite ? "values, then their first derivatives and so on, or one column of positions before them"
                         : "the first numbers of all vectors, then the second and so on",
           columns);
    return;
  }
  const std::vector<double> positions = part(data, 0, 1).values;
  if (positions.size() == 1)
    fail(ErrorKind::data, "{}: expected two positions or more in the first column; found one", place({}));
  for (std::size_t i = 1; i < positions.size(); ++i)
    if (positions[i] <= positions[i - 1])
      fail(ErrorKind::data, "{}: expected a position above {} in the first column; found {}", place(i),
           positions[i - 1], positions[i]);
  if (const UniformGrid grid = uniform_grid(positions); !grid.uniform)
    fail(ErrorKind::data, "{}: expected positions in equal steps, in the mean {:g}; found the step {:g}",
         place(grid.worst + 1), nearest_double(grid.spacing), positions[grid.worst + 1] - positions[grid.worst]);
}

GridData<double> without_derivatives(const AnyScheme& scheme, const GridData<double>& data) {
  const auto columns = columns_of(scheme);
  if (!columns) return data;
  const std::size_t first = columns->have_positions(data.dimension) ? 1 : 0;
  return part(data, 0, first + (data.dimension - first) / columns->size);
}

std::vector<std::size_t> fewest_points(const AnyScheme& scheme, Boundary boundary) {
  if (const auto* l1 = std::get_if<DataDependentScheme>(&scheme))
    return continues_data(boundary) ? std::vector<std::size_t>(l1->rules.points.size(), 1)
                                    : std::vector<std::size_t>(l1->rules.points.begin(), l1->rules.points.end());
  const auto* levels = std::get_if<LevelDependentScheme>(&scheme);
  const LatticeMask& mask = levels ? levels->masks.at(0) : std::get<Scheme>(scheme).mask;
  if (columns_of(scheme)) {
    const auto* one = std::get_if<Scheme>(&scheme);
    const AxisRule rule = levels ? axis_rule(mask, *levels->form) : axis_rule(mask, *one->form, one->quadratic);
    return {boundary == Boundary::periodic ? 1 : AxisRefiner(rule, boundary).window()};
  }
  if (levels) return fewest_points(mask, boundary);
  require(mask.has_factors() || mask.dilation().factor().value_or(0) > 0,
          "refine: need a scheme that makes a grid finer along its axes, not one with the dilation {}",
          mask.dilation().to_text());
  return fewest_points(mask, boundary);
}

}  // namespace subcert::data
