// subcert conjecture 7|8: certified tables and verdicts over ranges of n and d

#include "sweep_arguments.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/symbol/interval.hpp>
#include <subcert/analysis/variance/variance_order.hpp>
#include <subcert/analysis/variance/variance_range.hpp>
#include <subcert/proofs-checks/verdict.hpp>
#include <subcert/reports/conjecture_limit.hpp>
#include <subcert/reports/conjectures.hpp>
#include <subcert/reports/sweep/number_list.hpp>

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <map>
#include <optional>
#include <sstream>

namespace subcert::cli {
namespace {

struct ConjectureOptions : CommonOptions, SweepArguments {
  int number = 7;
  std::string n = "1..40";
  std::string d = "1,3,5";
  double width = 1e-6;
  double budget = 60;
};

constexpr int largest_n = 2047, largest_d = 2 * largest_n - 1;

std::string budget_text(const ConjectureOptions& options) {
  std::ostringstream text;
  text << "relative width " << options.width << ", " << options.budget << " seconds";
  return text.str();
}

subcert::VarianceOptions variance_options(const ConjectureOptions& options) {
  subcert::VarianceOptions result;
  result.relative_width = Rational(options.width);
  result.budget.deadline = Deadline::in(options.budget);
  return result;
}

Json skipped_json(const reports::PrimalSchemes& range) {
  Json skipped = Json::array();
  for (const auto& one : range.skipped)
    skipped.push_back({{"scheme", one.scheme.specification()}, {"reason", one.reason()}});
  return skipped;
}

std::string skipped_text(const reports::PrimalSchemes& range) {
  std::string text;
  for (const std::string& line : range.skipped_lines()) text += "left out: " + line + "\n";
  return text;
}

/// Columns as wide as their widest word.
std::string table_text(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) line += row[i] + std::string(widths[i] - row[i].size() + 2, ' ');
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

Json answer_head(const ConjectureOptions& options, const sweeps::SweepOptions& sweep) {
  Json json{{"conjecture", options.number}, {"n", options.n}, {"d", options.d}};
  if (!sweep.shard.is_whole()) json["shard"] = options.shard;
  return json;
}

std::string shard_note(const ConjectureOptions& options) {
  return "shard " + options.shard + ": no verdict; join the journals with 'subcert merge' and run without --shard\n";
}

std::string verdict_text(Truth truth) {
  return truth == Truth::yes ? "holds" : truth == Truth::no ? "violated" : "undecided";
}

// Conjecture 7

Json range_json(const VarianceRange& range) {
  Json json{{"sup", reports::exact_json(range.maximum)}};
  json["derivative_sup"] = range.slope ? reports::exact_json(*range.slope) : Json();
  json["derivative_reason"] = range.slope_reason;
  json["mean"] = to_text(range.mean);
  json["complete"] = range.complete;
  return json;
}

struct Row {
  reports::PrimalScheme scheme;
  Enclosure sup;
  std::optional<Enclosure> slope;
  std::string slope_reason;
  std::string mean;
  bool complete = false;

