// subcert levels SCHEME --over w=LOW..HIGH [--over ...] --property PROPERTY [--certificate DIR] [--plot FILE]

#include "level_values.hpp"
#include "levels_of_list.hpp"

#include <subcert/analysis/family/limit_of_levels.hpp>
#include <subcert/analysis/family/local_levels.hpp>
#include <subcert/analysis/family/property_of_levels.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/cli/pages/plot.hpp>
#include <subcert/cli/paper_form.hpp>
#include <subcert/cli/parameter_range.hpp>
#include <subcert/cli/width.hpp>
#include <subcert/proofs-checks/certificates/certificate.hpp>
#include <subcert/reports/facts/exponents.hpp>
#include <subcert/reports/facts/screen_lines.hpp>
#include <subcert/schemes/parametric_specification.hpp>
#include <subcert/schemes/plain_text.hpp>

#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

namespace subcert::cli {
namespace {

/// A family of one letter, or of several.
struct LetteredScheme {
  std::string specification;
  std::vector<std::string> names;  ///< of the letters, as they are written
  std::optional<char> letter;      ///< of one, as in certificates
  ParametricMask mask;
};

LetteredScheme make_lettered_scheme(const std::string& text, const std::vector<std::string>& over) {
  if (over.size() == 1) {
    ParametricScheme scheme = make_parametric_scheme(text);
    return {scheme.specification, {scheme.name}, scheme.letter, std::move(scheme.mask)};
  }
  const std::vector<std::string> names = read_names(over);
  const auto [specification, letters] = in_letters(text, names);
  return {text, names, std::nullopt, make_parametric_mask(specification, letters)};
}

struct LevelsCommandOptions : SearchOptions {
  std::string scheme;
  std::vector<std::string> over;
  std::string property;
  std::string certificate;
  std::string plot;
  std::string recurrence;
  std::string start;
  int boxes = 0;
  bool each_point = false;
  PaperForm form;
};

/// Errors: throws a usage error where options do not fit, a domain error for a first value that has no mask.
std::optional<FollowedLevels> follow(const LevelsCommandOptions& options, const LetteredScheme& scheme, const Box& box,
                                     const Budget& budget) {
  if (options.recurrence.empty() != options.start.empty())
    fail(ErrorKind::usage, "--recurrence and --start: expected both or none");
  if (options.recurrence.empty()) return std::nullopt;
  if (!scheme.letter) fail(ErrorKind::usage, "--recurrence: expected one range, got {}", box.letters());
  const std::string& name = scheme.names[0];
  const FirstValues start = read_start(options.start, name);
  const auto& [low, high] = start.values;
  const Recurrence recurrence = read_recurrence(options.recurrence, name, *scheme.letter);
  if (!start.unbounded && low == high && scheme.mask.denominator()(low) == 0)
    fail(ErrorKind::domain, "--start: expected a value that has a mask, got {} = {}", name, number_text(low));
  return subcert::follow(scheme.mask, recurrence, start, {box.low[0], box.high[0]}, budget);
}

/// `w = 1/16`, `v = 0 and w = 1`.
std::string values_text(const Values& values, const LetteredScheme& scheme) {
  std::vector<std::string> parts;
  for (std::size_t v = 0; v < values.size(); ++v)
    parts.push_back(fmt::format("{} = {}", scheme.names[v], number_text(values[v])));
  return fmt::format("{}", fmt::join(parts, " and "));
}

/// `w from 1/1000 to 19/100`
std::string box_text(const Box& box, const LetteredScheme& scheme) {
  std::vector<std::string> parts;
  for (std::size_t v = 0; v < box.letters(); ++v)
    parts.push_back(
        fmt::format("{} from {} to {}", scheme.names[v], number_text(box.low[v]), number_text(box.high[v])));
  return fmt::format("{}", fmt::join(parts, " and "));
}

/// A number of one letter, a list of several.
Json values_json(const Values& values) {
  if (values.size() == 1) return to_text(values[0]);
  Json list = Json::array();
  for (const Rational& value : values) list.push_back(to_text(value));
  return list;
}

/// What was asked, and what is known.
struct LevelsAnswer {
  std::string property;
  LetteredScheme scheme;
  Box box;
  std::optional<FollowedLevels> followed;
  RangeProperty asked = {};
  PropertyOfLevels levels = {};
  std::vector<ExponentOfLevels> growing = {};

