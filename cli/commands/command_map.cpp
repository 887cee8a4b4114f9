// subcert map SCHEME --over v=LOW..HIGH --over w=LOW..HIGH --property PROPERTY [--plot FILE] [--csv FILE]

#include <subcert/analysis/family/property_map.hpp>
#include <subcert/cli/command.hpp>
#include <subcert/cli/pages/plot.hpp>
#include <subcert/cli/parameter_range.hpp>
#include <subcert/schemes/data/runtime/files.hpp>
#include <subcert/schemes/parametric_specification.hpp>

#include <fmt/format.h>

#include <map>

#include <algorithm>
#include <cctype>

namespace subcert::cli {
namespace {

struct MapCommandOptions : SearchOptions {
  std::string scheme;
  std::vector<std::string> over;
  std::string property;
  std::string plot;
  std::string csv;
  int resolution = 64;
};

constexpr Truth verdicts[] = {Truth::yes, Truth::no, Truth::unknown};

const char* colour_of(Truth holds) {
  return holds == Truth::yes ? "#7fbf7b" : holds == Truth::no ? "#e0a3a0" : "#d0d0d0";
}

Json json_of(const PropertyMap& map, const MapCommandOptions& options) {
  Json cells = Json::array(), shares = Json::object();
  for (const MapCell& cell : map.cells)
    cells.push_back({{"from", {to_text(cell.box.low[0]), to_text(cell.box.low[1])}},
                     {"to", {to_text(cell.box.high[0]), to_text(cell.box.high[1])}},
                     {"verdict", verdict_text(cell.holds)},
                     {"reason", cell.reason}});
  for (const Truth holds : verdicts) shares[verdict_text(holds)] = to_text(map.share(holds));
  return {{"family", options.scheme}, {"property", options.property},
          {"over", options.over},     {"sum_rules", map.sum_rules},
          {"shares", shares},         {"cells", cells}};
}

std::string csv_of(const PropertyMap& map, const std::string& letters) {
  std::string text = fmt::format("{0}_from,{0}_to,{1}_from,{1}_to,verdict\n", letters[0], letters[1]);
  for (const MapCell& cell : map.cells) {
    const Box& r = cell.box;
    text += fmt::format("{},{},{},{},{}\n", to_text(r.low[0]), to_text(r.high[0]), to_text(r.low[1]),
                        to_text(r.high[1]), verdict_text(cell.holds));
  }
  return text;
}

void draw(const PropertyMap& map, const MapCommandOptions& options, const std::string& letters) {
  formats::Panel panel{options.property, letters.substr(0, 1), letters.substr(1, 1), {}};
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

/// The letters of the parameters, in the order of --over.
std::string read_letters(const std::vector<std::string>& over) {
  std::string letters;
  for (const std::string& range : over)
    if (range.size() > 2 && std::isalpha(static_cast<unsigned char>(range[0])) != 0 && range[1] == '=')
      letters += range[0];
  if (over.size() != 2 || letters.size() != 2 || letters[0] == letters[1])
    fail(ErrorKind::usage, "--over: expected two ranges with different letters, --over v=LOW..HIGH --over w=LOW..HIGH");
  return letters;
}

ExitCode run(const MapCommandOptions& options) {
  require_picture_name(options.plot);
  const std::string letters = read_letters(options.over);
  const ParametricMask mask = make_parametric_mask(options.scheme, letters);
  const auto [v_low, v_high] = read_over(options.over[0], letters[0]);
  const auto [w_low, w_high] = read_over(options.over[1], letters[1]);
  const auto property = parse_range_property(options.property);
  if (!property)
    fail(ErrorKind::usage, "--property: expected convergent, C1, C2, ... or holder>=3/2, got '{}'", options.property);
  options.progress("cells");
  const PropertyMap map = property_map(mask, *property, {{v_low, w_low}, {v_high, w_high}},
                                       {options.resolution, options.threads(), options.limits()});
  options.end_progress();
  if (!options.csv.empty()) runtime::write_file(options.csv, csv_of(map, letters));
  if (!options.plot.empty()) draw(map, options, letters);
  std::string text = fmt::format("scheme       {}\nproperty     {}\nsum rules    {} for all {} and {}\n",
                                 options.scheme, options.property, map.sum_rules, letters[0], letters[1]);
  // No larger share is said to be decided than is.
  for (const Truth holds : verdicts)
    text += fmt::format("{}{} % of the area, {} cells\n", padded(verdict_text(holds), 13),
                        to_decimal(map.share(holds) * 100, 4, holds == Truth::unknown ? Rounding::up : Rounding::down),
                        std::ranges::count(map.cells, holds, &MapCell::holds));
  std::map<std::string, int> reasons;
  for (const MapCell& cell : map.cells)
    if (cell.holds == Truth::unknown) ++reasons[cell.reason];
  for (const auto& [reason, cells] : reasons) text += fmt::format("             {} of them: {}\n", cells, reason);
  options.answer(json_of(map, options), text);
  return map.complete ? done : undecided;
}

}  // namespace

void add_map(Command& app) {
  auto options = std::make_shared<MapCommandOptions>();
  Command command = add_command(
      app, "map", "For which values of two parameters a property holds, with proof",
      "subcert map 'mask:[t,0,-w-3*t,0,1/2+w+2*t,1,1/2+w+2*t,0,-w-3*t,0,t]' --over w=0..1/5 --over t=-1/20..1/20 "
      "--property C1 --plot map.svg",
      options, [=] { return run(*options); });
  command.option("SCHEME", options->scheme, "mask:[...] with coefficients that are polynomials in two letters")
      .required()
      .suggest(suggested_schemes);
  command.option("--over", options->over, "The values, twice: w=LOW..HIGH, the first one from left to right")
      .required()
      .one_each();
  command.option("--property", options->property, "convergent, C1, C2, ... or holder>=3/2").required();
  command.option("--resolution", options->resolution, "Cells along each side, at most").within(1, 1024).with_default();
  command.option("--plot", options->plot, "Draw the cells, as .svg, .png or .html");
  command.option("--csv", options->csv, "Write the cells as a table");
  add_limits(command, *options);
}

}  // namespace subcert::cli
