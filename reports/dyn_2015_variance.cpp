#include "sections.hpp"

#include "computed_quantities.hpp"
#include "story_sentences.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/numbers/interval.hpp>
#include <subcert/analysis/variance/variance.hpp>
#include <subcert/proofs-checks/papers/dyn-2015/checks.hpp>
#include <subcert/schemes/specification.hpp>

#include <fmt/ranges.h>

#include <algorithm>

namespace subcert::reports {

using namespace statements::dyn_2015;

namespace {

formats::ComparisonTable compare_table_3(const statements::PublishedTable& table, ComputedQuantities& quantities) {
  quantities.need_variance(schemes_of(table));
  const NumericalRecipeSearch& search = quantities.recipes();
  formats::ComparisonTable result = empty_table(table);
  for (const statements::PublishedCell& cell : table.cells) {
    const VarianceFacts& facts = quantities.variance(cell.scheme);
    const auto what = scaled_maximum(cell);
    formats::Comparison comparison = compare_number(cell,
                                                    scaled(what.slope ? facts.slope : facts.maximum, what.factor));
    if (comparison.verdict == ValueVerdict::mismatch) {
      const Rational witnessed = what.factor * (what.slope ? facts.steepest : facts.largest);
      comparison.note = formats::compare(cell.printed, Enclosure::at_least(witnessed)) != ValueVerdict::mismatch
                            ? "not reached anywhere on [0, 1]"
                        : what.slope ? "exceeded " + facts.steepest_at
                                     : "exceeded at x = " + to_text(facts.largest_at);
      comparison.note += "; " + search.note(cell);
    }
    result.comparisons.push_back(comparison);
  }
  return result;
}

/// What the best recipe does, beside what is certified.
RecipeFinding recipe_found(const statements::PublishedTable& table, ComputedQuantities& quantities) {
  const NumericalRecipeSearch& search = quantities.recipes();
  std::vector<Truth> lower, flat;
  for (const statements::PublishedCell& cell : table.cells) {
    const VarianceFacts& facts = quantities.variance(cell.scheme);
    const auto what = scaled_maximum(cell);
    const Enclosure certified = scaled(what.slope ? facts.slope : facts.maximum, what.factor);
    const Rational value = search.value(cell, search.best());
    const Rational reached = what.factor * (what.slope ? facts.steepest : facts.largest);
    const Truth not_above = value <= std::max(reached, *certified.lower) ? Truth::yes
                            : value > *certified.upper                   ? Truth::no
                                                                         : Truth::unknown;
    (what.slope ? flat : lower).push_back(not_above);
  }
  const Truth no_slope = all_of(flat);
  return {search.cells_given(), search.cells(), numerical_recipes()[search.best()].curve.window.has_value(),
          all_of(lower),
          no_slope == Truth::no    ? Truth::yes
          : no_slope == Truth::yes ? Truth::no
                                   : Truth::unknown};
}

/// Printed over certified values, by n; without what is a multiple of another value.
formats::Panel printed_over_certified(const statements::PublishedTable& published,
                                      const formats::ComparisonTable& compared) {
  formats::Panel panel{"Table 3: printed / certified", "n", "", {}, true};
  for (std::size_t i = 0; i < published.cells.size(); ++i) {
    const statements::PublishedCell& cell = published.cells[i];
    const auto& certified = std::get<Enclosure>(compared.comparisons[i].computed);
    if (!cell.derived.empty() || !certified.upper || *certified.upper <= 0) continue;
    auto curve = std::ranges::find(panel.curves, cell.quantity, &formats::Curve::label);
    if (curve == panel.curves.end()) curve = panel.curves.insert(curve, {cell.quantity, {}, true, false});
    curve->points.emplace_back(cell.n.value(),
                               Rational(read_decimal(cell.printed).value / *certified.upper).convert_to<double>());
    curve->values.push_back(fmt::format("{}: printed {}, certified {}", cell.scheme, cell.printed,
                                        compared.comparisons[i].computed_text()));
  }
  return panel;
}

formats::Curve variance_curve(int n, int degree, const std::string& label) {
  const VarianceGrid grid = variance_grid(make_scheme(statements::specification("primal", n, degree)).mask.curve(),
                                          plot_level, false);
  formats::Curve curve{label, {}};
  for (std::size_t i = 0; i < grid.values.size(); ++i)
    curve.points.emplace_back((Rational(i) * grid.step()).convert_to<double>(), grid.values[i].convert_to<double>());
  return curve;
}

const char* const curve_caption =
    "Exact values at the multiples of 1/128. The table gives maximum, minimum and largest slope over all x.";

formats::Figure figure_2() {
  formats::Figure figure{
      "fig2", "Variance curves psi_1, ..., psi_5", std::string("The scales differ. ") + curve_caption, 3, {}};
  for (int n = 1; n <= last_n_of_figure_2; ++n)
    figure.panels.push_back({"psi_" + std::to_string(n), "x", "", {variance_curve(n, 1, "")}});
  return figure;
}

formats::Figure figure_8(ComputedQuantities& quantities) {
  quantities.need_variance(schemes_of_figure_8());
  formats::Panel left{"n max psi", "n", "", {}}, right{"n^2 max |psi'|", "n", "", {}, true};
  for (int degree : {1, 3, 5}) {
    formats::Curve values{"d = " + std::to_string(degree), {}, true}, slopes = values;
    for (int n = (degree + 1) / 2; n <= last_n_of_figure_8; ++n) {
      const VarianceFacts& facts = quantities.variance(statements::specification("primal", n, degree));
      values.points.emplace_back(n, Rational(n * *facts.maximum.lower).convert_to<double>());
      slopes.points.emplace_back(n, Rational(n * n * *facts.slope.lower).convert_to<double>());
    }
    left.curves.push_back(values);
    right.curves.push_back(slopes);
  }
  return {"fig8",
          "The scaled maxima over n",
          "Certified maxima, relative width 1e-6; the right panel is logarithmic, unlike the paper's.",
          2,
          {left, right}};
}

formats::Figure figure_9() {
  formats::Panel by_degree{"n = 5", "x", "psi", {}, false, "outside right"}, by_n = by_degree;
  by_n.title = "d = 3";
  for (int degree : {5, 3, 1}) by_degree.curves.push_back(variance_curve(5, degree, "d = " + std::to_string(degree)));
  for (int n : {3, 4, 5, 6, 7}) by_n.curves.push_back(variance_curve(n, 3, "n = " + std::to_string(n)));
  return {"fig9", "Variance curves over degree and support", curve_caption, 2, {by_degree, by_n}};
}

/// The certified numbers beside a figure of curves.
formats::PlainTable extremes_table(const std::string& id, const std::string& title,
                                   const std::vector<std::string>& schemes, ComputedQuantities& quantities) {
  quantities.need_variance(schemes);
  const auto certain = [](const Enclosure& e) {
    constexpr int digits = 6;
    return e.is_exact() ? to_decimal(*e.lower, digits, Rounding::nearest)
                        : e.lower_text(digits) + " ... " + e.upper_text(digits);
  };
  formats::PlainTable table{id, title, {"scheme", "max psi", "min psi", "max |psi'|"}, {}};
  for (const std::string& scheme : schemes) {
    const VarianceFacts& facts = quantities.variance(scheme);
    table.rows.push_back({scheme, certain(facts.maximum), certain(facts.minimum), certain(facts.slope)});
  }
  return table;
}

/// n^2 times the largest slope for degree 1, at some n.
std::string slope_sentence(ComputedQuantities& quantities) {
  const auto scaled_slope = [&](int n) {
    return to_decimal(n * n * *quantities.variance(statements::specification("primal", n)).slope.upper, 3,
                      Rounding::up);
  };
  std::vector<std::string> parts;
  for (const int n : {1, 3, 7, last_n_of_figure_8}) parts.push_back(fmt::format("{} at n = {}", scaled_slope(n), n));
  return fmt::format("Figure 8, right: for degree 1 n^2 times the largest slope is at most {}.",
                     fmt::join(parts, ", "));
}

}  // namespace

formats::Section variance_section(const ReportOptions& options, ComputedQuantities& quantities) {
  formats::Section section{"variance", "The variance curves", {}};
  if (options.wants("table3")) {
    quantities.say("table3");
    section.comparisons.push_back(compare_table_3(quantities.published("table3"), quantities));
    section.paragraphs.push_back("Table 3: " + verdict_sentence(section.comparisons.back()));
    section.evidence = printed_over_certified(quantities.published("table3"), section.comparisons.back());
    const RecipeFinding recipe = recipe_found(quantities.published("table3"), quantities);
    section.finding = fmt::format("{} (Their multiples by n and n^2 aside.) {}", section.paragraphs.back(),
                                  recipe_finding(recipe));
    section.paragraphs.push_back(
        "What the verdicts mean. Maxima of psi and of |psi'| are enclosed over all of [0, 1], to a relative width of "
        "1e-6, and a printed value that the enclosure excludes is a mismatch. Where the printed value is too small "
        "there is also a witness that anyone can evaluate: an exact value of psi at a dyadic point, or a divided "
        "difference of two such values, which bounds the largest slope from below.");
    section.paragraphs.push_back("Where the digits may come from. " + quantities.recipes().summary() +
                                 " That it agrees with the digits does not prove that it is what was computed. " +
                                 truncation_sentence(recipe) + " docs/table-3.md lists what was tried.");
  }
  if (options.wants("fig2")) {
    quantities.say("fig2");
    section.tables.push_back(
        extremes_table("fig2-values", "Figure 2, enclosed over all x", schemes_of_figure_2(), quantities));
    section.figures.push_back(figure_2());
  }
  if (options.wants("fig8")) {
    quantities.say("fig8");
    section.figures.push_back(figure_8(quantities));
    section.paragraphs.push_back(slope_sentence(quantities));
  }
  if (options.wants("fig9")) {
    quantities.say("fig9");
    section.tables.push_back(
        extremes_table("fig9-values", "Figure 9, enclosed over all x", schemes_of_figure_9(), quantities));
    section.figures.push_back(figure_9());
  }
  return section;
}

}  // namespace subcert::reports
