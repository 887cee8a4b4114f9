#include "arrays.hpp"
#include "work.hpp"

#include <subcert/analysis/family/limit_values_of_levels.hpp>
#include <subcert/analysis/limit/field_values.hpp>
#include <subcert/analysis/limit/limit_range.hpp>
#include <subcert/analysis/regularity/derivatives.hpp>
#include <subcert/analysis/regularity/multivariate_regularity.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/variance/variance.hpp>
#include <subcert/analysis/variance/variance_range.hpp>
#include <subcert/reports/facts/regularity_facts.hpp>

#include <map>

namespace subcert::python {
namespace {

void require_limits(const Scheme& scheme) {
  require_derivative(scheme.specification, scheme.mask, LatticePoint(scheme.mask.dilation().variables(), 0));
}

LimitValues values_of(const Scheme& scheme, int level, int order, const py::object& progress) {
  require(level >= 0 && order >= 0, "limit: need level >= 0 and derivative >= 0, got {} and {}", level, order);
  return interruptible(progress, [&] {
    require_derivative(scheme.specification, scheme.mask, {order});
    return limit_values(scheme.mask.curve(), level, order);
  });
}

/// The points M^-level i and the values there, where they are not 0.
std::pair<std::vector<std::vector<Rational>>, std::vector<Rational>> surface_values_of(const Scheme& scheme, int level,
                                                                                       double budget) {
  require(level >= 0, "limit: need level >= 0, got {}", level);
  require_convergence(scheme.specification, multivariate_regularity(scheme.mask, {Deadline::in(budget)}).converges);
  std::pair<std::vector<std::vector<Rational>>, std::vector<Rational>> result;
  for (const auto& [index, value] : limit_values(scheme.mask, level)) {
    result.first.push_back(point_at(scheme.mask.dilation(), index, level));
    result.second.push_back(value);
  }
  return result;
}

/// The values at lattice points of all functions of a vector, which are proved to be continuous.
LatticeSequence at_lattice_points(const Scheme& scheme, double seconds) {
  FunctionVector vector =
      *vector_regularity(scheme.mask, scheme.quadratic, {Deadline::in(seconds)}, {.integral = scheme.integral}).vector;
  require_convergence(scheme.specification, vector.continuous);
  require(vector.solutions == 1, "{}: need {}", scheme.specification, facts::needed_solution(vector));
  return *std::move(vector.values);
}

/// The same of all functions of a vector, by the indices of the points.
FieldValues vector_values_of(const Scheme& scheme, int level, double seconds) {
  require(level >= 0, "limit: need level >= 0, got {}", level);
  return limit_values(scheme.mask, scheme.quadratic, at_lattice_points(scheme, seconds), level);
}

/// Points, and the values there: with `exact` rational numbers or texts, else rounded.
py::tuple vector_values_of(const Scheme& scheme, int level, double budget, bool exact, const py::object& progress) {
  constexpr long bits = 64;
  py::list points, values;
  for (const auto& [index, numbers] :
       interruptible(progress, [&] { return vector_values_of(scheme, level, budget); })) {
    points.append(py::cast(point_at(scheme.mask.dilation(), index, level)));
    py::list row;
    for (const QuadraticNumber& number : numbers) {
      if (!exact)
        row.append(rounded(number, bits).convert_to<double>());
      else if (number.root == 0)
        row.append(py::cast(number.rational));
      else
        row.append(number.to_text());
    }
    values.append(row);
  }
  return py::make_tuple(points, values);
}

/// Of schemes that take turns: the arity, the indices of the points, and numbers or lists of them.
py::tuple values_in_turn(const std::vector<std::string>& first, const std::vector<std::string>& again, int level,
                         double budget, const py::object& progress) {
  const LevelDependentScheme levels = levels_in_turn(first, again);
  const LatticeMask& mask = levels.masks.at(0);
  require(mask.dimension() == 1, "limit: need schemes of one variable, got {}", mask.dimension());
  const Scheme period = period_of(levels);
  std::vector<long> indices;
  if (!levels.form) {
    LimitValues found = interruptible(progress, [&] {
      require_derivative(levels.specification, period.mask, {0});
      return limit_values(levels.masks, level);
    });
    for (std::size_t i = 0; i < found.values.size(); ++i) indices.push_back(found.first_index + static_cast<long>(i));
    return py::make_tuple(found.arity, indices, found.values);
  }
  std::vector<std::vector<Rational>> rows;
  const FieldValues values = interruptible(progress, [&] {
    return by_points(limit_values(levels.masks, at_lattice_points(period, budget), level), mask.components(), 0);
  });
  for (const auto& [index, numbers] : values) {
    indices.push_back(index[0]);
    std::vector<Rational>& row = rows.emplace_back();
    for (const QuadraticNumber& number : numbers) row.push_back(number.rational);
  }
  return py::make_tuple(mask.arity(), indices, rows);
}

}  // namespace

void add_limits(py::module_& module) {
  module.def("limit_values", [](const Scheme& scheme, int level, int order, const py::object& progress) {
    const LimitValues found = values_of(scheme, level, order, progress);
    return py::make_tuple(found.first_index, found.values);
  });
  module.def("rounded_limit_values", [](const Scheme& scheme, int level, int order, const py::object& progress) {
    const LimitValues found = values_of(scheme, level, order, progress);
    std::vector<double> x, y;
    for (std::size_t i = 0; i < found.values.size(); ++i) {
      x.push_back(found.point(i).convert_to<double>());
      y.push_back(found.values[i].convert_to<double>());
    }
    return py::make_tuple(array_of(std::move(x)), array_of(std::move(y)));
  });
  module.def("surface_limit_values", [](const Scheme& scheme, int level, double budget, const py::object& progress) {
    return interruptible(progress, [&] { return surface_values_of(scheme, level, budget); });
  });
  module.def("vector_limit_values",
             [](const Scheme& scheme, int level, double budget, bool exact, const py::object& progress) {
               return vector_values_of(scheme, level, budget, exact, progress);
             });
  module.def("limit_values_in_turn", &values_in_turn);
  module.def("limit_range", [](const Scheme& scheme, const Rational& width, double budget, const py::object& progress) {
    const LimitRange range = interruptible(progress, [&] {
      require_limits(scheme);
      return limit_range(scheme.mask.curve(), {width, {Deadline::in(budget)}});
    });
    return py::dict("maximum"_a = range.maximum, "minimum"_a = range.minimum, "sup_norm"_a = range.sup_norm,
                    "slope"_a = range.slope, "slope_reason"_a = range.slope_reason, "l1_norm"_a = range.l1_norm,
                    "complete"_a = range.complete);
  });
  module.def("variance_grid", [](const Scheme& scheme, int level, const py::object& progress) {
    require(level >= 0, "variance: need level >= 0, got {}", level);
    const VarianceGrid grid = interruptible(progress, [&] {
      require_limits(scheme);
      return variance_grid(scheme.mask.curve(), level, false);
    });
    return grid.values;
  });
  module.def(
      "variance_range", [](const Scheme& scheme, const Rational& width, double budget, const py::object& progress) {
        const VarianceRange range = interruptible(progress, [&] {
          require_limits(scheme);
          return variance_range(scheme.mask.curve(), {width, {Deadline::in(budget)}});
        });
        return py::dict("maximum"_a = range.maximum, "minimum"_a = range.minimum, "slope"_a = range.slope,
                        "slope_reason"_a = range.slope_reason, "mean"_a = range.mean, "complete"_a = range.complete);
      });
}

}  // namespace subcert::python
