#include "errata.hpp"

#include <subcert/analysis/symbol/parallel.hpp>
#include "formats/html.hpp"

#include <algorithm>
#include <chrono>
#include <mutex>

namespace subcert::reports {
namespace {

using statements::Outcome;
using statements::Statement;

const std::vector<Verdict> verdicts{Verdict::holds_for_all, Verdict::holds,         Verdict::misprint,
                                    Verdict::false_claim,   Verdict::not_checkable, Verdict::undecided};

bool is_wrong(const Outcome& outcome) {
  return outcome.verdict == Verdict::misprint || outcome.verdict == Verdict::false_claim;
}

std::string verdict_html(const Outcome& outcome) {
  return "<span class=verdict>" + to_text(outcome.verdict) + "</span>";
}

std::string line(const std::string& label, const std::string& content, bool formula) {
  if (content.empty()) return "";
  return "<p><span class=label>" + label + "</span> " +
         (formula ? "<code>" + formats::html(content) + "</code>" : formats::html(content)) + "</p>\n";
}

std::string erratum(const CheckedStatement& checked) {
  const Statement& statement = *checked.statement;
  const Outcome& outcome = checked.outcome;
  return "<div class=\"claim " + to_text(outcome.verdict) + "\" id=\"" + statement.id + "\">\n<p class=head>" +
         formats::html(statement.place) + " " + verdict_html(outcome) + "</p>\n" +
         line("claim", statement.paraphrase, false) + line("printed", printed_latex(statement), true) +
         line("witness", outcome.witness, false) + line("corrected", corrected_latex(statement), true) +
         line("tried on", outcome.range, false) + line("remark", outcome.argument, false) +
         line("id", statement.id, false) + "</div>\n";
}

std::string confirmation_row(const CheckedStatement& checked) {
  const Statement& statement = *checked.statement;
  const Outcome& outcome = checked.outcome;
  return "<tr class=\"" + to_text(outcome.verdict) + "\" id=\"" + statement.id + "\"><th>" +
         formats::html(statement.place) + "</th><td class=text>" + formats::html(statement.paraphrase) + "<br><code>" +
         formats::html(printed_latex(statement)) + "</code></td><td>" + verdict_html(outcome) + "</td><td class=text>" +
         formats::html(outcome.range) +
         (outcome.argument.empty() ? "" : "<br><span class=computed>" + formats::html(outcome.argument) + "</span>") +
         "</td></tr>\n";
}

std::string table_of(const std::vector<const CheckedStatement*>& checked) {
  std::string rows;
  for (const CheckedStatement* one : checked) rows += confirmation_row(*one);
  return "<div class=scroll><table class=statements>\n<tr><th>place</th><th class=left>claim</th><th "
         "class=left>verdict</th><th class=left>for which parameters, and why</th></tr>\n" +
         rows + "</table></div>\n";
}

std::string summary(const std::vector<CheckedStatement>& checked) {
  std::vector<std::string> head{"paper"};
  for (const Verdict verdict : verdicts) head.push_back(to_text(verdict));
  std::vector<formats::SummaryRow> rows;
  for (const std::string& paper : statements::paper_keys()) {
    formats::SummaryRow row{paper, paper, {}};
    for (const Verdict verdict : verdicts)
      row.counts.push_back(static_cast<std::size_t>(std::ranges::count_if(checked, [&](const CheckedStatement& one) {
        return one.statement->paper() == paper && one.outcome.verdict == verdict;
      })));
    if (std::ranges::any_of(row.counts, [](std::size_t count) { return count > 0; })) rows.push_back(row);
  }
  return formats::summary_html(head, rows);
}

std::string paper_section(const statements::Paper& paper, const std::vector<CheckedStatement>& checked) {
  std::vector<const CheckedStatement*> wrong, right, open;
  for (const CheckedStatement& one : checked) {
    if (one.statement->paper() != paper.key) continue;
    const Verdict verdict = one.outcome.verdict;
    (is_wrong(one.outcome)                                            ? wrong
     : verdict == Verdict::holds || verdict == Verdict::holds_for_all ? right
                                                                      : open)
        .push_back(&one);
  }
  if (wrong.empty() && right.empty() && open.empty()) return "";
  std::string text = "<h2 id=\"" + paper.key + "\">" + paper.key + "</h2>\n<p class=citation>" +
                     formats::html(paper.citation) + "</p>\n";
  if (!wrong.empty()) text += "<h3>Errata</h3>\n";
  for (const CheckedStatement* one : wrong) text += erratum(*one);
  if (!right.empty()) text += "<h3>Confirmations</h3>\n" + table_of(right);
  if (!open.empty()) text += "<h3>Not checked</h3>\n" + table_of(open);
  return text;
}

}  // namespace

std::vector<CheckedStatement> check_statements(const std::vector<const Statement*>& chosen, statements::Tier tier,
                                               int jobs, const std::function<void(const std::string&)>& progress) {
  std::vector<CheckedStatement> results(chosen.size());
  std::mutex one_at_a_time;
  parallel_for_each(chosen.size(), jobs, [&](std::size_t i) {
    if (progress) {
      const std::lock_guard lock(one_at_a_time);
      progress(chosen[i]->id);
    }
    const auto start = std::chrono::steady_clock::now();
    Outcome outcome = check(*chosen[i], tier);
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    results[i] = {chosen[i], std::move(outcome), passed.count()};
  });
  return results;
}

std::string errata_page(const std::vector<CheckedStatement>& checked) {
  std::string body =
      "<h1>Errata and confirmations</h1>\n<p>The statements of the papers as executable checks. The printed forms are "
      "typed in as they stand and compared with what follows from the definitions, in exact arithmetic or with outward "
      "rounding. <b>holds-for-all-n</b>: proved for all admissible parameters; <b>holds</b>: on the range named; "
      "<b>misprint</b>: the printed form fails at the witness and the corrected form passes the same check; "
      "<b>false</b>: it fails, and no change of a symbol saves it. Formulas are given in LaTeX; the closed forms among "
      "them are printed from what was checked.</p>\n" +
      summary(checked);
  for (const auto& paper : statements::papers()) body += paper_section(paper, checked);
  return formats::html_page("subcert: errata and confirmations", body);
}

}  // namespace subcert::reports
