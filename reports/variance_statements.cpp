#include "variance_statements.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/variance/variance_order.hpp>
#include <subcert/proofs-checks/conjectures/decay.hpp>
#include <subcert/schemes/specification.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace subcert::reports {
namespace {

constexpr int digits = 4;

Truth truth_of(bool yes, bool no) { return yes ? Truth::yes : no ? Truth::no : Truth::unknown; }

struct Answer {
  Truth truth;
  std::string text;
};

const VarianceFacts& facts_of(ComputedQuantities& quantities, int n, int degree = 1) {
  quantities.need_variance({statements::specification("primal", n, degree)});
  return quantities.variance(statements::specification("primal", n, degree));
}

/// psi_n <= 1, with strict inequality for n > 1.
Answer below_one(ComputedQuantities& quantities) {
  std::vector<Truth> truths;
  std::vector<std::string> bounds;
  for (int n = 1; n <= last_n_of_figure_2; ++n) {
    const Enclosure& maximum = facts_of(quantities, n).maximum;
    truths.push_back(n == 1 ? truth_of(*maximum.upper <= 1, *maximum.lower > 1)
                            : truth_of(*maximum.upper < 1, *maximum.lower >= 1));
    bounds.push_back(maximum.upper_text(digits));
  }
  return {all_of(truths), "max psi_n for n = 1, ..., 5 is at most " + fmt::format("{}", fmt::join(bounds, ", "))};
}

/// psi_1(x) = 1 at the integers.
Answer one_at_integers() {
  const Rational value = variance_at(make_scheme("primal:n=1").mask, 0, 0);
  return {truth_of(value == 1, value != 1), "psi_1(0) = " + to_text(value) + ", and psi_1 has period 1"};
}

Answer ordered(const std::string& smaller, const std::string& larger) {
  const VarianceOrder order = compare_variance(make_scheme(smaller).mask, make_scheme(larger).mask);
  // Equality is allowed.
  const Truth truth = order.below == Truth::no && order.difference == 0 ? Truth::unknown : order.below;
  return {truth, order.reason};
}

/// psi becomes smaller from each n to the next.
Answer decreasing_in_n(int first, int last, int degree) {
  std::vector<Truth> truths;
  std::vector<std::string> words;
  for (int n = first; n < last; ++n) {
    const Answer one = ordered(statements::specification("primal", n + 1, degree),
                               statements::specification("primal", n, degree));
    truths.push_back(one.truth);
    words.push_back("n = " + std::to_string(n) + " to " + std::to_string(n + 1) + ": " + one.text);
  }
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : "; ") + word;
  return {all_of(truths), text};
}

Answer increasing_in_d() {
  const Answer low = ordered(statements::specification("primal", 5, 1), statements::specification("primal", 5, 3));
  const Answer high = ordered(statements::specification("primal", 5, 3), statements::specification("primal", 5, 5));
  return {all_of({low.truth, high.truth}), "d = 1 and 3: " + low.text + "; d = 3 and 5: " + high.text};
}

/// The heights of the curves call for different scales: each is below half of the one before.
Answer different_scales(ComputedQuantities& quantities) {
  std::vector<Truth> truths;
  std::vector<std::string> words;
  Enclosure before;
  for (int n = 1; n <= last_n_of_figure_2; ++n) {
    const VarianceFacts& facts = facts_of(quantities, n);
    const Enclosure height{*facts.maximum.lower - *facts.minimum.upper, *facts.maximum.upper - *facts.minimum.lower};
    if (n > 1) truths.push_back(truth_of(2 * *height.upper < *before.lower, 2 * *height.lower >= *before.upper));
    before = height;
    words.push_back(to_decimal(*height.upper, 2, Rounding::up));
  }
  return {all_of(truths), "max psi_n - min psi_n is at most " + fmt::format("{}", fmt::join(words, ", ")) +
                              ", each below half of the one before"};
}

/// Theorem 6, first sentence: positive, symmetric, of period 1.
Answer positive_and_symmetric(ComputedQuantities& quantities) {
  std::vector<Truth> truths;
  std::vector<std::string> bounds;
  for (int n = 1; n <= last_n_of_figure_2; ++n) {
    const LaurentPolynomial symbol = make_scheme(statements::specification("primal", n)).mask.symbol();
    truths.push_back(truth_of(symbol == symbol.reversed(), symbol != symbol.reversed()));
    const Enclosure& minimum = facts_of(quantities, n).minimum;
    truths.push_back(truth_of(*minimum.lower > 0, *minimum.upper <= 0));
    bounds.push_back(minimum.lower_text(digits));
  }
  return {all_of(truths), "min psi_n for n = 1, ..., 5 is at least " + fmt::format("{}", fmt::join(bounds, ", ")) +
                              "; the masks are palindromes about 0; the period is 1 by definition"};
}

