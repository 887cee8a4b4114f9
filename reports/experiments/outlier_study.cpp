#include "outlier_study.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/reports/formats/published.hpp>
#include <subcert/schemes/data/runtime/parallel.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace subcert::experiments {

const Names least_squares{"S_6", "S_7", "S_8"}, robust{"D_6", "D_7", "D_8"};
const NamePairs robust_over_least_squares{{"D_6", "S_6"}, {"D_7", "S_7"}, {"D_8", "S_8"}};
const NamePairs six_over_others{{"D_6", "S_6"}, {"D_6", "S_7"}, {"D_6", "S_8"}, {"D_6", "D_7"}, {"D_6", "D_8"}};
const NamePairs more_least_squares_points{{"S_7", "S_6"}, {"S_8", "S_7"}},
    more_robust_points{{"D_7", "D_6"}, {"D_8", "D_7"}};
const NamePairs more_over_fewer_points{{"S_7", "S_6"}, {"S_8", "S_7"}, {"D_7", "D_6"}, {"D_8", "D_7"}};

const std::vector<Method>& curve_methods() {
  static const std::vector<Method> methods{{"S_6", "dual:n=3"},    {"S_7", "dual-odd:n=3"}, {"S_8", "dual:n=4"},
                                           {"D_6", "l1:points=6"}, {"D_7", "l1:points=7"},  {"D_8", "l1:points=8"}};
  return methods;
}

const std::vector<Method>& surface_methods() {
  static const std::vector<Method> methods{{"S_6", "grid:points=6x6,d=1"}, {"S_7", "grid:points=7x7,d=1"},
                                           {"S_8", "grid:points=8x8,d=1"}, {"D_6", "l1:points=6x6"},
                                           {"D_7", "l1:points=7x7"},       {"D_8", "l1:points=8x8"}};
  return methods;
}

namespace {

constexpr std::size_t samples_per_task = 25;  // samples that are refined together

double squared_distance(const double* a, const double* b, std::size_t dimension) {
  double sum = 0;
  for (std::size_t c = 0; c < dimension; ++c) sum += (a[c] - b[c]) * (a[c] - b[c]);
  return sum;
}

double mean_squared_error(const std::vector<double>& values, const std::vector<double>& truth, std::size_t dimension) {
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); i += dimension) sum += squared_distance(&values[i], &truth[i], dimension);
  return sum / static_cast<double>(values.size() / dimension);
}

double largest_distance(const std::vector<double>& a, const std::vector<double>& b, std::size_t dimension) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); i += dimension)
    largest = std::max(largest, squared_distance(&a[i], &b[i], dimension));
  return std::sqrt(largest);
}

double roughness(const std::vector<double>& values, const std::vector<data::Axis>& axes, std::size_t dimension) {
  double sum = 0;
  std::size_t count = 0;
  const std::size_t columns = axes[0].count, row = columns * dimension;
  const auto add = [&](std::size_t at, std::size_t step) {
    const double difference = values[at - step] - 2 * values[at] + values[at + step];
    sum += difference * difference;
    ++count;
  };
  for (std::size_t j = 0; j < axes[1].count; ++j)
    for (std::size_t i = 0; i < columns; ++i)
      for (std::size_t c = 0; c < dimension; ++c) {
        const std::size_t at = j * row + i * dimension + c;
        if (i > 0 && i + 1 < columns) add(at, dimension);
        if (j > 0 && j + 1 < axes[1].count) add(at, row);
      }
  return sum / static_cast<double>(count);
}

}  // namespace

std::vector<double> true_points(const OutlierCase& what, const std::vector<data::Axis>& axes) {
  const auto xs = parameters(axes[0]), ys = axes.size() > 1 ? parameters(axes[1]) : std::vector<double>{0};
  std::vector<double> result;
  for (const double y : ys)
    for (const double x : xs) {
      const auto point = what.truth(x, y);
      result.insert(result.end(), point.begin(), point.begin() + static_cast<std::ptrdiff_t>(what.dimension));
    }
  return result;
}

Batch drawn_samples(const OutlierCase& what, std::uint64_t seed, std::size_t first, std::size_t count) {
  Batch batch{what.axes, what.dimension, {}};
  for (std::size_t r = first; r < first + count; ++r) {
    auto engine = generator(seed, r);
    OutlierSample sample = what.draw(engine);
    batch.sets.push_back(std::move(sample.without));
    batch.sets.push_back(std::move(sample.with));
  }
  return batch;
}

