// subcert map SCHEME --over v=LOW..HIGH --over w=LOW..HIGH [--over ...] --property PROPERTY [--plot FILE] [--csv FILE]
// subcert map FILE.toml --valence N --over a=LOW..HIGH --over b=LOW..HIGH --property C1|bounded-curvature ...

#include <subcert/analysis/family/property_map.hpp>
#include <subcert/analysis/vertex/weight_map.hpp>
#include <subcert/cli/pages/plot.hpp>
#include <subcert/cli/paper_form.hpp>
#include <subcert/cli/parameter_range.hpp>
#include <subcert/cli/vertex_arguments.hpp>
#include <subcert/proofs-checks/number_list.hpp>
#include <subcert/reports/facts/weight_facts.hpp>
#include <subcert/schemes/data/runtime/files.hpp>
#include <subcert/schemes/parametric_specification.hpp>
#include <subcert/schemes/plain_text.hpp>

#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <map>

namespace subcert::cli {
namespace {

struct MapCommandOptions : SearchOptions {
  std::string scheme;
  std::vector<std::string> over;
  std::string property;
  std::string plot;
  std::string csv;
  int resolution = 64;
  std::string valence;
  PaperForm form;
};

constexpr Truth verdicts[] = {Truth::yes, Truth::no, Truth::unknown};

const char* colour_of(Truth holds) {
  return holds == Truth::yes ? "#7fbf7b" : holds == Truth::no ? "#e0a3a0" : "#d0d0d0";
}

std::vector<std::string> texts_of(const Values& values) {
  std::vector<std::string> texts;
  for (const Rational& value : values) texts.push_back(to_text(value));
  return texts;
}

/// What the two kinds of maps have in common, and what they say beside it.
struct MapPage {
  CellMap map;
  std::string head;  ///< lines of the text
  Json facts;
};

Json json_of(const MapPage& page, const MapCommandOptions& options) {
  Json cells = Json::array(), shares = Json::object();
  for (const MapCell& cell : page.map.cells)
    cells.push_back({{"from", texts_of(cell.box.low)},
                     {"to", texts_of(cell.box.high)},
                     {"verdict", verdict_text(cell.holds)},
                     {"reason", cell.reason}});
  for (const Truth holds : verdicts) shares[verdict_text(holds)] = to_text(page.map.share(holds));
  Json result{{"family", options.scheme}, {"property", options.property}, {"over", options.over}};
  result.update(page.facts);
  result["shares"] = shares;
  result["cells"] = cells;
  return result;
}

std::string csv_of(const CellMap& map, const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& letter : names) text += fmt::format("{0}_from,{0}_to,", letter);
  text += "verdict\n";
  for (const MapCell& cell : map.cells) {
    for (std::size_t v = 0; v < names.size(); ++v)
      text += fmt::format("{},{},", to_text(cell.box.low[v]), to_text(cell.box.high[v]));
    text += fmt::format("{}\n", verdict_text(cell.holds));
  }
  return text;
}

/// No larger share is said to be decided than is.
std::string percent_text(const CellMap& map, Truth holds) {
  return to_decimal(map.share(holds) * 100, 4, holds == Truth::unknown ? Rounding::up : Rounding::down) + " %";
}

formats::TableRows rows_of(const CellMap& map) {
  formats::TableRows rows{{"verdict", "share", "cells"}};
  for (const Truth holds : verdicts)
    rows.push_back({verdict_text(holds), percent_text(map, holds),
                    std::to_string(std::ranges::count(map.cells, holds, &MapCell::holds))});
  return rows;
}

void draw(const CellMap& map, const MapCommandOptions& options, const std::vector<std::string>& names) {
  formats::Panel panel{options.property, names[0], names[1], {}};
  const auto number = [](const Rational& value) { return value.convert_to<double>(); };
  for (const Truth holds : verdicts) {
    formats::Cells cells{verdict_text(holds), colour_of(holds), {}};
    for (const MapCell& cell : map.cells) {
      const Box& r = cell.box;
      if (cell.holds == holds)
        cells.rectangles.push_back({number(r.low[0]), number(r.high[0]), number(r.low[1]), number(r.high[1])});
    }
    if (!cells.rectangles.empty()) panel.cells.push_back(std::move(cells));
  }
  panel.key = "outside top right horizontal";
  formats::draw_file({"map", options.scheme, "", 1, {panel}}, options.plot);
}

/// `v and w`
std::string listed(const std::vector<std::string>& names) {
  return fmt::format("{} and {}", fmt::join(names.begin(), names.end() - 1, ", "), names.back());
}

/// Of a scheme with letters in its mask.
MapPage map_of_family(const MapCommandOptions& options, const std::vector<std::string>& names) {
  if (!options.valence.empty())
    fail(ErrorKind::usage, "--valence: need a file with rules at vertices, FILE.toml, got {}", options.scheme);
  const auto [scheme, letters] = in_letters(options.scheme, names);
  const ParametricMask mask = make_parametric_mask(scheme, letters);
  const Box box = read_box(options.over, names);
  const auto property = parse_range_property(options.property);
  if (!property)
    fail(ErrorKind::usage, "--property: expected convergent, C1, C2, ..., HC1, ... or holder>=3/2, got '{}'",
         options.property);
  options.progress("cells");
  PropertyMap map = property_map(mask, *property, box, {options.resolution, options.threads(), options.limits()});
  const int rules = map.sum_rules;
  return {std::move(map), fmt::format("sum rules    {} for all {}\n", rules, listed(names)), {{"sum_rules", rules}}};
}

/// Of rules at vertices of one valence with letters in their weights.
MapPage map_of_weights(const MapCommandOptions& options, const std::vector<std::string>& names) {
  if (options.valence.empty()) fail(ErrorKind::usage, "--valence: expected a valence, as 5, with rules of a file");
  const std::vector<int> valences = parse_number_list("--valence", options.valence, smallest_valence, largest_valence);
  if (valences.size() != 1)
    fail(ErrorKind::usage, "--valence: expected one valence, as 5, got {}", in_quotes(options.valence));
  const WeightProperty property = facts::parse_weight_property(options.property, "--property");
  const VertexScheme scheme = read_free_rules(options.scheme, names);
  const Box box = read_box(options.over, names);
  options.progress("the regular part");
  const Budget budget = options.limits();
  const SectorRules rules = rules_with_letters(*scheme.written, valences.front());
  const RegularPart regular = regular_part(rules, budget);
  options.progress("cells");
  return {weight_map(rules, regular, property, box, {options.resolution, options.threads(), budget}),
          fmt::format("valence      {}\n", valences.front()),
          {{"valence", valences.front()}}};
}

ExitCode run(const MapCommandOptions& options) {
  require_one_form(options, options.form);
  require_picture_name(options.plot);
  const std::vector<std::string> names = read_names(options.over);
  if (!options.plot.empty() && names.size() > 2)
    fail(ErrorKind::usage, "--plot: expected two ranges, got {}; --csv and --json list the cells", names.size());
  const MapPage page = is_rules_file(options.scheme) ? map_of_weights(options, names) : map_of_family(options, names);
  const CellMap& map = page.map;
  options.end_progress();
  if (!options.csv.empty()) runtime::write_file(options.csv, csv_of(map, names));
  if (!options.plot.empty()) draw(map, options, names);
  std::string text = fmt::format("scheme       {}\nproperty     {}\n{}", options.scheme, options.property, page.head);
  for (const Truth holds : verdicts)
    text += fmt::format("{}{} of the {}, {} cells\n", padded(verdict_text(holds), 13), percent_text(map, holds),
                        names.size() == 2 ? "area" : "volume", std::ranges::count(map.cells, holds, &MapCell::holds));
  std::map<std::string, int> reasons;
  for (const MapCell& cell : map.cells)
    if (cell.holds == Truth::unknown) ++reasons[cell.reason];
  for (const auto& [reason, cells] : reasons) text += fmt::format("             {} of them: {}\n", cells, reason);
  if (options.form.asked_for())
    answer(options, options.form, TableAnswer{"% " + options.scheme + ", " + options.property + "\n", rows_of(map)});
  else
    options.answer(json_of(page, options), text);
  return map.complete ? done : undecided;
}

}  // namespace