  Row(const reports::PrimalScheme& of, const Json& json)
      : scheme(of),
        sup(reports::enclosure_from(json.at("sup"))),
        slope_reason(json.at("derivative_reason")),
        mean(json.at("mean")),
        complete(json.at("complete")) {
    if (!json.at("derivative_sup").is_null()) slope = reports::enclosure_from(json.at("derivative_sup"));
  }
};

/// n max psi / C_d - 1 for each degree that the rows have.
using Limits = std::map<int, reports::LimitComparison>;

Limits limits_of(const std::vector<Row>& rows) {
  std::map<int, std::vector<reports::CertifiedMaximum>> maxima;
  for (const Row& row : rows) maxima[row.scheme.d].push_back({row.scheme.n, row.sup});
  Limits limits;
  for (const auto& [degree, values] : maxima)
    if (const auto limit = reports::limit_comparison(degree, values)) limits.emplace(degree, *limit);
  return limits;
}

/// Nothing for degrees without a constant.
std::optional<Enclosure> deviation_of(const Row& row, const Limits& limits) {
  const auto found = limits.find(row.scheme.d);
  if (found == limits.end()) return std::nullopt;
  for (const reports::CertifiedMaximum& one : found->second.deviation)
    if (one.n == row.scheme.n) return one.value;
  return std::nullopt;
}

Json constant_json(const reports::LimitComparison& limit) {
  constexpr int digits = 26;
  return {{"lower", limit.constant.lower_text(digits)}, {"upper", limit.constant.upper_text(digits)}};
}

Json row_json(const Row& row, const Limits& limits) {
  const int n = row.scheme.n;
  Json json{{"d", row.scheme.d},
            {"n", n},
            {"scheme", row.scheme.specification()},
            {"sup", enclosure_json(row.sup)},
            {"n_sup", enclosure_json(scaled(row.sup, n))}};
  const auto deviation = deviation_of(row, limits);
  json["limit_constant"] = deviation ? constant_json(limits.at(row.scheme.d)) : Json();
  json["limit_deviation"] = deviation ? enclosure_json(*deviation) : Json();
  json["derivative_sup"] = row.slope ? enclosure_json(*row.slope) : Json();
  json["n2_derivative_sup"] = row.slope ? enclosure_json(scaled(*row.slope, n * n)) : Json();
  if (!row.slope) json["derivative_reason"] = row.slope_reason;
  json["mean"] = row.mean;
  json["complete"] = row.complete;
  return json;
}

struct DegreeDecay {
  int d;
  std::string quantity;
  reports::DecayFinding decay;
};

std::vector<DegreeDecay> findings_of(const std::vector<Row>& rows) {
  std::vector<DegreeDecay> findings;
  for (std::size_t begin = 0; begin < rows.size();) {
    std::size_t end = begin;
    std::vector<reports::CertifiedMaximum> sups, slopes;
    for (; end < rows.size() && rows[end].scheme.d == rows[begin].scheme.d; ++end) {
      sups.push_back({rows[end].scheme.n, rows[end].sup});
      if (rows[end].slope) slopes.push_back({rows[end].scheme.n, *rows[end].slope});
    }
    findings.push_back({rows[begin].scheme.d, "max psi", reports::decay_finding(1, sups)});
    if (!slopes.empty()) findings.push_back({rows[begin].scheme.d, "max |psi'|", reports::decay_finding(2, slopes)});
    begin = end;
  }
  return findings;
}

Json finding_json(const DegreeDecay& finding) {
  const reports::DecayFinding& decay = finding.decay;
  Json json{{"d", finding.d},
            {"quantity", finding.quantity},
            {"power", decay.power},
            {"largest", enclosure_json(decay.largest)},
            {"smallest", enclosure_json(decay.smallest)}};
  if (decay.exponent) {
    json["exponent"] = enclosure_json(*decay.exponent);
    json["exponent_n"] = {decay.rate_from, decay.last_n};
  }
  json["upper_bound"] = to_text(decay.upper_bound.truth);
  json["rate"] = to_text(decay.rate.truth);
  json["sentence"] = decay.sentence(finding.quantity);
  return json;
}

Json limit_json(const reports::LimitComparison& limit) {
  Json json{{"d", limit.degree}, {"constant", constant_json(limit)}};
  if (limit.exponent) {
    json["deviation_exponent"] = enclosure_json(*limit.exponent);
    json["exponent_n"] = {limit.rate_from, limit.deviation.back().n};
  }
  json["sentence"] = limit.sentence();
  return json;
}

ExitCode conjecture_7(const ConjectureOptions& options, const reports::PrimalSchemes& range) {
  std::vector<sweeps::SweepCase> cases;
  for (const reports::PrimalScheme& scheme : range.schemes)
    cases.push_back(
        {"variance range: " + scheme.specification() + ": " + budget_text(options), static_cast<double>(scheme.n)});
  const sweeps::SweepOptions sweep = sweep_options(options, options, "conjecture 7");
  const auto results = sweeps::run_sweep(
      cases,
      [&](std::size_t i) {
        return range_json(
            variance_range(make_scheme(range.schemes[i].specification()).mask, variance_options(options)));
      },
      sweep);
  if (!results) return done;
  options.end_progress();

  std::vector<Row> rows;
  for (std::size_t i = 0; i < range.schemes.size(); ++i)
    if (results->values[i]) rows.push_back(Row(range.schemes[i], *results->values[i]));
  const std::vector<DegreeDecay> findings = sweep.shard.is_whole() ? findings_of(rows) : std::vector<DegreeDecay>();
  const Limits limits = limits_of(rows);
  bool has_rate = false;
  std::vector<Truth> truths;
  for (const Row& row : rows) truths.push_back(row.complete ? Truth::yes : Truth::unknown);
  for (const DegreeDecay& finding : findings)
    if (finding.decay.exponent) {
      has_rate = true;
      truths.push_back(finding.decay.upper_bound.truth);
    }
  const Truth verdict = all_of(truths);

  if (options.json) {
    Json json = answer_head(options, sweep);
    json["rows"] = Json::array();
    for (const Row& row : rows) json["rows"].push_back(row_json(row, limits));
    json["skipped"] = skipped_json(range);
    if (sweep.shard.is_whole()) {
      json["findings"] = Json::array();
      for (const DegreeDecay& finding : findings) json["findings"].push_back(finding_json(finding));
      json["limits"] = Json::array();
      for (const auto& [degree, limit] : limits) json["limits"].push_back(limit_json(limit));
    }
    json["verdict"] = has_rate ? Json(verdict_text(verdict)) : Json();
    options.answer(json);
    return exit_code(verdict);
  }
  constexpr int digits = 6;
  std::vector<std::vector<std::string>> table{
      {"d", "n", "max psi", "n max psi", "n max psi / C_d - 1", "max |psi'|", "n^2 max |psi'|"}};
  for (const Row& row : rows) {
    const int n = row.scheme.n;
    table.push_back({std::to_string(row.scheme.d), std::to_string(n), enclosure_text(row.sup, digits),
                     enclosure_text(scaled(row.sup, n), digits)});
    const auto deviation = deviation_of(row, limits);
    table.back().push_back(deviation ? enclosure_text(*deviation, 4) : "-");
    if (row.slope) {
      table.back().push_back(enclosure_text(*row.slope, digits));
      table.back().push_back(enclosure_text(scaled(*row.slope, n * n), digits));
    } else {
      table.back().insert(table.back().end(), {"-", row.slope_reason});
    }
    if (!row.complete) table.back().push_back("(budget spent)");
  }
  std::ostringstream text;
  text << table_text(table) << "\n" << skipped_text(range);
  if (!sweep.shard.is_whole()) text << shard_note(options);
  for (const DegreeDecay& finding : findings)
    text << "d = " << finding.d << ": " << finding.decay.sentence(finding.quantity) << "\n";
  if (sweep.shard.is_whole())
    for (const auto& [degree, limit] : limits) text << "d = " << degree << ": " << limit.sentence() << "\n";
  options.answer(text.str());
  return exit_code(verdict);
}

// Conjecture 8

ExitCode conjecture_8(const ConjectureOptions& options, const reports::PrimalSchemes& range) {
  const std::vector<reports::VariancePair> pairs = reports::neighbouring_pairs(range.schemes);
  if (pairs.empty()) fail(ErrorKind::usage, "conjecture 8 compares: give two different n or two different d");
  std::vector<sweeps::SweepCase> cases;
  for (const reports::VariancePair& pair : pairs)
    cases.push_back({"variance order: " + pair.smaller.specification() + " <= " + pair.larger.specification() + ": " +
                         budget_text(options),
                     static_cast<double>(pair.smaller.n)});
  const sweeps::SweepOptions sweep = sweep_options(options, options, "conjecture 8");
  const auto results = sweeps::run_sweep(
      cases,
      [&](std::size_t i) -> Json {
        VarianceOrderOptions order_options;
        order_options.deadline = Deadline::in(options.budget);
        const VarianceOrder order = compare_variance(make_scheme(pairs[i].smaller.specification()).mask,
                                                     make_scheme(pairs[i].larger.specification()).mask, order_options);
        // The conjecture allows equality: curves that touch do not refute it.
        if (order.below == Truth::no && order.difference == 0)
          return {{"verdict", to_text(Truth::unknown)},
                  {"reason", "the curves touch at x = " + to_text(order.witness)}};
        Json json{{"verdict", to_text(order.below)}, {"reason", order.reason}};
        if (order.below == Truth::no) {
          json["witness"] = to_text(order.witness);
          json["difference"] = to_text(order.difference);
        }
        return json;
      },
      sweep);
  if (!results) return done;
  options.end_progress();

  std::vector<Truth> truths;
  Json rows = Json::array();
  std::ostringstream text;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (!results->values[i]) continue;
    const Json& value = *results->values[i];
    const std::string word = value.at("verdict");
    truths.push_back(word == "yes" ? Truth::yes : word == "no" ? Truth::no : Truth::unknown);
    Json row{{"larger", pairs[i].larger.specification()}, {"smaller", pairs[i].smaller.specification()}};
    row.update(value);
    rows.push_back(row);
    text << std::left << std::setw(10) << verdict_text(truths.back()) << "psi of "
         << row.at("larger").get<std::string>() << " >= psi of " << row.at("smaller").get<std::string>();
    if (value.contains("witness")) text << ", false at x = " << value.at("witness").get<std::string>();
    if (truths.back() == Truth::unknown) text << " (" << value.at("reason").get<std::string>() << ")";
    text << "\n";
  }
  const Truth verdict = all_of(truths);
  if (options.json) {
    Json json = answer_head(options, sweep);
    json["rows"] = rows;
    json["skipped"] = skipped_json(range);
    json["verdict"] = sweep.shard.is_whole() ? Json(verdict_text(verdict)) : Json();
    options.answer(json);
    return exit_code(verdict);
  }
  text << "\n" << skipped_text(range);
  const auto count = [&](Truth truth) { return std::count(truths.begin(), truths.end(), truth); };
  text << truths.size() << " comparisons: " << count(Truth::yes) << " hold, " << count(Truth::no) << " violated, "
       << count(Truth::unknown) << " undecided.\n";
  if (!sweep.shard.is_whole())
    text << shard_note(options);
  else
    text << "Conjecture 8 "
         << (verdict == Truth::yes  ? "holds"
             : verdict == Truth::no ? "is violated"
                                    : "is undecided")
         << " for n in " << options.n << " and d in " << options.d
         << (verdict == Truth::yes ? "; all other comparisons follow by transitivity.\n" : ".\n");
  options.answer(text.str());
  return exit_code(verdict);
}

ExitCode run(ConjectureOptions& options) {
  const std::vector<int> n = sweeps::parse_number_list("--n", options.n, 1, largest_n);
  const std::vector<int> d = sweeps::parse_number_list("--d", options.d, 0, largest_d);
  options.n = sweeps::number_list_text(n);
  options.d = sweeps::number_list_text(d);
  const reports::PrimalSchemes range = reports::distinct_primal_schemes(n, d);
  if (range.schemes.empty())
    fail(ErrorKind::usage, "{} is left out: {}; no scheme remains", range.skipped.front().scheme.specification(),
         range.skipped.front().reason());
  return options.number == 7 ? conjecture_7(options, range) : conjecture_8(options, range);
}

}  // namespace

void add_conjecture(Command& app) {
  auto options = std::make_shared<ConjectureOptions>();
  Command command = add_command(
      app, "conjecture", "Conjectures 7 and 8 of Dyn et al. over ranges of n and d, certified",
      "subcert conjecture 7 --n 1..40 --d 1,3,5 --journal seven.journal", options, [=] { return run(*options); });
  command.option("NUMBER", options->number, "7: max psi ~ 1/n and max |psi'| ~ 1/n^2; 8: psi is monotone in d and n")
      .required()
      .within(7, 8);
  command.option("--n", options->n, "Values of n, as 1..40 or 1,2,5..9").with_default();
  command.option("--d", options->d, "Degrees").with_default();
  command.option("--width", options->width, "Relative width of the enclosures").within(1e-15, 0.5).with_default();
  command.option("--budget", options->budget, "Seconds for each case").within(0.001, 1e6).with_default();
  add_sweep_arguments(command, *options);
}

}  // namespace subcert::cli
