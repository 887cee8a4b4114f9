#include "formats/html.hpp"
#include "formats/svg.hpp"
#include "pages.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <map>

namespace subcert::reports {
namespace {

using formats::html;

/// A kind of results, and what is said of those that are right and of those that are wrong.
struct Kind {
  ResultKind kind;
  const char* name;
  const char* right;
  const char* wrong;
};

constexpr Kind kinds[] = {{ResultKind::value, "printed values", "match", "excluded"},
                          {ResultKind::statement, "statements", "hold", "misprinted or false"},
                          {ResultKind::claim, "claims about experiments", "are confirmed", "not confirmed"}};

/// One group of a score: its class and its size.
struct Group {
  const char* name;
  int count;
};

std::vector<Group> groups(const Score& score) {
  return {{"right", score.right}, {"wrong", score.wrong}, {"open", score.open}, {"uncheckable", score.uncheckable}};
}

std::string bar(const Score& score) {
  std::string parts;
  for (const auto& [name, count] : groups(score))
    if (count > 0) parts += fmt::format("<span class=\"{}\" style=\"flex-grow:{}\"></span>", name, count);
  return "<span class=bar aria-hidden=true>" + parts + "</span>";
}

/// The first words of a citation: authors and title.
std::string title_of(const std::string& citation) {
  const std::size_t colon = citation.find(": ");
  return citation.substr(0, citation.find(". ", colon == std::string::npos ? 0 : colon));
}

/// The first sentence of the text is its headline.
std::string card(const std::string& link, const std::string& picture, const std::string& text) {
  const std::size_t end = std::min(text.find(". "), text.size() - 1) + 1;
  return fmt::format("<li class=finding><a href=\"{}\">{}<span><b>{}</b>{}</span></a></li>\n", html(link), picture,
                     html(text.substr(0, end)), html(text.substr(end)));
}

/// What matters, each with its picture.
std::string findings_html(const Findings& findings, const std::vector<Result>& all) {
  std::string cards;
  for (const Report& report : findings.reports)
    for (const formats::Section& section : report.sections) {
      if (section.finding.empty()) continue;
      const formats::Panel* panel = section.evidence          ? &*section.evidence
                                    : section.figures.empty() ? nullptr
                                                              : &section.figures.front().panels.front();
      cards += card(fmt::format("{0}.html#{0}-{1}", report.paper, section.id), panel ? formats::preview(*panel) : "",
                    section.finding);
    }
  if (const Score statements = score(all, ResultKind::statement); statements.wrong > 0) {
    std::string bars;
    for (const Report& report : findings.reports)
      if (const Score of_paper = score(all, ResultKind::statement, report.paper); of_paper.all() > 0)
        bars += fmt::format("<span class=name>{}</span>{}", html(report.paper), bar(of_paper));
    cards += card(
        "errata.html", "<span class=\"preview bars\">" + bars + "</span>",
        fmt::format("{} of {} statements of the papers are misprinted or false, each with a witness and, where "
                    "there is one, its correction.",
                    statements.wrong, statements.all()));
  }
  return cards.empty() ? "" : "<h2>What matters</h2>\n<ul class=findings>\n" + cards + "</ul>\n";
}

std::string paper_html(const Report& report, const std::vector<Result>& all) {
  const bool is_figure_only = report.sections.empty();
  std::vector<std::string> parts;
  for (const formats::Section& section : report.sections)
    parts.push_back(
        fmt::format("<a href=\"{0}.html#{0}-{1}\">{2}</a>", report.paper, section.id, html(section.heading)));
  return fmt::format("<section class=report>\n<h3><a href=\"{}.html\">{}</a></h3>\n{}{}</section>\n", report.paper,
                     html(title_of(report.citation)), score_bars(all, report.paper),
                     is_figure_only
                         ? ""
                         : fmt::format("<details><summary>{} {}</summary><p class=parts>{}</p></details>\n",
                                       parts.size(), parts.size() == 1 ? "part" : "parts", fmt::join(parts, " ")));
}

constexpr const char* how_to_read =
    "<h2 id=how>How to read it</h2>\n<p>Every number set beside a printed value was computed in exact rational "
    "arithmetic, or enclosed with outward rounding. In each cell the printed value stands first, ours below it, then "
    "the verdict: <b>match</b> where our enclosure is narrower than one unit of the last printed place and within "
    "one such unit of the printed value, <b>mismatch</b> where our result excludes that, <b>open</b> where it does "
    "not decide yet. A cell tells more when it is chosen: the enclosure, the reason, the command that computes it "
    "again, and a link to keep.</p>\n";

constexpr const char* about_experiments =
    "<p>Experiments are another matter: they repeat what a paper shows once, over many samples of random noise, in "
    "double precision. Each sentence of the text has a statistic that decides it: <b>confirmed</b> or <b>not "
    "confirmed</b>, with numbers; <b>not-reproducible</b> where it rests on data that were not published.</p>\n";

}  // namespace

std::string score_bars(const std::vector<Result>& results, const std::string& paper) {
  std::string lines;
  for (const auto& [kind, name, right, wrong] : kinds) {
    const Score total = score(results, kind, paper);
    if (total.all() == 0) continue;
    const std::string link = fmt::format("results.html?kind={}{}", to_text(kind),
                                         paper.empty() ? "" : "&amp;paper=" + html(paper));
    const std::map<std::string, std::string> words{
        {"wrong", wrong}, {"open", "open"}, {"uncheckable", "cannot be checked"}};
    std::vector<std::string> others;
    for (const auto& [group, count] : groups(total))
      if (const auto word = words.find(group); count > 0 && word != words.end())
        others.push_back(fmt::format("<a href=\"{}&amp;verdict={}\">{} {}</a>", link, group, count, word->second));
    const std::string head = total.checked() == 0
                                 ? std::string(name)
                                 : fmt::format("<b>{}</b> of {} {} {}", total.right, total.checked(), name, right);
    lines += fmt::format("<li><a href=\"{}\">{}</a><small>{}</small>{}</li>\n", link, head, fmt::join(others, ", "),
                         bar(total));
  }
  return lines.empty() ? "" : "<ul class=scores>\n" + lines + "</ul>\n";
}

std::string front_page(const Findings& findings) {
  const std::vector<Result> all = results(findings);
  std::string body =
      "<h1>Printed values, recomputed</h1>\n<p class=lead>What papers on least squares subdivision print, "
      "computed again with proof, and what is wrong in them.</p>\n";
  body += score_bars(all);
  body += "<nav aria-label=\"Everything\"><a href=\"results.html\">Every result</a> ";
  if (!findings.statements.empty()) body += "<a href=\"errata.html\">Errata and confirmations</a> ";
  body += "<a href=\"summary.txt\">As text</a> <a href=\"#how\">How to read it</a></nav>\n";
  body += findings_html(findings, all) + "<h2>The papers</h2>\n";
  for (const Report& report : findings.reports) body += paper_html(report, all);
  body += how_to_read;
  if (std::ranges::any_of(findings.reports, [](const Report& r) { return !r.experiments.empty(); }))
    body += about_experiments;
  return formats::html_page("subcert: printed values, recomputed", body);
}

}  // namespace subcert::reports
