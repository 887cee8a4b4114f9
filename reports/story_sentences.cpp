#include "story_sentences.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/proofs-checks/number_list.hpp>
#include <subcert/proofs-checks/verdict.hpp>

#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

namespace subcert::reports {
namespace {

/// Of one question to all findings.
Truth of_all(const std::vector<conjectures::DecayFinding>& findings, Decision conjectures::DecayFinding::*question) {
  std::vector<Truth> truths;
  for (const conjectures::DecayFinding& one : findings) truths.push_back((one.*question).truth);
  return findings.empty() ? Truth::unknown : all_of(truths);
}

/// One of three texts.
std::string by(Truth truth, const std::string& yes, const std::string& no, const std::string& unknown) {
  return truth == Truth::yes ? yes : truth == Truth::no ? no : unknown;
}

std::string family_sentence(const BoundsAndExponents& family) {
  const auto [largest, at_n] = family.largest_bound();
  const std::vector<int> above = family.above();
  const int last = family.first_n + static_cast<int>(family.exponents.size()) - 1;
  if (above.empty())
    return fmt::format("For the {} schemes no exponent is proved to exceed {}, the largest printed bound.",
                       family.family, largest);
  return fmt::format(
      "For the {} schemes the exponent is proved to exceed {}, the largest printed bound, for n = {}; from there on it "
      "falls by less than {} from any n to a larger one, and at n = {} it is at least {}.",
      family.family, largest, number_list_text(above), to_decimal(family.dip_from(above.front()), 2, Rounding::up),
      last, to_fixed(*family.exponents.back().lower, 4, Rounding::down));
}

/// The n from which on the printed bounds of all families fall; nothing where they do not.
std::optional<int> fall_from(const std::vector<BoundsAndExponents>& families) {
  std::optional<int> common;
  for (const BoundsAndExponents& family : families) {
    const int n = family.largest_bound().second;
    for (auto i = static_cast<std::size_t>(n - family.first_n) + 1; i < family.bounds.size(); ++i)
      if (read_decimal(family.bounds[i]).value >= read_decimal(family.bounds[i - 1]).value) return std::nullopt;
    if (common && *common != n) return std::nullopt;
    common = n;
  }
  return common;
}

/// Whether every exponent from the n of the largest bound on is above all bounds that are printed.
bool do_not_follow(const BoundsAndExponents& family) {
  const std::vector<int> above = family.above();
  const int last = family.first_n + static_cast<int>(family.exponents.size()) - 1;
  for (int n = family.largest_bound().second; n <= last; ++n)
    if (std::ranges::find(above, n) == above.end()) return false;
  return true;
}

}  // namespace

std::pair<std::string, int> BoundsAndExponents::largest_bound() const {
  const auto found = std::ranges::max_element(bounds, {}, [](const std::string& b) { return read_decimal(b).value; });
  return {*found, first_n + static_cast<int>(found - bounds.begin())};
}

std::vector<int> BoundsAndExponents::above() const {
  const Decimal largest = read_decimal(largest_bound().first);
  std::vector<int> result;
  for (std::size_t i = 0; i < exponents.size(); ++i)
    if (exponents[i].lower && *exponents[i].lower > largest.value + largest.unit)
      result.push_back(first_n + static_cast<int>(i));
  return result;
}

Rational BoundsAndExponents::dip_from(int n) const {
  Rational dip = 0;
  for (auto i = static_cast<std::size_t>(n - first_n); i < exponents.size(); ++i)
    for (std::size_t j = i + 1; j < exponents.size(); ++j)
      dip = std::max(dip, Rational(*exponents[i].upper - *exponents[j].lower));
  return dip;
}

std::string exponents_finding(const std::vector<BoundsAndExponents>& families) {
  const bool follow_not = std::ranges::all_of(families, do_not_follow);
  const std::optional<int> n = fall_from(families);
  std::string text = "Tables 1 and 2 print bounds";
  if (n) text += fmt::format(", which fall from n = {} on{}", *n, follow_not ? " because 16 levels are too few" : "");
  text += follow_not ? "; the exponents do not follow them."
                     : "; whether the exponents follow them is not decided for every n.";
  for (const BoundsAndExponents& family : families) text += " " + family_sentence(family);
  return text;
}

std::string for_every_n(const theorems::Theorem& theorem) {
  return theorem.decision.is_yes() ? fmt::format(" {}: {}", theorem.title, theorem.statement.front()) : "";
}

std::string levels_sentence(const LevelSteps& steps, const Rational& unit) {
  const std::string rise =
      steps.largest_rise > unit
          ? fmt::format(
                "Between 8 and 16 levels the bounds of these schemes still rise by up to {} ({}), so the last decimal "
                "of "
                "the printed tables says how far the computation went, not how smooth the limits are. A comparison of "
                "two schemes by these tables is safe only where their difference is larger than what further levels "
                "could add.",
                to_fixed(steps.largest_rise, 4, Rounding::down), steps.scheme)
          : "Between 8 and 16 levels no bound of these schemes rises by more than a unit of the last printed place.";
  return fmt::format("What the bounds mean. Each is proved, and belongs to its number of levels. {} {}", rise,
                     steps.falls > 0
                         ? fmt::format("Nor do the bounds simply grow: of {} steps from one level to the "
                                       "next, {} go down.",
                                       steps.steps, steps.falls)
                         : fmt::format("None of {} steps from one level to the next goes down.", steps.steps));
}

std::string recipe_finding(const RecipeFinding& found) {
  return fmt::format("One {} agrees with {} of the {} numbers of the table.",
                     found.is_truncated ? "truncated sum" : "numerical recipe", found.agrees, found.cells);
}

std::string truncation_sentence(const RecipeFinding& found) {
  if (!found.is_truncated) return "";
  return fmt::format(
      "It leaves out the ends of the support, which {}, and {}.",
      by(found.lowers, "does not raise the maxima of psi", "raises some of the maxima of psi",
         "changes the maxima of psi"),
      by(found.adds_a_slope, "adds a slope that psi does not have", "adds no slope", "changes the slopes"));
}

Truth ConjectureDecay::first_half() const { return of_all(maxima, &conjectures::DecayFinding::rate); }
Truth ConjectureDecay::upper_bound() const { return of_all(slopes, &conjectures::DecayFinding::upper_bound); }
Truth ConjectureDecay::second_half() const { return of_all(slopes, &conjectures::DecayFinding::rate); }

std::string conjecture_7_finding(const ConjectureDecay& decay) {
  const std::string first = by(decay.first_half(), "holds", "is against what is certified",
                               "is not decided by what is certified");
  const std::string bound = by(decay.upper_bound(), "true as an upper bound, which is what Theorem 6 claims",
                               "not even true as an upper bound", "not decided as an upper bound");
  const std::string rate = by(decay.second_half(), "true as a rate", "false as a rate: the largest slope falls faster",
                              "not decided as a rate");
  return fmt::format(
      "Conjecture 7: the first half, max psi ~ 1/n, {}. The second half, max |psi'| ~ 1/n^2, is {}, and {}.", first,
      bound, rate);
}

std::string theorems_sentence(const std::vector<std::pair<std::string, Truth>>& theorems) {
  std::vector<std::string> left;
  for (const auto& [name, truth] : theorems)
    if (truth != Truth::yes) left.push_back(name + by(truth, "", " (an inequality fails)", " (not decided)"));
  if (left.empty())
    return fmt::format(
        "All {} theorems below are proved: each inequality that they rest on was certified for this "
        "page.",
        theorems.size());
  return fmt::format("Of {} theorems {} are proved; not so: {}.", theorems.size(), theorems.size() - left.size(),
                     fmt::join(left, ", "));
}

}  // namespace subcert::reports