std::vector<Outcome> study(const OutlierCase& what, const std::vector<Method>& methods,
                           const ExperimentOptions& options) {
  std::vector<Outcome> outcomes;
  const std::vector<double> none(options.runs);
  for (const Method& method : methods) outcomes.push_back({method, none, none, none, none});
  const std::size_t shares = (options.runs + samples_per_task - 1) / samples_per_task;
  runtime::parallel_for_each(shares * methods.size(), options.jobs, [&](std::size_t task) {
    Outcome& result = outcomes[task / shares];
    const std::size_t first = task % shares * samples_per_task,
                      count = std::min(samples_per_task, options.runs - first);
    const Batch fine = refined(result.method.specification, drawn_samples(what, options.seed, first, count),
                               what.levels);
    const std::vector<double> truth = true_points(what, fine.axes);
    for (std::size_t k = 0; k < count; ++k) {
      const auto &without = fine.sets[2 * k], &with = fine.sets[2 * k + 1];
      result.error[first + k] = mean_squared_error(with, truth, what.dimension);
      result.error_without[first + k] = mean_squared_error(without, truth, what.dimension);
      result.response[first + k] = largest_distance(with, without, what.dimension);
      if (fine.axes.size() > 1) result.roughness[first + k] = roughness(with, fine.axes, what.dimension);
    }
  });
  return outcomes;
}

const Outcome& outcome(const std::vector<Outcome>& outcomes, const std::string& name) {
  const auto found = std::find_if(outcomes.begin(), outcomes.end(),
                                  [&](const Outcome& o) { return o.method.name == name; });
  require(found != outcomes.end(), "no outcome of {}", name);
  return *found;
}

std::vector<NamedMean> means(const std::vector<Outcome>& outcomes, const Names& names, Measure measure) {
  std::vector<NamedMean> result;
  for (const std::string& name : names) result.push_back({name, mean_interval(outcome(outcomes, name).*measure)});
  return result;
}

std::vector<NamedMean> differences(const std::vector<Outcome>& outcomes, const NamePairs& pairs, Measure measure) {
  return differences(outcomes, pairs, measure, 1);
}

std::vector<NamedMean> differences(const std::vector<Outcome>& outcomes, const NamePairs& pairs, Measure measure,
                                   double factor) {
  std::vector<NamedMean> result;
  for (const auto& [first, second] : pairs) {
    std::vector<double> subtracted = outcome(outcomes, second).*measure;
    for (double& value : subtracted) value *= factor;
    result.push_back({first + " - " + (factor == 1 ? "" : short_number(factor) + " ") + second,
                      mean_difference(outcome(outcomes, first).*measure, subtracted)});
  }
  return result;
}

formats::PlainTable outcome_table(const std::string& id, const std::string& title,
                                  const std::vector<Outcome>& outcomes) {
  formats::PlainTable table{
      id, title, {"scheme", "specification", "mean squared error", "without outliers", "response"}, {}};
  for (const Outcome& o : outcomes)
    table.rows.push_back({o.method.name, o.method.specification, mean_interval(o.error).text(),
                          mean_interval(o.error_without).text(), mean_interval(o.response).text()});
  return table;
}

namespace {

const std::string paper = "mustafa-li-2015";

std::pair<double, double> range(const std::vector<double>& values) {
  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  return {*least, *largest};
}

}  // namespace

formats::ComparisonTable printed_errors(const std::string& table, const std::vector<Outcome>& outcomes) {
  const formats::PublishedTable printed = formats::published_paper(paper).table(table);
  formats::ComparisonTable result{paper, printed.id, printed.title, printed.place, printed.grid, {}};
  for (const formats::PublishedCell& cell : printed.cells) {
    const Outcome& found = outcome(outcomes, cell.column);
    const auto [least, largest] = range(found.error);
    result.comparisons.push_back(
        {cell.row, cell.column, cell.scheme, cell.printed, mean_interval(found.error).text(), Verdict::not_reproducible,
         cell.recorded,
         "The printed value rests on one unpublished sample; over our samples the error runs from " +
             short_number(least) + " to " + short_number(largest) + "."});
  }
  return result;
}

Claim printed_errors_claim(const std::string& table, const std::vector<Outcome>& outcomes) {
  const formats::PublishedTable printed = formats::published_paper(paper).table(table);
  std::string numbers;
  for (const formats::PublishedCell& cell : printed.cells) {
    const auto [least, largest] = range(outcome(outcomes, cell.column).error);
    numbers += (numbers.empty() ? "" : "; ") + cell.column + ": printed " + cell.printed + ", ours " +
               short_number(least) + " to " + short_number(largest);
  }
  return {"The errors of " + printed.title + ".",
          printed.place,
          "the data were not published; the printed values beside the range over our samples",
          Verdict::not_reproducible,
          numbers,
          Verdict::not_reproducible};
}

}  // namespace subcert::experiments
