#pragma once
/// Sentences of pages that state results, each made of the decisions that it states: where one fails, it says another
/// thing.

#include <subcert/proofs-checks/conjectures/decay.hpp>
#include <subcert/proofs-checks/theorems/theorem.hpp>

#include <string>
#include <vector>

namespace subcert::reports {

/// The exponents of a family beside the bounds that a table prints, n by n. Domain: as many bounds as exponents.
struct BoundsAndExponents {
  std::string family;               ///< `primal`
  int first_n;                      ///< of the table
  std::vector<std::string> bounds;  ///< as printed
  std::vector<Enclosure> exponents;

  /// The largest printed bound, and its n.
  std::pair<std::string, int> largest_bound() const;
  /// The n whose exponents are proved to be above it.
  std::vector<int> above() const;
  /// How far the exponent falls at most, beyond this n, from one n to a larger one. Domain: both ends are enclosed.
  Rational dip_from(int n) const;
};

/// How bounds move from one number of levels to the next.
struct LevelSteps {
  Rational largest_rise;  ///< of any scheme, from the smaller to the larger number of levels that are compared
  std::string scheme;     ///< whose rise it is
  int falls, steps;       ///< how many of the steps from a level to the next go down
};
/// Domain: the tables print bounds in multiples of `unit`.
std::string levels_sentence(const LevelSteps& steps, const Rational& unit);

/// A recipe for Table 3 beside what is certified.
struct RecipeFinding {
  std::size_t agrees, cells;
  bool is_truncated;   ///< whether its sum leaves out the ends of the support
  Truth lowers;        ///< whether none of its maxima is above the certified ones
  Truth adds_a_slope;  ///< whether some of its slopes are above the certified ones
};
/// With how much of the table the recipe agrees.
std::string recipe_finding(const RecipeFinding& found);
/// What leaving out the ends does to the numbers; empty where nothing is left out.
std::string truncation_sentence(const RecipeFinding& found);

/// Whether the exponents follow the fall of the printed bounds.
std::string exponents_finding(const std::vector<BoundsAndExponents>& families);
/// What a theorem says first, behind a blank; empty where it is not proved.
std::string for_every_n(const theorems::Theorem& theorem);

/// The two halves of Conjecture 7 by the decay of max psi and of max |psi'|, a finding for each degree.
struct ConjectureDecay {
  std::vector<conjectures::DecayFinding> maxima, slopes;

  Truth first_half() const;   ///< the rate 1/n is observed for all degrees
  Truth upper_bound() const;  ///< 1/n^2 bounds the slopes of all degrees
  Truth second_half() const;  ///< the rate 1/n^2 is observed for all degrees
};

/// One sentence about each half.
std::string conjecture_7_finding(const ConjectureDecay& decay);

/// What the theorems on the page settle: how many of them are proved, and which are not.
std::string theorems_sentence(const std::vector<std::pair<std::string, Truth>>& theorems);

}  // namespace subcert::reports
