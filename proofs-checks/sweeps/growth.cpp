#include "growth.hpp"

#include "sweep_plan.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/analysis/symbol/support/utf8.hpp>

#include <algorithm>
#include <cmath>

namespace subcert::sweeps {
namespace {

constexpr std::size_t fewest = 3;

std::optional<Rational> middle_of(const Json* value) {
  if (!value) return std::nullopt;
  const Enclosure enclosure = enclosure_of(*value);
  if (!enclosure.lower || !enclosure.upper) return std::nullopt;
  return (*enclosure.lower + *enclosure.upper) / 2;
}

double log_of(const Rational& value) { return std::log(value.convert_to<double>()); }

Growth fitted(const std::string& schemes, const std::map<Rational, Rational>& values) {
  double x = 0, y = 0, xx = 0, xy = 0;
  const auto count = static_cast<double>(values.size());
  for (const auto& [key, value] : values) {
    x += log_of(key) / count;
    y += log_of(value) / count;
  }
  for (const auto& [key, value] : values) {
    xx += (log_of(key) - x) * (log_of(key) - x);
    xy += (log_of(key) - x) * (log_of(value) - y);
  }
  const auto last = std::prev(values.end()), before = std::prev(last);
  Growth growth{schemes, values.size(), values.begin()->first, last->first};
  growth.power = xy / xx;
  growth.factor = std::exp(y - growth.power * x);
  for (const auto& [key, value] : values)
    growth.deviation = std::max(growth.deviation,
                                std::abs(std::exp(log_of(value) - y - growth.power * (log_of(key) - x)) - 1));
  growth.last_power = (log_of(last->second) - log_of(before->second)) / (log_of(last->first) - log_of(before->first));
  return growth;
}

}  // namespace

GrowthQuestion GrowthQuestion::parse(std::string_view text) {
  const auto refuse = [&] {
    throw ParseError("--fit", text, 1, "NAME by KEY or NUMBER - NAME by KEY, as '2 - holder by n'");
  };
  const std::size_t by = text.find(" by ");
  if (by == std::string_view::npos) refuse();
  GrowthQuestion question;
  std::string_view quantity = text.substr(0, by);
  if (const std::size_t minus = quantity.find(" - "); minus != std::string_view::npos) {
    question.from = parse_number(trimmed(quantity.substr(0, minus)));
    if (!question.from) refuse();
    quantity = quantity.substr(minus + 3);
  }
  question.name = trimmed(quantity);
  question.key = trimmed(text.substr(by + 4));
  for (const std::string& name : {question.name, question.key})
    if (name.empty() || name.find(' ') != std::string::npos) refuse();
  return question;
}

std::string GrowthQuestion::text() const { return (from ? to_text(*from) + " - " : "") + name + " by " + key; }

void Growths::add(const Json& answers) {
  const std::optional<Rational> value = middle_of(value_of(answers, question_.name));
  std::optional<Rational> at;
  std::string others;
  for (const auto& [key, text] : answers.at("keys").items())
    if (key == question_.key)
      at = parse_number(text.get<std::string>());
    else
      others += (others.empty() ? "" : ",") + key + "=" + text.get<std::string>();
  if (!value || !at || *at <= 0) return;
  const Rational quantity = question_.from ? *question_.from - *value : *value;
  const std::string scheme = answers.at("scheme").get<std::string>();
  const std::string family = scheme.substr(0, std::min(scheme.find(':'), scheme.size()));
  if (quantity > 0) values_[family + (others.empty() ? "" : ":" + others)][*at] = quantity;
}

std::vector<Growth> Growths::result() const {
  std::vector<Growth> growths;
  for (const auto& [schemes, values] : values_)
    if (values.size() >= fewest) growths.push_back(fitted(schemes, values));
  return growths;
}

}  // namespace subcert::sweeps