void add_map(Command& app) {
  auto options = std::make_shared<MapCommandOptions>();
  Command command = add_command(
      app, "map", "For which values of two or three parameters a property holds, with proof",
      "subcert map merrien:lambda,mu --over lambda=-1/4..0 --over mu=-3..1 --property HC1 --plot map.svg", options,
      [=] { return run(*options); });
  command
      .option("SCHEME", options->scheme,
              "mask:[...], refinable:[...], ... with two or three letters in it, or rules at vertices, FILE.toml")
      .required()
      .suggest(suggested_schemes);
  command.option("--over", options->over, "The values, for each letter: w=LOW..HIGH, the first one from left to right")
      .required()
      .one_each();
  command
      .option("--property", options->property,
              "convergent, C1, C2, ..., HC1, ... or holder>=3/2; of a file C1, bounded-curvature")
      .required();
  command.option("--valence", options->valence, "Of a file: at vertices of this valence, as 5");
  command.option("--resolution", options->resolution, "Cells along each side, at most").within(1, 1024).with_default();
  command.option("--plot", options->plot, "Draw the cells of two parameters, as .svg, .png, .pdf, .tex or .html");
  command.option("--csv", options->csv, "Write the cells as a table");
  add_limits(command, *options);
  add_paper_form(command, options->form, "The shares as a table in LaTeX", "The same in Markdown");
}

}  // namespace subcert::cli
