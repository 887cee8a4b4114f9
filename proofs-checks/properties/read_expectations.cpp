#include "deciding.hpp"
#include "mask_list_table.hpp"

#include <subcert/analysis/family/property_of_levels.hpp>
#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/proofs-checks/toml_fields.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace subcert::properties {

namespace {

/// An integer, or a rational or decimal number in a string.
std::optional<Rational> exact_number(const toml::node& node) {
  if (const auto* integer = node.as_integer()) return Rational(static_cast<long>(integer->get()));
  if (const auto* text = node.as_string()) return parse_number(text->get());
  return std::nullopt;
}

[[noreturn]] void refuse(const toml::node& node, const Property& property) {
  const auto text = node.as_string() ? node.as_string()->get() : std::string();
  const std::string found = text.empty() ? "" : "; found " + in_quotes(text);
  throw FileError(place_of(node), "'" + property.name + "' takes " + property.values + found);
}

/// A number without a sign, which could mean each of them.
void refuse_number_alone(const toml::node& node, const Property& property) {
  const auto text = node.as_string() ? node.as_string()->get() : std::string();
  std::string number = parse_number(text) ? text : "";
  if (const auto* integer = node.as_integer()) number = std::to_string(integer->get());
  if (const auto* real = node.as_floating_point()) number = fmt::format("{}", real->get());
  if (number.empty() || property.expects == Expects::whole_number) return;
  const bool is_order = property.expects == Expects::order;
  const std::string others = is_order ? "" : fmt::format(", \"<= {0}\", or \"= {0}\" for exactly that number", number);
  throw FileError(place_of(node), fmt::format("'{0}' takes {1}; {2} alone does not say which: \">= {2}\"{3}",
                                              property.name, property.values, number, others));
}

/// With `>=` for the sign of one character, as papers print it.
std::string with_plain_signs(std::string value) {
  for (const auto& [sign, plain] : {std::pair("\xe2\x89\xa5", ">="), std::pair("\xe2\x89\xa4", "<=")})
    if (value.starts_with(sign)) value.replace(0, std::string_view(sign).size(), plain);
  return value;
}

void read_comparison(Expectation& to, const toml::node& node, const Property& property) {
  if (const auto* integer = node.as_integer(); integer && property.expects == Expects::whole_number) {
    to.relation = "=";
    to.number = Rational(static_cast<long>(integer->get()));
    to.expected = subcert::to_text(to.number);
    return;
  }
  refuse_number_alone(node, property);
  const auto* text = node.as_string();
  if (!text) refuse(node, property);
  const std::string value = with_plain_signs(text->get());
  for (const char* relation : {">=", "<=", ">", "<", "="}) {
    if (value.rfind(relation, 0) != 0) continue;
    const std::size_t begin = value.find_first_not_of(' ', std::string(relation).size());
    const auto number = begin == std::string::npos ? std::nullopt : parse_number(std::string_view(value).substr(begin));
    const bool is_order = property.expects == Expects::order;
    if (!number ||
        (is_order && (std::string(relation) != ">=" || denominator(*number) != 1 || *number < 0 || *number > 1000)))
      refuse(node, property);
    to.relation = relation;
    to.number = *number;
    to.expected = to.relation + " " + value.substr(begin);
    return;
  }
  refuse(node, property);
}

bool are_valences(const std::string& text) {
  try {
    return !valences_of(text).empty();
  } catch (const ParseError&) {
    return false;
  }
}

Expectation read_expectation(const Property& property, const toml::node& node, const Place& place) {
  Expectation result{property.name, "", place, "", 0, false, "", std::nullopt, ""};
  if (property.expects == Expects::answer) {
    const auto* value = node.as_boolean();
    if (!value) refuse(node, property);
    result.yes = value->get();
    result.expected = result.yes ? "yes" : "no";
  } else if (property.expects == Expects::ends) {
    const auto* list = node.as_array();
    if (!list || list->size() != 2) refuse(node, property);
    const auto lower = exact_number(*list->get(0)), upper = exact_number(*list->get(1));
    if (!lower || !upper) refuse(node, property);
    result.ends = Interval{*lower, *upper};
    result.expected = "[" + subcert::to_text(*lower) + ", " + subcert::to_text(*upper) + "]";
  } else if (property.expects == Expects::word) {
    const auto* word = node.as_string();
    if (!word || (word->get() != "odd" && word->get() != "even" && word->get() != "none")) refuse(node, property);
    result.word = result.expected = word->get();
  } else if (property.expects == Expects::valences) {
    if (const auto* one = node.as_integer()) result.word = std::to_string(one->get());
    if (const auto* list = node.as_string()) result.word = list->get();
    if (!are_valences(result.word)) refuse(node, property);
    result.expected = result.word;
  } else {
    read_comparison(result, node, property);
  }
  result.line = toml_line(property.name, node);
  return result;
}

std::vector<std::string> known_keys() {
  std::vector<std::string> keys{"mask", "name"};
  for (const Property& property : known_properties()) keys.push_back(property.name);
  for (const char* key : {"for", "levels", "points", "recurrence", "start", "masks", "period", "follows"})
    keys.emplace_back(key);
  return keys;
}

bool is_known(std::string_view key) {
  const std::vector<std::string> keys = known_keys();
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

/// For a word that others have for a property, `; did you mean 'mask'?`.
std::string property_meant(std::string_view word) {
  constexpr std::pair<std::string_view, std::string_view> words[] = {{"scheme", "mask"},
                                                                     {"specification", "mask"},
                                                                     {"symbol", "mask"},
                                                                     {"continuity", "smoothness"},
                                                                     {"C", "smoothness"},
                                                                     {"C1", "smoothness"},
                                                                     {"C2", "smoothness"},
                                                                     {"regularity", "holder"},
                                                                     {"exponent", "holder"},
                                                                     {"generation", "generates"},
                                                                     {"reproduction", "reproduces"},
                                                                     {"valence", "vertices"},
                                                                     {"valences", "vertices"},
                                                                     {"vertex", "vertices"},
                                                                     {"support_size", "support"}};
  for (const auto& [other, name] : words)
    if (other == word) return fmt::format("; did you mean '{}'?", name);
  return "";
}

SchemeRange read_range(const toml::node& node, ParametricScheme family) {
  const auto* text = node.as_string();
  const auto values = text ? parse_parameter_range(text->get(), family.name) : std::nullopt;
  if (!values)
    throw FileError(place_of(node), "'for' takes \"LOW < " + family.name + " < HIGH\", with < or <= and LOW < HIGH");
  return {std::move(family), *values};
}

/// A text. `what`: that it takes, for the message.
const std::string& text_of(const toml::node& node, const char* key, const std::string& what) {
  const auto* text = node.as_string();
  if (!text) throw FileError(place_of(node), fmt::format("'{}' takes {}", key, what));
  return text->get();
}

/// `v0=1/2` or `-1 <= v0 <= 1000`.
std::optional<Interval> read_start(const std::string& text, const std::string& name) {
  const std::string head = name + "0=";
  std::string without_blanks = text;
  std::erase(without_blanks, ' ');
  if (without_blanks.starts_with(head)) {
    const auto value = parse_number(std::string_view(without_blanks).substr(head.size()));
    return value ? std::optional(Interval::exactly(*value)) : std::nullopt;
  }
  const auto range = parse_parameter_range(text, name + "0");
  return range ? std::optional(Interval{range->low, range->high}) : std::nullopt;
}

/// The values of the parameter, closed ends included.
Interval read_values(const toml::node& node, const char* key, const ParametricScheme& family) {
  const std::string &name = family.name, range = "\"LOW <= " + name + " <= HIGH\" with LOW < HIGH";
  const auto values = parse_parameter_range(text_of(node, key, range), name);
  if (!values || !values->low_included || !values->high_included)
    throw FileError(place_of(node), fmt::format("'{}' takes {}", key, range));
  return {values->low, values->high};
}

SchemeLevels read_levels(const toml::table& table, const toml::node& levels, ParametricScheme family) {
  SchemeLevels result{family, read_values(levels, "levels", family), {}};
  const std::string& name = family.name;
  const toml::node *recurrence = table.get("recurrence"), *start = table.get("start");
  if (!recurrence && !start) return result;
  if (!recurrence || !start) throw FileError(place_of(levels), "expected both 'recurrence' and 'start', or none");
  const std::string rule = fmt::format("\"{0}=EXPRESSION\" or \"{0}=sqrt(EXPRESSION)\"", name),
                    first = fmt::format("\"{0}0=VALUE\" or \"LOW <= {0}0 <= HIGH\"", name);
  const auto from = read_start(text_of(*start, "start", first), name);
  if (!from) throw FileError(place_of(*start), "'start' takes " + first);
  try {
    result.following = SchemeLevels::Following{
        Recurrence::parse(text_of(*recurrence, "recurrence", rule), name, family.letter), *from};
  } catch (const ParseError&) {
    throw FileError(place_of(*recurrence), "'recurrence' takes " + rule);
  }
  return result;
}

SchemeList read_list(const toml::table& table) {
  MaskListFile file = mask_list_of(table);
  const char* order = !file.list.period.empty()    ? " in a period"
                      : !file.list.follows.empty() ? " along a graph"
                                                   : " in any order";
  return {fmt::format("{}{}", fmt::join(file.specifications, ", "), order), std::move(file.list)};
}

/// What the keys of the table name, of which others need these.
using Subject = std::variant<Scheme, SchemeRange, SchemeLevels, SchemePoints, SchemeList>;

Subject read_subject(const toml::table& table) {
  const auto needs = [&](const char* key, const char* other) {
    if (const toml::node* node = table.get(key); node && !table.get(other))
      throw FileError(place_of(*node), fmt::format("'{}' needs '{}'", key, other));
  };
  for (const auto& [key, other] : {std::pair{"period", "masks"}, std::pair{"follows", "masks"},
                                   std::pair{"recurrence", "levels"}, std::pair{"start", "levels"}})
    needs(key, other);
  const toml::node *mask = table.get("mask"), *masks = table.get("masks"), *levels = table.get("levels"),
                   *points = table.get("points"), *range = table.get("for");
  if (masks && (mask || levels || points || range))
    throw FileError(place_of(*masks), "'masks' stands without 'mask' and its values");
  for (const auto& [key, node, other, beside] : {std::tuple{"levels", levels, "for", range},
                                                 {"points", points, "for", range},
                                                 {"points", points, "levels", levels}})
    if (node && beside)
      throw FileError(place_of(*node), fmt::format("'{}' beside '{}'; expected one of them", key, other));
  if (masks) return read_list(table);
  if (!mask) throw FileError(place_of(table), "a scheme needs 'mask', a scheme specification");
  const std::string& specification = text_of(*mask, "mask", "a scheme specification in quotes");
  try {
    if (range) return read_range(*range, make_parametric_scheme(specification));
    if (levels) return read_levels(table, *levels, make_parametric_scheme(specification));
    if (points) {
      ParametricScheme family = make_parametric_scheme(specification);
      const Interval values = read_values(*points, "points", family);
      if (family.form) throw FileError(place_of(*points), "'points' is for masks of numbers");
      return SchemePoints{std::move(family), values};
    }
    return make_refinable_scheme(specification);
  } catch (const FileError&) {
    throw;
  } catch (const Error& error) {
    throw FileError(place_of(*mask), error.what());
  }
}

struct SpecificationOf {
  std::string operator()(const SchemeRange& range) const { return range.family.specification; }
  std::string operator()(const SchemeLevels& levels) const { return levels.family.specification; }
  std::string operator()(const SchemePoints& points) const { return points.family.specification; }
  template <class One>
  std::string operator()(const One& scheme) const {
    return scheme.specification;
  }
};

/// Whether it is a Hermite scheme, or all are.
struct IsHermite {
  bool operator()(const Scheme& scheme) const { return scheme.form == VectorForm::hermite; }
  bool operator()(const SchemeList& list) const { return list.list.hermite; }
  template <class Family>
  bool operator()(const Family& one) const {
    return one.family.form == VectorForm::hermite;
  }
};

/// Of several schemes: that the property is one of them, and is asked for in a way that can be answered for all.
void require_for_all(const ExpectedScheme& scheme, const Property& property, const Expectation& expected) {
  if (property.of_hermite && !std::visit(IsHermite(), scheme.scheme))
    throw FileError(expected.place, "'" + property.name + "' is a property of Hermite schemes, got others");
  const bool range = std::holds_alternative<SchemeRange>(scheme.scheme),
             points = std::holds_alternative<SchemePoints>(scheme.scheme);
  if (expected.relation.starts_with('<') || expected.relation == ">" || expected.relation == "=" ||
      (expected.relation.empty() && !expected.yes))
    throw FileError(expected.place, "'" + property.name +
                                        (range    ? "' over a range of a parameter takes "
                                         : points ? "' over points takes "
                                                  : "' over levels takes ") +
                                        (expected.relation.empty() ? "true" : "\">= X\""));
  const auto* list = std::get_if<SchemeList>(&scheme.scheme);
  if (!list) return;
  try {
    subcert::require_property(list->list, asked_of(property, expected));
  } catch (const Error& error) {
    throw FileError(expected.place, error.what());
  }
}

ExpectedScheme read_scheme(const toml::table& table) {
  for (const auto& [key, node] : table)
    if (!is_known(key.str()))
      throw FileError(place_of(key.source()),
                      "unknown property " + expected_one_of(known_keys(), key.str()) + property_meant(key.str()));
  Subject scheme = read_subject(table);
  std::string specification = std::visit(SpecificationOf{}, scheme);
  const toml::node* mask = table.get("mask");
  const std::string written = mask ? printable(mask->as_string()->get()) : specification;
  ExpectedScheme result{written, std::move(specification), std::move(scheme), {}, ""};
  const auto* single = std::get_if<Scheme>(&result.scheme);
  const bool range = std::holds_alternative<SchemeRange>(result.scheme),
             points = std::holds_alternative<SchemePoints>(result.scheme);
  for (const auto& [key, node] : table) {
    const Place place = place_of(key.source());
    if (key.str() != "name" && !find_property(key.str())) {
      result.lines += toml_line(key.str(), node);
      continue;
    }
    if (key.str() == "name") {
      if (!node.is_string()) throw FileError(place_of(node), "'name' takes a string");
      result.name = printable(node.as_string()->get());
      continue;
    }
    const Property* property = find_property(key.str());
    if (single && !property->decides(*single))
      throw FileError(place, "'" + property->name + "' is no property of " + kind_of(*single) + ", got " + written);
    if (range && !property->of_ranges)
      throw FileError(place, "'" + property->name + "' is a property of single schemes, got a range of a parameter");
    if (!single && !range && !property->of_levels())
      throw FileError(place, fmt::format("'{0}' is no property of masks that change from {1} to {1}", property->name,
                                         points ? "point" : "level"));
    result.expectations.push_back(read_expectation(*property, node, place));
    if (!single) require_for_all(result, *property, result.expectations.back());
  }
  if (result.expectations.empty())
    throw FileError(place_of(mask ? *mask : *table.get("masks")), "the scheme has no expected property");
  std::sort(result.expectations.begin(), result.expectations.end(), [](const Expectation& a, const Expectation& b) {
    return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
  });
  return result;
}

}  // namespace

std::vector<std::variant<ExpectedScheme, FileError>> read_schemes(std::string_view text) {
  const toml::table table = parse_toml(text);
  std::vector<std::variant<ExpectedScheme, FileError>> result;
  const auto read = [&](const toml::table& scheme) {
    try {
      result.emplace_back(read_scheme(scheme));
    } catch (const FileError& error) {
      result.emplace_back(error);
    }
  };
  const toml::node* list = table.get("scheme");
  if (!list) {
    if (table.empty()) throw FileError({1, 1}, "no scheme; expected 'mask' and properties, or tables [[scheme]]");
    read(table);
    return result;
  }
  for (const auto& [key, node] : table)
    if (key.str() != "scheme")
      throw FileError(place_of(key.source()),
                      "'" + printable(key.str()) + "' beside [[scheme]]; expected it inside of one");
  if (!list->is_array_of_tables())
    throw FileError(place_of(*list), "'scheme' is not a list of tables; expected [[scheme]]");
  for (const toml::node& entry : *list->as_array()) read(*entry.as_table());
  return result;
}

std::vector<ExpectedScheme> read_expectations(std::string_view text) {
  std::vector<ExpectedScheme> result;
  for (auto& one : read_schemes(text)) {
    if (const auto* error = std::get_if<FileError>(&one)) throw *error;
    result.push_back(std::get<ExpectedScheme>(std::move(one)));
  }
  return result;
}

}  // namespace subcert::properties
