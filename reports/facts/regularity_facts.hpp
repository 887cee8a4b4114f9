#pragma once
/// Facts about the Hoelder exponent of a scheme.

#include "exponent_formula.hpp"
#include "fact.hpp"

#include <subcert/analysis/limit/field_values.hpp>
#include <subcert/analysis/regularity/frequency/frequency_bound.hpp>
#include <subcert/analysis/regularity/regularity.hpp>
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

/// `sobolev`: of one variable.
Facts regularity_facts(const Scheme& scheme, const Regularity& regularity,
                       const std::optional<SobolevRegularity>& sobolev, const RegularityForm& form);

/// Of a vector of functions: its equation, its support and how many solutions there can be; the exponent of each, HC^l
/// of a Hermite scheme, and whether all are continuous.
Facts equation_facts(const LatticeMask& mask, const FunctionVector& vector);
Fact components_fact(const FunctionVector& vector, int digits = 0);
Fact hermite_fact(const std::optional<HermiteOrder>& hermite);
Fact continuous_fact(const Decision& continuous);

/// What is needed where one function is: `one continuous solution up to a factor, got up to 2; ...`.
std::string needed_solution(const FunctionVector& vector);

/// Of a vector of functions, its values at lattice points that are not 0.
Fact values_fact(const FieldValues& values);

/// The line of the exponent alone. `digits`: at least.
Fact exponent_fact(const Scheme& scheme, const Regularity& regularity, int digits);

/// What a supersolution in frequency proves.
Facts frequency_facts(const Scheme& scheme, const std::optional<FrequencyBound>& bound, double seconds);

}  // namespace subcert::facts
