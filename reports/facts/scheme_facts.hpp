#pragma once
/// Facts about a scheme: what follows from its mask, and what `subcert analyze` finds out.

#include "fact.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/regularity/regularity.hpp>
#include <subcert/analysis/regularity/sobolev.hpp>
#include <subcert/analysis/variance/variance.hpp>
#include <subcert/schemes/specification.hpp>

#include <functional>
#include <optional>

namespace subcert::facts {

/// Nested arrays of exact numbers, the last variable outermost.
Json coefficients_json(const LatticeMask& mask);
/// For each variable, of one alone without the list.
Json first_index_json(const LatticeMask& mask);
Json limit_support_json(const LatticeMask& mask);  ///< {"lower", "upper"}

/// What follows from the mask alone, exactly. Cost: that of polynomial_reproduction().
Facts mask_facts(const Scheme& scheme);

/// What takes time to find out; what was not asked or is not known is absent.
struct Analysis {
  Decision convergence;
  std::optional<SmoothnessProof> smoothness;  ///< of tensor products that of the roughest factor
  std::optional<Regularity> regularity;       ///< as far as the search gets in a few seconds
  std::optional<SobolevRegularity> sobolev;   ///< of curves
  std::optional<LimitValues> integers;
  std::optional<VarianceGrid> grid;
  std::optional<Rational> mean;
  std::string skipped;  ///< why values are missing although the scheme converges
};

struct AnalysisOptions {
  ProofLimits limits;
  int grid_level = 6;                                     ///< of the variance curve
  std::function<void(const std::string&)> progress = {};  ///< what is done next
};

/// Errors: what has no proof within the limits is absent; else those of the parts. Cost: the time of the limits, and
/// half a second more for exact values.
Analysis analysis(const Scheme& scheme, const AnalysisOptions& options);

/// The mask's facts, and those found out.
Facts scheme_facts(const Scheme& scheme, const Analysis& known);

}  // namespace subcert::facts
