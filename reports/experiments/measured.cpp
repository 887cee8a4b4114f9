#include "measured.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/proofs-checks/verdict.hpp>

#include <algorithm>

namespace subcert::experiments {
namespace {

std::string appended(const std::string& text, const std::string& separator, const std::string& name,
                     const std::string& numbers) {
  return text + (text.empty() ? "" : separator) + name + (name.empty() ? "" : ": ") + numbers;
}

}  // namespace

const std::vector<double>& Measured::at(const Quantity& quantity) const {
  const auto found = samples.find(quantity);
  require(found != samples.end(), "'{}' of '{}' was not measured", quantity.measure, quantity.subject);
  return found->second;
}

double Measured::number(const Bound& bound) const {
  if (const double* value = std::get_if<double>(&bound)) return *value;
  const auto found = numbers.find(std::get<std::string>(bound));
  require(found != numbers.end(), "the number '{}' was not measured", std::get<std::string>(bound));
  return found->second;
}

std::string Measured::filled(const std::string& text) const {
  std::string result;
  std::size_t from = 0;
  for (std::size_t open; (open = text.find('{', from)) != std::string::npos;) {
    const std::size_t close = std::min(text.find('}', open), text.size() - 1);
    result += text.substr(from, open - from) + short_number(number(text.substr(open + 1, close - open - 1)));
    from = close + 1;
  }
  return result + text.substr(from);
}

void Measured::add_fact(const std::string& topic, const std::string& name, bool holds, const std::string& shown) {
  facts[topic].push_back({name, holds, shown});
}

MeanInterval Mean::in(const Measured& measured, double confidence) const {
  if (!minus) return mean_interval(measured.at(of), confidence);
  std::vector<double> subtracted = measured.at(*minus);
  for (double& value : subtracted) value *= factor;
  return mean_difference(measured.at(of), subtracted, confidence);
}

Relation whole_intervals(const std::string& statistic, const std::vector<Mean>& means) {
  return [=](const Measured& measured) {
    const auto wanted = std::ranges::count_if(means, &Mean::is_bounded);
    std::vector<Truth> truths;
    std::string numbers;
    for (const Mean& mean : means) {
      const MeanInterval found = mean.in(measured, each_of(static_cast<std::size_t>(wanted)));
      const double lower = measured.number(mean.lower), upper = measured.number(mean.upper);
      truths.push_back(found.lower() > lower && found.upper() < upper     ? Truth::yes
                       : found.upper() <= lower || found.lower() >= upper ? Truth::no
                                                                          : Truth::unknown);
      numbers = appended(numbers, ", ", mean.name, found.text());
    }
    return Finding{all_of(truths), measured.filled(statistic), numbers};
  };
}

Relation all_facts(const std::string& statistic, const std::string& topic) {
  return [=](const Measured& measured) {
    const auto found = measured.facts.find(topic);
    require(found != measured.facts.end(), "no fact about '{}' was found", topic);
    bool holds = true;
    std::string numbers;
    for (const Fact& fact : found->second) {
      holds = holds && fact.holds;
      numbers = appended(numbers, "; ", fact.name, fact.numbers);
    }
    return Finding{holds ? Truth::yes : Truth::no, measured.filled(statistic), numbers};
  };
}

formats::PlainTable MeansTable::filled(const Measured& measured) const {
  formats::PlainTable table{id, title, label_heads, {}};
  for (const Column& column : columns) table.head.push_back(column.head);
  for (const Row& row : rows) {
    table.rows.push_back(row.labels);
    for (const auto& [head, measure, minus] : columns) {
      Mean mean{"", {measure, row.subject}};
      if (!minus.empty()) mean.minus = {minus, row.subject};
      table.rows.back().push_back(mean.in(measured, shown_confidence).text());
    }
  }
  return table;
}

}  // namespace subcert::experiments
