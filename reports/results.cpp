#include "results.hpp"

#include "formats/html.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
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

/// The groups of each kind, from the best to the worst, as counts() names them.
const std::vector<std::string>& groups_of(ResultKind kind) {
  static const std::array<std::vector<std::string>, 3> all{
      std::vector<std::string>{"match", "wrong", "open", "rest on data that were not published"},
      {"proved for all n", "on the range tried", "but for an edge", "slips of the pen", "numbers off", "wrong claims",
       "undecided", "left to experiments", "cannot be checked"},
      {"hold as printed", "hold in a weaker reading", "contrary shown", "depend on a choice the paper leaves open",
       "undecided", "on our data only"}};
  return all[static_cast<std::size_t>(kind)];
}

std::string group_of(ValueVerdict verdict) { return groups_of(ResultKind::value)[static_cast<std::size_t>(verdict)]; }

std::string group_of(ClaimVerdict verdict) {
  constexpr std::array places{0, 1, 2, 3, 5, 4};
  return groups_of(ResultKind::claim)[static_cast<std::size_t>(places[static_cast<std::size_t>(verdict)])];
}

std::string group_of(const CheckedStatement& one) {
  const statements::Statement& statement = *one.statement;
  const std::optional<Grade> grade = statements::grade_of(statement, one.outcome);
  const StatementVerdict verdict = one.outcome.verdict;
  const std::size_t place = grade == Grade::edge                             ? 2
                            : verdict == StatementVerdict::holds_for_all     ? 0
                            : verdict == StatementVerdict::holds             ? 1
                            : verdict == StatementVerdict::undecided         ? 6
                            : is_left_to_experiments(statement, one.outcome) ? 7
                            : verdict == StatementVerdict::not_checkable     ? 8
                            : grade == Grade::slip                           ? 3
                            : grade == Grade::number                         ? 4
                                                                             : 5;
  return groups_of(ResultKind::statement)[place];
}

std::string grade_text(const std::optional<Grade>& grade) { return grade ? to_text(*grade) : ""; }

Result result_of(const CheckedStatement& one) {
  const statements::Statement& statement = *one.statement;
  std::string note = one.outcome.witness.empty() ? "" : "Witness: " + one.outcome.witness + ".";
  for (const std::string& more : {statement.readings, one.outcome.argument})
    if (!more.empty()) note += (note.empty() ? "" : " ") + more;
  if (!statement.experiments.empty())
    note += fmt::format("{}experiments: {}.", note.empty() ? "" : "; ", fmt::join(statement.experiments, ", "));
  if (!statement.scan.empty()) note += " As the scan has it: " + statement.scan + ".";
  const std::string grade = grade_text(statements::grade_of(statement, one.outcome));
  const std::string recorded = grade_text(statement.grade);
  return {.kind = ResultKind::statement,
          .paper = statement.paper(),
          .item = statement.place,
          .key = statement.id,
          .page = "errata.html",
          .subject = statement.paraphrase,
          .printed = printed_latex(statement),
          .computed = corrected_latex(statement),
          .verdict = to_text(one.outcome.verdict),
          .recorded = to_text(statement.recorded) + (recorded.empty() ? "" : ", " + recorded),
          .grade = grade,
          .standing = standing(one.outcome.verdict),
          .words = verdict_in_words(statement, one.outcome),
          .group = group_of(one),
          .follows = statement.follows,
          .as_recorded = one.as_recorded(),
          .note = note,
          .remark = one.outcome.argument,
          .command = "subcert statements check " + statement.id};
}

/// `printed values`, and what is said of those that are right.
struct KindWords {
  const char* name;
  const char* hold;
};

KindWords words_of(ResultKind kind) {
  constexpr std::array all{KindWords{"printed values", "match"}, KindWords{"statements", "hold"},
                           KindWords{"claims", "hold as printed"}};
  return all[static_cast<std::size_t>(kind)];
}

/// `8 slips of the pen, 4 numbers off`.
std::string listed(const std::vector<Counts::Group>& groups, const std::vector<Standing>& chosen) {
  std::vector<std::string> parts;
  for (const Counts::Group& group : groups)
    if (std::ranges::find(chosen, group.standing) != chosen.end()) parts.push_back(group.text());
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

std::string to_text(const Origin& origin) {
  return "Made by subcert " + origin.version + (origin.commit.empty() ? "" : " (" + origin.commit + ")") + ", from " +
         origin.input + ", on " + origin.when + ".\n\n";
}

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
    list.push_back({.kind = ResultKind::value,
                    .paper = table.paper,
                    .item = table.id,
                    .key = keys.unique(fmt::format("{}-{}-{}", table.paper, table.id, formats::slug(c.cell()))),
                    .page = table.paper + ".html",
                    .subject = c.cell(),
                    .scheme = c.scheme,
                    .printed = c.printed,
                    .computed = c.computed_text(),
                    .enclosure = enclosure ? std::optional(*enclosure) : std::nullopt,
                    .verdict = to_text(c.verdict),
                    .recorded = to_text(c.recorded),
                    .standing = standing(c.verdict),
                    .words = to_text(c.verdict),
                    .group = group_of(c.verdict),
                    .derived = c.derived,
                    .as_recorded = c.verdict == c.recorded,
                    .note = c.note,
                    .command = c.command.empty() ? fmt::format("subcert reproduce {} --only {}", table.paper, table.id)
                                                 : c.command});
  }
  return list;
}

