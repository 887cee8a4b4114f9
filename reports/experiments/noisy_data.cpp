#include "noisy_data.hpp"

#include <subcert/analysis/symbol/support/parallel.hpp>

#include <algorithm>
#include <mutex>

namespace subcert::experiments {
namespace {

constexpr std::size_t samples_per_share = 24;  // samples that are refined together, an even number

double mean_squared_error(const std::vector<double>& values, const std::vector<double>& truth, std::size_t dimension) {
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); i += dimension) {
    double square = 0;
    for (std::size_t c = i; c < i + dimension; ++c) square += (values[c] - truth[c]) * (values[c] - truth[c]);
    sum += square;
  }
  return sum / (static_cast<double>(values.size()) / static_cast<double>(dimension));  // a whole number of points
}

double error(const RefinedSample& s) { return mean_squared_error(s.with, s.truth, s.data.dimension); }

double error_without(const RefinedSample& s) { return mean_squared_error(s.without, s.truth, s.data.dimension); }

double response(const RefinedSample& s) { return largest_distance(s.with, s.without, s.data.dimension); }

double response_to_noise(const RefinedSample& s) { return largest_distance(s.without, s.exact, s.data.dimension); }

double roughness(const RefinedSample& s) {
  double sum = 0;
  std::size_t count = 0;
  const std::size_t columns = s.axes[0].count, rows = s.axes[1].count, dimension = s.data.dimension,
                    row = columns * dimension;
  const auto add = [&](std::size_t at, std::size_t step) {
    const double difference = s.with[at - step] - 2 * s.with[at] + s.with[at + step];
    sum += difference * difference;
    ++count;
  };
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i)
      for (std::size_t c = 0; c < dimension; ++c) {
        const std::size_t at = j * row + i * dimension + c;
        if (i > 0 && i + 1 < columns) add(at, dimension);
        if (j > 0 && j + 1 < rows) add(at, row);
      }
  return sum / static_cast<double>(count);
}

double from_data(const RefinedSample& s) {
  const std::size_t dimension = s.data.dimension;
  const auto at_data = polygon_at({s.with, dimension, s.axes}, parameters(s.data.axes[0]));
  const auto outlying = distances(s.drawn.with, s.drawn.without, dimension);
  const auto left = distances(at_data, s.drawn.with, dimension);
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < left.size(); ++i)
    if (outlying[i] == 0) {
      sum += left[i] * left[i];
      ++count;
    }
  return sum / static_cast<double>(count);
}

double overfits(const RefinedSample& s) {
  const std::size_t dimension = s.data.dimension;
  const auto at_data = polygon_at({s.with, dimension, s.axes}, parameters(s.data.axes[0]));
  return mean_squared_error(at_data, s.drawn.with, dimension) < mean_squared_error(at_data, s.points, dimension);
}

/// Draws `count` samples and refines them by each method: visit(method, r, sample) in increasing order of r within a
/// share, from several threads. What is the same for all samples is refined once: without noise, the data without
/// outliers, too.
void for_each_refined(
    const NoisyData& data, const std::vector<Method>& methods, std::size_t count, Reads reads,
    const ExperimentOptions& options,
    const std::function<void(const Method& method, std::size_t r, const RefinedSample& sample)>& visit) {
  const std::size_t shares = (count + samples_per_share - 1) / samples_per_share;
  const bool without_outliers = reads != Reads::with_outliers && data.outliers > 0, noisy = data.sigma.value_or(0) != 0,
             both = without_outliers && noisy;
  const std::vector<double> points = data.true_points().values;
  struct Truth {
    std::once_flag once;
    std::vector<double> values, exact;  // at the parameters after refinement, the same for all samples
  };
  std::vector<Truth> truths(methods.size());
  parallel_for_each(shares * methods.size(), options.jobs, [&](std::size_t task) {
    const Method& method = methods[task / shares];
    const std::size_t first = task % shares * samples_per_share, last = std::min(count, first + samples_per_share);
    std::vector<OutlierSample> drawn;
    Batch batch{data.axes, data.dimension, {}};
    for (std::size_t r = first; r < last; ++r) {
      auto engine = generator(options.seed, r);
      drawn.push_back(data.draw(engine, points));
      if (both) batch.sets.push_back(drawn.back().without);
      batch.sets.push_back(drawn.back().with);
    }
    const int levels = method.levels.value_or(data.levels);
    const Batch fine = refined(method.specification, batch, levels);
    Truth& truth = truths[task / shares];
    std::call_once(truth.once, [&] {
      truth.values = data.true_points(fine.axes).values;
      if (reads == Reads::exact || (without_outliers && !noisy))
        truth.exact = refined(method.specification, data.as_grid(points), levels).values;
    });
    for (std::size_t k = 0; k < drawn.size(); ++k) {
      const auto &with = fine.sets[both ? 2 * k + 1 : k], &without = both               ? fine.sets[2 * k]
                                                                     : without_outliers ? truth.exact
                                                                                        : with;
      visit(method, first + k, {data, drawn[k], fine.axes, points, truth.values, without, with, truth.exact});
    }
  });
}

}  // namespace

