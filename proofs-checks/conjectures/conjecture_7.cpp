
#include "conjecture_7.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/variance/variance_range.hpp>
#include <subcert/proofs-checks/sweeps/journal.hpp>
#include <subcert/proofs-checks/theorems/limit_constant.hpp>
#include <subcert/proofs-checks/verdict.hpp>
#include <subcert/schemes/specification.hpp>

#include <sstream>

namespace subcert::conjectures {
namespace {

using sweeps::Json;

Json computed_row(const PrimalScheme& scheme, const CaseBudget& budget) {
  VarianceOptions options;
  options.relative_width = Rational(budget.relative_width);
  options.budget.deadline = Deadline::in(budget.seconds);
  const VarianceRange range = variance_range(make_scheme(scheme.specification()).mask.curve(), options);
  return {{"sup", sweeps::exact_json(range.maximum)},
          {"derivative_sup", range.slope ? sweeps::exact_json(*range.slope) : Json()},
          {"derivative_reason", range.slope_reason},
          {"mean", to_text(range.mean)},
          {"complete", range.complete}};
}

VarianceRow read_row(const PrimalScheme& scheme, const Json& json) {
  VarianceRow row{
      scheme, sweeps::enclosure_from(json.at("sup")), {}, json.at("derivative_reason"), 0, json.at("complete")};
  if (!json.at("derivative_sup").is_null()) row.slope = sweeps::enclosure_from(json.at("derivative_sup"));
  const auto mean = parse_rational(json.at("mean").get<std::string>());
  require(mean.has_value(), "conjecture 7: the mean of {} is no number", scheme.specification());
  row.mean = *mean;
  return row;
}

/// The rows of each degree, as decay_finding takes them.
struct DegreeValues {
  std::vector<CertifiedMaximum> sups, slopes;
};

std::map<int, DegreeValues> values_by_degree(const std::vector<VarianceRow>& rows) {
  std::map<int, DegreeValues> values;
  for (const VarianceRow& row : rows) {
    DegreeValues& degree = values[row.scheme.d];
    const bool interpolates = row.scheme.d >= 2 * row.scheme.n - 2;
    degree.sups.push_back({row.scheme.n, row.sup, interpolates});
    if (row.slope) degree.slopes.push_back({row.scheme.n, *row.slope, interpolates});
  }
  return values;
}

}  // namespace

std::string CaseBudget::text() const {
  std::ostringstream text;  // six digits, as journals have it
  text << "relative width " << relative_width << ", " << seconds << " seconds";
  return text.str();
}

std::optional<Enclosure> Conjecture7::deviation(const PrimalScheme& scheme) const {
  const auto found = limits.find(scheme.d);
  if (found == limits.end()) return std::nullopt;
  for (const CertifiedMaximum& one : found->second.deviation)
    if (one.n == scheme.n) return one.value;
  return std::nullopt;
}

std::optional<Conjecture7> check_conjecture_7(const PrimalSchemes& range, const CaseBudget& budget,
                                              const sweeps::SweepOptions& options) {
  std::vector<sweeps::SweepCase> cases;
  for (const PrimalScheme& scheme : range.schemes)
    cases.push_back(
        {"variance range: " + scheme.specification() + ": " + budget.text(), static_cast<double>(scheme.n)});
  const auto results = sweeps::run_sweep(
      cases, [&](std::size_t i) { return computed_row(range.schemes[i], budget); }, options);
  if (!results) return std::nullopt;
  Conjecture7 answer;
  std::vector<Truth> truths;
  for (std::size_t i = 0; i < range.schemes.size(); ++i) {
    if (!results->values[i]) continue;
    answer.rows.push_back(read_row(range.schemes[i], *results->values[i]));
    truths.push_back(answer.rows.back().complete ? Truth::yes : Truth::unknown);
  }
  for (const auto& [d, values] : values_by_degree(answer.rows)) {
    if (const auto limit = limit_comparison(d, values.sups)) answer.limits.emplace(d, *limit);
    if (!options.shard.is_whole()) continue;
    answer.findings.push_back({d, "max psi", decay_finding(1, values.sups)});
    if (!values.slopes.empty()) answer.findings.push_back({d, "max |psi'|", decay_finding(2, values.slopes)});
  }
  for (const DegreeDecay& finding : answer.findings)
    if (finding.decay.exponent) {
      answer.has_rate = true;
      truths.push_back(finding.decay.upper_bound.truth);
    }
  answer.verdict = all_of(truths);
  return answer;
}

namespace {

constexpr int largest_degree = 99;
constexpr int constant_digits = 25;

Enclosure deviation_of(const CertifiedMaximum& maximum, const Enclosure& constant) {
  Enclosure result;
  if (maximum.value.lower) result.lower = maximum.n * *maximum.value.lower / *constant.upper - 1;
  if (maximum.value.upper) result.upper = maximum.n * *maximum.value.upper / *constant.lower - 1;
  return result;
}

}  // namespace

std::optional<LimitComparison> limit_comparison(int degree, const std::vector<CertifiedMaximum>& maxima) {
  if (degree > largest_degree) return std::nullopt;
  LimitComparison result;
  result.degree = degree;
  result.constant = theorems::limit_constant(degree, constant_digits);
  for (const CertifiedMaximum& maximum : maxima)
    result.deviation.push_back({maximum.n, deviation_of(maximum, result.constant)});
  if (maxima.size() < 2) return result;
  const CertifiedMaximum& half = result.deviation[rate_start(maxima)];
  result.rate_from = half.n;
  result.exponent = decay_exponent(half.n, half.value, result.deviation.back().n, result.deviation.back().value);
  return result;
}

std::string LimitComparison::sentence() const {
  std::string text = "the proved limit of n max psi for n to infinity is C_" + std::to_string(degree) + " = " +
                     to_decimal(*constant.lower, 22, Rounding::down) + "...; n max psi / C_" + std::to_string(degree) +
                     " - 1 is " + shown(deviation.back().value) + " at n = " + std::to_string(deviation.back().n);
  if (exponent && exponent->is_bounded())
    text += " and falls like n^-r with r = " + shown(*exponent) + " from n = " + std::to_string(rate_from) + " on";
  return text + ".";
}

}  // namespace subcert::conjectures