std::vector<Result> results(const experiments::RanExperiment& ran) {
  std::vector<Result> list;
  const std::string &id = ran.experiment->id, &paper = ran.experiment->paper;
  for (const experiments::DecidedClaim& c : ran.result.claims)
    list.push_back(
        {.kind = ResultKind::claim,
         .paper = paper,
         .item = id,
         .key = experiments::claim_key(*ran.experiment, list.size()),
         .page = paper + ".html",
         .subject = c.sentence,
         .computed = c.numbers,
         .verdict = to_text(c.finding),
         .recorded = to_text(c.recorded),
         .standing = standing(c.finding),
         .words = to_text(c.finding),
         .group = group_of(c.finding),
         .as_recorded = c.finding == c.recorded,
         .note = c.statistic,
         .command = "subcert experiment " + id +
                    (ran.experiment->random ? fmt::format(" --seed {} --runs {}", ran.options.seed, ran.options.runs)
                                            : "")});
  return list;
}

std::vector<Result> results(const std::vector<CheckedStatement>& statements) {
  std::vector<Result> list;
  for (const CheckedStatement& one : statements) list.push_back(result_of(one));
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

std::string Counts::Group::text() const {
  static const std::map<std::string, std::string> singular{
      {"slips of the pen", "slip of the pen"},
      {"numbers off", "number off"},
      {"wrong claims", "wrong claim"},
      {"hold in a weaker reading", "holds in a weaker reading"},
      {"rest on data that were not published", "rests on data that were not published"},
      {"depend on a choice the paper leaves open", "depends on a choice the paper leaves open"}};
  const auto one = singular.find(name);
  return fmt::format("{} {}", count, count == 1 && one != singular.end() ? one->second : name);
}

int Counts::of(Standing standing) const {
  int sum = 0;
  for (const Group& group : groups) sum += group.standing == standing ? group.count : 0;
  return sum;
}

int Counts::all() const {
  int sum = 0;
  for (const Group& group : groups) sum += group.count;
  return sum;
}

std::string Counts::head() const {
  const auto [name, hold] = words_of(kind);
  return checked() == 0 ? "" : fmt::format("{} of {} {} {}", of(Standing::right), checked(), name, hold);
}

std::string Counts::wrong_text() const { return listed(groups, {Standing::wrong}); }

std::string Counts::text() const {
  if (all() == 0) return "";
  const auto right = std::ranges::count(groups, Standing::right, &Group::standing);
  const bool told = right > 1 || (right == 1 && kind == ResultKind::statement);  // proved, or tried?
  const std::string parts = told ? fmt::format(" ({})", listed(groups, {Standing::right})) : "";
  const std::string others = listed(groups, {Standing::wrong, Standing::open}),
                    beside = listed(groups, {Standing::aside});
  if (checked() == 0) return fmt::format("{} {}: {}", all(), words_of(kind).name, beside);
  return head() + parts + (others.empty() ? "" : "; " + others) + (beside.empty() ? "" : "; beside them " + beside);
}

Counts counts(const std::vector<Result>& results, ResultKind kind, const std::string& paper) {
  Counts total{kind, {}};
  for (const std::string& name : groups_of(kind)) {
    Counts::Group group{name, Standing::aside, 0};
    for (const Result& one : results) {
      if (one.kind != kind || one.group != name || !one.derived.empty() || (!paper.empty() && one.paper != paper))
        continue;
      group.standing = one.standing;
      ++group.count;
      total.causes += kind == ResultKind::statement && one.standing == Standing::wrong && one.follows.empty() ? 1 : 0;
    }
    if (group.count > 0) total.groups.push_back(group);
  }
  return total;
}

std::string standing_sentence(const Counts& statements) {
  if (statements.checked() == 0) return "What does not hold is named with its reason.";
  const auto proved = std::ranges::find(statements.groups, groups_of(ResultKind::statement).front(),
                                        &Counts::Group::name);
  return fmt::format("{}{}; what does not is named with its reason.", statements.head(),
                     proved == statements.groups.end()
                         ? ""
                         : fmt::format(", {} of them now with proofs for all parameters", proved->count));
}

std::string errata_sentence(const Counts& statements) {
  const int wrong = statements.of(Standing::wrong);
  if (wrong == 0) return "";
  return fmt::format(
      "{} of {} statements do not hold, from {} {}: {}; each with its witness and, where there is "
      "one, its correction.",
      wrong, statements.checked(), statements.causes, statements.causes == 1 ? "cause" : "causes",
      statements.wrong_text());
}

}  // namespace subcert::reports
