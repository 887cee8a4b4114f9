#pragma once
/// Scheme specifications `FAMILY:key=value,key=value`, read, checked and printed back.

#include "local_regression.hpp"

#include <subcert/analysis/symbol/parse_error.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace subcert {

/// A specification that cannot be read.
class SpecificationError : public ParseError {
 public:
  SpecificationError(std::string_view token, std::size_t position, const std::string& expected)
      : ParseError("scheme specification", token, position, expected) {}
};

/// A scheme of one variable: its canonical specification, a name for people, its exact mask, and the local regressions
/// that it was made from.
struct Scheme {
  std::string specification;
  std::string title;
  Mask mask;
  std::optional<LocalRegression> rules = std::nullopt;
};

/// A scheme of two or three variables.
struct MultivariateScheme {
  std::string specification;
  std::string title;
  MultivariateMask mask;
  std::vector<Mask> factors = {};  ///< of a tensor product, first variable first; else none
};

using AnyScheme = std::variant<Scheme, MultivariateScheme>;

/// Reads a specification and makes the mask. Domain: at most 30,000 characters. Errors: throws SpecificationError
/// for an unknown family or key, a missing or repeated key, a malformed value, a value outside its range (sizes are
/// bounded so that every accepted mask is made in seconds and megabytes), or coset sums other than 1.
Scheme make_scheme(std::string_view specification);

/// Reads a specification of one, two or three variables. Domain and errors: as make_scheme.
AnyScheme make_any_scheme(std::string_view specification);

/// The canonical specification.
const std::string& specification_of(const AnyScheme& scheme);

/// One line of help for every family: those of one variable, which make_scheme accepts, and the others.
struct FamilyHelp {
  std::string family;
  std::string usage;
  std::string meaning;
};
const std::vector<FamilyHelp>& families();
const std::vector<FamilyHelp>& multivariate_families();

/// The coefficients as nested lists over their common denominator, the last variable outermost, and the first index of
/// each variable: `[[1,3],[3,1]]/8@-1,0`.
std::string to_mask_text(const MultivariateMask& mask);

}  // namespace subcert