/// Whether a scaled maximum is approximately constant: its observed rate is that of the scaling.
Answer rate_over(ComputedQuantities& quantities, int degree, const std::vector<int>& sizes, bool slope) {
  std::vector<std::string> schemes;
  for (int n : sizes) schemes.push_back(statements::specification("primal", n, degree));
  quantities.need_variance(schemes);
  std::vector<conjectures::CertifiedMaximum> values;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const VarianceFacts& facts = quantities.variance(schemes[i]);
    values.push_back({sizes[i], slope ? facts.slope : facts.maximum});
  }
  const conjectures::DecayFinding finding = conjectures::decay_finding(slope ? 2 : 1, values);
  return {finding.rate.truth, finding.sentence(slope ? "max |psi'|" : "max psi")};
}

std::vector<int> sizes_of_figure_8(int degree) {
  std::vector<int> sizes;
  for (int n = (degree + 1) / 2; n <= last_n_of_figure_8; ++n) sizes.push_back(n);
  return sizes;
}

/// The sizes of a sentence about Figure 8 or about Table 3, whose cells of one degree stand together.
std::vector<int> sizes_of(const statements::PublishedCell& sentence, ComputedQuantities& quantities) {
  const int degree = sentence.d.value();
  if (sentence.over == "Figure 8") return sizes_of_figure_8(degree);
  std::vector<int> sizes;
  for (const statements::PublishedCell& cell : quantities.published("table3").cells)
    if (cell.d == degree && (sizes.empty() || sizes.back() != *cell.n)) sizes.push_back(*cell.n);
  return sizes;
}

using Answerer = Answer (*)(const statements::PublishedCell&, ComputedQuantities&);

/// The answers by the quantity that a sentence is about.
const std::map<std::string, Answerer> answers{
    {"below one", [](const auto&, ComputedQuantities& all) { return below_one(all); }},
    {"one at integers", [](const auto&, ComputedQuantities&) { return one_at_integers(); }},
    {"smaller with n", [](const auto&, ComputedQuantities&) { return decreasing_in_n(1, last_n_of_figure_2, 1); }},
    {"scales", [](const auto&, ComputedQuantities& all) { return different_scales(all); }},
    {"positive", [](const auto&, ComputedQuantities& all) { return positive_and_symmetric(all); }},
    {"larger with d", [](const auto&, ComputedQuantities&) { return increasing_in_d(); }},
    {"smaller with n for d = 3", [](const auto&, ComputedQuantities&) { return decreasing_in_n(2, 7, 3); }},
    {"n max psi",
     [](const auto& cell, ComputedQuantities& all) { return rate_over(all, *cell.d, sizes_of(cell, all), false); }},
    {"n^2 max |psi'|",
     [](const auto& cell, ComputedQuantities& all) { return rate_over(all, *cell.d, sizes_of(cell, all), true); }},
};

Answer answer(const statements::PublishedCell& cell, ComputedQuantities& quantities) {
  const auto found = answers.find(cell.quantity);
  require(found != answers.end(), "unknown statement '{}'", cell.quantity);
  return found->second(cell, quantities);
}

}  // namespace

std::vector<std::string> schemes_of_figure_2() {
  std::vector<std::string> schemes;
  for (int n = 1; n <= last_n_of_figure_2; ++n) schemes.push_back(statements::specification("primal", n));
  return schemes;
}

std::vector<std::string> schemes_of_figure_8() {
  std::vector<std::string> schemes;
  for (int degree : {1, 3, 5})
    for (int n : sizes_of_figure_8(degree)) schemes.push_back(statements::specification("primal", n, degree));
  return schemes;
}

std::vector<std::string> schemes_of_figure_9() {
  std::vector<std::string> schemes;
  for (int degree : {1, 3, 5}) schemes.push_back(statements::specification("primal", 5, degree));
  for (int n : {3, 4, 6, 7}) schemes.push_back(statements::specification("primal", n, 3));
  return schemes;
}

formats::ComparisonTable compare_statements(const statements::PublishedTable& table, ComputedQuantities& quantities) {
  formats::ComparisonTable result = empty_table(table);
  for (const statements::PublishedCell& cell : table.cells) {
    const Answer given = answer(cell, quantities);
    result.comparisons.push_back(compare_text(cell, given.text, given.truth));
  }
  return result;
}

}  // namespace subcert::reports
