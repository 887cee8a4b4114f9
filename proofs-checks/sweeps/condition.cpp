#include "condition.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/analysis/symbol/support/utf8.hpp>

#include <algorithm>
#include <charconv>

namespace subcert::sweeps {
namespace {

std::optional<Rational> number_in(const Json& value) {
  if (value.is_number_integer()) return Rational(value.get<long>());
  if (value.is_number_float()) return parse_number(value.dump());
  return value.is_string() ? parse_number(value.get<std::string>()) : std::nullopt;
}

Truth negated(Truth truth) {
  return truth == Truth::yes ? Truth::no : truth == Truth::no ? Truth::yes : Truth::unknown;
}

/// Whether x > y, or x >= y, for the x of an enclosure.
Truth is_above(const Enclosure& x, const Rational& y, bool or_equal) {
  if (x.lower && (*x.lower > y || (or_equal && *x.lower == y))) return Truth::yes;
  if (x.upper && (*x.upper < y || (!or_equal && *x.upper == y))) return Truth::no;
  return Truth::unknown;
}

Truth equals(const Enclosure& x, const Rational& y) {
  if ((x.lower && *x.lower > y) || (x.upper && *x.upper < y)) return Truth::no;
  return x.lower && x.upper && *x.lower == *x.upper ? Truth::yes : Truth::unknown;
}

/// Whether it is null, or an enclosure without ends.
bool says_nothing(const Json& value) {
  const bool is_enclosure = value.is_object() && value.contains("lower") && value.contains("upper");
  const Enclosure ends = enclosure_of(value);
  return value.is_null() || (is_enclosure && !ends.lower && !ends.upper);
}

/// Of an object the member of this name, of a list that of this number.
const Json* part_of(const Json& whole, std::string_view name) {
  if (whole.is_object()) {
    const auto found = whole.find(std::string(name));
    return found == whole.end() ? nullptr : &*found;
  }
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  const bool is_number = error == std::errc() && end == name.data() + name.size();
  return whole.is_array() && is_number && number < whole.size() ? &whole[number] : nullptr;
}

}  // namespace

Enclosure enclosure_of(const Json& value) {
  if (value.is_object() && value.contains("lower") && value.contains("upper"))
    return {number_in(value.at("lower")), number_in(value.at("upper"))};
  const auto number = number_in(value);
  return {number, number};
}

const Json* member_at(const Json& answer, std::string_view path) {
  const Json* at = &answer;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    at = part_of(*at, path.substr(begin, end - begin));
    if (!at) return nullptr;
    begin = end + 1;
  }
  return at;
}

Condition Condition::parse(const std::string& subject, std::string_view text) {
  static const std::vector<std::pair<std::string_view, Relation>> relations = {
      {">=", Relation::at_least},  {"<=", Relation::at_most}, {"==", Relation::equal},
      {"!=", Relation::different}, {">", Relation::greater},  {"<", Relation::less}};
  Condition result;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(" and ", begin), text.size());
    const std::string_view part = text.substr(begin, end - begin);
    const auto fail_at = [&](std::string_view token) {
      throw ParseError(subject, token, begin + 1,
                       "NAME OP VALUE with >, >=, <, <=, == or !=, as 'holder > 1.9', or NAME for NAME == yes");
    };
    const std::size_t at = part.find_first_of("<>=!");
    if (at == std::string_view::npos) {
      const std::string name = trimmed(part);
      if (name.empty() || name.find(' ') != std::string::npos) fail_at(part);
      result.comparisons_.push_back({name, Relation::equal, "yes", 0});
      begin = end + 5;
      continue;
    }
    const auto relation = std::ranges::find_if(relations,
                                               [&](const auto& r) { return part.substr(at).starts_with(r.first); });
    if (relation == relations.end()) fail_at(part);
    const std::string name = trimmed(part.substr(0, at)), value = trimmed(part.substr(at + relation->first.size()));
    if (name.empty() || value.empty() || value.find_first_of("<>=! ") != std::string::npos) fail_at(part);
    const auto number = parse_number(value);
    const bool has_order = relation->second != Relation::equal && relation->second != Relation::different;
    if (!number && has_order) fail_at(value);
    result.comparisons_.push_back({name, relation->second, number ? "" : value, number.value_or(Rational(0))});
    begin = end + 5;
  }
  return result;
}

Truth Condition::holds(const Comparison& comparison, const Json* value) {
  if (!value || value->is_null()) return Truth::unknown;
  const bool is_negated = comparison.relation == Relation::different;
  if (!comparison.word.empty()) {
    const std::string found = value->is_boolean()  ? (value->get<bool>() ? "yes" : "no")
                              : value->is_string() ? value->get<std::string>()
                                                   : value->dump();
    const Truth truth = found == comparison.word           ? Truth::yes
                        : found == to_text(Truth::unknown) ? Truth::unknown
                                                           : Truth::no;
    return is_negated ? negated(truth) : truth;
  }
  const Enclosure x = enclosure_of(*value);
  switch (comparison.relation) {
    case Relation::greater: return is_above(x, comparison.number, false);
    case Relation::at_least: return is_above(x, comparison.number, true);
    case Relation::less: return negated(is_above(x, comparison.number, true));
    case Relation::at_most: return negated(is_above(x, comparison.number, false));
    default: return is_negated ? negated(equals(x, comparison.number)) : equals(x, comparison.number);
  }
}

Truth Condition::holds(const Lookup& lookup) const {
  Truth all = Truth::yes;
  for (const Comparison& comparison : comparisons_) {
    const Truth truth = holds(comparison, lookup(comparison.name));
    if (truth == Truth::no) return Truth::no;
    if (truth == Truth::unknown) all = Truth::unknown;
  }
  return all;
}

Truth Condition::meets(const Lookup& lookup) const {
  const Json* converges = lookup("converges");
  if (converges && *converges == to_text(Truth::no))
    for (const std::string& name : names())
      if (const Json* value = lookup(name.substr(0, name.find('.'))); value && says_nothing(*value)) return Truth::no;
  return holds(lookup);
}

std::vector<std::string> Condition::names() const {
  std::vector<std::string> result;
  for (const Comparison& comparison : comparisons_) result.push_back(comparison.name);
  return result;
}

}  // namespace subcert::sweeps
