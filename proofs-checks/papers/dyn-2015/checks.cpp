
#include "checks.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/numbers/interval.hpp>
#include <subcert/proofs-checks/statements/computed.hpp>
#include <subcert/proofs-checks/statements/mask_form.hpp>
#include <subcert/proofs-checks/theorems/theorem.hpp>
#include <subcert/schemes/local_regression.hpp>
#include <subcert/schemes/specification.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace subcert::statements::dyn_2015 {
Checks checks() {
  return joined({section_2(), section_2_2(), section_2_2_theorem_5(), section_3(), section_4(), section_4_3(),
                 section_5(), appendix()});
}

Mask s_n(long n) { return regression_mask(primal(static_cast<int>(n), 1)); }

std::string range(int first, int last) {
  return "n = " + std::to_string(first) + (first == last ? "" : ".." + std::to_string(last));
}

std::string at_n_d(int n, int d) { return at("n", n) + ", " + at("d", d); }

ScaledMaximum scaled_maximum(const PublishedCell& cell) {
  const int n = cell.n.value();
  if (cell.quantity == "max psi") return {false, 1};
  if (cell.quantity == "n max psi") return {false, n};
  if (cell.quantity == "max |psi'|") return {true, 1};
  if (cell.quantity == "n^2 max |psi'|") return {true, n * n};
  fail(ErrorKind::domain, "need a maximum of psi or of |psi'|, got '{}'", cell.quantity);
}

Trial proved_theorem(const std::string& theorem, int degree, const std::string& family) {
  const Decision& proof = theorems::proved(theorem, degree, family).decision;
  Trial trial;
  trial.require(proof.is_yes(), proof.reason);
  return trial;
}

namespace {

/// `1.3 %`, or `a factor of 29.6` beyond a tenth.
std::string distance_text(const Rational& ratio) {
  return ratio < Rational(11, 10) ? to_decimal(100 * (ratio - 1), 2, Rounding::up) + " %"
                                  : "a factor of " + to_decimal(ratio, 3, Rounding::down);
}

/// How far the numbers that do not agree are from the certified ones; empty where all agree.
std::string distances(const std::vector<std::string>& printed, const std::function<Enclosure(std::size_t)>& certified) {
  std::vector<Rational> ratios;
  for (std::size_t i = 0; i < printed.size(); ++i) {
    const Rational value = read_decimal(printed[i]).value;
    const Enclosure truth = certified(i);
    if (value > 0 && truth.lower && *truth.lower > 0 && agrees(read_decimal(printed[i]), truth) == Truth::no)
      ratios.push_back(std::max(value / *truth.lower, *truth.upper / value));
  }
  if (ratios.empty()) return "";
  const auto [least, most] = std::ranges::minmax_element(ratios);
  return fmt::format("{} of {} numbers are off by more than a unit of the last place, by {}{}", ratios.size(),
                     printed.size(), distance_text(*least), ratios.size() == 1 ? "" : " to " + distance_text(*most));
}

}  // namespace

Outcome table_words(const Context& context, const std::string& id) {
  const std::vector<PublishedCell> cells = context.cells(id);
  std::vector<std::string> labels;
  for (const PublishedCell& cell : cells)
    labels.push_back((cell.d ? at("d", *cell.d) + ", " : "") + at("n", cell.n.value()));
  const auto certified = [&](std::size_t i) {
    const std::string scheme = make_scheme(cells[i].scheme).specification;
    if (cells[i].quantity == "bound after 16 levels") return holder_bound_of(scheme).exponent;
    const ScaledMaximum what = scaled_maximum(cells[i]);
    const VarianceRange& range = variance_of(scheme);
    return scaled(what.slope ? *range.slope : range.maximum, what.factor);
  };
  Outcome outcome = not_a_slip(
      in_both_forms([&](Form form) { return table_row(context.words(id, form), labels, certified); }));
  const bool corrected = outcome.argument.empty();
  if (!corrected) outcome.witness += "; " + outcome.argument;
  outcome.argument = distances(context.words(id), certified);
  return outcome;
}

std::vector<std::string> schemes_of_figure_2() {
  std::vector<std::string> schemes;
  for (int n = 1; n <= last_n_of_figure_2; ++n) schemes.push_back(specification("primal", n));
  return schemes;
}

std::vector<std::string> schemes_of_figure_8() {
  std::vector<std::string> schemes;
  for (const int degree : {1, 3, 5})
    for (int n = (degree + 1) / 2; n <= last_n_of_figure_8; ++n) schemes.push_back(specification("primal", n, degree));
  return schemes;
}

std::vector<std::string> schemes_of_figure_9() {
  std::vector<std::string> schemes;
  for (const int degree : {1, 3, 5}) schemes.push_back(specification("primal", 5, degree));
  for (const int n : {3, 4, 6, 7}) schemes.push_back(specification("primal", n, 3));
  return schemes;
}

}  // namespace subcert::statements::dyn_2015
