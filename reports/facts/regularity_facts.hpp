#pragma once
/// Facts about the Hoelder exponent of a scheme.

#include "fact.hpp"

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
Fact values_fact(const LatticeSequence& values);

/// The line of the exponent alone. `digits`: at least.
Fact exponent_fact(const Scheme& scheme, const Regularity& regularity, int digits);

/// The exponent in closed form: rules - log_arity(radius).
struct ExponentFormula {
  int rules, arity;
  Rational radius;

  std::string text() const;   ///< `3 - log_2(3)`
  std::string latex() const;  ///< `3 - \log_{2} 3`
};

/// Nothing where the radius is not known to be rational, or the exponent is.
std::optional<ExponentFormula> exponent_formula(const Scheme& scheme, const Regularity& regularity);

/// The same as a fact, for programs alone where there is none.
Fact formula_fact(const std::optional<ExponentFormula>& formula);

/// What a supersolution in frequency proves.
Facts frequency_facts(const Scheme& scheme, const std::optional<FrequencyBound>& bound, double seconds);

}  // namespace subcert::facts
