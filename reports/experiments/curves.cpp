// [DHHS15, sec. 5, Figures 14 to 19]: curves in the plane and a torus from noisy points.

#include "families.hpp"
#include "linear_method.hpp"
#include "statistics.hpp"

#include <subcert/reports/parallel.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace subcert {
namespace {

constexpr int level = 3;  // outputs at the multiples of 1/8
using Coordinate = std::vector<double>;

struct PlaneCurve {
  Coordinate x, y;
};

struct NoisyCurve {
  PlaneCurve samples;
  PlaneCurve truth;  // at the outputs
  bool closed;
};

PlaneCurve alpha(std::size_t count) {
  PlaneCurve curve;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = -1.4 + 2.8 * static_cast<double>(i) / static_cast<double>(count - 1);
    curve.x.push_back(3 * std::pow(t, 4) + t * t + 1);
    curve.y.push_back(std::pow(t, 5) - 2 * t);
  }
  return curve;
}

PlaneCurve star(std::size_t count) {
  PlaneCurve curve;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    curve.x.push_back(4 * std::cos(t) + std::cos(4 * t));
    curve.y.push_back(4 * std::sin(t) - std::sin(4 * t));
  }
  return curve;
}

PlaneCurve limit(const DenseMatrix& scheme, const PlaneCurve& data) { return {scheme * data.x, scheme * data.y}; }

PlaneCurve noisy(const PlaneCurve& samples, std::mt19937_64& engine, double decibel) {
  Coordinate all(samples.x);
  all.insert(all.end(), samples.y.begin(), samples.y.end());
  const double sigma = noise_deviation(mean_square(all), decibel);
  const auto noise = normal_noise(engine, all.size());
  PlaneCurve result(samples);
  for (std::size_t i = 0; i < samples.x.size(); ++i) {
    result.x[i] += sigma * noise[i];
    result.y[i] += sigma * noise[samples.x.size() + i];
  }
  return result;
}

double relative_error(const PlaneCurve& curve, const PlaneCurve& truth) {
  double error = 0, norm = 0;
  for (std::size_t i = 0; i < truth.x.size(); ++i) {
    error += std::pow(curve.x[i] - truth.x[i], 2) + std::pow(curve.y[i] - truth.y[i], 2);
    norm += truth.x[i] * truth.x[i] + truth.y[i] * truth.y[i];
  }
  return std::sqrt(error / norm);
}

/// Twice the area of the triangle of three points of a curve, with its sign.
double orientation(const PlaneCurve& c, std::size_t i, std::size_t j, std::size_t k) {
  return (c.x[j] - c.x[i]) * (c.y[k] - c.y[i]) - (c.y[j] - c.y[i]) * (c.x[k] - c.x[i]);
}

/// Pairs of edges of the open polygon that cross properly.
std::size_t crossings(const PlaneCurve& c) {
  std::size_t result = 0;
  for (std::size_t i = 0; i + 1 < c.x.size(); ++i)
    for (std::size_t j = i + 2; j + 1 < c.x.size(); ++j)
      result += orientation(c, i, i + 1, j) * orientation(c, i, i + 1, j + 1) < 0 &&
                orientation(c, j, j + 1, i) * orientation(c, j, j + 1, i + 1) < 0;
  return result;
}

/// The sum of the moduli of the angles between edges of the open polygon.
double total_turning(const PlaneCurve& c) {
  double result = 0;
  for (std::size_t i = 0; i + 2 < c.x.size(); ++i) {
    const double ux = c.x[i + 1] - c.x[i], uy = c.y[i + 1] - c.y[i];
    const double vx = c.x[i + 2] - c.x[i + 1], vy = c.y[i + 2] - c.y[i + 1];
    result += std::abs(std::atan2(ux * vy - uy * vx, ux * vx + uy * vy));
  }
  return result;
}

/// The smallest distance from the origin over the largest.
double roundness(const PlaneCurve& c) {
  double least = INFINITY, largest = 0;
  for (std::size_t i = 0; i < c.x.size(); ++i) {
    least = std::min(least, std::hypot(c.x[i], c.y[i]));
    largest = std::max(largest, std::hypot(c.x[i], c.y[i]));
  }
  return least / largest;
}

Claim claim(const std::string& sentence, const std::string& place, const std::string& statistic, bool holds,
            const std::string& numbers) {
  return {sentence, place, statistic, holds ? Finding::confirmed : Finding::not_confirmed, numbers};
}

/// What is measured: [scheme][noise][run].
using Measured = std::vector<std::array<std::vector<double>, 2>>;
Measured empty_measure(std::size_t schemes, std::size_t runs) {
  return Measured(schemes, {std::vector<double>(runs), std::vector<double>(runs)});
}

