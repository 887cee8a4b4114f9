#include "experiment.hpp"
#include "noise_levels.hpp"

#include <subcert/proofs-checks/toml_fields.hpp>

#include <algorithm>

namespace subcert::experiments {
namespace {

using Texts = std::map<std::string, std::string>;

const toml::array& list_of(const toml::table& table, const std::string& key) {
  const toml::node* node = table.get(key);
  if (!node || !node->is_array()) throw FileError(place_of(node ? *node : table), "expected the list '" + key + "'");
  return *node->as_array();
}

bool flag(const toml::table& table, const std::string& key, bool otherwise) {
  const toml::node* node = table.get(key);
  if (node && !node->is_boolean()) throw FileError(place_of(*node), "expected true or false");
  return node ? node->as_boolean()->get() : otherwise;
}

std::size_t times_of(const toml::table& table) {
  const toml::node* node = table.get("times");
  if (!node) return 1;
  const auto times = node->value<std::int64_t>();
  if (!node->is_integer() || *times < 1 || *times > 100) throw FileError(place_of(*node), "need 1 <= times <= 100");
  return static_cast<std::size_t>(*times);
}

/// The table of a claim, with values put in for {name} in its texts.
struct Fields {
  const toml::table& table;
  const Texts& values;
  std::set<std::string>& used;  ///< the names of the values that were put in

  bool has(const std::string& key) const { return table.contains(key); }
  std::string plain(const toml::node& node) const {
    const std::string text = text_of(node);
    for (const auto& [name, value] : values)
      if (text.find("{" + name + "}") != std::string::npos) used.insert(name);
    return filled(text, values);
  }
  std::string text(const std::string& key) const {
    needed_text(table, key);
    return plain(*table.get(key));
  }
  double number(const std::string& key, double otherwise) const {
    const toml::node* node = table.get(key);
    if (!node) return otherwise;
    if (!node->is_number()) throw FileError(place_of(*node), "expected a number");
    return *node->value<double>();
  }
  /// A number, or the name of one.
  Bound bound(const std::string& key, double otherwise) const {
    return has(key) && table.get(key)->is_string() ? Bound(text(key)) : Bound(number(key, otherwise));
  }
  /// A list of two texts, or of such lists.
  std::vector<Pair> pairs(const std::string& key) const {
    const toml::array& list = list_of(table, key);
    if (list.empty() || !list.get(0)->is_array()) return {pair(list)};
    std::vector<Pair> result;
    for (const toml::node& node : list) result.push_back(pair(node));
    return result;
  }
  Pair pair(const toml::node& node) const {
    const toml::array* both = node.as_array();
    if (!both || both->size() != 2) throw FileError(place_of(node), "expected two texts");
    return {plain(*both->get(0)), plain(*both->get(1))};
  }
};

/// The statistic, in which {bound} says on which side of it each mean lies.
std::string statistic_of(const Fields& claim) {
  std::map<std::string, std::string> bound;
  for (const std::string side : {"above", "below"})
    if (const toml::node* node = claim.table.get(side))
      bound["bound"] = fmt::format(
          "{} {} with the whole interval, each", side,
          node->is_string() ? "{" + claim.text(side) + "}" : short_number(claim.number(side, 0)));
  return filled(claim.text("statistic"), bound);
}

/// A mean that the claim names: "S_3", or the paired differences "D_3 - S_3"; or a table with a name, bounds and, where
/// it has them, a measure and what is subtracted of its own.
Mean read_mean(const Fields& claim, const toml::node& node) {
  const bool own = node.is_table();
  const Fields fields{own ? *node.as_table() : claim.table, claim.values, claim.used};
  if (own) only_keys(fields.table, {"of", "name", "above", "below", "measure", "minus", "factor"});
  const auto with = [&](const std::string& key) { return own && fields.has(key) ? fields : claim; };
  const std::string measure = with("measure").text("measure"), text = own ? fields.text("of") : claim.plain(node),
                    place = claim.has("at") ? " at " + claim.text("at") : "";
  const bool has_minus = with("minus").has("minus"), has_factor = with("factor").has("factor");
  const std::size_t minus = text.find(" - ");
  const std::string first = text.substr(0, minus);
  Mean mean{text, {measure, first + place}};
  if (minus != std::string::npos) {
    if (has_minus) throw FileError(place_of(node), "either a difference or the key 'minus'");
    mean.minus = {measure, text.substr(minus + 3) + place};
  } else if (has_minus) {
    mean.minus = {with("minus").text("minus"), mean.of.subject};
  }
  if (has_factor) {
    if (!mean.minus) throw FileError(place_of(node), "'factor' goes with what is subtracted");
    mean.factor = with("factor").number("factor", 1);
    if (minus != std::string::npos)
      mean.name = first + " - " + short_number(mean.factor) + " " + text.substr(minus + 3);
  }
  if (own && fields.has("name")) mean.name = fields.text("name");
  mean.lower = fields.bound("above", -INFINITY);
  mean.upper = fields.bound("below", INFINITY);
  return mean;
}

Relation relation_of_means(const Fields& claim) {
  std::vector<Mean> means;
  for (const toml::node& node : list_of(claim.table, "of")) means.push_back(read_mean(claim, node));
  const Bound none_above = INFINITY, none_below = -INFINITY;
  if (std::ranges::all_of(means, [&](const Mean& m) { return m.lower == none_below && m.upper == none_above; }))
    throw FileError(place_of(claim.table), "expected 'above' or 'below' for one of the means");
  return whole_intervals(statistic_of(claim), means);
}

Relation relation_of_facts(const Fields& claim) { return all_facts(claim.text("statistic"), claim.text("facts")); }

Levels levels_of(const Fields& claim) {
  const Levels levels{static_cast<int>(claim.number("from", loudest)), static_cast<int>(claim.number("to", quietest))};
  if (levels.from < loudest || levels.to < levels.from || levels.to > quietest)
    throw FileError(place_of(claim.table), fmt::format("need {} <= from <= to <= {}", loudest, quietest));
  return levels;
}

/// By the key `where`, one of these words; without it at each level.
At where_of(const Fields& claim, const std::map<std::string, At>& words) {
  if (!claim.has("where")) return At::each_level;
  const auto found = words.find(claim.text("where"));
  if (found != words.end()) return found->second;
  std::string expected;
  for (const auto& [word, at] : words) expected += (expected.empty() ? "'" : " or '") + word + "'";
  throw FileError(place_of(*claim.table.get("where")), "expected " + expected);
}

Relation relation_of_smaller_error(const Fields& claim) {
  return smaller_error(claim.pairs("smaller-error"), levels_of(claim),
                       where_of(claim, {{"some level", At::some_level}, {"mean", At::mean_over_levels}}));
}

Relation relation_of_equal_error(const Fields& claim) {
  const double factor = claim.number("within", 0);
  if (!(factor > 1)) throw FileError(place_of(claim.table), "expected the key 'within' with a factor > 1");
  return nearly_equal_error(claim.pairs("equal-error"), factor, levels_of(claim),
                            where_of(claim, {{"mean", At::mean_over_levels}}));
}

/// What decides a claim: the key that says so, the keys that go with it.
struct Kind {
  std::string key;
  Keys keys;
  Relation (*relation)(const Fields&);
};

/// `others` are keys that may stand in the same table.
Reading read_reading(const Fields& fields, const Keys& others) {
  static const std::vector<Kind> kinds{
      {"of", {"measure", "minus", "factor", "at", "above", "below", "statistic"}, relation_of_means},
      {"facts", {"statistic"}, relation_of_facts},
      {"smaller-error", {"from", "to", "where"}, relation_of_smaller_error},
      {"equal-error", {"within", "from", "to", "where"}, relation_of_equal_error}};
  const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return fields.has(k.key); });
  if (kind == kinds.end())
    throw FileError(place_of(fields.table), "expected one of the keys 'of', 'facts', 'smaller-error', 'equal-error'");
  Keys known(others);
  known.insert(known.end(), {"read-as", "late", "weaker", kind->key});
  known.insert(known.end(), kind->keys.begin(), kind->keys.end());
  only_keys(fields.table, known);
  return {fields.has("read-as") ? fields.text("read-as") : "", kind->relation(fields),
          flag(fields.table, "late", false), flag(fields.table, "weaker", false)};
}

