#pragma once
/// Claims that means over samples decide.

#include "experiment.hpp"
#include "statistics.hpp"

namespace subcert::experiments {

/// What a paper says, and where.
struct Sentence {
  std::string text;
  std::string place;
};

/// A mean of measured values, or of their paired differences, with the name of what was measured.
struct NamedMean {
  std::string name;
  MeanInterval mean;
};

/// confirmed where `holds`, else not_confirmed.
Claim decided(const Sentence& sentence, const std::string& statistic, bool holds, const std::string& numbers,
              Verdict recorded = Verdict::confirmed);

/// confirmed where every interval lies below (above) the bound as a whole. `measure` says what the means are of.
Claim all_below(const Sentence& sentence, const std::string& measure, double bound, const std::vector<NamedMean>& means,
                Verdict recorded = Verdict::confirmed);
Claim all_above(const Sentence& sentence, const std::string& measure, double bound, const std::vector<NamedMean>& means,
                Verdict recorded = Verdict::confirmed);

}  // namespace subcert::experiments
