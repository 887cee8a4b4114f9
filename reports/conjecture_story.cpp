#include "sections.hpp"

#include "computed_quantities.hpp"
#include "story_sentences.hpp"

#include <subcert/analysis/symbol/numbers/interval.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/proofs-checks/conjectures/conjecture_7.hpp>
#include <subcert/proofs-checks/papers/dyn-2015/checks.hpp>
#include <subcert/schemes/specification.hpp>

#include <algorithm>
#include <stdexcept>

namespace subcert::reports {
namespace {

using namespace conjectures;
using namespace statements::dyn_2015;

const std::vector<int>& degrees() {
  static const std::vector<int> list{1, 3, 5};
  return list;
}

/// Certified maxima of psi and |psi'| for one degree, over the n of Figure 8.
struct Course {
  int degree;
  std::vector<CertifiedMaximum> maxima, slopes;
  LimitComparison limit;

  Course(int of_degree, const ComputedQuantities& quantities) : degree(of_degree) {
    for (int n = (degree + 1) / 2; n <= last_n_of_figure_8; ++n) {
      const VarianceFacts& facts = quantities.variance(statements::specification("primal", n, degree));
      const bool interpolates = 2 * n == degree + 1;
      maxima.push_back({n, facts.maximum, interpolates});
      slopes.push_back({n, facts.slope, interpolates});
    }
    limit = *limit_comparison(degree, maxima);
  }

  const Enclosure& slope_at(int n) const {
    for (const CertifiedMaximum& slope : slopes)
      if (slope.n == n) return slope.value;
    fail(ErrorKind::domain, "no slope for n = {}", n);
  }
};

double upper_as_double(const Enclosure& value) { return value.upper->convert_to<double>(); }

formats::Curve scaled_curve(const std::string& label, const std::vector<CertifiedMaximum>& values, int power_of_n) {
  formats::Curve curve{label, {}, true};
  for (const CertifiedMaximum& value : values)
    curve.points.emplace_back(value.n, upper_as_double(scaled(value.value, power(Rational(value.n), power_of_n))));
  return curve;
}

/// n^2 max |psi'| for d = 1 as a recipe gives it, and as printed.
struct Suggested {
  std::vector<std::pair<int, Rational>> recipe;
  std::vector<std::pair<int, std::string>> printed;

  explicit Suggested(ComputedQuantities& quantities) {
    const auto& best = numerical_recipes()[quantities.recipes().best()];
    recipe.resize(last_n_of_figure_8);
    parallel_tasks(recipe.size(), quantities.jobs(), [&](std::size_t i) {
      const int n = static_cast<int>(i) + 1;
      const auto values = evaluate_numerical_recipe(
          best, make_scheme(statements::specification("primal", n)).mask.curve(), n);
      recipe[i] = {n, n * n * values.slope};
    });
    for (const statements::PublishedCell& cell : quantities.published("table3").cells)
      if (cell.d == 1 && cell.quantity == "n^2 max |psi'|") printed.emplace_back(cell.n.value(), cell.printed);
  }

