#include "noise_levels.hpp"

#include <subcert/proofs-checks/verdict.hpp>

#include <fmt/ranges.h>

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

/// Whether the first error is smaller at each level; the contrary: larger at one.
Truth each(const MethodComparison& found, const Levels& levels) {
  return found.smaller.size() == levels.count() ? Truth::yes : found.larger.empty() ? Truth::unknown : Truth::no;
}
/// At some level; the contrary: larger at all.
Truth some(const MethodComparison& found, const Levels& levels) {
  return !found.smaller.empty() ? Truth::yes : found.larger.size() == levels.count() ? Truth::no : Truth::unknown;
}

/// yes where one is, no where all are.
Truth any_of(const std::vector<Truth>& truths) {
  if (std::ranges::count(truths, Truth::yes) > 0) return Truth::yes;
  return std::ranges::count(truths, Truth::unknown) > 0 ? Truth::unknown : Truth::no;
}

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

Relation smaller_error(const std::vector<Pair>& pairs, const Levels& levels, At where) {
  std::string compared = "mean of the paired difference of errors";
  std::vector<Mean> excesses;
  for (const auto& [better, worse] : pairs) {
    compared += ", " + better + " minus " + worse;
    excesses.push_back(excess(better, worse));
  }
  if (where == At::mean_over_levels) return in_the_mean(compared + ", negative in the mean over ", levels, excesses);
  return [=](const Measured& errors) {
    const double confidence = each_of(pairs.size() * levels.count());
    std::vector<Truth> truths;
    std::vector<std::string> numbers;
    for (const auto& [better, worse] : pairs) {
      const MethodComparison found(errors, better, worse, levels, confidence);
      truths.push_back(where == At::some_level ? some(found, levels) : each(found, levels));
      numbers.push_back("negative at " + listed(found.smaller) + " dB; positive at " + listed(found.larger) +
                        "; undecided at " + listed(found.undecided) + "; " + ratios(errors, better, worse, levels));
    }
    return Finding{where == At::some_level ? any_of(truths) : all_of(truths),
                   compared + ", negative with its whole interval at " +
                       (where == At::some_level ? "some level, " : "each level, ") + decibels(levels),
                   fmt::format("{}", fmt::join(numbers, ". "))};
  };
}

Relation nearly_equal_error(const std::vector<Pair>& pairs, double factor, const Levels& levels, At where) {
  const std::string compared = "neither mean error is more than " + short_number(factor) + " times the other, ";
  std::vector<Pair> both_ways;
  for (const auto& [first, second] : pairs) both_ways.insert(both_ways.end(), {{first, second}, {second, first}});
  std::vector<Mean> excesses;
  for (const auto& [first, second] : both_ways) excesses.push_back(excess(first, second, factor));
  if (where == At::mean_over_levels) return in_the_mean(compared + "in the mean over ", levels, excesses);
  return [=](const Measured& errors) {
    const double confidence = each_of(both_ways.size() * levels.count());
    std::vector<Truth> truths;
    for (const auto& [first, second] : both_ways)
      truths.push_back(each(MethodComparison(errors, first, second, levels, confidence, factor), levels));
    std::vector<std::string> numbers;
    for (const auto& [first, second] : pairs) numbers.push_back(ratios(errors, first, second, levels));
    return Finding{all_of(truths), compared + "at each level, " + decibels(levels) + ", with their whole intervals",
                   fmt::format("{}", fmt::join(numbers, "; "))};
  };
}

}  // namespace subcert::experiments
