#include "claim.hpp"

#include <fmt/ranges.h>

#include <algorithm>

namespace subcert::experiments {
namespace {

/// Of readings, a smaller number is better.
int rank(ClaimVerdict verdict) {
  switch (verdict) {
    case ClaimVerdict::holds: return 0;
    case ClaimVerdict::depends: return 1;
    case ClaimVerdict::weaker: return 2;
    case ClaimVerdict::contrary: return 4;
    default: return 3;
  }
}

std::string said(Truth truth) { return truth == Truth::yes ? "holds" : truth == Truth::no ? "contrary" : "undecided"; }

std::vector<VariantFinding> findings_of(const Reading& reading, const Claim& claim,
                                        const std::vector<Variant>& variants) {
  std::vector<VariantFinding> result;
  for (const Variant& variant : variants)
    if (variant.choice.empty() || std::ranges::find(claim.over, variant.choice) != claim.over.end())
      result.push_back({variant.name(), variant.runs, reading.relation(variant.measured)});
  return result;
}

}  // namespace

ClaimVerdict verdict_over(const std::vector<VariantFinding>& findings) {
  const auto count = [&](Truth truth) {
    return std::ranges::count_if(findings, [&](const VariantFinding& f) { return f.finding.truth == truth; });
  };
  const auto yes = count(Truth::yes), no = count(Truth::no);
  if (yes > 0 && no > 0) return ClaimVerdict::depends;
  if (count(Truth::unknown) > 0) return ClaimVerdict::undecided;
  return yes > 0 ? ClaimVerdict::holds : ClaimVerdict::contrary;
}

std::string DecidedReading::read_as() const {
  std::string text = words;
  const auto add = [&](const char* more) { text += (text.empty() ? "" : " ") + std::string(more); };
  if (weaker) add("(less than the words say)");
  if (late) add("(chosen after the numbers were seen: it can save a sentence, not show it)");
  return text;
}

std::string DecidedReading::numbers() const {
  const Finding& taken = findings.front().finding;
  if (findings.size() == 1) return taken.numbers;
  std::vector<std::string> parts;
  for (const Truth truth : {Truth::yes, Truth::no, Truth::unknown}) {
    std::vector<std::string> names;
    const VariantFinding* shown = nullptr;
    for (const VariantFinding& f : findings)
      if (f.finding.truth == truth) {
        if (!shown) shown = &f;
        names.push_back(f.variant);
      }
    if (shown)
      parts.push_back(fmt::format("{}: {} ({}{})", said(truth), fmt::join(names, ", "),
                                  names.size() > 1 ? names.front() + ": " : "", shown->finding.numbers));
  }
  return fmt::format("{}", fmt::join(parts, "; "));
}

bool is_open(const DecidedClaim& claim, const DecidedReading& reading) {
  if (reading.verdict != ClaimVerdict::undecided || claim.finding == ClaimVerdict::own_data) return false;
  const auto is_no = [](const VariantFinding& f) { return f.finding.truth == Truth::no; };
  const bool may_hold = !reading.late && std::ranges::none_of(reading.findings, is_no);
  const ClaimVerdict best = claim.readings.front().verdict;
  return best == ClaimVerdict::undecided || (best == ClaimVerdict::depends && may_hold);
}

DecidedClaim decided(const Claim& claim, const std::vector<Variant>& variants) {
  std::vector<DecidedReading> readings;
  for (const Reading& reading : claim.readings) {
    auto findings = findings_of(reading, claim, variants);
    ClaimVerdict verdict = verdict_over(findings);
    if (reading.weaker && verdict == ClaimVerdict::holds) verdict = ClaimVerdict::weaker;
    if (reading.late && verdict == ClaimVerdict::holds) verdict = ClaimVerdict::depends;
    readings.push_back({reading.words, verdict, reading.late, reading.weaker, std::move(findings)});
  }
  std::ranges::stable_sort(readings, {}, [](const DecidedReading& r) { return rank(r.verdict); });
  const DecidedReading& best = readings.front();
  const std::string words = best.read_as().empty() ? "" : "read as: " + best.read_as() + "; ";
  DecidedClaim result{claim.sentence,
                      claim.place,
                      claim.on_our_data ? ClaimVerdict::own_data : best.verdict,
                      words + best.findings.front().finding.statistic,
                      (claim.on_our_data ? to_text(best.verdict) + " there. " : "") + best.numbers(),
                      claim.recorded,
                      claim.counted_in,
                      {}};
  result.readings = std::move(readings);
  return result;
}

}  // namespace subcert::experiments
