#include "computed_quantities.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/variance/variance.hpp>
#include <subcert/schemes/specification.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace subcert::reports {
namespace {

constexpr int variance_level = 9;  // dyadic level of the exact grid with the witnesses of Table 3

}  // namespace

std::string decimal(const Rational& value, int places) { return to_fixed(value, places, Rounding::nearest); }

VarianceFacts variance_facts(const std::string& specification) {
  const Mask mask = make_scheme(specification).mask.curve();
  const VarianceGrid grid = variance_grid(mask, variance_level, proved_smoothness(mask).order >= 1);
  VarianceFacts facts;
  for (std::size_t i = 0; i < grid.values.size(); ++i)
    if (i == 0 || grid.values[i] > facts.largest) {
      facts.largest = grid.values[i];
      facts.largest_at = Rational(i) * grid.step();
    }
  for (int level = 0; level <= variance_level; ++level) {
    const std::size_t stride = std::size_t{1} << (variance_level - level);
    for (std::size_t i = stride; i < grid.values.size(); i += stride) {
      const Rational slope = abs(grid.values[i] - grid.values[i - stride]) * power(Rational(2), level);
      if (slope > facts.steepest) {
        facts.steepest = slope;
        facts.steepest_at = "by the values at " + to_text(Rational(i - stride) * grid.step()) + " and " +
                            to_text(Rational(i) * grid.step());
      }
    }
  }
  for (std::size_t i = 0; i < grid.slopes.size(); ++i)
    if (abs(grid.slopes[i]) > facts.steepest) {
      facts.steepest = abs(grid.slopes[i]);
      facts.steepest_at = "by the derivative at x = " + to_text(Rational(i) * grid.step());
    }
  const VarianceRange range = variance_range(mask);
  facts.maximum = {std::max(*range.maximum.lower, facts.largest), range.maximum.upper};
  facts.minimum = range.minimum;
  facts.slope = Enclosure::at_least(facts.steepest);
  if (range.slope) facts.slope = {std::max(*range.slope->lower, facts.steepest), range.slope->upper};
  return facts;
}

ComputedQuantities::ComputedQuantities(const ReportOptions& options)
    : options_(options), paper_(statements::paper("dyn-2015")) {}

void ComputedQuantities::need_bounds(const std::vector<std::string>& specifications) {
  make_missing(bounds_, specifications, options_,
               [](const auto& s) { return holder_bounds(make_scheme(s).mask.curve(), holder_levels); });
}

void ComputedQuantities::need_exponents(const std::vector<std::string>& specifications, double seconds) {
  make_missing(exponents_, specifications, options_, [seconds](const auto& s) {
    const Scheme scheme = make_scheme(s);
    return holder_regularity(scheme.mask.curve(), holder_levels, {Deadline::in(seconds)}, HolderProof::certificate,
                             scheme.rounding);
  });
}

void ComputedQuantities::need_variance(const std::vector<std::string>& specifications) {
  make_missing(variance_, specifications, options_, variance_facts);
}

const statements::dyn_2015::NumericalRecipeSearch& ComputedQuantities::recipes() {
  if (recipes_) return *recipes_;
  say("recipes");
  const statements::PublishedTable& table = published("table3");
  statements::dyn_2015::NumericalRecipeSearch::Values values;
  std::map<std::string, int> sizes;
  for (const statements::PublishedCell& cell : table.cells) sizes[cell.scheme] = cell.n.value();
  make_missing(values, schemes_of(table), options_, [&](const std::string& scheme) {
    return statements::dyn_2015::evaluate_numerical_recipes(make_scheme(scheme).mask.curve(), sizes.at(scheme));
  });
  return recipes_.emplace(table, std::move(values));
}

formats::ComparisonTable empty_table(const statements::PublishedTable& table, const std::string& paper) {
  return {paper, table.id, table.title, table.place, table.grid, {}};
}

std::string source_text(const statements::PublishedCell& cell) {
  return cell.source.empty() ? "" : fmt::format("[{}] {}", cell.source, statements::reference(cell.source));
}

