#include "pages.hpp"

#include "formats/html.hpp"
#include "formats/mathml.hpp"
#include "results.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace subcert::reports {
namespace {

using statements::Outcome;
using statements::Statement;
using Chosen = std::vector<const CheckedStatement*>;

bool is_wrong(const CheckedStatement& one) { return standing(one.outcome.verdict) == Standing::wrong; }
bool is_edge(const CheckedStatement& one) { return !one.outcome.edge.empty(); }
bool is_right(const CheckedStatement& one) { return standing(one.outcome.verdict) == Standing::right && !is_edge(one); }
bool is_undecided(const CheckedStatement& one) { return !is_wrong(one) && !is_edge(one) && !is_right(one); }

std::string verdict_html(const CheckedStatement& one) {
  return "<span class=verdict>" + formats::html(verdict_in_words(*one.statement, one.outcome)) + "</span>";
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

std::string quoted(const std::string& sentence) {
  return sentence.empty() ? "" : "<q>" + formats::html(sentence) + "</q>";
}

/// The claims of an experiment as found, or the command that finds them.
std::string experiment_html(const std::string& id, const std::vector<Result>& results) {
  std::string claims;
  for (const Result& one : results)
    if (one.kind == ResultKind::claim && one.item == id)
      claims += fmt::format("<li><a href=\"{}\">{}</a> <b>{}</b></li>", formats::html(one.link()),
                            formats::html(one.subject), formats::html(one.words));
  return claims.empty() ? fmt::format("<li><code>subcert experiment {}</code></li>", formats::html(id)) : claims;
}

std::string experiments_html(const Statement& statement, const std::vector<Result>& results) {
  std::string lists;
  for (const std::string& id : statement.experiments) lists += experiment_html(id, results);
  return lists.empty() ? "" : "<ul>" + lists + "</ul>";
}

std::string statement_html(const CheckedStatement& checked, const std::vector<Result>& results) {
  const Statement& statement = *checked.statement;
  const Outcome& outcome = checked.outcome;
  const bool faulty = is_wrong(checked) || is_edge(checked);
  return fmt::format(
      "<section class=\"statement {}\" id=\"{}\">\n<p class=head>{} {}</p>\n<p>{}</p>\n{}<dl>\n{}{}{}{}{}{}{}{}{}{}"
      "</dl></section>\n",
      to_text(standing(outcome.verdict)), statement.id, formats::html(statement.place), verdict_html(checked),
      formats::html(statement.paraphrase), forms(printed_latex(statement), faulty ? corrected_latex(statement) : ""),
      line("the paper says", faulty ? quoted(statement.sentence) : ""),
      line("read as", faulty ? formats::html(statement.readings) : ""),
      line("as the scan has it", formats::html(statement.scan)), line("witness", formats::html(outcome.witness)),
      line("tried on", formats::html(outcome.range)), line(faulty ? "remark" : "why", formats::html(outcome.argument)),
      line("checked", formats::html(statement.checked)),
      line("follows from",
           statement.follows.empty() ? "" : fmt::format("<a href=\"#{0}\">{0}</a>", formats::html(statement.follows))),
      line("experiments", experiments_html(statement, results)), line("id", "<code>" + statement.id + "</code>"));
}

std::string list_of(const std::string& id, const std::string& heading, const Chosen& checked,
                    const std::vector<Result>& results) {
  if (checked.empty()) return "";
  std::string text = fmt::format("<h3 id=\"{}\">{} ({})</h3>\n", id, heading, checked.size());
  for (const CheckedStatement* one : checked) text += statement_html(*one, results);
  return text;
}

/// Each fault, and under it those that repeat it.
Chosen by_cause(const Chosen& checked) {
  Chosen result;
  for (const CheckedStatement* first : checked) {
    const auto in_list = [&](const std::string& id) {
      return std::ranges::any_of(checked, [&](const CheckedStatement* one) { return one->statement->id == id; });
    };
    if (!first->statement->follows.empty() && in_list(first->statement->follows)) continue;
    result.push_back(first);
    for (const CheckedStatement* other : checked)
      if (other->statement->follows == first->statement->id) result.push_back(other);
  }
  return result;
}

std::string paper_section(const statements::Paper& paper, const std::vector<CheckedStatement>& checked,
                          const std::vector<Result>& of_all) {
  struct Part {
    const char* id;
    const char* heading;
    bool (*belongs)(const CheckedStatement&);
  };
  constexpr Part parts[]{{"holds", "What holds", is_right},
                         {"edges", "What holds but for an edge", is_edge},
                         {"errata", "What to correct", is_wrong},
                         {"open", "What was not decided", is_undecided}};
  std::string lists, links;
  for (const auto& [id, heading, belongs] : parts) {
    Chosen chosen;
    for (const CheckedStatement& one : checked)
      if (one.statement->paper() == paper.key && belongs(one)) chosen.push_back(&one);
    const std::string anchor = paper.key + "-" + id;
    lists += list_of(anchor, heading, by_cause(chosen), of_all);
    if (!chosen.empty()) links += fmt::format("<a href=\"#{}\">{} ({})</a> ", anchor, heading, chosen.size());
  }
  if (lists.empty()) return "";
  const Counts found = counts(results(checked), ResultKind::statement, paper.key);
  return fmt::format("<h2 id=\"{0}\">{0}</h2>\n<p class=citation>{1}</p>\n<p>{2}.</p>\n<nav>{3}</nav>\n{4}", paper.key,
                     formats::html(paper.citation), found.text(), links, lists);
}

}  // namespace

std::string errata_page(const std::vector<CheckedStatement>& checked, const std::vector<Result>& results) {
  std::string body =
      "<h1>Errata and confirmations</h1>\n<p>The statements of the papers as executable checks. The printed forms are "
      "typed in as they stand and compared with what follows from the definitions, in exact arithmetic or with outward "
      "rounding. <b>Proved for all n</b>: for all admissible parameters. <b>Holds on the range tried</b>: no "
      "counterexample on the range named. <b>Holds, but not at ...</b>: all but a case at the edge of the printed "
      "range "
      "holds. <b>Slip of the pen</b>: an index, a sign, a letter or a word; the printed form fails at the witness and "
      "the corrected form passes the same check. <b>Numbers are off</b>: the remark says how far. <b>Does not "
      "hold</b>: "
      "it fails at the witness as it is read there, and no change of a symbol saves it. <b>See the experiments</b>: "
      "the data were not published; what repeated experiments find stands there. What repeats a fault stands under it. "
      "The closed forms among the formulas are printed from what was checked; beside an erratum, "
      "<span class=\"printed\"><span class=changed>what the printed form has alone</span></span> and <span "
      "class=\"corrected\"><span class=changed>what the corrected one has alone</span></span> are marked. Formulas are "
      "MathML with their LaTeX text. Where one scan was all there is, and a slip of the text recognition would explain "
      "what is found, the entry says so.</p>\n";
  for (const auto& paper : statements::papers()) body += paper_section(paper, checked, results);
  return formats::html_page("subcert: errata and confirmations", body);
}

}  // namespace subcert::reports