/// Whether the data are ours, by the key `data` of an experiment or of a claim.
bool is_on_our_data(const toml::table& table, bool otherwise) {
  const toml::node* node = table.get("data");
  if (!node) return otherwise;
  const std::string text = text_of(*node);
  if (text != "ours" && text != "any") throw FileError(place_of(*node), "expected 'ours' or 'any'");
  return text == "ours";
}

/// The names of the key `over`, all of them choices of the experiment; without this key all choices.
Names choices_of(const Fields& claim, const Experiment& experiment) {
  Names all, result;
  for (const Choice& choice : experiment.choices) all.push_back(choice.name);
  if (!claim.has("over")) return all;
  for (const toml::node& node : list_of(claim.table, "over")) {
    result.push_back(claim.plain(node));
    if (std::ranges::find(all, result.back()) == all.end())
      throw FileError(place_of(node), "the experiment has no choice of this name");
  }
  return result;
}

Claim read_claim(const Fields& fields, const Experiment& experiment, bool on_our_data) {
  const Keys own{"sentence", "place", "recorded", "data", "over", "counted-in"};
  Claim claim{fields.text("sentence"), fields.text("place"), {}};
  if ((claim.sentence + claim.place).find('{') != std::string::npos)
    throw FileError(place_of(fields.table), "a {name} in 'sentence' or 'place' without a value");
  if (fields.has("reading")) {
    Keys known(own);
    known.push_back("reading");
    only_keys(fields.table, known);
    for (const toml::table* reading : tables_of(fields.table, "reading"))
      claim.readings.push_back(read_reading({*reading, fields.values, fields.used}, {}));
    if (claim.readings.empty()) throw FileError(place_of(fields.table), "expected a reading");
  } else {
    claim.readings.push_back(read_reading(fields, own));
  }
  claim.over = choices_of(fields, experiment);
  claim.on_our_data = is_on_our_data(fields.table, on_our_data);
  if (fields.has("counted-in")) claim.counted_in = fields.text("counted-in");
  if (const toml::node* node = fields.table.get("recorded"))
    claim.recorded = verdict_of<ClaimVerdict>(*node, fields.plain(*node));
  else if (claim.on_our_data)
    claim.recorded = ClaimVerdict::own_data;
  return claim;
}