ValueVerdict recorded_verdict(const statements::PublishedCell& cell, ValueVerdict found) {
  const bool decided = !cell.source.empty() && cell.recorded == ValueVerdict::open && found == ValueVerdict::match;
  return decided ? found : cell.recorded;
}

std::string command_of(const statements::PublishedCell& cell) {
  const auto about = [&](std::string_view part) { return cell.quantity.find(part) != std::string::npos; };
  const std::string command = cell.quantity == "mask"                                                 ? "mask"
                              : cell.quantity == "support"                                            ? "analyze"
                              : about("psi")                                                          ? "variance"
                              : about("exponent") || about("bound after") || cell.quantity == "class" ? "regularity"
                                                                                                      : "";
  return command.empty() ? "" : fmt::format("subcert {} '{}'", command, cell.scheme);
}

formats::Comparison compare_number(const statements::PublishedCell& cell, const Enclosure& computed,
                                   const std::string& note) {
  const ValueVerdict verdict = formats::compare(cell.printed, computed);
  return {
      cell.row, cell.column,       cell.scheme, cell.printed,     computed,    verdict, recorded_verdict(cell, verdict),
      note,     source_text(cell), "",          command_of(cell), cell.derived};
}

formats::Comparison compare_smoothness(const statements::PublishedCell& cell, const std::string& specification,
                                       const MultivariateRegularity& regularity) {
  const Enclosure exponent = cell.quantity.starts_with("Sobolev") ? regularity.sobolev.value_or(Enclosure{})
                                                                  : regularity.exponent;
  const ValueVerdict verdict = formats::compare_exponent(cell.printed, exponent);
  std::string note;
  if (verdict == ValueVerdict::open)
    note = exponent.is_bounded() ? fmt::format("enclosed with a width of {}, which does not decide",
                                               to_decimal(*exponent.upper - *exponent.lower, 2, Rounding::up))
                                 : "not enclosed from both sides; stable shifts: " + regularity.stable.reason;
  else if (verdict == ValueVerdict::mismatch && regularity.radius)
    note = fmt::format("the product {} of the transition operators has the radius {}",
                       fmt::join(regularity.radius->product.word, ""),
                       formats::fixed_text(regularity.radius->product.radius, 12));
  return {cell.row,
          cell.column,
          specification,
          cell.printed,
          exponent,
          verdict,
          recorded_verdict(cell, verdict),
          note,
          source_text(cell),
          to_text(regularity.stable.truth),
          command_of(cell)};
}

formats::Comparison compare_text(const statements::PublishedCell& cell, const std::string& computed, Truth equal) {
  return {cell.row,      cell.column, cell.scheme, cell.printed, computed,         comparison_verdict(equal),
          cell.recorded, "",          "",          "",           command_of(cell), cell.derived};
}

std::vector<std::string> schemes_of(const statements::PublishedTable& table) {
  std::vector<std::string> result;
  for (const statements::PublishedCell& cell : table.cells) result.push_back(cell.scheme);
  return result;
}

std::string verdict_sentence(const formats::ComparisonTable& table) {
  const auto wrong = table.count(ValueVerdict::mismatch), open = table.count(ValueVerdict::open);
  return fmt::format("{} of {} printed values match, {} {} not, {} {} open.", table.count(ValueVerdict::match),
                     table.values(), wrong, wrong == 1 ? "does" : "do", open, open == 1 ? "is" : "are");
}

void add_published(formats::Section& section, const std::string& collection,
                   const statements::PublishedTable& published,
                   const std::function<formats::Comparison(const statements::PublishedCell&)>& compare, int jobs) {
  formats::ComparisonTable table = empty_table(published, collection);
  table.comparisons.resize(published.cells.size());
  parallel_tasks(published.cells.size(), jobs,
                 [&](std::size_t k) { table.comparisons[k] = compare(published.cells[k]); });
  section.paragraphs.push_back(verdict_sentence(table));
  section.comparisons.push_back(std::move(table));
}

Report collection_report(const std::string& collection, formats::Section section) {
  Report report{collection, statements::citation(collection), {std::move(section)}};
  report.listed = true;
  return report;
}

}  // namespace subcert::reports
