#pragma once
/// Random noise that is the same on every machine, and means with confidence intervals.

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace subcert::experiments {

/// The generator of sample `run` of an experiment.
std::mt19937_64 generator(std::uint64_t seed, std::size_t run);

/// Independent standard normal numbers.
std::vector<double> normal_noise(std::mt19937_64& engine, std::size_t count);

/// A uniform number in [0, 1).
double uniform(std::mt19937_64& engine);

/// `count` distinct indices below `size`. Domain: count <= size.
std::vector<std::size_t> chosen_indices(std::mt19937_64& engine, std::size_t count, std::size_t size);

/// The interval mean - half_width ... mean + half_width.
struct MeanInterval {
  double mean;
  double half_width;

  double lower() const { return mean - half_width; }
  double upper() const { return mean + half_width; }
  bool is_negative() const { return upper() < 0; }
  bool is_positive() const { return lower() > 0; }
  std::string text() const;
};

/// The confidence of a table's intervals, each for itself, and that with which all intervals of a decision hold
/// together.
inline constexpr double shown_confidence = 0.95, together = 0.99;
/// How many times the samples a question gets that fewer leave open.
inline constexpr std::array<std::size_t, 3> patience{4, 16, 64};
/// The confidence of each of `count` intervals that hold together with the confidence `together`, in the first look at
/// the samples and in each that `patience` adds, by Bonferroni's inequality. Domain: count >= 1.
double each_of(std::size_t count);

/// The mean with its interval by Student's t; where all values are 0 or 1, by Clopper and Pearson, whose farther end it
/// takes on both sides. Domain: at least two values, 0 < confidence < 1.
MeanInterval mean_interval(const std::vector<double>& values, double confidence = shown_confidence);
/// The mean of first[i] - second[i], by Student's t. Domain: as many of both.
MeanInterval mean_difference(const std::vector<double>& first, const std::vector<double>& second,
                             double confidence = shown_confidence);

/// The deviation of noise with the signal-to-noise ratio `decibel` = `factor` log10 of the L2 norm of signal and noise
/// over that of the noise, both in the mean: the root of mean_square / (10^(2 decibel/factor) - 1). Domain: decibel >
/// 0, factor > 0. Ref: [DHHS15, sec. 3.2], which does not print the factor.
double noise_deviation(double mean_square, double decibel, double factor = 20);

double mean_square(const std::vector<double>& values);

/// Four significant digits.
std::string short_number(double value);

}  // namespace subcert::experiments
