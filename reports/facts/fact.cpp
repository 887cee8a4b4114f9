
#include "fact.hpp"

#include "screen_lines.hpp"

#include <algorithm>
#include <iterator>

namespace subcert::facts {
Fact member(std::string key, Json json) { return {std::move(key), "", "", "", std::move(json)}; }

Fact decided(std::string key, std::string label, const Decision& decision) {
  return {std::move(key), std::move(label), to_text(decision.truth), decision.reason, decision_json(decision)};
}

const char* verdict_text(Truth holds) {
  return holds == Truth::yes ? "proved" : holds == Truth::no ? "refuted" : "undecided";
}

Facts named(const std::string& specification, const std::string& title) {
  return {{"scheme", "scheme", specification, title, specification}, member("title", title)};
}

void append(Facts& list, Facts more) {
  list.insert(list.end(), std::move_iterator(more.begin()), std::move_iterator(more.end()));
}

std::string text_with_remark(const Fact& fact) {
  if (fact.remark.empty()) return fact.text;
  const bool answer = fact.text == "yes" || fact.text == "no" || fact.text == "unknown";
  return fact.text + (answer ? ": " + fact.remark : "  (" + fact.remark + ")");
}

std::string page_text(const Facts& list, std::size_t width) {
  std::string page;
  for (const Fact& fact : list) {
    if (fact.label.empty()) continue;
    std::string text = text_with_remark(fact);
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += width + 1)
      text.insert(at + 1, width, ' ');
    const std::size_t indent = std::max(width, fact.label.size() + 1);
    page += wrapped(fact.label + std::string(indent - fact.label.size(), ' ') + text, indent) + "\n";
  }
  return page;
}

Json page_json(const Facts& list) {
  Json json = Json::object();
  for (const Fact& fact : list)
    if (!fact.key.empty()) json[fact.key] = fact.json;
  return json;
}

std::vector<std::string> labels(const std::vector<Facts>& of_objects) {
  std::vector<std::string> names;
  for (const Facts& list : of_objects) {
    auto place = names.begin();
    for (const Fact& fact : list) {
      if (fact.label.empty()) continue;
      const auto there = std::ranges::find(names, fact.label);
      place = std::next(there != names.end() ? there : names.insert(place, fact.label));
    }
  }
  return names;
}

const Fact* find(const Facts& list, const std::string& label) {
  const auto found = std::ranges::find(list, label, &Fact::label);
  return found == list.end() ? nullptr : &*found;
}

Json enclosure_json(const Enclosure& enclosure, int digits) {
  digits = enclosure.telling_digits(digits);
  return {{"lower", enclosure.lower_text(digits)}, {"upper", enclosure.upper_text(digits)}};
}

Json enclosure_json(const std::optional<Enclosure>& enclosure) {
  return enclosure ? enclosure_json(*enclosure) : Json();
}

Json interval_json(const Interval& interval) {
  return {{"lower", to_text(interval.lower)}, {"upper", to_text(interval.upper)}};
}

Json decision_json(const Decision& decision) {
  return {{"verdict", to_text(decision.truth)}, {"reason", decision.reason}};
}

Json numbers_json(const std::vector<Rational>& numbers) {
  Json list = Json::array();
  for (const Rational& number : numbers) list.push_back(to_text(number));
  return list;
}

}  // namespace subcert::facts
