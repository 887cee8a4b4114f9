#include "conjecture_8.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/variance/variance_order.hpp>
#include <subcert/proofs-checks/verdict.hpp>
#include <subcert/schemes/specification.hpp>

#include <algorithm>

namespace subcert::conjectures {
namespace {

using sweeps::Json;

Json computed_comparison(const VariancePair& pair, const CaseBudget& budget) {
  VarianceOrderOptions options;
  options.deadline = Deadline::in(budget.seconds);
  const VarianceOrder order = compare_variance(make_scheme(pair.smaller.specification()).mask.curve(),
                                               make_scheme(pair.larger.specification()).mask.curve(), options);
  // The conjecture allows equality: curves that touch do not refute it.
  if (order.below == Truth::no && order.difference == 0)
    return {{"verdict", to_text(Truth::unknown)}, {"reason", "the curves touch at x = " + to_text(order.witness)}};
  Json json{{"verdict", to_text(order.below)}, {"reason", order.reason}};
  if (order.below == Truth::no) {
    json["witness"] = to_text(order.witness);
    json["difference"] = to_text(order.difference);
  }
  return json;
}

ComparisonRow read_comparison(const VariancePair& pair, const Json& json) {
  const std::string word = json.at("verdict");
  ComparisonRow row{pair, {Truth::unknown, json.at("reason")}, {}, {}};
  for (const Truth truth : {Truth::yes, Truth::no})
    if (to_text(truth) == word) row.holds.truth = truth;
  if (json.contains("witness")) row.witness = parse_rational(json.at("witness").get<std::string>());
  if (json.contains("difference")) row.difference = parse_rational(json.at("difference").get<std::string>());
  return row;
}

}  // namespace

std::size_t Conjecture8::count(Truth truth) const {
  return static_cast<std::size_t>(
      std::count_if(rows.begin(), rows.end(), [&](const ComparisonRow& row) { return row.holds.truth == truth; }));
}

std::optional<Conjecture8> check_conjecture_8(const PrimalSchemes& range, const CaseBudget& budget,
                                              const sweeps::SweepOptions& options) {
  const std::vector<VariancePair> pairs = neighbouring_pairs(range.schemes);
  if (pairs.empty()) fail(ErrorKind::usage, "conjecture 8 compares: give two different n or two different d");
  std::vector<sweeps::SweepCase> cases;
  for (const VariancePair& pair : pairs)
    cases.push_back({"variance order: " + pair.smaller.specification() + " <= " + pair.larger.specification() + ": " +
                         budget.text(),
                     static_cast<double>(pair.smaller.n)});
  const auto results = sweeps::run_sweep(
      cases, [&](std::size_t i) { return computed_comparison(pairs[i], budget); }, options);
  if (!results) return std::nullopt;
  Conjecture8 answer;
  std::vector<Truth> truths;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (!results->values[i]) continue;
    answer.rows.push_back(read_comparison(pairs[i], *results->values[i]));
    truths.push_back(answer.rows.back().holds.truth);
  }
  answer.verdict = all_of(truths);
  return answer;
}

}  // namespace subcert::conjectures
