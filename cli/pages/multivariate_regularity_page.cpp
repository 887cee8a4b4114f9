#include "multivariate_regularity_page.hpp"

#include "exponent_text.hpp"

#include <sstream>

namespace subcert::cli {
MultivariateRegularityPage multivariate_regularity_page(MultivariateScheme scheme, const Budget& budget,
                                                        const WantedWidth& wanted) {
  const Stopwatch watch;
  MultivariateRegularity regularity = scheme.factors.empty()
                                          ? multivariate_regularity(scheme.mask, budget, wanted.bits)
                                          : tensor_product_regularity(scheme.factors, budget, wanted.bits);
  return {std::move(scheme), std::move(regularity), watch.seconds(), wanted.digits};
}

Json MultivariateRegularityPage::json() const {
  const Dilation& dilation = scheme.mask.dilation();
  const auto& radius = regularity.radius;
  return {{"scheme", scheme.specification},
          {"variables", scheme.mask.dimension()},
          {"dilation", dilation.rows()},
          {"digits", dilation.digits()},
          {"sum_rules", regularity.sum_rules},
          {"bound", regularity.bound ? bound_json(*regularity.bound) : Json()},
          {"converges", to_text(regularity.converges.truth)},
          {"dimension", regularity.space ? Json(regularity.space->family.size()) : Json()},
          {"blocks", radius && radius->by_blocks() ? Json(radius->by_blocks()->triangular.sizes) : Json()},
          {"radius", radius ? enclosure_json(radius->radius) : Json()},
          {"holder", enclosure_json(regularity.exponent, std::max(digits, 20))},
          {"exact", regularity.exact.is_yes()},
          {"exactness", regularity.exact.reason},
          {"closed", regularity.is_closed()},
          {"method", radius ? method_text(*radius) : "factors of a tensor product"},
          {"product", radius ? word_text(radius->product.word) : ""},
          {"vertices", radius ? Json(radius->vertices()) : Json()},
          {"stable", regularity.stable.is_yes()},
          {"stability", regularity.stable.reason},
          {"sobolev", regularity.sobolev ? Json{{"exponent", enclosure_json(*regularity.sobolev)},
                                                {"stable", regularity.stable.is_yes()}}
                                         : Json()},
          {"seconds", seconds}};
}

std::string MultivariateRegularityPage::text() const {
  const Dilation& dilation = scheme.mask.dilation();
  const auto& radius = regularity.radius;
  std::ostringstream page;
  page << "scheme       " << scheme.specification << "  (" << scheme.title << ")\n"
       << "dilation     " << dilation.to_text() << ", digits " << to_text(dilation.digits()) << "\n"
       << "sum rules    " << regularity.sum_rules << "\n"
       << "converges    " << to_text(regularity.converges.truth) << ": " << regularity.converges.reason << "\n";
  if (regularity.space)
    page << "space        dimension " << regularity.space->family.size() << ", differences of order "
         << regularity.space->order << (regularity.space->is_of_values() ? " of phi on " : " on ")
         << regularity.space->window.size() << " lattice points"
         << (regularity.space->dilation == dilation
                 ? "\n"
                 : ", for the dilation " + regularity.space->dilation.to_text() + ", digits " +
                       to_text(regularity.space->dilation.digits()) + "\n");
  if (regularity.bound && regularity.bound->exponent.lower.value_or(0) > 0)
    page << "bound        >= " << regularity.bound->exponent.lower_text(12) << " by norms of products of length "
         << regularity.bound->levels << "\n";
  if (radius) {
    page << "radius       " << enclosure_text(radius->radius, 15) << "  (joint spectral radius, "
         << sized_method_text(*radius) << ")\n";
    if (const BlockProof* blocks = radius->by_blocks())
      page << "blocks       " << sizes_text(blocks->triangular.sizes) << "\n";
    page << "product      " << word_text(radius->product.word) << "  (radius "
         << enclosure_text(radius->product.radius, 15)
         << (radius->exact.is_yes() ? ", proved to attain the joint spectral radius)\n" : ")\n");
  }
  page << "stable       " << to_text(regularity.stable.truth) << ": " << regularity.stable.reason << "\n"
       << "exponent     ";
  if (!regularity.exponent.lower)
    page << (regularity.converges.is_no()    ? "none, as the scheme does not converge"
             : regularity.converges.is_yes() ? "unknown"
                                             : "unknown, as convergence is not proved");
  else if (!regularity.exponent.upper)
    page << enclosure_text(regularity.exponent, 14) << "  (a proved lower bound"
         << (regularity.stable.is_no() ? "; the shifts are unstable, so the limits may be smoother)" : ")");
  else
    page << enclosure_text(regularity.exponent, std::max(digits, 14)) << "  (enclosed with proof"
         << (scheme.factors.empty() || radius ? ")" : ", by the factors)");
  page << "\n";
  if (regularity.sobolev)
    page << "Sobolev      " << enclosure_text(*regularity.sobolev, 14) << "  (L2 smoothness"
         << (!regularity.sobolev->upper   ? ", a lower bound as the shifts are not proved stable)"
             : regularity.stable.is_yes() ? ", exact as the shifts are stable)"
                                          : ", exact, by the inner products of the shifts)")
         << "\n";
  if (!regularity.is_closed() && !regularity.converges.is_no())
    page << "budget       the search did not close; the enclosure reached is printed\n";
  return page.str();
}

}  // namespace subcert::cli
