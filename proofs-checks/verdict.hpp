#pragma once
/// The words for what was found: of a printed value, of a statement, of a claim about an experiment. Each kind has its
/// own, so that none is asked for more than it knows.

#include <subcert/analysis/symbol/numbers/numbers.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace subcert {

/// match: the computed enclosure is narrower than one unit of the last printed place and lies within one such unit of
/// the printed value. mismatch: the two cannot be that near. open: the enclosure does not decide. not_reproducible: the
/// value rests on data that were not published.
enum class ValueVerdict { match, mismatch, open, not_reproducible };

/// holds: on the range tried. holds_for_all: proved for every admissible parameter. misprint: the printed form fails at
/// the witness, and a corrected form, tried in the same way, does not. false_claim: fails, and no correction of the
/// formula saves it. not_checkable: the reason is in the outcome. undecided: the check ran out of its budget.
enum class StatementVerdict { holds, holds_for_all, misprint, false_claim, not_checkable, undecided };

/// holds: as printed, in its best fair reading, under every fair choice that was tried. weaker: not as printed, but in
/// a reading that says less than its words. contrary: its contrary was shown under every fair choice. depends: it holds
/// under one fair choice of what the paper leaves open and not under another. own_data: the paper's data were not
/// published, so that only ours speak. undecided: more samples are needed.
enum class ClaimVerdict { holds, weaker, contrary, depends, own_data, undecided };

/// How much is wrong. slip: an index, a sign, a letter or a word. edge: all holds but for a case at the edge of the
/// range. number: a printed number is off. claim: what is said is not so.
enum class Grade { slip, edge, number, claim };

/// What a result adds to a count. open: not decided, or between right and wrong; aside: there is nothing to decide by.
enum class Standing { right, wrong, open, aside };

/// The words of each kind, in the order of its verdicts; those of statements and values are words of the contract.
template <class V>
struct VerdictWords;
template <>
struct VerdictWords<ValueVerdict> {
  static constexpr std::array<const char*, 4> list{"match", "mismatch", "open", "not-reproducible"};
};
template <>
struct VerdictWords<StatementVerdict> {
  static constexpr std::array<const char*, 6> list{"holds", "holds-for-all-n", "misprint",
                                                   "false", "not-checkable",   "undecided"};
};
template <>
struct VerdictWords<ClaimVerdict> {
  static constexpr std::array<const char*, 6> list{"holds as printed",    "holds in a weaker reading", "contrary shown",
                                                   "depends on a choice", "on our data only",          "undecided"};
};
template <>
struct VerdictWords<Grade> {
  static constexpr std::array<const char*, 4> list{"slip", "edge", "number", "claim"};
};
template <>
struct VerdictWords<Standing> {
  static constexpr std::array<const char*, 4> list{"right", "wrong", "open", "aside"};
};

template <class V>
concept HasVerdictWords = requires {
  VerdictWords<V>::list.size();
};

template <HasVerdictWords V>
std::string to_text(V verdict) {
  return VerdictWords<V>::list[static_cast<std::size_t>(verdict)];
}

inline Standing standing(ValueVerdict verdict) {
  constexpr std::array all{Standing::right, Standing::wrong, Standing::open, Standing::aside};
  return all[static_cast<std::size_t>(verdict)];
}

inline Standing standing(StatementVerdict verdict) {
  constexpr std::array all{Standing::right, Standing::right, Standing::wrong,
                           Standing::wrong, Standing::aside, Standing::open};
  return all[static_cast<std::size_t>(verdict)];
}

inline Standing standing(ClaimVerdict verdict) {
  constexpr std::array all{Standing::right, Standing::open,  Standing::wrong,
                           Standing::open,  Standing::aside, Standing::open};
  return all[static_cast<std::size_t>(verdict)];
}

/// Of a comparison with a printed value: match, mismatch or open.
inline ValueVerdict comparison_verdict(Truth equal) {
  return equal == Truth::yes ? ValueVerdict::match : equal == Truth::no ? ValueVerdict::mismatch : ValueVerdict::open;
}

/// What several questions give together: no before unknown before yes.
inline Truth all_of(const std::vector<Truth>& truths) {
  const auto has = [&](Truth truth) { return std::find(truths.begin(), truths.end(), truth) != truths.end(); };
  return has(Truth::no) ? Truth::no : has(Truth::unknown) ? Truth::unknown : Truth::yes;
}

}  // namespace subcert