Curve drawn(const std::string& label, const PlaneCurve& curve, bool joined, bool closed = false) {
  Curve result{label, {}, !joined, joined};
  for (std::size_t i = 0; i < curve.x.size(); ++i) result.points.emplace_back(curve.x[i], curve.y[i]);
  if (closed && joined) result.points.push_back(result.points.front());
  return result;
}

Figure limits_figure(const std::string& id, const std::string& title, const std::vector<std::string>& schemes,
                     const std::vector<DenseMatrix>& matrices, const NoisyCurve& curve,
                     const std::array<double, 2>& decibels, std::uint64_t seed) {
  Figure figure{id, title, "One sample of the noise; rows: low and high noise.", static_cast<int>(schemes.size()), {}};
  auto engine = generator(seed, 0);
  for (const double decibel : decibels) {
    const PlaneCurve data = noisy(curve.samples, engine, decibel);
    for (std::size_t s = 0; s < schemes.size(); ++s)
      figure.panels.push_back({schemes[s] + ", " + short_number(decibel) + " dB", "", "",
                               {drawn("data", data, false), drawn("curve", curve.truth, true, curve.closed),
                                drawn("limit", limit(matrices[s], data), true, curve.closed)},
                               false, "below", true});
  }
  return figure;
}

PlainTable measures_table(const std::string& id, const std::string& title, const std::vector<std::string>& schemes,
                          const std::array<double, 2>& decibels,
                          const std::vector<std::pair<std::string, const Measured*>>& columns) {
  PlainTable table{id, title, {"scheme", "SNR (dB)"}, {}};
  for (const auto& column : columns) table.head.push_back(column.first);
  for (std::size_t s = 0; s < schemes.size(); ++s)
    for (std::size_t d = 0; d < 2; ++d) {
      std::vector<std::string> row{schemes[s], short_number(decibels[d])};
      for (const auto& column : columns) row.push_back(mean_interval((*column.second)[s][d]).text());
      table.rows.push_back(row);
    }
  return table;
}

ExperimentResult run_alpha(const ExperimentOptions& options) {
  constexpr std::size_t count = 30;
  const std::vector<std::string> schemes{"primal:n=3", "primal:n=5"};
  const std::array<double, 2> decibels{17, 4};
  std::vector<DenseMatrix> matrices;
  for (const std::string& scheme : schemes) matrices.push_back(limit_matrix(scheme, count, Extension::interp, level));
  const NoisyCurve curve{alpha(count), alpha(((count - 1) << level) + 1), false};
  const std::size_t true_crossings = crossings(curve.truth);
  Measured error = empty_measure(2, options.runs), turning = error, kept = error;
  parallel_for_each(options.runs, options.jobs, [&](std::size_t run) {
    auto engine = generator(options.seed, run);
    for (std::size_t d = 0; d < 2; ++d) {
      const PlaneCurve data = noisy(curve.samples, engine, decibels[d]);
      for (std::size_t s = 0; s < 2; ++s) {
        const PlaneCurve result = limit(matrices[s], data);
        error[s][d][run] = relative_error(result, curve.truth);
        turning[s][d][run] = total_turning(result);
        kept[s][d][run] = crossings(result) == true_crossings;
      }
    }
  });
  ExperimentResult result{
      {"x = 3t^4 + t^2 + 1, y = t^5 - 2t at t = -7/5 + i 14/145, i = 0, ..., 29, as printed; ends continued by the "
       "scheme's own fit (interp), limits at the multiples of 1/8. The signal-to-noise ratio counts both coordinates. "
       "The curve crosses itself " + std::to_string(true_crossings) + " time(s); its total turning is " +
       short_number(total_turning(curve.truth)) + "."}};
  const MeanInterval low3 = mean_interval(kept[0][0]), low5 = mean_interval(kept[1][0]), high5 = mean_interval(kept[1][1]);
  result.claims.push_back(claim("With low noise the limits of S_3 and S_5 retain the general shape.", "Sec. 5.1, Fig. 15(a,b)",
                                "both keep the number of crossings in more than half of the samples",
                                low3.mean - low3.half_width > 0.5 && low5.mean - low5.half_width > 0.5,
                                "S_3: " + low3.text() + ", S_5: " + low5.text()));
  const MeanInterval artifact = mean_difference(turning[0][0], turning[1][0]);
  result.claims.push_back(claim("With low noise S_3 fits the noise and has an artifact.", "Sec. 5.1, Fig. 15(a)",
                                "total turning of S_3 minus that of S_5, positive with its whole interval",
                                artifact.is_positive(), artifact.text()));
  const MeanInterval overfit = mean_difference(turning[0][1], turning[1][1]);
  result.claims.push_back(claim("With high noise S_3 overfits.", "Sec. 5.1, Fig. 15(c)",
                                "total turning of S_3 minus that of S_5, positive with its whole interval",
                                overfit.is_positive(), overfit.text()));
  result.claims.push_back(claim("With high noise S_5 preserves the topology.", "Sec. 5.1, Fig. 15(d)",
                                "the number of crossings is kept in more than half of the samples",
                                high5.mean - high5.half_width > 0.5,
                                "S_5: " + high5.text() + ", S_3: " + mean_interval(kept[0][1]).text()));
  result.tables.push_back(measures_table("fig15-measures", "Alpha curve", schemes, decibels,
                                         {{"relative error", &error}, {"total turning", &turning}, {"crossings kept", &kept}}));
  result.figures.push_back(limits_figure("fig15", "Alpha curve", schemes, matrices, curve, decibels, options.seed));
  return result;
}