/// The claim, or for {use, with} the shared claims of this name with these values in their texts.
std::vector<Claim> read_claims(const toml::table& table, const std::map<std::string, const toml::table*>& shared,
                               const Experiment& experiment, bool on_our_data) {
  std::set<std::string> used;
  if (!table.contains("use")) return {read_claim({table, {}, used}, experiment, on_our_data)};
  only_keys(table, {"use", "with"});
  const auto found = shared.find(needed_text(table, "use"));
  if (found == shared.end()) throw FileError(place_of(*table.get("use")), "no [[shared]] claims of this name");
  const Texts values = texts_in(table, "with");
  std::vector<Claim> result;
  for (const toml::table* claim : tables_of(*found->second, "claim"))
    result.push_back(read_claim({*claim, values, used}, experiment, on_our_data));
  for (const auto& [name, value] : values)
    if (!used.contains(name)) throw FileError(place_of(table), "the shared claims have no {" + name + "}");
  return result;
}

/// The [[choice]]s of a file by their names.
std::map<std::string, Choice> read_choices(const toml::table& file) {
  std::map<std::string, Choice> result;
  for (const toml::table* table : tables_of(file, "choice")) {
    only_keys(*table, {"name", "open", "taken", "others"});
    Choice choice{needed_text(*table, "name"), needed_text(*table, "open"), needed_text(*table, "taken"), {}};
    for (const toml::node& other : list_of(*table, "others")) choice.others.push_back(text_of(other));
    if (!result.emplace(choice.name, choice).second)
      throw FileError(place_of(*table), "the choice '" + choice.name + "' is there twice");
  }
  return result;
}

/// Those that the experiment names.
std::vector<Choice> named_choices(const toml::table& table, const std::map<std::string, Choice>& all) {
  std::vector<Choice> result;
  if (!table.contains("choices")) return result;
  for (const toml::node& node : list_of(table, "choices")) {
    const auto found = all.find(text_of(node));
    if (found == all.end()) throw FileError(place_of(node), "no [[choice]] of this name");
    result.push_back(found->second);
  }
  return result;
}

/// With the texts of [text] put in for <<id>>.
std::vector<std::string> read_setup(const toml::table& table, const Texts& texts) {
  std::vector<std::string> result;
  for (const toml::node& node : list_of(table, "setup")) {
    std::string paragraph = text_of(node);
    for (std::size_t open; (open = paragraph.find("<<")) != std::string::npos;) {
      const std::size_t close = std::min(paragraph.find(">>", open), paragraph.size());
      const auto text = texts.find(paragraph.substr(open + 2, close - open - 2));
      if (text == texts.end()) throw FileError(place_of(node), "a '<<' names no text of [text]");
      paragraph.replace(open, close + 2 - open, text->second);
    }
    result.push_back(paragraph);
  }
  return result;
}

}  // namespace

std::vector<Experiment> read_experiments(const std::string& paper, std::string_view text, const Measures& measures) {
  const toml::table file = parse_toml(text);
  only_keys(file, {"text", "choice", "shared", "experiment"});
  const Texts texts = texts_in(file, "text");
  std::map<std::string, const toml::table*> shared;
  for (const toml::table* table : tables_of(file, "shared")) {
    only_keys(*table, {"name", "claim"});
    shared[needed_text(*table, "name")] = table;
  }
  const std::map<std::string, Choice> choices = read_choices(file);
  ById<Measure> open(paper, "measure", "experiment", measures);
  std::vector<Experiment> result;
  for (const toml::table* table : tables_of(file, "experiment")) {
    only_keys(*table, {"id", "title", "setup", "choices", "data", "random", "printed", "times", "claim"});
    const std::string id = needed_text(*table, "id");
    Experiment experiment{id,
                          paper,
                          needed_text(*table, "title"),
                          read_setup(*table, texts),
                          named_choices(*table, choices),
                          {},
                          optional_text(*table, "printed"),
                          flag(*table, "random", true),
                          open.taken(*table, id),
                          times_of(*table)};
    for (const toml::table* claim : tables_of(*table, "claim"))
      for (Claim& one : read_claims(*claim, shared, experiment, is_on_our_data(*table, false)))
        experiment.claims.push_back(std::move(one));
    result.push_back(std::move(experiment));
  }
  open.require_all_taken();
  return result;
}

}  // namespace subcert::experiments
