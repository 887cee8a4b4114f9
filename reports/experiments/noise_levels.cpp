#include "noise_levels.hpp"

namespace subcert::experiments {
namespace {

std::string decibels(int from, int to) { return std::to_string(from) + " to " + std::to_string(to) + " dB"; }

/// "1 to 4, 6".
std::string listed(const std::vector<int>& levels) {
  std::string text;
  for (std::size_t i = 0; i < levels.size();) {
    std::size_t end = i + 1;
    while (end < levels.size() && levels[end] == levels[end - 1] + 1) ++end;
    text += (text.empty() ? "" : ", ") + std::to_string(levels[i]) +
            (end > i + 1 ? " to " + std::to_string(levels[end - 1]) : "");
    i = end;
  }
  return text.empty() ? "none" : text;
}

/// By the paired differences of the errors, and the ratios of their means.
struct MethodComparison {
  std::vector<int> smaller = {}, larger = {}, undecided = {};
  double least = INFINITY, largest = 0;
  std::string ratios = {};

  MethodComparison(const Measured& errors, const std::string& first, const std::string& second, int from, int to) {
    for (int decibel = from; decibel <= to; ++decibel) {
      const auto &a = errors.at(error_at(first, decibel)), &b = errors.at(error_at(second, decibel));
      const MeanInterval difference = mean_difference(a, b);
      const double ratio = mean_interval(a).mean / mean_interval(b).mean;
      least = std::min(least, ratio);
      largest = std::max(largest, ratio);
      (difference.is_negative() ? smaller : difference.is_positive() ? larger : undecided).push_back(decibel);
    }
    ratios = "ratio of mean errors " + first + " / " + second + ": " + short_number(least) + " ... " +
             short_number(largest);
  }
};

}  // namespace

Quantity error_at(const std::string& method, int decibel) { return {method, std::to_string(decibel)}; }

Relation smaller_error(const std::string& better, const std::string& worse, int from, int to, At where) {
  return [=](const Measured& errors) {
    const MethodComparison found(errors, better, worse, from, to);
    return finding(where == At::some_level ? !found.smaller.empty() : found.larger.empty() && found.undecided.empty(),
                   "mean of the paired difference of errors, " + better + " minus " + worse +
                       ", negative with its whole interval at " +
                       (where == At::some_level ? "some level, " : "each level, ") + decibels(from, to),
                   "negative at " + listed(found.smaller) + " dB; positive at " + listed(found.larger) +
                       "; undecided at " + listed(found.undecided) + "; " + found.ratios);
  };
}

Relation nearly_equal_error(const std::string& first, const std::string& second, double tolerance) {
  return [=](const Measured& errors) {
    const MethodComparison found(errors, first, second, loudest, quietest);
    return finding(found.least >= 1 - tolerance && found.largest <= 1 + tolerance,
                   "the ratio of the mean errors differs from 1 by at most " + short_number(tolerance) +
                       " at each level, " + decibels(loudest, quietest),
                   found.ratios);
  };
}

}  // namespace subcert::experiments
