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

/// How an answer is printed.
struct RegularityForm {
  double seconds = 0;    ///< that the work took
  int digits = 0;        ///< of the exponent, at least
  bool complete = true;  ///< the enclosure is as narrow as was asked for
};

Facts regularity_facts(const Scheme& scheme, const HolderRegularity& regularity,
                       const std::optional<SobolevRegularity>& sobolev, const RegularityForm& form);
Facts regularity_facts(const Scheme& scheme, const MultivariateRegularity& regularity, const RegularityForm& form);

/// What a supersolution in frequency proves.
Facts frequency_facts(const Scheme& scheme, const std::optional<FrequencyBound>& bound, double seconds);

}  // namespace subcert::facts
