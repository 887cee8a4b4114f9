#pragma once
/// Facts about the Hoelder exponent of a scheme.

#include "fact.hpp"

#include <subcert/analysis/regularity/frequency/frequency_bound.hpp>
#include <subcert/analysis/regularity/holder_regularity.hpp>
#include <subcert/analysis/regularity/multivariate_regularity.hpp>
#include <subcert/analysis/regularity/sobolev.hpp>
#include <subcert/schemes/specification.hpp>

#include <optional>

namespace subcert::facts {

/// By the factors of a tensor product, otherwise by the mask. Domain and errors: those of multivariate_regularity() and
/// tensor_product_regularity().
MultivariateRegularity regularity_of(const MultivariateScheme& scheme, const Budget& budget, int bits = default_bits);

/// How an answer is printed.
struct RegularityForm {
  double seconds = 0;    ///< that the work took
  int digits = 0;        ///< of the exponent, at least
  bool complete = true;  ///< the enclosure is as narrow as was asked for
};

Facts regularity_facts(const Scheme& scheme, const HolderRegularity& regularity,
                       const std::optional<SobolevRegularity>& sobolev, const RegularityForm& form);
Facts regularity_facts(const MultivariateScheme& scheme, const MultivariateRegularity& regularity,
                       const RegularityForm& form);

/// What a supersolution in frequency proves.
Facts frequency_facts(const Scheme& scheme, const std::optional<FrequencyBound>& bound, double seconds);

}  // namespace subcert::facts
