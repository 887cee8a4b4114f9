#pragma once
/// A printed value set beside the computed one, and the verdict.

#include <subcert/proofs-checks/verdict.hpp>

#include <string>
#include <variant>
#include <vector>

namespace subcert::formats {

/// Domain: `printed` is a decimal number as printed; the count of its decimals sets the unit. Errors: throws
/// a domain error where it is not.
Verdict compare(const std::string& printed, const Enclosure& computed);

/// What was computed: a number, or an exact object (a mask, an interval) as text.
using Computed = std::variant<Enclosure, std::string>;

struct Comparison {
  std::string row;
  std::string column;
  std::string scheme;  ///< specification
  std::string printed;
  Computed computed;
  Verdict verdict;
  Verdict recorded;  ///< the verdict that this version of the toolkit is known to reach
  std::string note;

  std::string cell() const { return row + ", " + column; }
  /// For people: the number with two digits more than printed, or both ends, or '>= bound'.
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
  int count(Verdict verdict) const;
};

}  // namespace subcert::formats
