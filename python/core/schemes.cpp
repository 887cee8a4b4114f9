#include "work.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/regularity/stability.hpp>
#include <subcert/reports/facts/l1_facts.hpp>
#include <subcert/reports/facts/scheme_facts.hpp>
#include <subcert/schemes/specification.hpp>

namespace subcert::python {
namespace {

/// JSON, as the command line has it.
std::string facts_of(const Scheme& scheme) { return page_json(facts::mask_facts(scheme)).dump(); }

std::string analysis_of(const Scheme& scheme, int levels, double budget, const py::object& progress) {
  return interruptible(progress, [&] {
    const facts::Analysis known = facts::analysis(scheme, {{levels, Deadline::in(budget)}});
    return page_json(facts::scheme_facts(scheme, known)).dump();
  });
}

std::string l1_analysis_of(const DataDependentScheme& scheme, int steps, int order, double budget,
                           const py::object& progress) {
  return interruptible(progress, [&] {
    const Deadline deadline = Deadline::in(budget);
    const data::LeastAbsoluteLimit limit = data::least_absolute_limit(
        facts::points_of_curve(scheme), scheme.rules.degree,
        {.steps = steps, .order = order, .deadline = deadline.after(facts::share_of_limit)}, scheme.rules.arity);
    return page_json(facts::l1_facts(scheme, limit, {deadline})).dump();
  });
}

LaurentPolynomial remaining_factor(const Scheme& scheme) {
  const Mask& mask = scheme.mask.curve();
  return *mask.symbol().exact_quotient(LaurentPolynomial::all_ones(mask.arity()).pow(sum_rules(mask)));
}

using Term = std::tuple<std::vector<long>, std::size_t, std::size_t, Rational>;  // row and column, 0 for numbers

std::vector<Term> terms_of(const Scheme& scheme) {
  std::vector<Term> result;
  for (const LatticeMask::Term& term : scheme.mask.terms())
    result.emplace_back(term.exponents, term.row, term.column, term.coefficient);
  return result;
}

std::vector<std::tuple<std::string, std::string, std::string>> help_of(const std::vector<FamilyHelp>& families) {
  std::vector<std::tuple<std::string, std::string, std::string>> result;
  for (const FamilyHelp& one : families) result.emplace_back(one.family, one.usage, one.meaning);
  return result;
}

}  // namespace

void add_schemes(py::module_& module) {
  py::class_<Scheme>(module, "Scheme")
      .def(py::pickle([](const Scheme& scheme) { return py::make_tuple(scheme.specification); },
                      [](const py::tuple& state) { return make_refinable_scheme(state[0].cast<std::string>()); }))
      .def_readonly("specification", &Scheme::specification)
      .def_readonly("title", &Scheme::title)
      .def_property_readonly("dimension", [](const Scheme& scheme) { return scheme.mask.dimension(); })
      .def_property_readonly("dilation", [](const Scheme& scheme) { return scheme.mask.dilation().rows(); })
      .def_property_readonly("components", [](const Scheme& scheme) { return scheme.mask.components(); })
      .def_property_readonly("terms", &terms_of)
      .def_property_readonly("arity", [](const Scheme& scheme) { return scheme.mask.arity(); })
      .def_property_readonly("symbol", [](const Scheme& scheme) { return scheme.mask.curve().symbol(); })
      .def_property_readonly("rounding", [](const Scheme& scheme) {
        return scheme.rounding ? std::optional(scheme.rounding->distance) : std::nullopt;
      });
  py::class_<DataDependentScheme>(module, "DataDependentScheme")
      .def_readonly("specification", &DataDependentScheme::specification)
      .def_readonly("title", &DataDependentScheme::title)
      .def_property_readonly("dimension", [](const DataDependentScheme& scheme) { return scheme.rules.points.size(); });
  module.def("make_any_scheme", [](const std::string& specification) -> AnyScheme {
    if (is_l1_specification(specification)) return make_any_scheme(specification);
    return make_refinable_scheme(specification);
  });
  module.def("vector_families", [] { return help_of(vector_families()); });
  module.def("families", [] { return help_of(families()); });
  module.def("multivariate_families", [] { return help_of(multivariate_families()); });
  module.def("facts", &facts_of);
  module.def("analyze", &analysis_of);
  module.def("analyze_l1", &l1_analysis_of);
  module.def("remaining_factor", &remaining_factor);
  module.def("symbol_text", [](const LaurentPolynomial& symbol) { return symbol.to_text(); });
  module.def("symbol_latex", [](const LaurentPolynomial& symbol) { return symbol.to_latex(); });
  module.def("stable", [](const Scheme& scheme) { return has_stable_shifts(scheme.mask.curve()); });
  module.def("converges", [](const Scheme& scheme, int levels, double budget, const py::object& progress) {
    return interruptible(progress, [&] { return converges(scheme.mask, {levels, Deadline::in(budget)}); });
  });
  module.def("smoothness", [](const Scheme& scheme, int levels, double budget, const py::object& progress) {
    const SmoothnessProof proof = interruptible(progress, [&] {
      return proved_smoothness(scheme.mask, {levels, Deadline::in(budget)});
    });
    return py::make_tuple(proof.order, proof.evidence, proof.obstacle);
  });
}

}  // namespace subcert::python