const SampleMeasure error_measure{"error", error},
    error_without_measure{"error without", error_without, Reads::without_outliers},
    response_measure{"response", response, Reads::without_outliers},
    response_to_noise_measure{"response to noise", response_to_noise, Reads::exact},
    roughness_measure{"roughness", roughness}, from_data_measure{"from data", from_data},
    overfits_measure{"overfits", overfits};

std::vector<MeansTable::Row> rows_of(const std::vector<Method>& methods) {
  std::vector<MeansTable::Row> result;
  for (const Method& method : methods) result.push_back({{method.name}, method.name});
  return result;
}

OutlierSample NoisyData::draw(std::mt19937_64& engine, std::vector<double> points) const {
  OutlierSample sample{std::move(points), {}};
  if (sigma) {
    const auto noise = normal_noise(engine, sample.without.size());
    for (std::size_t i = 0; i < noise.size(); ++i) sample.without[i] += *sigma * noise[i];
  }
  sample.with = sample.without;
  for (const std::size_t i : chosen_indices(engine, outliers, sample.with.size() / dimension))
    displace(engine, &sample.with[i * dimension]);
  return sample;
}

OutlierSample NoisyData::first_sample(std::uint64_t seed) const {
  auto engine = generator(seed, 0);
  return draw(engine);
}

std::function<void(std::mt19937_64&, double*)> vertical_outlier(double low, double width) {
  return [low, width](std::mt19937_64& engine, double* height) {
    const double distance = low + width * uniform(engine);
    *height += uniform(engine) < 0.5 ? -distance : distance;
  };
}

void study(Measured& measured, const NoisyData& data, const std::vector<Method>& methods,
           const std::vector<SampleMeasure>& measures, const ExperimentOptions& options, const std::string& prefix) {
  Reads reads = Reads::with_outliers;
  for (const SampleMeasure& measure : measures) {
    reads = std::max(reads, measure.reads);
    for (const Method& method : methods) measured.samples[{prefix + measure.name, method.name}].resize(options.runs);
  }
  for_each_refined(data, methods, options.runs, reads, options,
                   [&](const Method& method, std::size_t r, const RefinedSample& sample) {
                     for (const SampleMeasure& measure : measures)
                       measured.samples.at({prefix + measure.name, method.name})[r] = measure.value(sample);
                   });
}

void study_error_parts(Measured& measured, const NoisyData& data, const std::vector<Method>& methods,
                       const ExperimentOptions& options) {
  const std::size_t pairs = std::max<std::size_t>(2, options.runs / 2);
  std::map<std::string, std::vector<std::vector<double>>> errors;  // by method, of each sample at each value
  for (const Method& method : methods) {
    for (const char* part : {"squared bias", "variance"}) measured.samples[{part, method.name}].resize(pairs);
    errors[method.name].resize(2 * pairs);
  }
  for_each_refined(data, methods, 2 * pairs, Reads::with_outliers, options,
                   [&](const Method& method, std::size_t r, const RefinedSample& sample) {
                     std::vector<double>&previous = errors.at(method.name)[r - r % 2],
                     &error = errors.at(method.name)[r];
                     error = sample.with;
                     for (std::size_t i = 0; i < error.size(); ++i) error[i] -= sample.truth[i];
                     if (r % 2 == 0) return;
                     double &squared_bias = measured.samples.at({"squared bias", method.name})[r / 2],
                            &variance = measured.samples.at({"variance", method.name})[r / 2];
                     const double points = static_cast<double>(error.size() / data.dimension);
                     for (std::size_t i = 0; i < error.size(); ++i) {
                       const double e = previous[i], f = error[i];
                       squared_bias += e * f / points;
                       variance += (e - f) * (e - f) / 2 / points;
                     }
                     previous = error = {};
                   });
}

MeansTable outlier_table(const std::string& id, const std::string& title, const std::vector<Method>& methods,
                         const std::string& prefix) {
  MeansTable table{id,
                   title,
                   {"scheme", "specification"},
                   {},
                   {{"mean squared error", prefix + error_measure.name},
                    {"without outliers", prefix + error_without_measure.name},
                    {"response", prefix + response_measure.name}}};
  for (const Method& method : methods) table.rows.push_back({{method.name, method.specification}, method.name});
  return table;
}

}  // namespace subcert::experiments
