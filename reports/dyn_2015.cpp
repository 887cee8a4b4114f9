#include "dyn_2015.hpp"

#include "parallel.hpp"
#include "published.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/regularity/holder_regularity.hpp>
#include <subcert/analysis/variance/variance.hpp>
#include <subcert/analysis/variance/variance_range.hpp>
#include <subcert/schemes/specification.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

namespace subcert {
namespace {

constexpr int holder_levels = 16;  // as in the paper
constexpr int variance_level = 9;  // dyadic level of the exact grid behind Table 3
constexpr int plot_level = 7;
constexpr int longest_plot = 15;  // n in Figure 8
constexpr double exponent_seconds = 10;  // for the polytope of one scheme

std::string spec(const std::string& family, int n, int degree = 1) {
  return family + ":n=" + std::to_string(n) + ",d=" + std::to_string(degree);
}

std::string decimal(const Rational& value, int places) { return to_fixed(value, places, Rounding::nearest); }

/// A variance curve on an exact grid, whose points are the witnesses, and enclosed between them.
struct VarianceFacts {
  Rational largest, largest_at;
  Enclosure maximum, slope;
  Rational steepest;
  std::string steepest_at;
  /// Largest |divided difference| of neighbours at the levels 0, ..., variance_level.
  std::vector<Rational> divided;
};

VarianceFacts variance_facts(const std::string& specification) {
  const Mask mask = make_scheme(specification).mask;
  const VarianceGrid grid = variance_grid(mask, variance_level, proved_smoothness(mask).order >= 1);
  VarianceFacts facts;
  for (std::size_t i = 0; i < grid.values.size(); ++i)
    if (i == 0 || grid.values[i] > facts.largest) {
      facts.largest = grid.values[i];
      facts.largest_at = Rational(i) * grid.step();
    }
  for (int level = 0; level <= variance_level; ++level) {
    const std::size_t stride = std::size_t{1} << (variance_level - level);
    Rational most = 0;
    for (std::size_t i = stride; i < grid.values.size(); i += stride) {
      const Rational slope = abs(grid.values[i] - grid.values[i - stride]) * power(Rational(2), level);
      most = std::max(most, slope);
      if (slope > facts.steepest) {
        facts.steepest = slope;
        facts.steepest_at = "by the values at " + to_text(Rational(i - stride) * grid.step()) + " and " +
                            to_text(Rational(i) * grid.step());
      }
    }
    facts.divided.push_back(most);
  }
  for (std::size_t i = 0; i < grid.slopes.size(); ++i)
    if (abs(grid.slopes[i]) > facts.steepest) {
      facts.steepest = abs(grid.slopes[i]);
      facts.steepest_at = "by the derivative at x = " + to_text(Rational(i) * grid.step());
    }
  const VarianceRange range = variance_range(mask);
  facts.maximum = {std::max(*range.maximum.lower, facts.largest), range.maximum.upper};
  facts.slope = Enclosure::at_least(facts.steepest);
  if (range.slope) facts.slope = {std::max(*range.slope->lower, facts.steepest), range.slope->upper};
  return facts;
}

/// Everything the items share, computed once.
class Workshop {
 public:
  explicit Workshop(const ReportOptions& options) : options_(options), paper_(published_paper("dyn-2015")) {}

  const PublishedPaper& paper() const { return paper_; }
  const PublishedTable& published(const std::string& id) const { return paper_.table(id); }
  void say(const std::string& line) const {
    if (options_.progress) options_.progress(line);
  }

  /// Make what is missing, in parallel.
  void need_bounds(const std::vector<std::string>& specifications) {
    need(bounds_, specifications, [](const auto& s) { return holder_bounds(make_scheme(s).mask, holder_levels); });
  }
  const HolderBounds& bounds(const std::string& specification) const { return *bounds_.at(specification); }

  /// Enclosures of the exponents.
  void need_exponents(const std::vector<std::string>& specifications) {
    need(exponents_, specifications,
         [](const auto& s) { return holder_regularity(make_scheme(s).mask, holder_levels, exponent_seconds); });
  }
  const HolderRegularity& exponent(const std::string& specification) const { return *exponents_.at(specification); }

