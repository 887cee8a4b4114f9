#pragma once
/// What is asked about a scheme, as it is meant.

#include <subcert/analysis/regularity/regularity.hpp>
#include <subcert/schemes/specification.hpp>

#include <utility>

namespace subcert {

/// The options with what the scheme says of its mask: how it is rounded, the field of its matrices, Hermite data.
inline RegularityOptions of_scheme(const Scheme& scheme, RegularityOptions options = {}) {
  options.rounding = scheme.rounding;
  options.quadratic = scheme.quadratic;
  options.integral = scheme.integral;
  options.hermite = scheme.form == VectorForm::hermite;
  return options;
}

}  // namespace subcert
