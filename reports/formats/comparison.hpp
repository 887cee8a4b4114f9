#pragma once
/// A printed value set beside the computed one, and the verdict.

#include <subcert/proofs-checks/verdict.hpp>

#include <string>
#include <variant>
#include <vector>

namespace subcert::formats {

/// Domain: `printed` is a decimal number as printed; the count of its decimals sets the unit. Errors: throws
/// a domain error where it is not.
ValueVerdict compare(const std::string& printed, const Enclosure& computed);

/// The same for a published statement about an exponent of smoothness: a decimal number; a whole number, which is meant
/// exactly; `<= 2.5`, a bound; `C^2`, for the class of the limits, which an exponent equal to 2 leaves open.
/// Errors: throws a domain error for any other text.
ValueVerdict compare_exponent(const std::string& printed, const Enclosure& computed);

/// The number to the nearest with so many places where they decide it, or both ends, or '>= bound', rounded outward.
std::string fixed_text(const Enclosure& enclosure, int places);

/// What was computed: a number, or an exact object (a mask, an interval) as text.
using Computed = std::variant<Enclosure, std::string>;

struct Comparison {
  std::string row;
  std::string column;
  std::string scheme;  ///< specification
  std::string printed;
  Computed computed;
  ValueVerdict verdict;
  ValueVerdict recorded;  ///< the verdict that this version of the toolkit is known to reach
  std::string note;
  std::string source = {};   ///< `[KEY] reference`, where a table is gathered from many
  std::string stable = {};   ///< whether the shifts are stable, where exponents depend on it
  std::string command = {};  ///< that computes this value again; empty where only the whole table is
  std::string derived = {};  ///< from what it follows, where it is no printed value of its own

  /// `[KEY]`.
  std::string source_key() const { return source.substr(0, source.find(']') + 1); }
  std::string cell() const { return row + ", " + column; }
  /// For people: the number with two digits more than printed, or with six where no number is printed; or both ends,
  /// or '>= bound'.
  std::string computed_text() const;
};

struct ComparisonTable {
  std::string paper;
  std::string id;
  std::string title;
  std::string place;
  bool grid;  ///< rows and columns as in the paper; otherwise one comparison a line
  std::vector<Comparison> comparisons;

  bool as_recorded() const;
  /// How many printed values there are of their own.
  int values() const;
  int count(ValueVerdict verdict) const;  ///< without derived ones
  /// Whether the cells have sources of their own.
  bool is_gathered() const;
};

}  // namespace subcert::formats
