// The sentences about Figures 2, 8 and 9, by certified extremes of variance curves.

#include "figure_sentences.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/variance/variance_order.hpp>
#include <subcert/proofs-checks/conjectures/decay.hpp>
#include <subcert/proofs-checks/statements/computed.hpp>
#include <subcert/proofs-checks/verdict.hpp>

#include <fmt/ranges.h>

#include <map>

namespace subcert::statements::dyn_2015 {
namespace {

constexpr int digits = 4;

using Extremes = std::function<VarianceExtremes(const std::string& scheme)>;

std::string s_n_d(int n, int degree) { return specification("primal", n, degree); }

Truth truth_of(bool yes, bool no) { return yes ? Truth::yes : no ? Truth::no : Truth::unknown; }

/// The n with 2n data enough for the degree.
std::vector<int> sizes_of_figure_8(int degree) {
  std::vector<int> sizes;
  for (int n = (degree + 1) / 2; n <= last_n_of_figure_8; ++n) sizes.push_back(n);
  return sizes;
}

/// psi_n <= 1, with strict inequality for n > 1.
DecidedSentence below_one(const Extremes& extremes) {
  std::vector<Truth> truths;
  std::vector<std::string> bounds;
  for (int n = 1; n <= last_n_of_figure_2; ++n) {
    const Enclosure maximum = extremes(s_n_d(n, 1)).maximum;
    truths.push_back(n == 1 ? truth_of(*maximum.upper <= 1, *maximum.lower > 1)
                            : truth_of(*maximum.upper < 1, *maximum.lower >= 1));
    bounds.push_back(maximum.upper_text(digits));
  }
  return {all_of(truths), "max psi_n for n = 1, ..., 5 is at most " + fmt::format("{}", fmt::join(bounds, ", "))};
}

/// psi_1(x) = 1 at the integers.
DecidedSentence one_at_integers() {
  const Rational value = variance_at(mask_of("primal:n=1"), 0, 0);
  return {truth_of(value == 1, value != 1), "psi_1(0) = " + to_text(value) + ", and psi_1 has period 1"};
}

DecidedSentence ordered(const std::string& smaller, const std::string& larger) {
  const VarianceOrder& order = variance_order_of(smaller, larger);
  // Equality is allowed.
  const Truth truth = order.below == Truth::no && order.difference == 0 ? Truth::unknown : order.below;
  return {truth, order.reason};
}

/// psi becomes smaller from each n to the next.
DecidedSentence decreasing_in_n(int first, int last, int degree) {
  std::vector<Truth> truths;
  std::vector<std::string> words;
  for (int n = first; n < last; ++n) {
    const DecidedSentence one = ordered(s_n_d(n + 1, degree), s_n_d(n, degree));
    truths.push_back(one.truth);
    words.push_back("n = " + std::to_string(n) + " to " + std::to_string(n + 1) + ": " + one.text);
  }
  return {all_of(truths), fmt::format("{}", fmt::join(words, "; "))};
}

DecidedSentence increasing_in_d() {
  const DecidedSentence low = ordered(s_n_d(5, 1), s_n_d(5, 3));
  const DecidedSentence high = ordered(s_n_d(5, 3), s_n_d(5, 5));
  return {all_of({low.truth, high.truth}), "d = 1 and 3: " + low.text + "; d = 3 and 5: " + high.text};
}

/// The heights of the curves call for different scales: each is below half of the one before.
DecidedSentence different_scales(const Extremes& extremes) {
  std::vector<Truth> truths;
  std::vector<std::string> words;
  Enclosure before;
  for (int n = 1; n <= last_n_of_figure_2; ++n) {
    const VarianceExtremes found = extremes(s_n_d(n, 1));
    const Enclosure height{*found.maximum.lower - *found.minimum.upper, *found.maximum.upper - *found.minimum.lower};
    if (n > 1) truths.push_back(truth_of(2 * *height.upper < *before.lower, 2 * *height.lower >= *before.upper));
    before = height;
    words.push_back(to_decimal(*height.upper, 2, Rounding::up));
  }
  return {all_of(truths), "max psi_n - min psi_n is at most " + fmt::format("{}", fmt::join(words, ", ")) +
                              ", each below half of the one before"};
}

/// Theorem 6, first sentence: positive, symmetric, of period 1.
DecidedSentence positive_and_symmetric(const Extremes& extremes) {
  std::vector<Truth> truths;
  std::vector<std::string> bounds;
  for (int n = 1; n <= last_n_of_figure_2; ++n) {
    const LaurentPolynomial symbol = mask_of(s_n_d(n, 1)).symbol();
    truths.push_back(truth_of(symbol == symbol.reversed(), symbol != symbol.reversed()));
    const Enclosure minimum = extremes(s_n_d(n, 1)).minimum;
    truths.push_back(truth_of(*minimum.lower > 0, *minimum.upper <= 0));
    bounds.push_back(minimum.lower_text(digits));
  }
  return {all_of(truths), "min psi_n for n = 1, ..., 5 is at least " + fmt::format("{}", fmt::join(bounds, ", ")) +
                              "; the masks are palindromes about 0; the period is 1 by definition"};
}

/// Whether a scaled maximum of the curves of Figure 8 or of Table 3 is approximately constant: its observed rate is
/// that of the scaling.
DecidedSentence rate_over(const PublishedCell& sentence, const Paper& paper, const Extremes& extremes, bool slope) {
  const int degree = sentence.d.value();
  std::vector<int> sizes;
  if (sentence.over == "Figure 8")
    sizes = sizes_of_figure_8(degree);
  else
    for (const PublishedCell& cell : paper.table("table3").cells)  // the cells of one degree stand together
      if (cell.d == degree && (sizes.empty() || sizes.back() != *cell.n)) sizes.push_back(*cell.n);
  std::vector<conjectures::CertifiedMaximum> values;
  for (const int n : sizes) {
    const VarianceExtremes found = extremes(s_n_d(n, degree));
    values.push_back({n, slope ? found.slope : found.maximum});
  }
  const conjectures::DecayFinding finding = conjectures::decay_finding(slope ? 2 : 1, values);
  return {finding.rate.truth, finding.sentence(slope ? "max |psi'|" : "max psi")};
}

using Decide = DecidedSentence (*)(const PublishedCell&, const Paper&, const Extremes&);

/// By the quantity that a sentence is about.
const std::map<std::string, Decide> decisions{
    {"below one", [](const auto&, const auto&, const Extremes& all) { return below_one(all); }},
    {"one at integers", [](const auto&, const auto&, const Extremes&) { return one_at_integers(); }},
    {"smaller with n",
     [](const auto&, const auto&, const Extremes&) { return decreasing_in_n(1, last_n_of_figure_2, 1); }},
    {"scales", [](const auto&, const auto&, const Extremes& all) { return different_scales(all); }},
    {"positive", [](const auto&, const auto&, const Extremes& all) { return positive_and_symmetric(all); }},
    {"larger with d", [](const auto&, const auto&, const Extremes&) { return increasing_in_d(); }},
    {"smaller with n for d = 3", [](const auto&, const auto&, const Extremes&) { return decreasing_in_n(2, 7, 3); }},
    {"n max psi", [](const auto& s, const auto& p, const Extremes& all) { return rate_over(s, p, all, false); }},
    {"n^2 max |psi'|", [](const auto& s, const auto& p, const Extremes& all) { return rate_over(s, p, all, true); }},
};

}  // namespace

std::vector<std::string> schemes_of_figure_2() {
  std::vector<std::string> schemes;
  for (int n = 1; n <= last_n_of_figure_2; ++n) schemes.push_back(specification("primal", n));
  return schemes;
}

std::vector<std::string> schemes_of_figure_8() {
  std::vector<std::string> schemes;
  for (const int degree : {1, 3, 5})
    for (const int n : sizes_of_figure_8(degree)) schemes.push_back(s_n_d(n, degree));
  return schemes;
}

std::vector<std::string> schemes_of_figure_9() {
  std::vector<std::string> schemes;
  for (const int degree : {1, 3, 5}) schemes.push_back(s_n_d(5, degree));
  for (const int n : {3, 4, 6, 7}) schemes.push_back(s_n_d(n, 3));
  return schemes;
}

DecidedSentence decide_sentence(const PublishedCell& sentence, const Paper& paper, const Extremes& extremes) {
  const auto found = decisions.find(sentence.quantity);
  require(found != decisions.end(), "unknown statement '{}'", sentence.quantity);
  return found->second(sentence, paper, extremes);
}

}  // namespace subcert::statements::dyn_2015
