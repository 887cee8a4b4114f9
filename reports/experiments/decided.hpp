#pragma once
/// Claims that means over samples decide.

#include "experiment.hpp"
#include "statistics.hpp"

namespace subcert {

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
              Finding recorded = Finding::confirmed);

/// confirmed where every interval lies below (above) the bound as a whole. `measure` says what the means are of.
Claim all_below(const Sentence& sentence, const std::string& measure, double bound, const std::vector<NamedMean>& means,
                Finding recorded = Finding::confirmed);
Claim all_above(const Sentence& sentence, const std::string& measure, double bound, const std::vector<NamedMean>& means,
                Finding recorded = Finding::confirmed);

}  // namespace subcert
