#pragma once
/// What `subcert analyze` says about a scheme of one variable.

#include "exponent_text.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/variance/variance.hpp>

namespace subcert::cli {

/// All answers, once computed, for both ways of printing.
struct SchemePage {
  Scheme scheme;
  int rules;
  LaurentPolynomial rest;  ///< symbol / (1 + ... + z^(arity-1))^rules
  Interval support;
  SymmetryReport symmetry;
  PolynomialReproduction polynomials;
  Decision convergence;
  SmoothnessProof smoothness;
  std::optional<HolderBounds> bounds;
  Decision stable;
  std::optional<SobolevRegularity> sobolev;
  std::optional<LimitValues> integers;
  std::optional<VarianceGrid> grid;
  std::optional<Rational> mean;
  std::string skipped;  ///< why values are missing although the scheme converges

  Json json() const;
  std::string text() const;
};

}  // namespace subcert::cli
