#pragma once
/// Specifications of the data-dependent schemes, `l1:points=6,d=1,iterations=6,delta=1e-8`.

#include "l1_scheme.hpp"

#include <subcert/schemes/specification.hpp>

namespace subcert::data {

/// A data-dependent scheme with its canonical specification and a name for people.
struct NamedL1Scheme {
  std::string specification;
  std::string title;
  L1Scheme scheme;
};

/// Whether the text names the family l1.
bool is_l1_specification(std::string_view specification);

/// Reads `l1:points=P[xQ]` with the optional keys d (1), iterations (6), delta (1e-8, decimal or p/q), tolerance (0,
/// the same) and residuals (separate or joint). Domain: 2, ..., 64 points on curves, 2, ..., 16 along each axis of a
/// grid; d < points, at most 3; at most 10^6 iterations; delta from 1e-300 to 1e300. Errors: throws SpecificationError.
NamedL1Scheme make_l1_scheme(std::string_view specification);

/// The line of help beside those of families().
FamilyHelp l1_help();

}  // namespace subcert::data
