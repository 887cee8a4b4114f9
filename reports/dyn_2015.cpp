#include "collections.hpp"

#include "computed_quantities.hpp"
#include "sections.hpp"
#include "story_sentences.hpp"

#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/proofs-checks/papers/registry.hpp>
#include <subcert/schemes/specification.hpp>

#include <algorithm>

namespace subcert::reports {
namespace {

formats::ComparisonTable compare_masks(const statements::PublishedTable& table) {
  formats::ComparisonTable result = empty_table(table);
  for (const statements::PublishedCell& cell : table.cells) {
    const Mask computed = make_scheme(cell.scheme).mask.curve();
    // The paper prints no indices with the masks: the coefficients are compared in order.
    const LaurentPolynomial printed = LaurentPolynomial::parse_mask(cell.printed).shifted(computed.symbol().lowest());
    formats::Comparison comparison = compare_text(cell, computed.symbol().to_mask_text(),
                                                  printed == computed.symbol() ? Truth::yes : Truth::no);
    if (comparison.verdict == ValueVerdict::mismatch)
      comparison.note = "the printed coefficients sum to " + to_text(coset_sums({printed, 2})[0]) + " and " +
                        to_text(coset_sums({printed, 2})[1]) + " over the even and odd indices; a mask needs 1 and 1";
    result.comparisons.push_back(comparison);
  }
  return result;
}

formats::ComparisonTable compare_supports(const statements::PublishedTable& table) {
  formats::ComparisonTable result = empty_table(table);
  for (const statements::PublishedCell& cell : table.cells) {
    const Interval support = limit_support(make_scheme(cell.scheme).mask.curve());
    const std::string computed = "[" + to_text(support.lower) + ", " + to_text(support.upper) + "]";
    result.comparisons.push_back(compare_text(cell, computed, computed == cell.printed ? Truth::yes : Truth::no));
  }
  return result;
}

formats::ComparisonTable compare_bounds(const statements::PublishedTable& table, ComputedQuantities& quantities) {
  quantities.need_bounds(schemes_of(table));
  formats::ComparisonTable result = empty_table(table);
  for (const statements::PublishedCell& cell : table.cells)
    result.comparisons.push_back(compare_number(cell, quantities.bounds(cell.scheme).last().exponent));
  return result;
}

/// Points of a function on a grid, x = index / arity^level.
std::vector<std::pair<double, double>> curve_points(const LimitValues& values) {
  std::vector<std::pair<double, double>> points;
  for (std::size_t i = 0; i < values.values.size(); ++i)
    points.emplace_back(values.point(i).convert_to<double>(), values.values[i].convert_to<double>());
  return points;
}

formats::Figure figure_1() {
  formats::Figure figure{"fig1",
                         "Basic limit functions of S_2, S_3 and S_4",
                         "Exact values at the dyadic points of level " + std::to_string(plot_level) + ".",
                         3,
                         {}};
  for (int n = 2; n <= 4; ++n)
    figure.panels.push_back(
        {"S_" + std::to_string(n),
         "x",
         "phi",
         {{"",
           curve_points(limit_values(make_scheme(statements::specification("primal", n)).mask.curve(), plot_level))}}});
  return figure;
}

std::vector<std::string> bound_schemes() {
  std::vector<std::string> result;
  for (const char* family : {"primal", "dual"})
    for (int n = 2; n <= 10; ++n) result.push_back(statements::specification(family, n));
  return result;
}

/// How the bounds move with the number of levels.
void explain_levels(formats::Section& section, ComputedQuantities& quantities) {
  quantities.need_bounds(bound_schemes());
  const std::vector<int> shown{1, 2, 4, 8, 12, 16};
  formats::PlainTable table{"levels", "The bound after L levels", {"scheme"}, {}};
  for (int level : shown) table.head.push_back("L = " + std::to_string(level));
  Rational largest_step = 0;
  std::string largest_scheme;
  int decreasing = 0, pairs = 0;
  for (const std::string& name : bound_schemes()) {
    const HolderBounds& bounds = quantities.bounds(name);
    const auto at = [&](int level) -> const Rational& {
      return *bounds.levels[static_cast<std::size_t>(level) - 1].exponent.lower;
    };
    std::vector<std::string> row{name};
    for (int level : shown) row.push_back(decimal(at(level), 4));
    table.rows.push_back(row);
    const Rational step = at(16) - at(8);
    if (largest_scheme.empty() || step > largest_step) {
      largest_step = step;
      largest_scheme = name;
    }
    for (int level = 2; level <= holder_levels; ++level, ++pairs) decreasing += at(level) < at(level - 1) ? 1 : 0;
  }
  section.tables.push_back(table);
  section.paragraphs.push_back(
      levels_sentence({largest_step, largest_scheme, decreasing, pairs}, read_decimal("1.000").unit));
  formats::Figure figure{
      "levels-plot",
      "The bounds over the number of levels",
      "One curve a scheme; every point is a proved bound. Those that are not positive say nothing and are left out.",
      2,
      {}};
  for (const char* family : {"primal", "dual"}) {
    formats::Panel panel{std::string(family) + " schemes", "levels", "bound", {}, false, "bottom right"};
    for (int n : {2, 3, 4, 5, 7, 10}) {
      formats::Curve curve{"n = " + std::to_string(n), {}, true};
      for (const HolderBound& bound : quantities.bounds(statements::specification(family, n)).levels)
        if (*bound.exponent.lower > 0)
          curve.points.emplace_back(bound.levels, bound.exponent.lower->convert_to<double>());
      panel.curves.push_back(curve);
    }
    figure.panels.push_back(panel);
  }
  section.figures.push_back(figure);
}

std::string smoothness_finding(int threads) {
  std::string text;
  for (const char* id : {"smoothness", "smoothness-dual"})
    text += for_every_n(theorems::proved(id, 1, "primal", threads));
  return text;
}

/// The exponents themselves beside what sixteen levels show.
formats::Section exponents(ComputedQuantities& quantities, const ReportOptions& options) {
  quantities.need_exponents(bound_schemes());
  formats::Section section{"exponents", "The exponents themselves", {}};
  formats::PlainTable table{
      "exponents",
      "Printed bounds and exponents",
      {"scheme", "printed bound", "16 levels", "exponent", "width", "product", "vertices", "exact"},
      {}};
  formats::Figure figure{"exponents-plot",
                         "Printed bounds and exponents over n",
                         "Bounds after 16 levels as printed, and the proved exponents.",
                         2,
                         {}};
  int exact = 0, total = 0;
  Rational widest = 0;
  std::vector<BoundsAndExponents> families;
  for (const char* family : {"primal", "dual"}) {
    const statements::PublishedTable& printed = quantities.published(family == std::string("primal") ? "table1"
                                                                                                     : "table2");
    formats::Curve bound_curve{"printed bound", {}, true}, upper_curve{"exponent, proved upper end", {}, true},
        lower_curve{"exponent, proved lower end", {}, true};
    bool closed = true;
    families.push_back({family, 2, {}, {}});
    for (int n = 2; n <= 10; ++n) {
      const HolderRegularity& regularity = quantities.exponent(statements::specification(family, n));
      const Rational low = *regularity.exponent.lower, high = *regularity.exponent.upper;
      const std::string bound = printed.cells[static_cast<std::size_t>(n) - 2].printed;
      families.back().bounds.push_back(bound);
      families.back().exponents.push_back(regularity.exponent);
      widest = std::max(widest, Rational(high - low));
      closed = closed && regularity.radius.is_closed();
      exact += regularity.radius.exact.is_yes() ? 1 : 0;
      ++total;
      std::string word;
      for (int letter : regularity.radius.product.word) word += std::to_string(letter);
      table.rows.push_back({statements::specification(family, n), bound,
                            decimal(*regularity.bounds.last().exponent.lower, 4),
                            regularity.radius.exact.is_yes()
                                ? decimal(low, 12)
                                : to_fixed(low, 4, Rounding::down) + " ... " + to_fixed(high, 4, Rounding::up),
                            to_decimal(high - low, 2, Rounding::up), word, std::to_string(regularity.radius.vertices()),
                            regularity.radius.exact.is_yes() ? "yes" : "unknown"});
      const Mask mask = make_scheme(statements::specification(family, n)).mask.curve();
      table.proofs.push_back(
          row_proof(fmt::format("{}-{}.cert", family, n), exponent_certificate(mask, regularity), options.verified));
      table.proofs.back().scheme = printed.cells[static_cast<std::size_t>(n) - 2].scheme;
      table.row_ids.push_back(fmt::format("dyn-2015-exponents-{}-{}", family, n));
      bound_curve.points.emplace_back(n, std::stod(bound));
      upper_curve.points.emplace_back(n, high.convert_to<double>());
      lower_curve.points.emplace_back(n, low.convert_to<double>());
      lower_curve.values.push_back(fmt::format("n = {}: {}", n, table.rows.back()[3]));
    }
    if (closed) lower_curve.label = "exponent";
    std::vector<formats::Curve> curves{bound_curve, lower_curve};
    if (!closed) curves.push_back(upper_curve);
    figure.panels.push_back({std::string(family) + " schemes", "n", "", curves, false, "bottom right"});
  }
  section.finding = exponents_finding(families) + smoothness_finding(options.jobs);
  section.paragraphs.push_back(
      "Tables 1 and 2 print bounds after sixteen levels; a larger scheme needs more levels for "
      "as sharp a bound. " +
      section.finding);
  section.paragraphs.push_back(
      "The exponents come from the joint spectral radius of the transition matrices: a product of them proves the "
      "upper end (the integer shifts are stable, which is decided exactly), an invariant polytope the lower end, both "
      "in rational arithmetic. For " +
      (exact == total ? "all " : std::to_string(exact) + " of ") + std::to_string(total) +
      " schemes the named product is proved to attain the radius, so that the exponent is known exactly; no enclosure "
      "is wider than " +
      to_decimal(widest, 2, Rounding::up) +
      ". 'subcert regularity SCHEME --certificate FILE' writes each proof, 'subcert verify FILE' checks it with an "
      "independent program.");
  section.tables.push_back(table);
  section.figures.push_back(figure);
  return section;
}

}  // namespace

std::vector<std::string> dyn_2015_items() {
  std::vector<std::string> result{"masks",     "supports", "fig1", "table1", "table2", "levels",
                                  "exponents", "table3",   "fig2", "fig8",   "fig9"};
  for (const std::string& id : experiment_ids("dyn-2015")) result.push_back(id);
  result.insert(result.end(), {"conjecture7", "theorems"});
  return result;
}

Report report_dyn_2015(const ReportOptions& options) {
  ComputedQuantities quantities(options);
  Report report{quantities.paper().key, statements::citation(quantities.paper().key), {}};

  formats::Section masks{"masks", "Masks, supports and basic limit functions", {}};
  if (options.wants("masks")) masks.comparisons.push_back(compare_masks(quantities.published("masks")));
  if (options.wants("supports")) masks.comparisons.push_back(compare_supports(quantities.published("supports")));
  if (options.wants("fig1")) masks.figures.push_back(figure_1());
  if (!masks.comparisons.empty())
    masks.paragraphs.push_back(
        "The masks are derived from the local fits in exact rational arithmetic and compared coefficient by "
        "coefficient; the supports follow from the masks.");
  if (options.wants("masks"))
    masks.paragraphs.push_back(
        "Masks: " + verdict_sentence(masks.comparisons.front()) +
        (masks.comparisons.front().count(ValueVerdict::mismatch) > 0
             ? " A list that does not sum to 1 over the even and over the odd indices cannot be the mask of a "
               "convergent scheme, whatever its fits; the notes name the sums."
             : ""));

  formats::Section bounds{"bounds", "Lower bounds of the Hoelder exponent", {}};
  for (const char* id : {"table1", "table2"})
    if (options.wants(id)) {
      bounds.comparisons.push_back(compare_bounds(quantities.published(id), quantities));
      bounds.paragraphs.push_back((id == std::string("table1") ? "Table 1: " : "Table 2: ") +
                                  verdict_sentence(bounds.comparisons.back()));
    }
  if (!bounds.comparisons.empty())
    bounds.paragraphs.push_back(
        "Computed is the sixteen-level bound of Dyn and Levin: the norm behind it is an exact rational number, and "
        "only its logarithm is rounded, outward.");
  if (options.wants("levels")) explain_levels(bounds, quantities);

  formats::Section sharp{"exponents", "", {}};
  if (options.wants("exponents")) sharp = exponents(quantities, options);

  formats::Section variance = variance_section(options, quantities), conjecture, theorems;
  if (options.wants("conjecture7")) conjecture = conjecture_7_section(quantities);
  if (options.wants("theorems")) {
    quantities.say("theorems");
    theorems = theorem_section(options);
  }

  const auto append = [&](formats::Section& section) {
    if (!section.comparisons.empty() || !section.tables.empty() || !section.figures.empty())
      report.sections.push_back(std::move(section));
  };
  for (formats::Section* section : {&masks, &bounds, &sharp, &variance}) append(*section);
  report.experiments_at = report.sections.size();
  for (formats::Section* section : {&conjecture, &theorems}) append(*section);
  return report;
}

}  // namespace subcert::reports
