#include "noise_levels.hpp"

#include <algorithm>
#include <cmath>

namespace subcert::experiments {
namespace {

std::string decibels(const Levels& levels) {
  return std::to_string(levels.from) + " to " + std::to_string(levels.to) + " dB";
}

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

/// By the paired differences of the errors of the first and of a multiple of those of the second.
struct MethodComparison {
  std::vector<int> smaller = {}, larger = {}, undecided = {};

  MethodComparison(const Measured& errors, const std::string& first, const std::string& second, const Levels& levels,
                   double confidence, double factor = 1) {
    for (int decibel = levels.from; decibel <= levels.to; ++decibel) {
      const Mean mean{"", error_at(first, decibel), error_at(second, decibel), factor};
      const MeanInterval difference = mean.in(errors, confidence);
      (difference.is_negative() ? smaller : difference.is_positive() ? larger : undecided).push_back(decibel);
    }
  }
};

std::string ratios(const Measured& errors, const std::string& first, const std::string& second, const Levels& levels) {
  double least = INFINITY, largest = 0;
  for (int decibel = levels.from; decibel <= levels.to; ++decibel) {
    const double ratio = mean_interval(errors.at(error_at(first, decibel))).mean /
                         mean_interval(errors.at(error_at(second, decibel))).mean;
    least = std::min(least, ratio);
    largest = std::max(largest, ratio);
  }
  return "ratio of mean errors " + first + " / " + second + ": " + short_number(least) + " ... " +
         short_number(largest);
}

/// The paired differences of the first and `factor` times the second, negative; their samples averaged over levels.
Mean excess(const std::string& first, const std::string& second, double factor = 1) {
  return {first + " - " + (factor == 1 ? "" : short_number(factor) + " ") + second,
          {first, "mean"},
          Quantity{second, "mean"},
          factor,
          -INFINITY,
          0.0};
}

/// Whether all means are negative over the levels.
Relation in_the_mean(const std::string& statistic, const Levels& levels, const std::vector<Mean>& means) {
  return [=](const Measured& errors) {
    Measured averaged;
    for (const Mean& mean : means)
      for (const std::string& method : {mean.of.measure, mean.minus->measure}) {
        std::vector<double> sum(errors.at(error_at(method, levels.from)).size());
        for (int decibel = levels.from; decibel <= levels.to; ++decibel) {
          const auto& error = errors.at(error_at(method, decibel));
          for (std::size_t r = 0; r < sum.size(); ++r) sum[r] += error[r] / static_cast<double>(levels.count());
        }
        averaged.samples[{method, "mean"}] = sum;
      }
    return whole_intervals(statistic + decibels(levels) + ", with the whole interval", means)(averaged);
  };
}

}  // namespace

Quantity error_at(const std::string& method, int decibel) { return {method, std::to_string(decibel)}; }

Relation smaller_error(const std::string& better, const std::string& worse, const Levels& levels, At where) {
  const std::string compared = "mean of the paired difference of errors, " + better + " minus " + worse;
  if (where == At::mean_over_levels)
    return in_the_mean(compared + ", negative in the mean over ", levels, {excess(better, worse)});
  return [=](const Measured& errors) {
    const MethodComparison found(errors, better, worse, levels, each_of(levels.count()));
    const bool some = where == At::some_level;
    const bool yes = some ? !found.smaller.empty() : found.smaller.size() == levels.count(),
               no = some ? found.larger.size() == levels.count() : !found.larger.empty();
    return Finding{yes  ? Truth::yes
                   : no ? Truth::no
                        : Truth::unknown,
                   compared + ", negative with its whole interval at " + (some ? "some level, " : "each level, ") +
                       decibels(levels),
                   "negative at " + listed(found.smaller) + " dB; positive at " + listed(found.larger) +
                       "; undecided at " + listed(found.undecided) + "; " + ratios(errors, better, worse, levels)};
  };
}

Relation nearly_equal_error(const std::string& first, const std::string& second, double factor, const Levels& levels,
                            At where) {
  const std::string compared = "neither mean error is more than " + short_number(factor) + " times the other, ";
  if (where == At::mean_over_levels)
    return in_the_mean(compared + "in the mean over ", levels,
                       {excess(first, second, factor), excess(second, first, factor)});
  return [=](const Measured& errors) {
    const double confidence = each_of(2 * levels.count());
    const MethodComparison one(errors, first, second, levels, confidence, factor),
        other(errors, second, first, levels, confidence, factor);
    const std::size_t all = levels.count();
    return Finding{one.smaller.size() == all && other.smaller.size() == all ? Truth::yes
                   : !one.larger.empty() || !other.larger.empty()           ? Truth::no
                                                                            : Truth::unknown,
                   compared + "at each level, " + decibels(levels) + ", with their whole intervals",
                   ratios(errors, first, second, levels)};
  };
}

}  // namespace subcert::experiments
