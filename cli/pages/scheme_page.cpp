#include "scheme_page.hpp"

#include <sstream>

namespace subcert::cli {
namespace {

std::string symmetry_text(const SymmetryReport& report) {
  if (report.kind == Symmetry::none) return "none";
  return (report.kind == Symmetry::odd ? "odd, about " : "even, about ") + to_text(report.centre);
}

std::string factor_text(const SchemePage& page) {
  const std::string ones = "(" + LaurentPolynomial::all_ones(page.scheme.mask.arity()).to_text() + ")";
  return ones + (page.rules == 1 ? "" : "^" + std::to_string(page.rules)) + " * (" + page.rest.to_text() + ")";
}

}  // namespace

Json SchemePage::json() const {
  const LaurentPolynomial& symbol = scheme.mask.symbol();
  Json page{{"scheme", scheme.specification},
            {"title", scheme.title},
            {"arity", scheme.mask.arity()},
            {"first_index", symbol.lowest()},
            {"coefficients", numbers_json(symbol.coefficients())},
            {"symbol", symbol.to_text()},
            {"sum_rules", rules},
            {"remaining_factor", rest.to_text()},
            {"support", interval_json(support)},
            {"symmetry", symmetry.kind == Symmetry::none  ? "none"
                         : symmetry.kind == Symmetry::odd ? "odd"
                                                          : "even"},
            {"generation_degree", polynomials.generation_degree},
            {"reproduction_degree", polynomials.reproduction_degree},
            {"parametrization", to_text(polynomials.parametrization)},
            {"approximation_order", polynomials.approximation_order()},
            {"convergence", decision_json(convergence)}};
  if (!convergence.is_yes()) return page;
  page["smoothness"] = {
      {"proved", smoothness.order}, {"evidence", smoothness.evidence}, {"obstacle", smoothness.obstacle}};
  page["bound"] = bound_json(bounds->last());
  page["stable"] = decision_json(stable);
  page["sobolev"] = sobolev_json(sobolev, stable);
  if (integers)
    page["limit"] = {{"level", 0}, {"first_index", integers->first_index}, {"values", numbers_json(integers->values)}};
  if (grid && mean)
    page["variance"] = {{"level", grid->level},
                        {"sup", enclosure_json({grid->largest(), variance_ceiling(scheme.mask)})},
                        {"inf", enclosure_json({variance_floor(scheme.mask), grid->smallest()})},
                        {"derivative_sup", enclosure_json(Enclosure::at_least(grid->steepest()))},
                        {"mean", to_text(*mean)}};
  if (!skipped.empty()) page["skipped"] = skipped;
  return page;
}

std::string SchemePage::text() const {
  std::ostringstream page;
  const Mask& mask = scheme.mask;
  const IndexRange range = subcert::support(mask);
  page << "scheme        " << scheme.specification << "  (" << scheme.title << ")\n"
       << "mask          " << mask.symbol().to_mask_text() << "\n"
       << "symbol        " << mask.symbol().to_text() << "\n"
       << "              = " << factor_text(*this) << "\n"
       << "symmetry      " << symmetry_text(symmetry) << "\n"
       << "support       mask " << range.first << " ... " << range.last << ", basic limit function ["
       << to_text(support.lower) << ", " << to_text(support.upper) << "]\n"
       << "sum rules     " << rules << "\n"
       << "polynomials   generates degree " << polynomials.generation_degree << ", reproduces degree "
       << polynomials.reproduction_degree << " with f_j at j"
       << (polynomials.parametrization == 0  ? ""
           : polynomials.parametrization > 0 ? " + "
                                             : " - ")
       << (polynomials.parametrization == 0 ? "" : to_text(abs(polynomials.parametrization)))
       << "; approximation order " << polynomials.approximation_order() << "\n"
       << "convergence   " << to_text(convergence.truth) << ": " << convergence.reason << "\n";
  if (!convergence.is_yes()) return page.str();
  page << "smoothness    C^" << smoothness.order << " proved: " << smoothness.evidence << "\n"
       << "              C^" << smoothness.order + 1 << " not proved: " << smoothness.obstacle << "\n";
  const HolderBound& bound = bounds->last();
  page << "Hoelder       >= " << bound.exponent.lower_text(12) << " after " << bound.levels << " levels; ||S_b^"
       << bound.levels << "|| = " << to_decimal(bound.norm, 12, Rounding::nearest) << "\n";
  if (sobolev) page << "Sobolev       " << sobolev_text(*sobolev, stable) << "\n";
  page << "stable        " << to_text(stable.truth) << ": " << stable.reason << "\n";
  if (!skipped.empty()) page << "values        skipped: " << skipped << "\n";
  if (integers) {
    page << "at integers  ";
    for (std::size_t i = 0; i < integers->values.size(); ++i)
      page << (i ? ", " : " ") << "phi(" << to_text(integers->point(i)) << ") = " << to_text(integers->values[i]);
    page << "\n";
  }
  if (grid && mean)
    page << "variance      psi on the grid of level " << grid->level
         << ": maximum >= " << to_decimal(grid->largest(), 9, Rounding::down)
         << ", minimum <= " << to_decimal(grid->smallest(), 9, Rounding::up)
         << ", max |psi'| >= " << to_decimal(grid->steepest(), 9, Rounding::down) << "\n"
         << "              mean = squared L2 norm of phi = " << to_decimal(*mean, 15, Rounding::nearest) << " = "
         << to_text(*mean) << "\n";
  return page.str();
}

}  // namespace subcert::cli
