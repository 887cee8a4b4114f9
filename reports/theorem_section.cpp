#include "sections.hpp"

#include "story_sentences.hpp"

#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>
#include <subcert/analysis/variance/variance.hpp>
#include <subcert/proofs-checks/theorems/degree_one.hpp>
#include <subcert/proofs-checks/theorems/theorem.hpp>
#include <subcert/schemes/specification.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace subcert::reports {
namespace {

constexpr int grid_level = 5;  ///< of the exact values between which the ripple is seen

struct TheoremCase {
  const char* id;
  std::vector<int> degrees;
};

/// Conjecture 7 first: what it encloses serves the others too.
const std::vector<TheoremCase>& theorem_cases() {
  static const std::vector<TheoremCase> list{{"conjecture-7", {1, 3, 5, 7, 9}}, {"conjecture-8-n", {1, 3, 5, 7, 9}},
                                             {"conjecture-8-d", {1, 3, 5, 7}},  {"conjecture-8-d-all", {1, 3, 5, 7}},
                                             {"conjecture-8-d-large", {13}},    {"convergence", {1}},
                                             {"limit-constants-order", {1}},    {"smoothness", {1}},
                                             {"smoothness-dual", {1}}};
  return list;
}

std::string verdict_word(Truth truth) {
  return truth == Truth::yes ? "holds" : truth == Truth::no ? "fails" : "unknown";
}

std::string range(const std::string& id) {
  for (const theorems::TheoremEntry& entry : theorems::theorem_list())
    if (entry.id == id) return entry.range;
  return "";
}

Mask scheme(int n, int degree) {
  return make_scheme("primal:n=" + std::to_string(n) + ",d=" + std::to_string(degree)).mask.curve();
}

double plain(const Rational& value) { return value.convert_to<double>(); }

/// Means, and largest minus smallest exact value on a grid, over n = 1, 2, 3, 4, 6, 8, 12, ...
formats::Figure mean_and_ripple() {
  formats::Panel means{"mean of psi_n", "n", "", {}, true},
      ripples{"largest minus smallest value of psi_n", "n", "", {}, true};
  for (int degree : {1, 3, 5}) {
    formats::Curve mean{"d = " + std::to_string(degree), {}, true}, ripple = mean;
    for (int n = (degree + 1) / 2; n <= 24; n += n < 12 ? 1 : 3) {
      const Mask mask = scheme(n, degree);
      const VarianceGrid grid = variance_grid(mask, grid_level, false);
      mean.points.emplace_back(n, plain(squared_l2_norm(mask)));
      ripple.points.emplace_back(n, plain(grid.largest() - grid.smallest()));
    }
    means.curves.push_back(mean);
    ripples.curves.push_back(ripple);
  }
  formats::Curve bound{"proved bound, d = 1", {}, true};
  for (int n = 3; n <= 24; n += n < 12 ? 1 : 3)
    bound.points.emplace_back(n, plain(2 * *theorems::degree_one_bounds(n).ripple.upper));
  ripples.curves.push_back(bound);
  return {"theorems-plot",
          "Mean and ripple of the variance curves over n",
          "Exact means, and differences of exact values on the grid of step 1/" + std::to_string(1 << grid_level) +
              ", on logarithmic scales; above them twice the proved bound of |psi_n - mean|.",
          2,
          {means, ripples}};
}

/// Side by side, as each has parts that one thread does alone; they are kept for those who ask again.
void prove_all(const ReportOptions& options) {
  std::vector<std::pair<std::string, int>> asked;
  for (const TheoremCase& one : theorem_cases())
    for (const int degree : one.degrees) asked.emplace_back(one.id, degree);
  parallel_tasks(asked.size(), options.jobs, [&](std::size_t i) {
    const auto& [id, degree] = asked[i];
    if (options.progress) options.progress("theorem " + id + ", d = " + std::to_string(degree));
    theorems::proved(id, degree, "primal", options.jobs);
  });
}

}  // namespace

formats::Section theorem_section(const ReportOptions& options) {
  formats::Section section{"theorems", "Conjectures 7 and 8, and smoothness, for every n", {}};
  formats::PlainTable table{"theorems",
                            "Theorems, and the inequalities behind them",
                            {"theorem", "degrees", "range", "inequalities", "verdict"},
                            {}};
  std::vector<std::pair<std::string, Truth>> decided;
  std::vector<std::string> statements;
  prove_all(options);
  for (const TheoremCase& one : theorem_cases())
    for (int degree : one.degrees) {
      const theorems::Theorem& theorem = theorems::proved(one.id, degree, "primal", options.jobs);
      table.rows.push_back({one.id, fmt::format("{}", fmt::join(theorem.degrees, ", ")), range(one.id),
                            std::to_string(theorem.checks.size()), verdict_word(theorem.decision.truth)});
      decided.emplace_back(fmt::format("{}, d = {}", one.id, degree), theorem.decision.truth);
      if (!theorem.decision.is_yes()) continue;
      std::string statement = theorem.title + ".";
      for (const std::string& sentence : theorem.statement) statement += " " + sentence;
      statements.push_back(statement);
    }
  section.paragraphs.push_back(
      "Conjecture 7: for each degree, max psi_n ~ 1/n and max |psi_n'| ~ 1/n^2. Conjecture 8: psi_n decreases "
      "pointwise in n and increases pointwise in the degree d. A table supports such sentences up to some n, a theorem "
      "for every n. " +
      theorems_sentence(decided) +
      " Their proofs are two papers, named in docs/theorems/README.md, and rest on numbered inequalities ('subcert "
      "theorem ID --d D' prints them with their margins).");
  section.paragraphs.insert(section.paragraphs.end(), statements.begin(), statements.end());
  section.tables.push_back(table);
  section.figures.push_back(mean_and_ripple());
  return section;
}

}  // namespace subcert::reports