ExperimentResult run_star(const ExperimentOptions& options) {
  constexpr std::size_t count = 50;
  const std::vector<std::string> schemes{"primal:n=3", "primal:n=5", "primal:n=4,d=3", "primal:n=6,d=3"};
  const std::array<double, 2> decibels{19, 10};
  std::vector<DenseMatrix> matrices;
  for (const std::string& scheme : schemes) matrices.push_back(limit_matrix(scheme, count, Extension::wrap, level));
  const NoisyCurve curve{star(count), star(count << level), true};
  Measured error = empty_measure(4, options.runs), round = error;
  parallel_for_each(options.runs, options.jobs, [&](std::size_t run) {
    auto engine = generator(options.seed, run);
    for (std::size_t d = 0; d < 2; ++d) {
      const PlaneCurve data = noisy(curve.samples, engine, decibels[d]);
      for (std::size_t s = 0; s < 4; ++s) {
        const PlaneCurve result = limit(matrices[s], data);
        error[s][d][run] = relative_error(result, curve.truth);
        round[s][d][run] = roundness(result);
      }
    }
  });
  const double pentagon = std::cos(std::numbers::pi / 5), between = (0.6 + pentagon) / 2;
  const double covered = 50 / (100 * std::numbers::pi);
  ExperimentResult result{
      {"x = 4 cos t + cos 4t, y = 4 sin t - sin 4t. The printed parameters t_i = i/(100 pi), i = 0, ..., 49, cover only a "
       "small arc; here t_i = 2 pi i/50, and the data are closed. Limits at the multiples of 1/8."}};
  result.claims.push_back(claim("The samples at t_i = i/(100 pi), i = 0, ..., 49, are those of the star.", "Sec. 5.1, after (26)",
                                "50 steps make a period, 2 pi", std::abs(covered - 2 * std::numbers::pi) < 0.01,
                                "50 steps cover " + short_number(covered) + " of " + short_number(2 * std::numbers::pi)));
  bool as_said = true;
  std::string numbers;
  for (std::size_t s = 0; s < 4; ++s) {
    const MeanInterval r = mean_interval(round[s][0]);
    as_said = as_said && (s == 1 ? r.mean - r.half_width > between : r.mean + r.half_width < between);
    numbers += (s ? ", " : "") + schemes[s] + ": " + r.text();
  }
  result.claims.push_back(claim("With low noise all limits are stars but that of S_5, which is more like a pentagon.",
                                "Sec. 5.1, Fig. 17",
                                "smallest over largest radius, 0.6 for the star and cos 36° for a pentagon: above the middle, " +
                                    short_number(between) + ", for S_5 and below it for the others",
                                as_said, numbers));
  bool better = true;
  numbers.clear();
  for (const std::size_t good : {0u, 3u})
    for (const std::size_t bad : {1u, 2u}) {
      const MeanInterval difference = mean_difference(error[good][1], error[bad][1]);
      better = better && difference.is_negative();
      numbers += (numbers.empty() ? "" : ", ") + schemes[good] + " - " + schemes[bad] + ": " + difference.text();
    }
  result.claims.push_back(claim("With high noise S_3 and S_6^3 are reasonable, S_5 oversmooths and S_4^3 overfits.",
                                "Sec. 5.1, Fig. 17",
                                "the errors of S_3 and S_6^3 minus those of S_5 and S_4^3 are negative with their intervals",
                                better, numbers));
  result.tables.push_back(measures_table("fig17-measures", "Star", schemes, decibels,
                                         {{"relative error", &error}, {"smallest / largest radius", &round}}));
  result.figures.push_back(limits_figure("fig17", "Star", schemes, matrices, curve, decibels, options.seed));
  return result;
}

