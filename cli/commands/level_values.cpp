#include "level_values.hpp"

#include "parameter_range.hpp"

#include <subcert/analysis/family/limit_values_of_levels.hpp>
#include <subcert/analysis/symbol/polynomials/expression.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/schemes/data/runtime/files.hpp>
#include <subcert/schemes/plain_text.hpp>

#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

namespace subcert::cli {
namespace {

constexpr int most_levels_refined = 64;  // more make too many points of any data

LevelDependentScheme scheme_of_list(const std::string& file) {
  const properties::MaskListFile read = read_lists(file);
  if (read.list.period.empty())
    fail(ErrorKind::usage, "{}: expected period = [...], which says what mask each level takes", file);
  std::vector<std::string> names;
  LevelDependentScheme result;
  if (read.list.masks.front().components() > 1)
    result.form = read.list.hermite ? VectorForm::hermite : VectorForm::vector;
  for (const std::size_t number : read.list.period) {
    names.push_back(read.specifications[number]);
    result.masks.again.emplace_back(read.list.masks[number]);
  }
  result.specification = fmt::format("{} again and again", fmt::join(names, ", "));
  return result;
}

/// The mask of a family of numbers. Errors: throws a domain error where it has none there.
LatticeMask mask_at(const ParametricScheme& family, const Rational& value) {
  if (family.mask.denominator()(value) == 0)
    fail(ErrorKind::domain, "{}: there is no mask for {} = {}", family.specification, family.name, to_text(value));
  return family.mask.at(value);
}

/// `w=1/16,1/20`: these, and the last one at all later levels.
LevelDependentScheme scheme_of_values(const ParametricScheme& family, const std::string& written) {
  const std::string text = plain_text(written), head = family.name + "=";
  LevelDependentScheme result;
  std::vector<std::string> values;
  std::istringstream parts(text.starts_with(head) ? text.substr(head.size()) : "");
  for (std::string part; std::getline(parts, part, ',');) {
    const auto value = parse_constant(part);
    if (!value) {
      values.clear();
      break;
    }
    values.push_back(to_text(*value));
    result.masks.first.push_back(mask_at(family, *value));
  }
  if (values.empty() || text.ends_with(','))
    fail(ErrorKind::usage, "--values: expected {}VALUE,VALUE,... with exact numbers, got {}", head, in_quotes(written));
  result.masks.again.push_back(std::move(result.masks.first.back()));
  result.masks.first.pop_back();
  result.specification = fmt::format("{} with {} = {}", family.specification, family.name, fmt::join(values, ", "));
  return result;
}

FollowedFamily followed(ParametricScheme family, const LevelOptions& options) {
  const auto& [start, unbounded] = read_start(options.start, family.name);
  if (unbounded || start.lower != start.upper)
    fail(ErrorKind::usage, "--start: expected one value, {}0=VALUE, got {}", family.name, in_quotes(options.start));
  Recurrence recurrence = read_recurrence(options.recurrence, family.name, family.letter);
  std::string text = fmt::format("{0} with {1} = {2}, {1}0 = {3}", family.specification, family.name, recurrence.text(),
                                 to_text(start.lower));
  return {std::move(text), std::move(family), std::move(recurrence), start.lower};
}

}  // namespace

properties::MaskListFile read_lists(const std::string& file) {
  try {
    return properties::read_mask_list(runtime::read_file(file));
  } catch (const FileError& error) {
    fail(ErrorKind::data, "{}, {}", file, error.what());
  }
}

FirstValues read_start(const std::string& written, const std::string& name) {
  constexpr std::string_view unbounded = "..inf";
  const std::string text = plain_text(written);
  const std::string heads[] = {name + "0=", name + "="};
  for (const std::string& head : heads) {
    if (!text.starts_with(head)) continue;
    if (text.find("..") == std::string::npos)
      if (const auto value = parse_number(text.substr(head.size()))) return {{*value, *value}};
    if (text.find("..") == std::string::npos) break;
    if (text.ends_with(unbounded)) {
      const auto low = parse_number(text.substr(head.size(), text.size() - head.size() - unbounded.size()));
      if (!low) break;
      return {{*low, *low}, true};
    }
    const auto [low, high] = read_over(name + "=" + text.substr(head.size()), name);
    return {{low, high}};
  }
  fail(ErrorKind::usage, "--start: expected {0}VALUE, {0}LOW..HIGH or {0}LOW..inf, got {1}", heads[0],
       in_quotes(written));
}

Recurrence read_recurrence(const std::string& written, const std::string& name, char letter) {
  try {
    return Recurrence::parse(plain_text(written), name, letter);
  } catch (const ParseError&) {
    fail(ErrorKind::usage,
         "--recurrence: expected {0}=EXPRESSION or {0}=sqrt(EXPRESSION), as {0}=sqrt((1+{0})/2), got {1}", name,
         in_quotes(written));
  }
}

void add_level_options(Command& command, LevelOptions& options) {
  command.option("--recurrence", options.recurrence,
                 "Of a family, how each level has its parameter from the one before: v=sqrt((1+v)/2)");
  command.option("--start", options.start, "With it, the parameter of the first level: v0=1/2");
  command.option("--values", options.values,
                 "Of a family, the parameters of the levels, the last for all after it: w=1/16,1/20");
}

LevelDependentScheme FollowedFamily::levels(int count) const {
  const int known = std::clamp(count, 1, most_levels_refined);
  return {specification, masks_of_levels(family.mask, recurrence, start, static_cast<std::size_t>(known))};
}

std::optional<std::variant<LevelDependentScheme, FollowedFamily>> read_levels(const std::string& scheme,
                                                                              const LevelOptions& options) {
  const bool follows = !options.recurrence.empty() || !options.start.empty(), listed = !options.values.empty();
  if (scheme.starts_with(lists)) {
    if (follows || listed)
      fail(ErrorKind::usage, "--{}: cannot be asked for with a list of masks",
           listed                       ? "values"
           : options.recurrence.empty() ? "start"
                                        : "recurrence");
    return scheme_of_list(scheme.substr(std::string_view(lists).size()));
  }
  if (!follows && !listed) return std::nullopt;
  if (options.recurrence.empty() != options.start.empty())
    fail(ErrorKind::usage, "--recurrence and --start: expected both or none");
  if (follows && listed) fail(ErrorKind::usage, "--values: cannot be asked for with --recurrence");
  ParametricScheme family = make_parametric_scheme(scheme);
  if (family.form) fail(ErrorKind::usage, "{}: levels are of masks of numbers", scheme);
  if (listed) return scheme_of_values(family, options.values);
  return followed(std::move(family), options);
}

}  // namespace subcert::cli