  void need_variance(const std::vector<std::string>& specifications) {
    need(variance_, specifications, variance_facts);
  }
  const VarianceFacts& variance(const std::string& specification) const { return *variance_.at(specification); }

 private:
  template <class Map, class Make>
  void need(Map& map, const std::vector<std::string>& names, const Make& make) {
    std::vector<typename Map::value_type*> missing;
    for (const std::string& name : names) {
      const auto [entry, fresh] = map.try_emplace(name);
      if (fresh) missing.push_back(&*entry);
    }
    parallel_for_each(missing.size(), options_.jobs, [&](std::size_t i) {
      say(missing[i]->first);
      missing[i]->second = make(missing[i]->first);
    });
  }

  const ReportOptions& options_;
  PublishedPaper paper_;
  std::map<std::string, std::optional<HolderBounds>> bounds_;
  std::map<std::string, std::optional<HolderRegularity>> exponents_;
  std::map<std::string, std::optional<VarianceFacts>> variance_;
};

ComparisonTable empty_table(const PublishedTable& table) {
  return {"dyn-2015", table.id, table.title, table.place, table.grid, {}};
}

Comparison number(const PublishedCell& cell, const Enclosure& computed, const std::string& note = "") {
  return {cell.row,  cell.column, cell.scheme, cell.printed, computed, compare(cell.printed, computed), cell.recorded,
          note};
}

Comparison text(const PublishedCell& cell, const std::string& computed, bool equal) {
  return {cell.row, cell.column, cell.scheme, cell.printed, computed, equal ? Verdict::match : Verdict::mismatch,
          cell.recorded, ""};
}

ComparisonTable compare_masks(const PublishedTable& table) {
  ComparisonTable result = empty_table(table);
  for (const PublishedCell& cell : table.cells) {
    const Mask computed = make_scheme(cell.scheme).mask;
    // The paper prints no indices with the masks: the coefficients are compared in order.
    const LaurentPolynomial printed = LaurentPolynomial::parse_mask(cell.printed).shifted(computed.symbol().lowest());
    Comparison comparison = text(cell, computed.symbol().to_mask_text(), printed == computed.symbol());
    if (comparison.verdict == Verdict::mismatch)
      comparison.note = "the printed coefficients sum to " + to_text(coset_sums({printed, 2})[0]) + " and " +
                        to_text(coset_sums({printed, 2})[1]) + " over the even and odd indices; a mask needs 1 and 1";
    result.comparisons.push_back(comparison);
  }
  return result;
}

ComparisonTable compare_supports(const PublishedTable& table) {
  ComparisonTable result = empty_table(table);
  for (const PublishedCell& cell : table.cells) {
    const Interval support = limit_support(make_scheme(cell.scheme).mask);
    const std::string computed = "[" + to_text(support.lower) + ", " + to_text(support.upper) + "]";
    result.comparisons.push_back(text(cell, computed, computed == cell.printed));
  }
  return result;
}

std::vector<std::string> schemes_of(const PublishedTable& table) {
  std::vector<std::string> result;
  for (const PublishedCell& cell : table.cells) result.push_back(cell.scheme);
  return result;
}

ComparisonTable compare_bounds(const PublishedTable& table, Workshop& workshop) {
  workshop.need_bounds(schemes_of(table));
  ComparisonTable result = empty_table(table);
  for (const PublishedCell& cell : table.cells)
    result.comparisons.push_back(number(cell, workshop.bounds(cell.scheme).last().exponent));
  return result;
}

/// The n of a row label `d=1, n=3`.
int n_of(const PublishedCell& cell) { return std::stoi(cell.row.substr(cell.row.find("n=") + 2)); }

std::string divided_difference_note(const VarianceFacts& facts, const std::string& printed, int factor) {
  const auto places = static_cast<int>(printed.size() - printed.find('.') - 1);
  for (std::size_t level = facts.divided.size(); level-- > 2;)
    if (decimal(factor * facts.divided[level], places) == printed)
      return "divided differences of step 2^-" + std::to_string(level) + " give the printed digits";
  return "";
}

ComparisonTable compare_variance(const PublishedTable& table, Workshop& workshop) {
  workshop.need_variance(schemes_of(table));
  ComparisonTable result = empty_table(table);
  for (const PublishedCell& cell : table.cells) {
    const VarianceFacts& facts = workshop.variance(cell.scheme);
    const int n = n_of(cell);
    const bool slope = cell.quantity.find("slope") != std::string::npos;
    const int factor = cell.quantity == "n*variance" ? n : cell.quantity == "n^2*slope" ? n * n : 1;
    const Enclosure& certified = slope ? facts.slope : facts.maximum;
    Enclosure computed;
    if (certified.lower) computed.lower = factor * *certified.lower;
    if (certified.upper) computed.upper = factor * *certified.upper;
    Comparison comparison = number(cell, computed);
    const Rational& witnessed = slope ? facts.steepest : facts.largest;
    if (comparison.verdict == Verdict::mismatch && compare(cell.printed, Enclosure::at_least(factor * witnessed)) == Verdict::mismatch)
      comparison.note = slope ? "exceeded " + facts.steepest_at : "exceeded at x = " + to_text(facts.largest_at);
    else if (comparison.verdict == Verdict::mismatch)
      comparison.note = "not reached anywhere on [0, 1]";
    if (slope && comparison.verdict == Verdict::mismatch) {
      const std::string shortcut = divided_difference_note(facts, cell.printed, factor);
      if (!shortcut.empty()) comparison.note += (comparison.note.empty() ? "" : "; ") + shortcut;
    }
    result.comparisons.push_back(comparison);
  }
  return result;
}

/// Points of a function on a grid, x = index / arity^level.
std::vector<std::pair<double, double>> curve_points(const LimitValues& values) {
  std::vector<std::pair<double, double>> points;
  for (std::size_t i = 0; i < values.values.size(); ++i)
    points.emplace_back(values.point(i).convert_to<double>(), values.values[i].convert_to<double>());
  return points;
}

std::vector<std::pair<double, double>> curve_points(const VarianceGrid& grid) {
  std::vector<std::pair<double, double>> points;
  for (std::size_t i = 0; i < grid.values.size(); ++i)
    points.emplace_back((Rational(i) * grid.step()).convert_to<double>(), grid.values[i].convert_to<double>());
  return points;
}

Curve variance_curve(int n, int degree, const std::string& label) {
  return {label, curve_points(variance_grid(make_scheme(spec("primal", n, degree)).mask, plot_level, false))};
}

Figure figure_1() {
  Figure figure{"fig1", "Basic limit functions of S_2, S_3 and S_4",
                "Exact values at the dyadic points of level " + std::to_string(plot_level) + ".", 3, {}};
  for (int n = 2; n <= 4; ++n)
    figure.panels.push_back({"S_" + std::to_string(n), "x", "phi",
                             {{"", curve_points(limit_values(make_scheme(spec("primal", n)).mask, plot_level))}}});
  return figure;
}

Figure figure_2() {
  Figure figure{"fig2", "Variance curves psi_1, ..., psi_5", "Exact values on [0, 1]; the scales differ.", 3, {}};
  for (int n = 1; n <= 5; ++n)
    figure.panels.push_back({"psi_" + std::to_string(n), "x", "", {variance_curve(n, 1, "")}});
  return figure;
}

Figure figure_8(Workshop& workshop) {
  std::vector<std::string> schemes;
  for (int degree : {1, 3, 5})
    for (int n = (degree + 1) / 2; n <= longest_plot; ++n) schemes.push_back(spec("primal", n, degree));
  workshop.need_variance(schemes);
  Panel left{"n max psi", "n", "", {}}, right{"n^2 max |psi'|", "n", "", {}, true};
  for (int degree : {1, 3, 5}) {
    Curve values{"d = " + std::to_string(degree), {}, true}, slopes = values;
    for (int n = (degree + 1) / 2; n <= longest_plot; ++n) {
      const VarianceFacts& facts = workshop.variance(spec("primal", n, degree));
      values.points.emplace_back(n, Rational(n * *facts.maximum.lower).convert_to<double>());
      slopes.points.emplace_back(n, Rational(n * n * *facts.slope.lower).convert_to<double>());
    }
    left.curves.push_back(values);
    right.curves.push_back(slopes);
  }
  return {"fig8", "The scaled maxima over n",
          "Certified maxima, relative width 1e-6; the right panel is logarithmic, unlike the paper's.", 2,
          {left, right}};
}

Figure figure_9() {
  Panel by_degree{"n = 5", "x", "psi", {}, false, "outside right"}, by_n = by_degree;
  by_n.title = "d = 3";
  for (int degree : {5, 3, 1}) by_degree.curves.push_back(variance_curve(5, degree, "d = " + std::to_string(degree)));
  for (int n : {3, 4, 5, 6, 7}) by_n.curves.push_back(variance_curve(n, 3, "n = " + std::to_string(n)));
  return {"fig9", "Variance curves over degree and support", "Exact values on [0, 1].", 2, {by_degree, by_n}};
}

std::vector<std::string> bound_schemes() {
  std::vector<std::string> result;
  for (const char* family : {"primal", "dual"})
    for (int n = 2; n <= 10; ++n) result.push_back(spec(family, n));
  return result;
}

/// How the bounds move with the number of levels.
void explain_levels(Section& section, Workshop& workshop) {
  workshop.need_bounds(bound_schemes());
  const std::vector<int> shown{1, 2, 4, 8, 12, 16};
  PlainTable table{"levels", "The bound after L levels", {"scheme"}, {}};
  for (int level : shown) table.head.push_back("L = " + std::to_string(level));
  Rational largest_step = 0;
  std::string largest_scheme;
  int decreasing = 0, pairs = 0;
  for (const std::string& name : bound_schemes()) {
    const HolderBounds& bounds = workshop.bounds(name);
    const auto at = [&](int level) -> const Rational& { return *bounds.levels[static_cast<std::size_t>(level) - 1].exponent.lower; };
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
      "What the bounds mean. Each is proved, and none is the exponent itself: a bound belongs to its number of levels. "
      "Between 8 and 16 levels the bounds of these schemes still rise by up to " +
      decimal(largest_step, 4) + " (" + largest_scheme + "), so the third decimal of the printed tables says how far the "
      "computation went, not how smooth the limits are. Nor do the bounds simply grow: of " + std::to_string(pairs) +
      " steps from one level to the next, " + std::to_string(decreasing) +
      " go down. A comparison of two schemes by these tables is safe only where their difference is larger than what "
      "further levels could add.");
  Figure figure{"levels-plot", "The bounds over the number of levels", "One curve a scheme; every point is a proved bound. Those that are not positive say nothing and are left out.", 2, {}};
  for (const char* family : {"primal", "dual"}) {
    Panel panel{std::string(family) + " schemes", "levels", "bound", {}, false, "bottom right"};
    for (int n : {2, 3, 4, 5, 7, 10}) {
      Curve curve{"n = " + std::to_string(n), {}, true};
      for (const HolderBound& bound : workshop.bounds(spec(family, n)).levels)
        if (*bound.exponent.lower > 0) curve.points.emplace_back(bound.levels, bound.exponent.lower->convert_to<double>());
      panel.curves.push_back(curve);
    }
    figure.panels.push_back(panel);
  }
  section.figures.push_back(figure);
}

/// The exponents themselves beside what sixteen levels show.
Section exponents(Workshop& workshop) {
  workshop.need_exponents(bound_schemes());
  Section section{"exponents", "What the paper could not see", {}};
  PlainTable table{"exponents", "Printed bounds and exponents",
                   {"scheme", "printed bound", "16 levels", "exponent", "width", "product", "vertices", "exact"}, {}};
  Figure figure{"exponents-plot", "Printed bounds and exponents over n",
                "Bounds after 16 levels as printed, and the proved ends of the exponents; where those are closed they coincide.", 2, {}};
  int exact = 0, total = 0;
  Rational widest = 0;
  std::string trend;
  for (const char* family : {"primal", "dual"}) {
    const PublishedTable& printed = workshop.published(family == std::string("primal") ? "table1" : "table2");
    Curve bound_curve{"printed bound", {}, true}, upper_curve{"exponent, proved upper end", {}, true},
        lower_curve{"exponent, proved lower end", {}, true};
    std::string largest, above;  // the largest printed bound, and the n whose exponents are proved to exceed it
    for (const PublishedCell& cell : printed.cells) largest = std::max(largest, cell.printed);
    for (int n = 2; n <= 10; ++n) {
      const HolderRegularity& regularity = workshop.exponent(spec(family, n));
      const Rational low = *regularity.exponent.lower, high = *regularity.exponent.upper;
      const std::string bound = printed.cells[static_cast<std::size_t>(n) - 2].printed;
      if (compare(largest, Enclosure::at_least(low)) == Verdict::mismatch) above += (above.empty() ? "" : ", ") + std::to_string(n);
      widest = std::max(widest, Rational(high - low));
      exact += regularity.radius.exact.is_yes() ? 1 : 0;
      ++total;
      std::string word;
      for (int letter : regularity.radius.product.word) word += std::to_string(letter);
      table.rows.push_back({spec(family, n), bound, decimal(*regularity.bounds.last().exponent.lower, 4),
                            regularity.radius.exact.is_yes() ? decimal(low, 12)
                                                     : to_fixed(low, 4, Rounding::down) + " ... " + to_fixed(high, 4, Rounding::up),
                            to_decimal(high - low, 2, Rounding::up), word, std::to_string(regularity.radius.vertices),
                            regularity.radius.exact.is_yes() ? "yes" : "unknown"});
      bound_curve.points.emplace_back(n, std::stod(bound));
      upper_curve.points.emplace_back(n, high.convert_to<double>());
      lower_curve.points.emplace_back(n, low.convert_to<double>());
    }
    figure.panels.push_back({std::string(family) + " schemes", "n", "", {bound_curve, upper_curve, lower_curve}, false, "bottom right"});
    trend += std::string(trend.empty() ? "" : " ") + "For the " + family + " schemes the exponent is proved to exceed " +
             largest + ", the largest printed bound, for n = " + above + ".";
  }
  section.paragraphs.push_back(
      "Tables 1 and 2 print bounds after sixteen levels. They rise to a maximum at n = 4 and then fall, which suggests that "
      "larger supports make the limits less smooth. The exponents themselves do not follow that trend. " + trend +
      " The fall in the tables is an effect of stopping at sixteen levels: larger schemes need more of them.");
  section.paragraphs.push_back(
      "The exponents come from the joint spectral radius of the transition matrices: a product of them proves the upper "
      "end (the integer shifts are stable, which is decided exactly), an invariant polytope the lower end, both in rational "
      "arithmetic. For " + std::to_string(exact) + " of " + std::to_string(total) +
      " schemes the named product is proved to attain the radius, so that the exponent is known exactly; the widest of the "
      "other enclosures measures " + to_decimal(widest, 2, Rounding::up) +
      ". 'subcert regularity SCHEME --certificate FILE' writes each proof, 'subcert verify FILE' checks it with an "
      "independent program.");
  section.tables.push_back(table);
  section.figures.push_back(figure);
  return section;
}

std::string verdict_sentence(const ComparisonTable& table) {
  return std::to_string(table.count(Verdict::match)) + " of " + std::to_string(table.comparisons.size()) +
         " printed values match, " + std::to_string(table.count(Verdict::mismatch)) + " do not, " +
         std::to_string(table.count(Verdict::open)) + " are open.";
}

}  // namespace

const std::vector<std::string>& dyn_2015_items() {
  static const std::vector<std::string> items{"masks",  "supports", "fig1",   "table1", "table2",
                                              "levels", "exponents", "table3",   "fig2", "fig8",   "fig9"};
  return items;
}

Report report_dyn_2015(const ReportOptions& options) {
  const std::set<std::string> only(options.only.begin(), options.only.end());
  const auto wanted = [&](const char* item) { return only.empty() || only.contains(item); };
  Workshop workshop(options);
  Report report{workshop.paper().key, workshop.paper().citation, {}};

  Section masks{"masks", "Masks, supports and basic limit functions", {}};
  if (wanted("masks")) masks.comparisons.push_back(compare_masks(workshop.published("masks")));
  if (wanted("supports")) masks.comparisons.push_back(compare_supports(workshop.published("supports")));
  if (wanted("fig1")) masks.figures.push_back(figure_1());
  if (!masks.comparisons.empty())
    masks.paragraphs.push_back("The masks are derived from the local fits in exact rational arithmetic and compared "
                               "coefficient by coefficient; the supports follow from the masks.");
  if (wanted("masks"))
    masks.paragraphs.push_back("Masks: " + verdict_sentence(masks.comparisons.front()) +
                               " A list that does not sum to 1 over the even and over the odd indices cannot be the "
                               "mask of a convergent scheme, whatever its fits; the notes name the sums.");

  Section bounds{"bounds", "Lower bounds of the Hoelder exponent", {}};
  for (const char* id : {"table1", "table2"})
    if (wanted(id)) {
      bounds.comparisons.push_back(compare_bounds(workshop.published(id), workshop));
      bounds.paragraphs.push_back((id == std::string("table1") ? "Table 1: " : "Table 2: ") +
                                  verdict_sentence(bounds.comparisons.back()));
    }
  if (!bounds.comparisons.empty())
    bounds.paragraphs.push_back("Computed is the sixteen-level bound of Dyn and Levin: the norm behind it is an exact "
                                "rational number, and only its logarithm is rounded, outward.");
  if (wanted("levels")) explain_levels(bounds, workshop);

  Section sharp{"exponents", "", {}};
  if (wanted("exponents")) sharp = exponents(workshop);

  Section variance{"variance", "The variance curves", {}};
  if (wanted("table3")) {
    workshop.say("table3");
    variance.comparisons.push_back(compare_variance(workshop.published("table3"), workshop));
    variance.paragraphs.push_back("Table 3: " + verdict_sentence(variance.comparisons.back()));
    variance.paragraphs.push_back(
        "What the verdicts mean. Maxima of psi and of |psi'| are enclosed over all of [0, 1], to a relative width of 1e-6, and "
        "a printed value that the enclosure excludes is a mismatch. Where the printed value is too small there is also a "
        "witness that anyone can evaluate: values of psi at dyadic points of level " +
        std::to_string(variance_level) +
        " are exact, and a divided difference of exact values bounds the largest slope from below. Where divided "
        "differences of some step give the printed digits, the note says so.");
  }
  if (wanted("fig2")) variance.figures.push_back(figure_2());
  if (wanted("fig8")) {
    variance.figures.push_back(figure_8(workshop));
    const auto scaled_slope = [&](int n) {
      return to_decimal(n * n * *workshop.variance(spec("primal", n)).slope.upper, 3, Rounding::up);
    };
    variance.paragraphs.push_back(
        "Figure 8. The paper reads its right panel as nearly constant. Certified, n^2 times the largest slope for "
        "degree 1 falls from " + scaled_slope(1) + " at n = 1 through " + scaled_slope(3) + " at n = 3 and " +
        scaled_slope(7) + " at n = 7 to " + scaled_slope(longest_plot) + " at n = " + std::to_string(longest_plot) +
        ": on this range 1/n^2 is true as an upper bound and not the rate. For every n this is a theorem, see "
        "docs/theorems/degree-one.md.");
  }
  if (wanted("fig9")) variance.figures.push_back(figure_9());

  for (Section* section : {&masks, &bounds, &sharp, &variance})
    if (!section->comparisons.empty() || !section->tables.empty() || !section->figures.empty())
      report.sections.push_back(std::move(*section));
  return report;
}

}  // namespace subcert
