#pragma once
/// Expected properties of schemes, read from a TOML file and checked: docs/properties.md.

#include <subcert/analysis/family/mask_list.hpp>
#include <subcert/analysis/family/property_range.hpp>
#include <subcert/analysis/family/recurrence.hpp>
#include <subcert/analysis/symbol/support/budget.hpp>
#include <subcert/proofs-checks/file_error.hpp>
#include <subcert/schemes/parametric_specification.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace subcert::properties {

using subcert::FileError;

/// Of each search.
struct SearchLimits {
  double seconds;                             ///< of processor time
  std::size_t memory = std::size_t{1} << 30;  ///< bytes that it may hold

  /// From now on.
  Budget budget() const { return {Deadline::in(seconds), memory}; }
};

/// One property with what is expected. `expected` is what follows the name in messages: `>= 2`, `yes`, `[-2, 2]`;
/// `line` says both as the file does. Canonical: of relation/number, yes, word and ends exactly what the property needs
/// is present.
struct Expectation {
  std::string property;
  std::string expected;
  Place place;
  std::string relation;  ///< `=`, `>=`, `<=`, `>` or `<`, with `number`
  Rational number;
  bool yes = false;
  std::string word;
  std::optional<Interval> ends;
  std::string line;
};

/// The schemes of a family for all values of its parameter between two numbers.
struct SchemeRange {
  ParametricScheme family;
  ParameterRange values;
};

/// The same family with a value for each level: every sequence of values, closed ends included, or those that follow
/// each other from a start on.
struct SchemeLevels {
  /// All that is said of how they follow each other.
  struct Following {
    Recurrence recurrence;
    Interval start;
  };
  ParametricScheme family;
  Interval values;
  std::optional<Following> following;
};

/// The same family with a value for each new point of each level: every choice of values, closed ends included.
struct SchemePoints {
  ParametricScheme family;
  Interval values;
};

/// Masks of a list, one for each level.
struct SchemeList {
  std::string specification;  ///< for people
  MaskList list;
};

struct ExpectedScheme {
  std::string name;  ///< the specification where the file gives none
  std::string specification;
  std::variant<Scheme, SchemeRange, SchemeLevels, SchemePoints, SchemeList> scheme;
  std::vector<Expectation> expectations;
  std::string lines;  ///< of the file that say which scheme it is: TOML, which lines of expectations follow
};

/// How an expected value is written: true or false; `>= K` with a whole K; a comparison; one, or an integer; [first,
/// last]; a word; valences, `3..12` or 7.
enum class Expects { answer, order, comparison, whole_number, ends, word, valences };

/// All that is known of a property. A function that is absent: it is none of such schemes.
struct Property {
  std::string name;
  std::string values;  ///< that it takes, for messages
  std::string meaning;
  Expects expects;
  using Decides = Decision (*)(const Scheme& scheme, const Expectation& expectation, const SearchLimits& limits);
  Decides of_curve;
  Decides of_surface;
  std::optional<RangeProperty::Kind> of_ranges = {};  ///< for all values of a parameter
  /// Of masks that change from level to level, or from point to point.
  bool of_levels() const;
  Decides of_vector = nullptr;  ///< of masks of matrices
  bool of_hermite = false;      ///< of these of Hermite schemes alone

  /// The one for this scheme, or null.
  Decides decides(const Scheme& of) const;
};
/// Which schemes it is one of, for messages.
std::string kind_of(const Scheme& scheme);

const std::vector<Property>& known_properties();
/// The one of this name, or null.
const Property* find_property(std::string_view name);

/// Reads a file; a scheme with an unknown key, a value of the wrong kind, without expected properties, or one that
/// cannot be made, is that error. Domain: at most 10^6 characters. Errors: throws FileError for what is no TOML, and
/// for a file without schemes.
std::vector<std::variant<ExpectedScheme, FileError>> read_schemes(std::string_view text);
/// The same where no scheme is an error. Errors: throws the first one.
std::vector<ExpectedScheme> read_expectations(std::string_view text);

/// Whether the scheme has the property, of a range: for all values of the parameter, of levels: for all sequences that
/// are meant, of points: for all choices. The reason says what was found. Domain: a property of surfaces for schemes of
/// two and three variables, of vectors for masks of matrices, of ranges for ranges, of levels for these. Cost: as the
/// analysis that it needs, with these limits for each search.
Decision has_property(const ExpectedScheme& scheme, const Expectation& expectation, const SearchLimits& limits);

}  // namespace subcert::properties