/// scheme ⊗ scheme applied to count x count values.
Coordinate tensor(const DenseMatrix& scheme, const Coordinate& values) {
  const std::size_t count = scheme.columns(), outputs = scheme.rows();
  Coordinate half(outputs * count), line(count), result(outputs * outputs);
  for (std::size_t j = 0; j < count; ++j) {
    for (std::size_t i = 0; i < count; ++i) line[i] = values[i * count + j];
    const Coordinate column = scheme * line;
    for (std::size_t i = 0; i < outputs; ++i) half[i * count + j] = column[i];
  }
  for (std::size_t i = 0; i < outputs; ++i) {
    for (std::size_t j = 0; j < count; ++j) line[j] = half[i * count + j];
    const Coordinate row = scheme * line;
    std::copy(row.begin(), row.end(), result.begin() + static_cast<std::ptrdiff_t>(i * outputs));
  }
  return result;
}

std::array<Coordinate, 3> torus(std::size_t count) {
  std::array<Coordinate, 3> result;
  const double step = 2 * std::numbers::pi / static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < count; ++j) {
      const double u = step * static_cast<double>(i), v = step * static_cast<double>(j);
      result[0].push_back(std::cos(u) * (10 + 5 * std::cos(v)));
      result[1].push_back(std::sin(u) * (10 + 5 * std::cos(v)));
      result[2].push_back(5 * std::sin(v));
    }
  return result;
}

ExperimentResult run_torus(const ExperimentOptions& options) {
  constexpr std::size_t count = 24;
  const std::vector<std::string> schemes{"primal:n=3", "primal:n=5"};
  const std::array<double, 2> decibels{15, 6};
  std::vector<DenseMatrix> matrices;
  for (const std::string& scheme : schemes) matrices.push_back(limit_matrix(scheme, count, Extension::wrap, 1));
  const auto samples = torus(count), truth = torus(2 * count);
  double square = 0, norm = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    square += mean_square(samples[c]) / 3;
    norm += mean_square(truth[c]);
  }
  Measured error = empty_measure(2, options.runs);
  parallel_for_each(options.runs, options.jobs, [&](std::size_t run) {
    auto engine = generator(options.seed, run);
    for (std::size_t d = 0; d < 2; ++d) {
      const double sigma = noise_deviation(square, decibels[d]);
      for (std::size_t c = 0; c < 3; ++c) {
        Coordinate data(samples[c]);
        const auto noise = normal_noise(engine, data.size());
        for (std::size_t i = 0; i < data.size(); ++i) data[i] += sigma * noise[i];
        for (std::size_t s = 0; s < 2; ++s) {
          Coordinate difference = tensor(matrices[s], data);
          for (std::size_t i = 0; i < difference.size(); ++i) difference[i] -= truth[c][i];
          error[s][d][run] += mean_square(difference);
        }
      }
      for (std::size_t s = 0; s < 2; ++s) error[s][d][run] = std::sqrt(error[s][d][run] / norm);
    }
  });
  ExperimentResult result{{"The torus at u, v = i pi/12, i = 0, ..., 23, closed in both directions, as printed; limits at the "
                           "multiples of 1/2. The signal-to-noise ratio counts all three coordinates."}};
  const MeanInterval difference = mean_difference(error[1][1], error[0][1]);
  result.claims.push_back(claim("With high noise S_5 x S_5 provides a better approximation than S_3 x S_3.",
                                "Sec. 5.2, Fig. 19(c,d)", "error of S_5 x S_5 minus that of S_3 x S_3, negative",
                                difference.is_negative(), difference.text()));
  const MeanInterval low3 = mean_interval(error[0][0]), low5 = mean_interval(error[1][0]);
  result.claims.push_back(claim("With low noise both limits are fairly good (read as: relative error below 1/10).",
                                "Sec. 5.2, Fig. 19(a,b)", "means below 1/10 with their intervals",
                                low3.mean + low3.half_width < 0.1 && low5.mean + low5.half_width < 0.1,
                                "S_3: " + low3.text() + ", S_5: " + low5.text()));
  result.tables.push_back(measures_table("fig19-measures", "Torus", schemes, decibels, {{"relative error", &error}}));
  return result;
}

}  // namespace

std::vector<Experiment> curve_experiments() {
  return {{"fig15", "dyn-2015", "Figures 14 and 15: the alpha curve", run_alpha},
          {"fig17", "dyn-2015", "Figures 16 and 17: the star", run_star},
          {"fig19", "dyn-2015", "Figures 18 and 19: the torus", run_torus}};
}

}  // namespace subcert
