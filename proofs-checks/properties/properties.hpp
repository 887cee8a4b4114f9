#pragma once
/// Expected properties of schemes, read from a TOML file and checked: docs/properties.md.

#include <subcert/proofs-checks/file_error.hpp>
#include <subcert/schemes/parametric_specification.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace subcert::properties {

using subcert::FileError;

/// One property with what is expected. `expected` is what follows the name in messages: `>= 2`, `yes`, `[-2, 2]`.
/// Canonical: of relation/number, yes, word and ends exactly what the property needs is present.
struct Expectation {
  std::string property;
  std::string expected;
  Place place;
  std::string relation;  ///< `=`, `>=`, `<=`, `>` or `<`, with `number`
  Rational number;
  bool yes = false;
  std::string word;
  std::optional<Interval> ends;
};

/// The schemes of a family for all values of its parameter between two numbers.
struct SchemeRange {
  ParametricScheme family;
  ParameterRange values;
};

struct ExpectedScheme {
  std::string name;  ///< the specification where the file gives none
  std::string specification;
  std::variant<Scheme, MultivariateScheme, SchemeRange> scheme;
  std::vector<Expectation> expectations;
};

/// The names of the properties, each with the values that it takes.
struct PropertyHelp {
  std::string name;
  std::string values;
  std::string meaning;
  bool of_surfaces = true;  ///< also of schemes of two and three variables
  bool of_ranges = false;   ///< also for all values of a parameter
};
const std::vector<PropertyHelp>& known_properties();

/// Reads a file. Domain: at most 10^6 characters. Errors: throws FileError for what is no TOML, an unknown key, a value
/// of the wrong kind, a scheme that cannot be made, a scheme without expected properties, a file without schemes.
std::vector<ExpectedScheme> read_expectations(std::string_view text);

/// Whether the scheme has the property, of a range: for all values of the parameter. The reason says what was found.
/// Domain: a property of surfaces for schemes of two and three variables, of ranges for ranges. Cost: as the analysis
/// that it needs, with about this many seconds for each search.
Decision has_property(const ExpectedScheme& scheme, const Expectation& expectation, double seconds);

}  // namespace subcert::properties
