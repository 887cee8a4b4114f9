#pragma once
/// What is known of an object, made once and printed in every form: as text, as JSON, as HTML, in Python.

#include <subcert/analysis/symbol/numbers/interval.hpp>
#include <subcert/analysis/symbol/numbers/numbers.hpp>

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace subcert::facts {

using Json = nlohmann::ordered_json;

/// {"lower", "upper"}, with as many digits as tell it from thresholds (Enclosure::telling_digits).
Json enclosure_json(const Enclosure& enclosure, int digits = 20);
Json enclosure_json(const std::optional<Enclosure>& enclosure);  ///< null where there is none
/// {"lower", "upper"}, exact.
Json interval_json(const Interval& interval);
/// {"verdict", "reason"}.
Json decision_json(const Decision& decision);
/// A list of exact numbers.
Json numbers_json(const std::vector<Rational>& numbers);
/// The value, or null.
template <class Value>
Json optional_json(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

/// Texts are plain, as for a terminal.
struct Fact {
  std::string key;          ///< of the member in JSON; empty: for people alone
  std::string label;        ///< what people call it; empty: for programs alone
  std::string text;         ///< further lines stand below the first
  std::string remark = {};  ///< why, or in what sense
  Json json = {};
};

using Facts = std::vector<Fact>;

/// A fact for programs alone.
Fact member(std::string key, Json json);
/// A number or a word that looks the same in all forms.
template <class Value>
Fact plain(std::string key, std::string label, const Value& value) {
  const Json json(value);
  return {
      std::move(key), std::move(label), json.is_string() ? json.template get<std::string>() : json.dump(), {}, json};
}
/// An answer with its reason.
Fact decided(std::string key, std::string label, const Decision& decision);
/// `proved`, `refuted` or `undecided`.
const char* verdict_text(Truth holds);
/// `phi  (a function)`, and `scheme` and `title` in JSON.
Facts named(const std::string& specification, const std::string& title);

void append(Facts& list, Facts more);

/// `text  (remark)`; of an answer `yes: remark`.
std::string text_with_remark(const Fact& fact);

/// A line a fact, or several where it is long, texts from the column `width` on.
std::string page_text(const Facts& list, std::size_t width);

/// One object.
Json page_json(const Facts& list);

/// The labels of the facts of any of these objects, in an order that is that of each.
std::vector<std::string> labels(const std::vector<Facts>& of_objects);

/// The fact with this label, or null.
const Fact* find(const Facts& list, const std::string& label);

}  // namespace subcert::facts