  std::string values() const { return box_text(box, scheme); }
  /// What fails for some sequence may hold for those of a recurrence.
  Truth truth() const { return followed ? followed->have(asked, levels.holds) : levels.holds; }
};

/// `C1 for every sequence of w from 1/1000 to 19/100, one for each level`
std::string answer_text(const LevelsAnswer& found) {
  const auto& [property, scheme, box, followed, asked, levels, growing] = found;
  if (followed && found.truth() == Truth::yes) {
    const auto& [values, unbounded] = followed->start;
    const bool one = !unbounded && values.lower == values.upper;
    const std::string first = scheme.names[0] + "0", low = number_text(values.lower);
    return fmt::format("{} for {} = {} from level to level, {}", property, scheme.names[0], followed->recurrence.text(),
                       one         ? fmt::format("{} = {}", first, low)
                       : unbounded ? fmt::format("for all {} from {} on", first, low)
                                   : fmt::format("for all {} from {} to {}", first, low, number_text(values.upper))) +
           (followed->masks_exist ? ""
            : one                 ? ", if there is a mask at each level"
                                  : " that have a mask at each level");
  }
  if (followed && levels.holds == Truth::no)
    return fmt::format("not decided: {} does not hold for every sequence in the range", property);
  const std::string all = fmt::format("every sequence of {}, one value for each level", found.values());
  if (levels.holds == Truth::yes) return fmt::format("{} for {}", property, all);
  if (levels.holds == Truth::unknown) return fmt::format("not decided for {}", all);
  const std::string last = levels.period.size() == 1
                               ? values_text(levels.period[0], scheme) + " at all levels"
                               : fmt::format("{} and {} in turn", values_text(levels.period[0], scheme),
                                             values_text(levels.period[1], scheme));
  return fmt::format("not {} for every sequence: not for {}", property, last);
}

/// What the masks at late levels tell of all limits.
std::string limit_text(const LimitOfLevels& limit, const std::string& name) {
  std::string text = fmt::format("limit        {} tends to {} for all of them\n", name, number_text(limit.value));
  if (!limit.rules.exponentials.empty())
    text += fmt::format("generates    {}, where {} is cos(t h) at the level with distances h\n", to_text(limit.rules),
                        name);
  const ExponentOfList& found = limit.exponent;
  const Enclosure& exponent = found.exponent;
  text += "exponent     ";
  if (!exponent.lower) return text + "not bounded: the mask in the limit was not proved to converge\n";
  if (found.exact.is_yes()) return text + enclosure_text(exponent, 12) + "  (exact)\n" + formula_line(found);
  text += "at least " + exponent.lower_text(12);
  if (exponent.upper) text += fmt::format(", at most {}", exponent.upper_text(12));
  return text + "\n";
}

Json limit_json(const LimitOfLevels& limit) {
  Json json{{"value", to_text(limit.value)},
            {"sum_rules", limit.rules.sum_rules},
            {"exponentials", limit.rules.exponentials}};
  json.update(exponent_json(limit.exponent));
  json["stable"] = limit.exponent.stable.is_yes();
  return json;
}

Json json_of(const LevelsAnswer& found) {
  const auto& [property, scheme, box, followed, asked, levels, growing] = found;
  Json period = Json::array(), boxes = Json::array();
  for (const Values& values : levels.period) period.push_back(values_json(values));
  for (const ExponentOfLevels& one : growing)
    boxes.push_back({{"from", values_json(one.box.low)},
                     {"to", values_json(one.box.high)},
                     {"holder", enclosure_json(positive_part(one.exponent))}});
  Json recurrence;
  const std::optional<int> first_level = followed ? followed->first_level() : std::nullopt;
  if (followed)
    recurrence = {{"step", followed->recurrence.text()},
                  {"from", to_text(followed->start.values.lower)},
                  {"to", followed->start.unbounded ? Json() : Json(to_text(followed->start.values.upper))},
                  {"masks_exist", followed->masks_exist},
                  {"first_level", first_level ? Json(*first_level) : Json()},
                  {"limit", followed->limit ? limit_json(*followed->limit) : Json()}};
  return {{"family", scheme.specification},
          {"recurrence", recurrence},
          {"property", property},
          {"sum_rules", levels.sum_rules},
          {"summary", answer_text(found)},
          {"pieces", Json::array({{{"from", values_json(box.low)},
                                   {"to", values_json(box.high)},
                                   {"verdict", verdict_text(levels.holds)},
                                   {"reason", levels.reason}}})},
          {"period", period},
          {"growing", boxes}};
}

std::string text_of(const LevelsAnswer& found) {
  const auto& [property, scheme, box, followed, asked, levels, growing] = found;
  std::string text = fmt::format("scheme       {}\nanswer       {}\nproperty     {}\nsum rules    {} for all {}\n",
                                 scheme.specification, answer_text(found), property, levels.sum_rules,
                                 fmt::join(scheme.names, " and "));
  if (followed)
    text += followed->way
                ? fmt::format("levels       {} is from {} to {} from {} on\n", scheme.names[0], number_text(box.low[0]),
                              number_text(box.high[0]),
                              followed->start.unbounded ? std::string("some level")
                                                        : fmt::format("level {}", *followed->first_level()))
                : fmt::format("levels       {} = {} was not proved to lead into the range and to stay in it\n",
                              scheme.names[0], followed->recurrence.text());
  if (followed && followed->limit) text += limit_text(*followed->limit, scheme.names[0]);
  if (found.truth() == Truth::unknown && !levels.reason.empty()) text += "open         " + levels.reason + "\n";
  for (const ExponentOfLevels& one : growing) {
    const Enclosure exponent = positive_part(one.exponent);
    text += fmt::format("exponent     {}: {}\n", box_text(one.box, scheme),
                        exponent.lower ? "at least " + exponent.lower_text(8) + " for all sequences" : "not bounded");
    if (exponent.upper)
      text.insert(text.size() - 1, fmt::format(", at most {} for all of them", exponent.upper_text(8)));
  }
  return facts::wrapped(text, 13);
}

/// `1/20 <= w <= 1/10`, as formulas are written.
std::string inequalities_text(const Box& box, const LetteredScheme& scheme) {
  std::vector<std::string> parts;
  for (std::size_t v = 0; v < box.letters(); ++v)
    parts.push_back(fmt::format("{} <= {} <= {}", number_text(box.low[v]), scheme.names[v], number_text(box.high[v])));
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// The exponents, or else the answer.
formats::TableRows rows_of(const LevelsAnswer& found) {
  const auto& [property, scheme, box, followed, asked, levels, growing] = found;
  if (growing.empty())
    return {{"values", "property", "for all sequences"},
            {inequalities_text(box, scheme), property, verdict_text(levels.holds)}};
  formats::TableRows rows{{"values", "at least", "at most"}};
  for (const ExponentOfLevels& one : growing) {
    const Enclosure exponent = positive_part(one.exponent);
    rows.push_back({inequalities_text(one.box, scheme), exponent.lower ? exponent.lower_text(8) : "-",
                    exponent.upper ? exponent.upper_text(8) : "-"});
  }
  return rows;
}

/// Over the width of the boxes, as a share of the last one.
void draw(const std::vector<ExponentOfLevels>& growing, const LetteredScheme& scheme, const std::string& file) {
  formats::Panel panel{scheme.specification, "width of the values, as a share", "Hoelder exponent", {}};
  formats::Curve lower{"all sequences have at least", {}, false, true, "#0b559f"},
      upper{"one of them has at most", {}, false, true, "#c0392b"};
  const Box& last = growing.back().box;
  for (const ExponentOfLevels& one : growing) {
    const Enclosure exponent = positive_part(one.exponent);
    const double share = Rational(one.box.width() / last.width()).convert_to<double>();
    if (exponent.lower) lower.points.emplace_back(share, exponent.lower->convert_to<double>());
    if (exponent.upper) upper.points.emplace_back(share, exponent.upper->convert_to<double>());
  }
  for (formats::Curve* curve : {&lower, &upper})
    if (!curve->points.empty()) panel.curves.push_back(std::move(*curve));
  if (panel.curves.empty())
    fail(ErrorKind::domain, "--plot {}: there is no exponent to draw, as no box is proved to converge", file);
  formats::draw_file({"levels", scheme.specification, "", 1, {panel}}, file);
}

/// Errors: throws a usage error for an option that is given.
void refuse_with(const char* what, const std::vector<std::pair<const char*, bool>>& options) {
  for (const auto& [name, is_given] : options)
    if (is_given) fail(ErrorKind::usage, "{}: cannot be asked for with {}", name, what);
}

/// The certificates that there are, if they are asked for.
WrittenCertificates write(const LevelsCommandOptions& options,
                          const std::function<std::vector<NamedCertificate>()>& make, Json& json) {
  if (options.certificate.empty()) return {};
  return write_certificates(options.certificate, make(), {"-proved", "-limit"}, "what is not proved", json);
}

void add(std::vector<NamedCertificate>& certificates, const char* name, std::optional<Certificate> certificate) {
  if (certificate) certificates.push_back({name, std::move(*certificate)});
}

/// Of all levels, and of the exponent in the limit of a recurrence.
std::vector<NamedCertificate> certificates_of(const LevelsAnswer& found, const Budget& budget) {
  const LetteredScheme& scheme = found.scheme;
  const FollowedLevels* followed = found.followed ? &*found.followed : nullptr;
  std::vector<NamedCertificate> result;
  add(result, "01-proved",
      levels_certificate(scheme.mask, *scheme.letter, found.asked, found.box, found.levels, followed));
  if (followed) add(result, "02-limit", limit_certificate(scheme.mask, *scheme.letter, found.box, *followed, budget));
  return result;
}

/// One value for each new point of each level.
ExitCode run_each_point(const LevelsCommandOptions& options, const LetteredScheme& scheme, const Box& box,
                        const RangeProperty& property) {
  refuse_with("--each-point", {{"--recurrence", !options.recurrence.empty()},
                               {"--start", !options.start.empty()},
                               {"--plot", !options.plot.empty()},
                               {"--boxes", options.boxes > 0},
                               {"--latex or --markdown", options.form.asked_for()}});
  const Budget budget = options.limits();
  options.progress("values");
  const LocalLevels found = local_levels(scheme.mask, box, budget);
  options.end_progress();
  const Truth answer = holds(found.exponent, property);
  const std::string values = box_text(box, scheme),
                    summary = fmt::format("{} for any choice of {}, one value for each new point of each level",
                                          answer == Truth::yes  ? options.property
                                          : answer == Truth::no ? "not " + options.property
                                                                : options.property + " is not decided",
                                          values);
  std::string exponent = found.exponent.lower ? fmt::format("at least {} for all choices", found.exponent.lower_text(8))
                                              : "no convergence is proved for all choices";
  if (found.exponent.upper)
    exponent += fmt::format(", at most {} for one value everywhere", found.exponent.upper_text(8));
  Json json{{"family", scheme.specification},
            {"property", options.property},
            {"summary", summary},
            {"order", found.order},
            {"matrices", found.family.count()},
            {"verdict", verdict_text(answer)},
            {"holder", enclosure_json(positive_part(found.exponent))}};
  const auto certificates = [&] {
    std::vector<NamedCertificate> result;
    add(result, "01-proved", each_point_certificate(scheme.mask, *scheme.letter, box, found));
    return result;
  };
  const WrittenCertificates written = write(options, certificates, json);
  options.answer(json,
                 facts::wrapped(fmt::format("scheme       {}\nanswer       {}\nproperty     {}\nrules        each "
                                            "keeps polynomials of degree {}\nexponent     {}\n",
                                            scheme.specification, summary, options.property, found.order - 1, exponent),
                                13) +
                     written.text);
  written.failure.raise();
  return exit_code(answer, !budget.deadline.expired());
}

ExitCode run(const LevelsCommandOptions& options) {
  require_one_form(options, options.form);
  require_picture_name(options.plot);
  if (options.scheme.starts_with(lists)) {
    refuse_with("a list of masks", {{"--over", !options.over.empty()},
                                    {"--each-point", options.each_point},
                                    {"--recurrence", !options.recurrence.empty()},
                                    {"--start", !options.start.empty()},
                                    {"--plot", !options.plot.empty()},
                                    {"--boxes", options.boxes > 0},
                                    {"--latex or --markdown", options.form.asked_for()}});
    return run_levels_of_list(options, options.scheme.substr(std::string_view(lists).size()), options.property,
                              options.certificate);
  }
  if (options.scheme.ends_with(".toml"))
    fail(ErrorKind::usage, "'{}'; a file with a list of masks is {}{}", options.scheme, lists, options.scheme);
  for (const auto& [name, is_given] :
       {std::pair{"--over", !options.over.empty()}, {"--property", !options.property.empty()}})
    if (!is_given) fail(ErrorKind::usage, "{} is required with a family that has a parameter", name);
  LetteredScheme lettered = make_lettered_scheme(options.scheme, options.over);
  const RangeProperty property = read_levels_property(options.property, lettered.mask.components() > 1);
  LevelsAnswer found{options.property, std::move(lettered), {}, {}, property};
  const LetteredScheme& scheme = found.scheme;
  found.box = read_box(options.over, scheme.names);
  if (!options.certificate.empty() && !scheme.letter)
    fail(ErrorKind::usage, "--certificate: expected one range, got {}; certificates know one letter",
         found.box.letters());
  if (!options.certificate.empty()) require_folder(options.certificate);
  if (options.each_point) return run_each_point(options, scheme, found.box, property);
  options.progress("values");
  const Budget budget = options.limits();
  const bool growing = options.boxes > 0 || !options.plot.empty();
  found.followed = follow(options, scheme, found.box, {budget.deadline.after(0.4), budget.memory});
  found.levels = property_of_levels(scheme.mask, property, found.box,
                                    growing ? Budget{budget.deadline.after(0.5), budget.memory} : budget);
  if (growing)
    found.growing = exponents_of_levels(scheme.mask, found.box, found.box.middle(),
                                        {options.boxes > 0 ? options.boxes : 24, options.threads(), budget});
  options.end_progress();
  Json json = json_of(found);
  const WrittenCertificates written = write(
      options, [&] { return certificates_of(found, budget); }, json);
  if (!options.plot.empty()) draw(found.growing, scheme, options.plot);
  if (options.form.asked_for())
    answer(options, options.form, TableAnswer{"% " + scheme.specification + "\n", rows_of(found), {0}});
  else
    options.answer(json, text_of(found) + written.text);
  written.failure.raise();
  return exit_code(found.truth(), !budget.deadline.expired());
}

}  // namespace

void add_levels(Command& app) {
  auto options = std::make_shared<LevelsCommandOptions>();
  Command command = add_command(
      app, "levels", "Whether a property holds for every sequence of parameters, one for each level, with proof",
      "subcert levels four-point:w --over w=1/1000..19/100 --property C1 --certificate proofs", options,
      [=] { return run(*options); });
  command
      .option("SCHEME", options->scheme,
              "mask:[...] with letters in its coefficients, four-point:w, hermite:[[[...]]]; or lists:FILE")
      .required()
      .suggest(suggested_schemes);
  command.option("--over", options->over, "The values, for each letter: w=LOW..HIGH").one_each();
  command.option("--property", options->property, "convergent, C1, C2, ..., holder>=3/2 or, of Hermite schemes, HC1");
  command.option("--recurrence", options->recurrence,
                 "How each level has its value from the one before: v=sqrt((1+v)/2)");
  command.option("--start", options->start,
                 "With it, the first value or all of them: v0=1/2, v0=-1..1000 or v0=-1..inf");
  command.flag("--each-point", options->each_point,
               "A value for each new point of each level, in place of one for each level");
  command.option("--boxes", options->boxes, "Exponents over so many ranges, which grow from the middle to the whole")
      .within(1, 1000);
  command.option("--certificate", options->certificate, "Write the certificate into this folder");
  command.option("--plot", options->plot, "Draw these exponents, as .svg, .png, .pdf, .tex or .html");
  add_limits(command, *options);
  add_paper_form(command, options->form, "The exponents as a table in LaTeX", "The same in Markdown");
}

}  // namespace subcert::cli
