#pragma once
/// Which shortcut gives the digits that Table 3 of [DHHS15] prints: a search over all of variance_shortcuts().

#include "formats/published.hpp"
#include "variance_shortcuts.hpp"

#include <map>

namespace subcert::reports {

/// What a cell of Table 3 is: a maximum of psi or of |psi'|, times a power of n.
struct VarianceCell {
  int n;
  bool slope;
  int factor;

  /// Domain: a row `d=1, n=3` and a quantity variance, n*variance, slope or n^2*slope.
  explicit VarianceCell(const formats::PublishedCell& cell);
};

class ShortcutSearch {
 public:
  /// Evaluates all shortcuts for all schemes of the table, on at most `jobs` threads.
  ShortcutSearch(const formats::PublishedTable& table, int jobs);

  /// The index of the shortcut that gives the digits of the most cells; of several the first.
  std::size_t best() const { return best_; }
  std::size_t cells_given() const { return cells_given_; }
  std::size_t cells() const { return table_.cells.size(); }

  Rational value(const formats::PublishedCell& cell, std::size_t shortcut) const;
  bool gives(const formats::PublishedCell& cell, std::size_t shortcut) const;

  /// For a cell whose printed value is wrong: the best shortcut where it gives the digits, else the first other one
  /// that does, else that none tried does.
  std::string note(const formats::PublishedCell& cell) const;

  /// How far one shortcut explains the table, in sentences.
  std::string summary() const;

 private:
  const formats::PublishedTable& table_;
  std::map<std::string, std::vector<ShortcutValues>> values_;
  std::size_t best_ = 0;
  std::size_t cells_given_ = 0;
};

}  // namespace subcert::reports
