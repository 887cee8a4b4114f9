#include "vertex_rules_file.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/proofs-checks/toml_fields.hpp>

#include <algorithm>
#include <cctype>
#include <charconv>

namespace subcert {
namespace {

constexpr long largest_coordinate = 20;
constexpr std::size_t most_letters = 3;
constexpr const char* lattices = "\"triangles\", \"quads\" or \"dual\"";

std::optional<long> whole(std::string_view text) {
  long value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

/// Texts between these signs.
std::vector<std::string> split_at(const std::string& text, char sign) {
  std::vector<std::string> parts{""};
  for (const char one : text)
    if (one == sign)
      parts.emplace_back();
    else if (one != ' ')
      parts.back() += one;
  return parts;
}

class RulesFile {
 public:
  RulesFile(const toml::table& table, std::string file) : table_(table), file_(std::move(file)) {}

  VertexScheme read() {
    only_keys(table_, {"name", "scheme", "lattice", "letter", "value", "rule"});
    const toml::node* const node = table_.get("scheme");
    const std::string specification = needed_text(table_, "scheme");
    const Scheme scheme = scheme_at(*node, specification);
    VertexScheme result = base(*node, scheme);
    lattice_ = result.written->lattice;
    result.written->letters = letters();
    const std::vector<const toml::table*> tables = tables_of(table_, "rule");
    if (tables.empty()) throw FileError({1, 1}, "no rules; expected tables [[rule]]");
    std::vector<WrittenRule> own;
    for (const toml::table* table : tables) add_rules(*table, own);
    std::erase_if(result.written->rules, [&](const WrittenRule& rule) {
      return std::ranges::find(own, rule.point, &WrittenRule::point) != own.end();
    });
    result.written->rules.insert(result.written->rules.end(), own.begin(), own.end());
    const std::string name = optional_text(table_, "name");
    result.title = name.empty() ? "rules of " + file_ + ", " + scheme.specification
                                : name + ", " + scheme.specification;
    result.specification = file_;
    check_rules(*result.written);
    return result;
  }

 private:
  Scheme scheme_at(const toml::node& node, const std::string& text) const {
    try {
      return make_linear_scheme(text);
    } catch (const ParseError& error) {
      throw FileError(place_of(node), error.what());
    }
  }

  /// The rules that the file changes, or those of a mask alone, whose lattice it says.
  VertexScheme base(const toml::node& node, const Scheme& scheme) const {
    const std::string lattice = optional_text(table_, "lattice");
    if (!lattice.empty()) {
      const std::vector<std::string> names{"triangles", "quads", "dual"};
      const auto found = std::ranges::find(names, lattice);
      if (found == names.end())
        throw FileError(place_of(*table_.get("lattice")),
                        fmt::format("'{}' is no lattice; expected {}", printable(lattice), lattices));
      const std::vector<LatticePoint>& rows = scheme.mask.dilation().rows();
      if (scheme.mask.components() != 1 || rows.size() != 2 || rows[0][0] < 2 ||
          rows != std::vector<LatticePoint>{{rows[0][0], 0}, {0, rows[0][0]}})
        throw FileError(place_of(node), "a lattice is of masks of two variables, with a dilation m times the identity");
      const auto kind = static_cast<SectorLattice>(found - names.begin());
      return {"", "", WrittenRules{kind, mask_in_sectors(scheme.mask, kind)}, {}};
    }
    if (!has_vertex_rules(scheme))
      throw FileError(place_of(node), fmt::format("{} has no rules at vertices; a mask needs 'lattice', {}",
                                                  scheme.specification, lattices));
    VertexScheme result = VertexScheme::named(scheme.specification);
    if (!result.written)
      throw FileError(place_of(node), fmt::format("the rules of {} are computed from others, and a file cannot change "
                                                  "them",
                                                  scheme.specification));
    return result;
  }

  /// One or several, in a list.
  static std::vector<const toml::node*> nodes_of(const toml::node* node) {
    std::vector<const toml::node*> result;
    if (const toml::array* list = node ? node->as_array() : nullptr)
      for (const toml::node& one : *list) result.push_back(&one);
    else if (node)
      result.push_back(node);
    return result;
  }

  std::vector<WrittenLetter> letters() const {
    const std::vector<const toml::node*> names = nodes_of(table_.get("letter")), values = nodes_of(table_.get("value"));
    if (names.empty() && !values.empty())
      throw FileError(place_of(*values.front()), "a value is that of a letter; expected the key 'letter', too");
    std::vector<WrittenLetter> result;
    for (const toml::node* node : names) {
      const std::string name = node->is_string() ? text_of(*node) : "";
      if (name.size() != 1 || std::isalpha(static_cast<unsigned char>(name[0])) == 0 || name == "c" || name == "C" ||
          name == "n")
        throw FileError(place_of(*node), "'letter' takes one letter other than c, C and n, or a list of such");
      if (std::ranges::find(result, name[0], &WrittenLetter::name) != result.end() || result.size() == most_letters)
        throw FileError(place_of(*node), fmt::format("'letter' takes up to {} different letters", most_letters));
      result.push_back({name[0]});
    }
    if (!values.empty() && values.size() != result.size())
      throw FileError(place_of(*values.front()), fmt::format("{} values of {} letters; expected one for each, or none",
                                                             values.size(), result.size()));
    for (std::size_t v = 0; v < values.size(); ++v) {
      result[v].value = parse_number(expression_at(*values[v]));
      if (!result[v].value)
        throw FileError(place_of(*values[v]), "'value' takes an exact number in quotes, as \"3/8\"");
    }
    return result;
  }

  /// A text, or a whole number.
  static std::string expression_at(const toml::node& node) {
    if (const auto* integer = node.as_integer()) return std::to_string(integer->get());
    if (!node.is_string())
      throw FileError(place_of(node), "expected a whole number or an exact expression in quotes, as \"3/8\"");
    return text_of(node);
  }

  std::string place(const toml::node& node, std::string_view key) const {
    const Place at = place_of(node);
    return fmt::format("{}, line {}, column {}, '{}'", file_, at.line, at.column, printable(key));
  }

  void add_rules(const toml::table& table, std::vector<WrittenRule>& rules) const {
    only_keys(table, {"valence", "point", "weights"});
    WrittenRule rule{point_of_rule(table), {}};
    const toml::node* const weights = table.get("weights");
    if (!weights || !weights->is_table() || weights->as_table()->empty())
      throw FileError(place_of(weights ? *weights : static_cast<const toml::node&>(table)),
                      "expected the table 'weights', as weights = {" + std::string(example()) + "}");
    rule.place = place(*weights, "weights");
    for (const auto& [key, node] : *weights->as_table()) rule.weights.push_back(weights_at_key(key.str(), node));
    for (const auto& [first, last] : valences_of_rule(table)) {
      rule.first = first;
      rule.last = last;
      for (const WrittenRule& other : rules)
        if (other.point == rule.point && (!last || other.first <= *last) && (!other.last || first <= *other.last))
          throw FileError(place_of(table), fmt::format("two rules of the point ({},{}) at valence {}", rule.point[0],
                                                       rule.point[1], std::max(first, other.first)));
      rules.push_back(rule);
    }
  }

  const char* example() const {
    return lattice_ == SectorLattice::dual ? "corner = \"1/4\", corners = \"(3+2*C)/(4*n)\""
                                           : "vertex = \"5/8\", neighbours = \"3/8/n\"";
  }

  std::vector<std::pair<long, std::optional<long>>> valences_of_rule(const toml::table& table) const {
    const toml::node* const node = table.get("valence");
    if (!node) return {{smallest_valence, std::nullopt}};
    std::vector<std::pair<long, std::optional<long>>> result;
    for (const std::string& part : split_at(expression_at(*node), ',')) {
      const std::size_t dots = part.find("..");
      const auto first = whole(std::string_view(part).substr(0, dots));
      const std::string rest = dots == std::string::npos ? part : part.substr(dots + 2);
      const auto last = rest.empty() ? std::nullopt : whole(rest);
      if (!first || (!rest.empty() && !last) || *first < smallest_valence || *first > largest_valence ||
          (last && *last < *first))
        throw FileError(place_of(*node), fmt::format("'{}' is no valence; expected as 5, 3..6 or 7.., from {} to {}",
                                                     printable(part), smallest_valence, largest_valence));
      result.emplace_back(*first, last);
    }
    return result;
  }

  bool has_vertex() const { return lattice_ != SectorLattice::dual; }

  bool is_canonical(const LatticePoint& at) const {
    const bool inside = at[0] >= (has_vertex() ? 1 : 0) && at[1] >= 0;
    return (inside || at == LatticePoint{0, 0}) && at[0] <= largest_coordinate && at[1] <= largest_coordinate;
  }

  std::optional<LatticePoint> point_of(const std::string& text) const {
    const std::vector<std::string> parts = split_at(text, ',');
    if (parts.size() != 2) return std::nullopt;
    const auto x = whole(parts[0]), y = whole(parts[1]);
    if (!x || !y || !is_canonical({*x, *y})) return std::nullopt;
    return LatticePoint{*x, *y};
  }

  LatticePoint point_of_rule(const toml::table& table) const {
    const toml::node* const node = table.get("point");
    if (!node) return {0, 0};
    const std::string text = text_of(*node);
    if (text == (has_vertex() ? "vertex" : "corner")) return {0, 0};
    if (text == "edge" && has_vertex()) return {1, 0};
    if (text == "face" && lattice_ == SectorLattice::quads) return {1, 1};
    if (const auto point = point_of(text)) return *point;
    throw FileError(place_of(*node),
                    fmt::format("'{}' is no new point of a sector; expected {} or \"x,y\"", printable(text),
                                has_vertex() ? "\"vertex\", \"edge\", \"face\" of quads" : "\"corner\""));
  }

  WrittenWeights weights_at_key(std::string_view key, const toml::node& node) const {
    WrittenWeights result{{0, 0}, std::nullopt, {}, place(node, key)};
    if (const toml::array* list = node.as_array()) {
      if (list->empty()) throw FileError(place_of(node), "expected weights, one for each sector");
      for (const toml::node& one : *list) result.values.push_back(expression_at(one));
    } else {
      result.values.push_back(expression_at(node));
    }
    const std::string text(key);
    const std::size_t at = text.find('@');
    const auto turn = at == std::string::npos ? std::nullopt : whole(text.substr(at + 1));
    const auto point = point_of(text.substr(0, at));
    if (text == (has_vertex() ? "vertex" : "corner")) {
      result.turn = 0;
    } else if (text == "neighbours" && has_vertex()) {
      result.point = {1, 0};
    } else if (text == "across" && has_vertex()) {
      result.point = {1, 1};
    } else if (text != "corners" || has_vertex()) {
      if (!point || (at != std::string::npos && (!turn || std::abs(*turn) > largest_valence)))
        throw FileError(place_of(node),
                        fmt::format("'{}' names no data; expected {}, \"x,y\" of all sectors or "
                                    "\"x,y@sector\"",
                                    printable(text), has_vertex() ? "vertex, neighbours, across" : "corner, corners"));
      result.point = *point;
      result.turn = turn;
    }
    if (result.turn && result.values.size() > 1)
      throw FileError(place_of(node), fmt::format("'{}' is one datum, and takes one weight", printable(text)));
    return result;
  }

  const toml::table& table_;
  std::string file_;
  SectorLattice lattice_ = SectorLattice::triangles;
};

}  // namespace

VertexScheme read_vertex_rules(std::string_view toml, const std::string& file) {
  try {
    const toml::table table = parse_toml(toml);
    return RulesFile(table, file).read();
  } catch (const FileError& error) {
    fail(ErrorKind::data, "{}, {}", file, error.what());
  }
}

}  // namespace subcert
