#include "errata.hpp"

#include <subcert/analysis/symbol/budget.hpp>
#include <subcert/analysis/symbol/parallel.hpp>
#include "formats/html.hpp"
#include "formats/mathml.hpp"

#include <algorithm>
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

/// A row of a statement: a label and HTML.
std::string line(const std::string& label, const std::string& content) {
  if (content.empty()) return "";
  return "<dt>" + label + "</dt><dd>" + content + "</dd>\n";
}

std::string formula(const std::string& content) { return "<div class=formula>" + content + "</div>"; }

std::string source(const std::vector<std::string>& latex) {
  std::string text;
  for (const std::string& one : latex) text += "<pre><code>" + formats::html(one) + "</code></pre>";
  return "<details><summary>LaTeX</summary>" + text + "</details>\n";
}

/// The printed and the corrected form side by side, where there is a corrected one.
std::string forms(const std::string& printed, const std::string& corrected) {
  if (corrected.empty() || corrected == printed) return formula(formats::formula_html(printed)) + source({printed});
  const formats::MarkedFormulas both = formats::marked_difference(printed, corrected);
  return "<div class=forms><div class=printed><span class=label>printed</span>" + formula(both.printed) +
         "</div>\n<div class=corrected><span class=label>corrected</span>" + formula(both.corrected) +
         "</div></div>\n" + source({printed, corrected});
}

std::string statement_html(const CheckedStatement& checked) {
  const Statement& statement = *checked.statement;
  const Outcome& outcome = checked.outcome;
  return "<section class=\"statement " + to_text(outcome.verdict) + "\" id=\"" + statement.id + "\">\n<p class=head>" +
         formats::html(statement.place) + " " + verdict_html(outcome) + "</p>\n<p>" +
         formats::html(statement.paraphrase) + "</p>\n" +
         forms(printed_latex(statement), is_wrong(outcome) ? corrected_latex(statement) : "") + "<dl>\n" +
         line("witness", formats::html(outcome.witness)) + line("tried on", formats::html(outcome.range)) +
         line(is_wrong(outcome) ? "remark" : "why", formats::html(outcome.argument)) +
         line("id", "<code>" + statement.id + "</code>") + "</dl></section>\n";
}

std::string list_of(const std::string& heading, const std::vector<const CheckedStatement*>& checked) {
  if (checked.empty()) return "";
  std::string text = "<h3>" + heading + "</h3>\n";
  for (const CheckedStatement* one : checked) text += statement_html(*one);
  return text;
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
  return "<h2 id=\"" + paper.key + "\">" + paper.key + "</h2>\n<p class=citation>" + formats::html(paper.citation) +
         "</p>\n" + list_of("Errata", wrong) + list_of("Confirmations", right) + list_of("Not checked", open);
}

}  // namespace

std::vector<CheckedStatement> check_statements(const std::vector<const Statement*>& chosen, statements::Tier tier,
                                               int jobs, const std::function<void(const std::string&)>& progress) {
  std::vector<CheckedStatement> results(chosen.size());
  std::mutex one_at_a_time;
  parallel_tasks(chosen.size(), jobs, [&](std::size_t i) {
    if (progress) {
      const std::lock_guard lock(one_at_a_time);
      progress(chosen[i]->id);
    }
    const Stopwatch watch;
    Outcome outcome = check(*chosen[i], tier);
    results[i] = {chosen[i], std::move(outcome), watch.seconds()};
  });
  return results;
}

std::string errata_page(const std::vector<CheckedStatement>& checked) {
  std::string body =
      "<h1>Errata and confirmations</h1>\n<p>The statements of the papers as executable checks. The printed forms are "
      "typed in as they stand and compared with what follows from the definitions, in exact arithmetic or with outward "
      "rounding. <b>holds-for-all-n</b>: proved for all admissible parameters; <b>holds</b>: on the range named; "
      "<b>misprint</b>: the printed form fails at the witness and the corrected form passes the same check; "
      "<b>false</b>: it fails, and no change of a symbol saves it. The closed forms among the formulas are printed "
      "from "
      "what was checked; beside an erratum, <span class=\"printed\"><span class=changed>what the printed form has "
      "alone</span></span> and <span class=\"corrected\"><span class=changed>what the corrected one has "
      "alone</span></span> are marked. Formulas are MathML with their LaTeX text.</p>\n" +
      summary(checked);
  for (const auto& paper : statements::papers()) body += paper_section(paper, checked);
  return formats::html_page("subcert: errata and confirmations", body);
}

}  // namespace subcert::reports
