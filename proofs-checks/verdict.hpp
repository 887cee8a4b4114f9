#pragma once
/// The words for what was found: of a printed value, of a statement, of a claim about random data.

#include <subcert/analysis/symbol/numbers.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace subcert {

/// Printed values. match: the computed enclosure is narrower than one unit of the last printed place and lies within
/// one such unit of the printed value. mismatch: the two cannot be that near. open: the enclosure does not decide.
/// Statements. holds: on the range tried. holds_for_all: proved for every admissible parameter. misprint: the printed
/// form fails at the witness, and a corrected form, tried in the same way, does not. false_claim: fails, and no
/// correction of the formula saves it. not_checkable: the reason is in the outcome. undecided: the check ran out of its
/// budget.
/// Claims about random data. confirmed: by a statistic. not_confirmed: the statistic does not show the claim; its
/// numbers say whether it shows the contrary.
/// not_reproducible: rests on data that were not published.
enum class Verdict {
  match,
  mismatch,
  open,
  holds,
  holds_for_all,
  misprint,
  false_claim,
  not_checkable,
  undecided,
  confirmed,
  not_confirmed,
  not_reproducible,
};

/// The words of the contract, in the order of Verdict.
inline constexpr std::array<const char*, 12> verdict_words{
    "match", "mismatch",      "open",      "holds",     "holds-for-all-n", "misprint",
    "false", "not-checkable", "undecided", "confirmed", "not confirmed",   "not-reproducible"};

inline std::string to_text(Verdict verdict) { return verdict_words[static_cast<std::size_t>(verdict)]; }

/// yes: what the paper says is right; no: it is wrong, or not shown; unknown: neither was found.
inline Truth truth_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::match:
    case Verdict::holds:
    case Verdict::holds_for_all:
    case Verdict::confirmed: return Truth::yes;
    case Verdict::mismatch:
    case Verdict::misprint:
    case Verdict::false_claim:
    case Verdict::not_confirmed: return Truth::no;
    default: return Truth::unknown;
  }
}

/// Of a comparison with a printed value: match, mismatch or open.
inline Verdict comparison_verdict(Truth equal) {
  return equal == Truth::yes ? Verdict::match : equal == Truth::no ? Verdict::mismatch : Verdict::open;
}

/// What several questions give together: no before unknown before yes.
inline Truth all_of(const std::vector<Truth>& truths) {
  const auto has = [&](Truth truth) { return std::find(truths.begin(), truths.end(), truth) != truths.end(); };
  return has(Truth::no) ? Truth::no : has(Truth::unknown) ? Truth::unknown : Truth::yes;
}

}  // namespace subcert