  Rational recipe_at(int n) const { return recipe.at(static_cast<std::size_t>(n) - 1).second; }
  /// Whether the recipe is above what is certified wherever a value is printed but for n = 1, and at the last n.
  bool is_above(const Course& certified) const {
    std::vector<int> sizes{last_n_of_figure_8};
    for (const auto& [n, text] : printed)
      if (n > 1) sizes.push_back(n);
    return std::ranges::all_of(sizes, [&](int n) { return recipe_at(n) > n * n * *certified.slope_at(n).upper; });
  }
};

formats::Figure plot(const std::vector<Course>& courses, const Suggested& suggested) {
  formats::Panel values{"n max psi, and its limits", "n", "", {}, false, "top right"};
  formats::Panel deviations{"n max psi / C_d - 1", "n", "", {}, true, "top right"};
  formats::Panel slopes{"n^2 max |psi'|, certified", "n", "", {}, true, "top right"};
  formats::Panel degree_one{"n^2 max |psi'| for d = 1", "n", "", {}, true, "bottom left"};
  for (const Course& course : courses) {
    const std::string label = "d = " + std::to_string(course.degree);
    values.curves.push_back(scaled_curve(label, course.maxima, 1));
    slopes.curves.push_back(scaled_curve(label, course.slopes, 2));
    deviations.curves.push_back(scaled_curve(label, course.limit.deviation, 0));
  }
  for (const Course& course : courses) {
    const double limit = upper_as_double(course.limit.constant);
    const std::string label = course.degree == degrees().front() ? "limits C_d" : "";
    values.curves.push_back({label, {{1, limit}, {last_n_of_figure_8, limit}}});
  }
  formats::Curve printed{"printed in Table 3", {}, true}, recipe{"recipe", {}, true};
  for (const auto& [n, text] : suggested.printed) printed.points.emplace_back(n, std::stod(text));
  for (const auto& [n, value] : suggested.recipe) recipe.points.emplace_back(n, value.convert_to<double>());
  printed.joined = false;
  degree_one.curves = {scaled_curve("certified", courses.front().slopes, 2), recipe, printed};
  return {"conjecture7",
          "Conjecture 7, both halves",
          "Above: n max psi beside its limits (horizontal lines), and its distance from them. Below: n^2 max |psi'| "
          "(left), and for d = 1 beside the printed values and the recipe that agrees with most of their digits "
          "(right). Certified values have relative width 1e-6.",
          2,
          {values, deviations, slopes, degree_one}};
}

formats::PlainTable limits(const std::vector<Course>& courses) {
  const std::string last = std::to_string(last_n_of_figure_8);
  formats::PlainTable table{"conjecture7-limits",
                            "Limits of n max psi, and how near n = " + last + " is",
                            {"d", "C_d, the limit of n max psi", "n max psi at n = " + last, "n max psi / C_d - 1",
                             "falls like n^-r, r =", "n^2 max |psi'| at n = " + last},
                            {}};
  for (const Course& course : courses) {
    const LimitComparison& limit = course.limit;
    table.rows.push_back({std::to_string(course.degree), to_decimal(*limit.constant.lower, 22, Rounding::down) + "...",
                          shown(scaled(course.maxima.back().value, last_n_of_figure_8)),
                          shown(limit.deviation.back().value), shown(*limit.exponent),
                          shown(scaled(course.slopes.back().value, last_n_of_figure_8 * last_n_of_figure_8))});
  }
  return table;
}

std::string in_words(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  return text;
}

ConjectureDecay decay_of(const std::vector<Course>& courses) {
  ConjectureDecay decay;
  for (const Course& course : courses) {
    decay.maxima.push_back(decay_finding(1, course.maxima));
    decay.slopes.push_back(decay_finding(2, course.slopes));
  }
  return decay;
}

std::vector<std::string> story(const std::vector<Course>& courses, const Suggested& suggested,
                               const NumericalRecipeSearch& search) {
  const Course& first = courses.front();
  const ConjectureDecay decay = decay_of(courses);
  std::vector<std::string> sizes, printed, certified, by_recipe, constants, falls;
  for (const auto& [n, text] : suggested.printed) {
    if (n == 1) continue;  // the kink of the hat function, not of the rate
    sizes.push_back(std::to_string(n));
    printed.push_back(text);
    certified.push_back(to_decimal(n * n * *first.slope_at(n).upper, 3, Rounding::up));
    by_recipe.push_back(to_fixed(suggested.recipe_at(n), 4, Rounding::nearest));
  }
  for (const Course& course : courses) {
    const DecayFinding finding = decay_finding(2, course.slopes);
    constants.push_back(to_decimal(*course.limit.constant.lower, 7, Rounding::down) +
                        "... for d = " + std::to_string(course.degree));
    falls.push_back("like n^-" + to_fixed(*finding.exponent->lower, 1, Rounding::nearest) +
                    " for d = " + std::to_string(course.degree));
  }
  const std::string last = std::to_string(last_n_of_figure_8);
  const std::string above_certified = suggested.is_above(first)
                                          ? " All these are above the certified ones: the terms that such a sum leaves "
                                            "out have slopes of their own."
                                          : "";
  return {
      "What was conjectured. For every degree d, max psi ~ 1/n and max |psi'| ~ 1/n^2 (Conjecture 7); for d = 1 "
      "Theorem 6 of the paper proves both as bounds.",
      "What Table 3 suggested. Its caption reads the columns n max psi and n^2 max |psi'| as approximately constant. "
      "For d = 1 and n = " +
          in_words(sizes) + " it prints n^2 max |psi'| = " + in_words(printed) +
          ". Over all x, n^2 max |psi'| is proved to be at most " + in_words(certified) + " there.",
      "Where the printed values may come from. Of the " + std::to_string(search.cells()) + " printed values, " +
          std::to_string(search.cells_given()) +
          " agree with one numerical recipe: " + numerical_recipes()[search.best()].text() +
          ". For d = 1 and n = " + in_words(sizes) + " it gives n^2 max |psi'| = " + in_words(by_recipe) +
          " and at n = " + last + " still " + to_fixed(suggested.recipe_at(last_n_of_figure_8), 4, Rounding::nearest) +
          "." + above_certified + " What was really computed for the paper we cannot know.",
      "What is certified. " + conjecture_7_finding(decay) + " The limits of n max psi are " + in_words(constants) +
          "; between n = " + std::to_string(decay.slopes.front().rate_from) + " and n = " + last +
          " max |psi'| falls " + in_words(falls) + ".",
      "What is proved for every n. The limits C_d and that max |psi'| falls faster than every power of n: "
      "docs/limit-constants.md. Explicit bounds for the degrees up to 13: docs/theorems/README.md; their inequalities "
      "are run below."};
}

}  // namespace

formats::Section conjecture_7_section(ComputedQuantities& quantities) {
  quantities.need_variance(schemes_of_figure_8());
  quantities.say("conjecture7");
  std::vector<Course> courses;
  for (int degree : degrees()) courses.emplace_back(degree, quantities);
  const Suggested suggested(quantities);
  formats::Section section{"conjecture-7", "Conjecture 7: what is true",
                           story(courses, suggested, quantities.recipes())};
  section.finding = conjecture_7_finding(decay_of(courses));
  section.tables.push_back(limits(courses));
  section.figures.push_back(plot(courses, suggested));
  section.evidence = section.figures.back().panels.back();
  return section;
}

}  // namespace subcert::reports
