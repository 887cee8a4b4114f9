#include "measured.hpp"

#include <subcert/analysis/symbol/error.hpp>

#include <algorithm>

namespace subcert::experiments {
namespace {

std::string appended(const std::string& text, const std::string& separator, const std::string& name,
                     const std::string& numbers) {
  return text + (text.empty() ? "" : separator) + name + (name.empty() ? "" : ": ") + numbers;
}

std::string bound_words(const std::string& measure, const std::string& side, double bound) {
  return measure + ": " + side + " " + short_number(bound) + " with the whole interval, each";
}

}  // namespace

NamePairs all_pairs(const Names& first, const Names& second) {
  NamePairs result;
  for (const std::string& a : first)
    for (const std::string& b : second) result.emplace_back(a, b);
  return result;
}

const std::vector<double>& Measured::at(const Quantity& quantity) const {
  const auto found = samples.find(quantity);
  require(found != samples.end(), "'{}' of {} was not measured", quantity.measure, quantity.subject);
  return found->second;
}

void Measured::add_fact(const std::string& topic, const std::string& name, bool holds, const std::string& numbers) {
  facts[topic].push_back({name, holds, numbers});
}

MeanInterval Mean::in(const Measured& measured) const {
  if (!minus) return mean_interval(measured.at(of));
  std::vector<double> subtracted = measured.at(*minus);
  for (double& value : subtracted) value *= factor;
  return mean_difference(measured.at(of), subtracted);
}

Means means(const std::string& measure, const Names& subjects) {
  Means result;
  for (const std::string& subject : subjects) result.push_back({subject, {measure, subject}});
  return result;
}

Means differences(const std::string& measure, const NamePairs& pairs, double factor) {
  Means result;
  for (const auto& [first, second] : pairs)
    result.push_back({first + " - " + (factor == 1 ? "" : short_number(factor) + " ") + second,
                      {measure, first},
                      Quantity{measure, second},
                      factor});
  return result;
}

Means excess(const std::string& measure, const std::string& subtracted, const Names& subjects, double factor) {
  Means result = means(measure, subjects);
  for (Mean& mean : result) {
    mean.minus = {subtracted, mean.of.subject};
    mean.factor = factor;
  }
  return result;
}

Means all_above(double bound, Means means) {
  for (Mean& mean : means) mean.lower = bound;
  return means;
}

Means all_below(double bound, Means means) {
  for (Mean& mean : means) mean.upper = bound;
  return means;
}

Finding finding(bool holds, const std::string& numbers) {
  return {holds ? Verdict::confirmed : Verdict::not_confirmed, numbers};
}

Relation whole_intervals(const std::string& statistic, const Means& means) {
  return {statistic, [means](const Measured& measured) {
            bool holds = true;
            std::string numbers;
            for (const Mean& mean : means) {
              const MeanInterval found = mean.in(measured);
              holds = holds && found.mean - found.half_width > mean.lower && found.mean + found.half_width < mean.upper;
              numbers = appended(numbers, ", ", mean.name, found.text());
            }
            return finding(holds, numbers);
          }};
}

Relation below(const std::string& measure, double bound, const Means& means) {
  return whole_intervals(bound_words(measure, "below", bound), all_below(bound, means));
}

Relation above(const std::string& measure, double bound, const Means& means) {
  return whole_intervals(bound_words(measure, "above", bound), all_above(bound, means));
}

Relation all_facts(const std::string& topic, const std::string& statistic) {
  return {statistic, [topic](const Measured& measured) {
            const auto found = measured.facts.find(topic);
            require(found != measured.facts.end(), "no fact about '{}' was found", topic);
            std::string numbers;
            for (const Fact& fact : found->second) numbers = appended(numbers, "; ", fact.name, fact.numbers);
            return finding(
                std::all_of(found->second.begin(), found->second.end(), [](const Fact& f) { return f.holds; }),
                numbers);
          }};
}

formats::PlainTable MeansTable::filled(const Measured& measured) const {
  formats::PlainTable table{id, title, label_heads, {}};
  for (const Column& column : columns) table.head.push_back(column.head);
  for (const Row& row : rows) {
    table.rows.push_back(row.labels);
    for (const auto& [head, measure, minus] : columns) {
      Mean mean{"", {measure, row.subject}};
      if (!minus.empty()) mean.minus = {minus, row.subject};
      table.rows.back().push_back(mean.in(measured).text());
    }
  }
  return table;
}

}  // namespace subcert::experiments
