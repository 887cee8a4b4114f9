#include "decided.hpp"

#include <algorithm>

namespace subcert::experiments {
namespace {

std::string listed(const std::vector<NamedMean>& means) {
  std::string text;
  for (const NamedMean& m : means) text += (text.empty() ? "" : ", ") + m.name + ": " + m.mean.text();
  return text;
}

Claim compared(const Sentence& sentence, const std::string& measure, const std::string& relation, double bound,
               bool holds, const std::vector<NamedMean>& means, Verdict recorded) {
  return decided(sentence, measure + ": " + relation + " " + short_number(bound) + " with the whole interval, each",
                 holds, listed(means), recorded);
}

}  // namespace

Claim decided(const Sentence& sentence, const std::string& statistic, bool holds, const std::string& numbers,
              Verdict recorded) {
  return {sentence.text, sentence.place, statistic, holds ? Verdict::confirmed : Verdict::not_confirmed,
          numbers,       recorded};
}

Claim all_below(const Sentence& sentence, const std::string& measure, double bound, const std::vector<NamedMean>& means,
                Verdict recorded) {
  const bool holds = std::all_of(means.begin(), means.end(),
                                 [&](const NamedMean& m) { return m.mean.mean + m.mean.half_width < bound; });
  return compared(sentence, measure, "below", bound, holds, means, recorded);
}

Claim all_above(const Sentence& sentence, const std::string& measure, double bound, const std::vector<NamedMean>& means,
                Verdict recorded) {
  const bool holds = std::all_of(means.begin(), means.end(),
                                 [&](const NamedMean& m) { return m.mean.mean - m.mean.half_width > bound; });
  return compared(sentence, measure, "above", bound, holds, means, recorded);
}

}  // namespace subcert::experiments
