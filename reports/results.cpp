#include "results.hpp"

#include "formats/html.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>

namespace subcert::reports {
namespace {

/// The same names again get a number.
class Keys {
 public:
  std::string unique(const std::string& key) {
    const int before = seen_[key]++;
    return before == 0 ? key : fmt::format("{}--{}", key, before + 1);
  }

 private:
  std::map<std::string, int> seen_;
};

Result result_of(const CheckedStatement& one) {
  const statements::Statement& statement = *one.statement;
  std::string note = one.outcome.witness.empty() ? "" : "Witness: " + one.outcome.witness;
  if (!one.outcome.argument.empty()) note += (note.empty() ? "" : " ") + one.outcome.argument;
  return {ResultKind::statement,
          statement.paper(),
          statement.place,
          statement.id,
          "errata.html",
          statement.paraphrase,
          "",
          printed_latex(statement),
          corrected_latex(statement),
          std::nullopt,
          one.outcome.verdict,
          statement.recorded,
          note,
          "subcert statements check " + statement.id};
}

}  // namespace

bool Findings::as_recorded() const {
  return std::ranges::all_of(reports, &Report::as_recorded) &&
         std::ranges::all_of(statements, &CheckedStatement::as_recorded);
}

std::string to_text(ResultKind kind) {
  return kind == ResultKind::value ? "value" : kind == ResultKind::claim ? "claim" : "statement";
}

std::vector<Result> results(const formats::ComparisonTable& table) {
  std::vector<Result> list;
  Keys keys;
  for (const formats::Comparison& c : table.comparisons) {
    const auto* enclosure = std::get_if<Enclosure>(&c.computed);
    list.push_back(
        {ResultKind::value, table.paper, table.id,
         keys.unique(fmt::format("{}-{}-{}", table.paper, table.id, formats::slug(c.cell()))), table.paper + ".html",
         c.cell(), c.scheme, c.printed, c.computed_text(), enclosure ? std::optional(*enclosure) : std::nullopt,
         c.verdict, c.recorded, c.note,
         c.command.empty() ? fmt::format("subcert reproduce {} --only {}", table.paper, table.id) : c.command});
  }
  return list;
}

std::vector<Result> results(const experiments::RanExperiment& ran) {
  std::vector<Result> list;
  const std::string &id = ran.experiment->id, &paper = ran.experiment->paper;
  for (const experiments::DecidedClaim& c : ran.result.claims)
    list.push_back(
        {ResultKind::claim, paper, id, experiments::claim_key(*ran.experiment, list.size()), paper + ".html",
         c.sentence, "", "", c.numbers, std::nullopt, c.finding, c.recorded, c.statistic,
         "subcert experiment " + id +
             (ran.experiment->random ? fmt::format(" --seed {} --runs {}", ran.options.seed, ran.options.runs) : "")});
  return list;
}

std::vector<Result> results(const Report& report, const std::vector<CheckedStatement>& statements) {
  std::vector<Result> list;
  for (const formats::ComparisonTable* table : report.comparison_tables())
    std::ranges::move(results(*table), std::back_inserter(list));
  for (const experiments::RanExperiment& ran : report.experiments)
    std::ranges::move(results(ran), std::back_inserter(list));
  for (const CheckedStatement& one : statements)
    if (one.statement->paper() == report.paper) list.push_back(result_of(one));
  return list;
}

std::vector<Result> results(const Findings& findings) {
  std::vector<Result> list;
  for (const Report& report : findings.reports)
    std::ranges::move(results(report, findings.statements), std::back_inserter(list));
  return list;
}

void Score::add(Verdict verdict) {
  const Truth truth = truth_of(verdict);
  const bool no_check = verdict == Verdict::not_checkable || verdict == Verdict::not_reproducible;
  ++(truth == Truth::yes ? right : truth == Truth::no ? wrong : no_check ? uncheckable : open);
}

std::string Score::text(const std::string& what, const std::string& hold) const {
  if (all() == 0) return "";
  if (checked() == 0) return fmt::format("{} {} cannot be checked", uncheckable, what);
  std::vector<std::string> left;
  if (open > 0) left.push_back(fmt::format("{} open", open));
  if (uncheckable > 0) left.push_back(fmt::format("{} cannot be checked", uncheckable));
  return fmt::format("{} of {} {} {}{}", right, checked(), what, hold,
                     left.empty() ? "" : fmt::format(" ({})", fmt::join(left, ", ")));
}

Score score(const std::vector<Result>& results, ResultKind kind, const std::string& paper) {
  Score total;
  for (const Result& result : results)
    if (result.kind == kind && (paper.empty() || result.paper == paper)) total.add(result.verdict);
  return total;
}

}  // namespace subcert::reports
