#include "multivariate_page.hpp"

#include <subcert/analysis/difference/multivariate_convergence.hpp>
#include <subcert/analysis/regularity/multivariate_regularity.hpp>
#include <subcert/analysis/reproduction/multivariate_reproduction.hpp>

#include <sstream>

namespace subcert::cli {
namespace {

constexpr const char* names[] = {"x", "y", "z"};

Json nested(const MultivariatePolynomial& symbol, MultivariatePolynomial::Exponents& at, std::size_t variable) {
  Json list = Json::array();
  const long first = symbol.lowest()[variable], last = symbol.highest()[variable];
  for (at[variable] = first; at[variable] <= last; ++at[variable])
    list.push_back(variable == 0 ? Json(to_text(symbol.coefficient(at))) : nested(symbol, at, variable - 1));
  return list;
}

std::string bracketed(const std::vector<Rational>& values) {
  std::string text;
  for (const Rational& value : values) text += (text.empty() ? "(" : ", ") + to_text(value);
  return text + ")";
}

struct MultivariatePage {
  MultivariateReproduction polynomials;
  std::vector<Interval> support;
  Decision convergence;
  std::optional<SmoothnessProof> smoothness;  ///< of tensor products: that of the roughest factor
  std::optional<MultivariateRegularity>
      regularity;  ///< of other schemes with a dilation that splits into isotropic ones
};

MultivariatePage make_page(const MultivariateScheme& scheme, const ProofLimits& limits) {
  MultivariatePage page{
      scheme.factors.empty() ? polynomial_reproduction(scheme.mask) : tensor_product_reproduction(scheme.factors),
      limit_support(scheme.mask),
      {},
      {},
      {}};
  if (scheme.factors.empty() && !scheme.mask.dilation().isotropic_subspaces().empty()) {
    page.regularity = multivariate_regularity(scheme.mask, {limits.deadline});
    page.convergence = page.regularity->converges;
    return page;
  }
  if (scheme.factors.empty()) {
    page.convergence = converges(scheme.mask, limits);
    return page;
  }
  page.convergence = tensor_product_converges(scheme.factors, limits);
  for (const Mask& factor : scheme.factors) {
    const SmoothnessProof proof = proved_smoothness(factor, limits);
    if (!page.smoothness || proof.order < page.smoothness->order) page.smoothness = proof;
  }
  return page;
}

std::string page_text(const MultivariateScheme& scheme, const MultivariatePage& page) {
  std::ostringstream text;
  text << "scheme        " << scheme.specification << "  (" << scheme.title << ")\n";
  const long count = scheme.mask.symbol().count();
  text << "mask          "
       << (count <= 150 ? to_mask_text(scheme.mask) : std::to_string(count) + " coefficients, see subcert mask")
       << "\n";
  text << "support       basic limit function in ";
  for (std::size_t v = 0; v < page.support.size(); ++v)
    text << (v ? " x [" : "[") << to_text(page.support[v].lower) << ", " << to_text(page.support[v].upper) << "]";
  text << "\nsum rules     " << page.polynomials.sum_rules;
  const int arity = scheme.mask.dilation().factor().value_or(0);
  for (std::size_t v = 0; v < page.polynomials.factors.size(); ++v) {
    text << (v ? ", (" : "; factors (") << "1 + " << (arity == 2 ? "" : "... + ") << names[v];
    if (arity > 2) text << "^" << arity - 1;
    text << ")^" << page.polynomials.factors[v];
  }
  text << "\npolynomials   generates total degree " << page.polynomials.generation_degree()
       << ", reproduces total degree " << page.polynomials.reproduction_degree << " with f_j at j + "
       << bracketed(page.polynomials.parametrization) << "\n"
       << "convergence   " << to_text(page.convergence.truth) << ": " << page.convergence.reason << "\n";
  if (page.regularity && page.convergence.is_yes())
    text << "stable        " << to_text(page.regularity->stable.truth) << ": " << page.regularity->stable.reason << "\n"
         << "exponent      " << enclosure_text(page.regularity->exponent, 12) << "  (Hoelder, as far as "
         << "subcert regularity gets in the time)\n";
  if (page.regularity && page.regularity->sobolev)
    text << "Sobolev       " << enclosure_text(*page.regularity->sobolev, 12) << "\n";
  if (page.smoothness && page.convergence.is_yes())
    text << "smoothness    C^" << page.smoothness->order << " proved, by the factors; C^" << page.smoothness->order + 1
         << " not proved: " << page.smoothness->obstacle << "\n";
  return text.str();
}

}  // namespace

Json coefficients_json(const MultivariateMask& mask) {
  MultivariatePolynomial::Exponents at = mask.symbol().lowest();
  return nested(mask.symbol(), at, at.size() - 1);
}

Json limit_support_json(const MultivariateMask& mask) {
  Json list = Json::array();
  for (const Interval& side : limit_support(mask)) list.push_back(interval_json(side));
  return list;
}

Decision analyze_multivariate(const MultivariateScheme& scheme, const ProofLimits& limits,
                              const CommonOptions& options) {
  const MultivariatePage page = make_page(scheme, limits);
  if (options.json) {
    Json json{{"scheme", scheme.specification},
              {"title", scheme.title},
              {"variables", scheme.mask.dimension()},
              {"arity", optional_json(scheme.mask.dilation().factor())},
              {"dilation", scheme.mask.dilation().rows()},
              {"first_index", scheme.mask.symbol().lowest()},
              {"coefficients", coefficients_json(scheme.mask)},
              {"sum_rules", page.polynomials.sum_rules},
              {"factors", page.polynomials.factors},
              {"support", limit_support_json(scheme.mask)},
              {"generation_degree", page.polynomials.generation_degree()},
              {"reproduction_degree", page.polynomials.reproduction_degree},
              {"parametrization", numbers_json(page.polynomials.parametrization)},
              {"convergence", decision_json(page.convergence)}};
    if (page.regularity) {
      json["stable"] = decision_json(page.regularity->stable);
      json["holder"] = enclosure_json(page.regularity->exponent);
      json["sobolev"] = enclosure_json(page.regularity->sobolev);
    }
    if (page.smoothness && page.convergence.is_yes())
      json["smoothness"] = {{"proved", page.smoothness->order}, {"obstacle", page.smoothness->obstacle}};
    options.answer(json);
  } else {
    options.answer(page_text(scheme, page));
  }
  return page.convergence;
}

}  // namespace subcert::cli
