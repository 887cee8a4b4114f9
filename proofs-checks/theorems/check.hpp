#pragma once
/// One inequality of a proof, decided on enclosures.

#include <subcert/analysis/symbol/numbers/numbers.hpp>

#include <string>
#include <vector>

namespace subcert::theorems {

/// left < right, with the number it has in the text.
struct Check {
  std::string id;
  std::string claim;
  Enclosure left;
  Enclosure right;
  Decision decision;

  /// right - left: positive where the inequality is proved. Absent ends where an end of a side is absent.
  Enclosure margin() const;
};

/// yes if every point of `left` is below every point of `right`, no if none is, unknown otherwise.
Check less(const std::string& id, const std::string& claim, const Enclosure& left, const Enclosure& right);

/// yes if all checks are, no if one is, otherwise unknown with the first undecided check.
Decision verdict(const std::vector<Check>& checks);

}  // namespace subcert::theorems
