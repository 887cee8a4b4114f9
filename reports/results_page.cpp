#include "formats/html.hpp"
#include "formats/mathml.hpp"
#include "pages.hpp"

#include <fmt/ranges.h>

#include <set>

namespace subcert::reports {
namespace {

using formats::html;

/// Of a cell; the rest stands where the link leads.
std::string shortened(const std::string& text) { return formats::shortened_html(text, 400); }

/// Statements are formulas in LaTeX.
std::string object_html(const Result& result, const std::string& text) {
  if (text.empty() || result.kind != ResultKind::statement) return shortened(text);
  return "<div class=formula>" + formats::formula_html(text) + "</div>";
}

std::string choice(const std::string& name, const std::string& all,
                   const std::vector<std::pair<std::string, std::string>>& values) {
  std::string options = fmt::format("<option value=\"\">{}</option>", all);
  for (const auto& [value, text] : values)
    options += fmt::format("<option value=\"{}\">{}</option>", html(value), html(text));
  return fmt::format("<label>{} <select name={}>{}</select></label>\n", name, name, options);
}

std::string row(const Result& result) {
  const std::string standing = to_text(result.standing);
  return fmt::format(
      "<tr class=\"{}\" data-verdict=\"{}\" data-truth=\"{}\" data-paper=\"{}\" data-kind=\"{}\"><td>{}<br>{}</td><td "
      "class=text><a href=\"{}\">{}</a></td><td class=text>{}</td><td class=text>{}</td><td><span "
      "class=verdict>{}</span>"
      "</td><td class=text>{}<code class=again>{}</code></td></tr>\n",
      standing, result.verdict, standing, html(result.paper), to_text(result.kind), html(result.paper),
      html(result.item), html(result.link()), shortened(result.subject), object_html(result, result.printed),
      object_html(result, result.computed), html(result.words),
      result.note.empty() ? "" : shortened(result.note) + "<br>", html(result.command));
}

}  // namespace

std::string results_page(const std::vector<Result>& results) {
  std::set<std::string> verdicts;
  std::set<std::string> papers;
  std::string rows;
  for (const Result& result : results) {
    verdicts.insert(result.verdict);
    papers.insert(result.paper);
    rows += row(result);
  }
  std::vector<std::pair<std::string, std::string>> verdict_choices{{"right", "all that are right"},
                                                                   {"wrong", "all that are wrong"},
                                                                   {"open", "all that are open"},
                                                                   {"aside", "all that cannot be checked"}},
      paper_choices;
  for (const std::string& verdict : verdicts) verdict_choices.emplace_back(verdict, verdict);
  for (const std::string& paper : papers) paper_choices.emplace_back(paper, paper);
  const std::string form = choice("verdict", "any", verdict_choices) + choice("paper", "any", paper_choices) +
                           choice("kind", "any",
                                  {{"value", "printed values"},
                                   {"statement", "statements"},
                                   {"claim", "claims about experiments"}});
  return formats::html_page(
      "subcert: every result",
      fmt::format(
          "<p class=up><a href=\"index.html\">All papers</a></p>\n<h1>Every result</h1>\n<p>Printed values, statements "
          "and claims, each with what was found and the command that finds it again. The links lead to the "
          "places.</p>\n<form class=filter hidden>\n{}<label>search <input type=search name=search></label>\n<button "
          "type=reset>all</button> <output></output></form>\n<div class=scroll tabindex=0 role=region "
          "aria-label=\"Results\"><table "
          "class=results>\n<thead><tr><th>paper</th><th class=text>what</th><th class=text>printed</th><th "
          "class=text>found</th><th>verdict</th><th class=text>why, and the command</th>"
          "</tr></thead>\n<tbody>\n{}</tbody>\n"
          "</table></div>\n",
          form, rows));
}

}  // namespace subcert::reports
