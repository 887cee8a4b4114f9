#pragma once
/// What `subcert regularity` prints about schemes of two and three variables.

#include <subcert/cli/command.hpp>
#include "exponent_text.hpp"

#include <subcert/analysis/regularity/multivariate_regularity.hpp>

namespace subcert::cli {

struct MultivariateRegularityPage {
  MultivariateScheme scheme;
  MultivariateRegularity regularity;
  double seconds = 0;
  int digits = 0;  ///< of the exponent, at least

  Json json() const;
  std::string text() const;
};

/// By the factors of a tensor product, otherwise by the mask.
MultivariateRegularityPage multivariate_regularity_page(MultivariateScheme scheme, const Budget& budget,
                                                        const WantedWidth& wanted);

}  // namespace subcert::cli
