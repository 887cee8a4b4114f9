#include "formats/html.hpp"
#include "formats/svg.hpp"
#include "pages.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace subcert::reports {
namespace {

using formats::html;

/// What counts as one bar; what nothing decides stands beside it.
std::string bar(const Counts& counts) {
  const auto part = [&](Standing standing) {
    const int count = counts.of(standing);
    return count == 0 ? "" : fmt::format("<span class=\"{}\" style=\"flex-grow:{}\"></span>", to_text(standing), count);
  };
  const std::string counted = part(Standing::right) + part(Standing::wrong) + part(Standing::open);
  return "<span class=bar aria-hidden=true>" +
         (counted.empty()
              ? ""
              : fmt::format("<span class=counted style=\"flex-grow:{}\">{}</span>", counts.checked(), counted)) +
         part(Standing::aside) + "</span>";
}

/// Links to the groups, those that nothing decides behind the others.
std::string group_links(const Counts& counts, const std::string& link) {
  std::vector<std::string> counted, beside;
  for (const Counts::Group& group : counts.groups)
    (group.standing == Standing::aside ? beside : counted)
        .push_back(fmt::format("<a href=\"{}&amp;verdict={}\">{}</a>", link, to_text(group.standing), group.text()));
  return fmt::format("{}{}{}", fmt::join(counted, ", "), counted.empty() || beside.empty() ? "" : "; beside them ",
                     fmt::join(beside, ", "));
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
  if (const std::string errata = errata_sentence(counts(all, ResultKind::statement)); !errata.empty()) {
    std::string bars;
    for (const Report& report : findings.reports)
      if (const Counts of_paper = counts(all, ResultKind::statement, report.paper); of_paper.all() > 0)
        bars += fmt::format("<span class=name>{}</span>{}", html(report.paper), bar(of_paper));
    cards += card("errata.html", "<span class=\"preview bars\">" + bars + "</span>", errata);
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
    "not decide yet. Values that only follow from other printed ones, as products or as formulas evaluated, are "
    "compared and not counted. A cell tells more when it is chosen: the enclosure, the reason, the command that "
    "computes it "
    "again, and a link to keep.</p>\n";

constexpr const char* about_experiments =
    "<p>Experiments are another matter: they repeat what a paper shows once, over many samples of random noise, in "
    "double precision. Each sentence of the text has a statistic that decides it. It <b>holds as printed</b>, or <b>in "
    "a weaker reading</b> that says less than its words; or its <b>contrary is shown</b>, under every fair choice that "
    "was tried; or it <b>depends on a choice the paper leaves open</b>; it stands <b>on our data only</b> where the "
    "paper's data were not published, which is a remark and no minus; it is <b>undecided</b> where more samples would "
    "be needed.</p>\n";

constexpr const char* how_to_object =
    "<h2 id=object>How to object</h2>\n<p>The texts of the papers were typed in from what was at hand, and each "
    "verdict "
    "rests on a reading; the authors were not asked. Whatever is misread is ours to correct. Every result has a link "
    "and "
    "the command that computes it again; what was typed in stands in "
    "<code>proofs-checks/papers/PAPER/paper.toml</code> "
    "of the sources, to be corrected without any C++. An issue with the link and the right reading is enough "
    "(<code>CONTRIBUTING.md</code>).</p>\n";

/// What a scheme does: corners are cut at a quarter, again and again.
std::string example_html() {
  using Points = std::vector<std::pair<double, double>>;
  const Points points{{0, 0}, {1, 2}, {3, 2.5}, {4, 0.5}, {6, 1}, {6.5, 3}};
  Points curve = points;
  for (int level = 0; level < 5; ++level) {
    Points next;
    for (std::size_t i = 0; i + 1 < curve.size(); ++i)
      for (const double t : {0.25, 0.75})
        next.emplace_back(std::lerp(curve[i].first, curve[i + 1].first, t),
                          std::lerp(curve[i].second, curve[i + 1].second, t));
    curve = std::move(next);
  }
  formats::Panel panel{"", "", "", {{"six points", points, true}, {"the curve of Chaikin's scheme", curve}}};
  panel.curves.front().colour = "#999999";
  panel.equal_units = true;
  return formats::preview(panel);
}

/// What subcert is, how much holds, and which version made this page from what and when.
std::string origin_html(const Origin& origin, const std::string& standing) {
  std::string made;
  if (!origin.version.empty()) made += "subcert " + html(origin.version);
  if (!origin.commit.empty()) made += " (" + html(origin.commit) + ")";
  if (!origin.input.empty()) made += ", from <code>" + html(origin.input) + "</code>";
  if (!origin.when.empty()) made += ", on " + html(origin.when);
  return "<div class=intro><div>\n<p class=lead>A subdivision scheme draws a smooth curve or surface through or near a "
         "few points: it puts new points between the old ones, each an average of its neighbours, again and again. "
         "How smooth are the curves, and how much noise do they leave? subcert decides that from the numbers of the "
         "scheme, with a proof that other programs check.</p>\n<p>These pages recompute what papers on least squares "
         "schemes print: numbers as exact fractions or enclosures rounded outward, formulas and theorems as executable "
         "checks, experiments over many samples. " +
         html(standing) + "</p>\n" +
         (made.empty() ? "" : "<p class=place>Made by " + made + ". <a href=\"#object\">How to object</a></p>\n") +
         "</div><div class=example aria-hidden=true>" + example_html() + "</div></div>\n";
}

}  // namespace

std::string score_bars(const std::vector<Result>& results, const std::string& paper) {
  std::string lines;
  for (const ResultKind kind : {ResultKind::statement, ResultKind::value, ResultKind::claim}) {
    const Counts total = counts(results, kind, paper);
    if (total.all() == 0) continue;
    const std::string link = fmt::format("results.html?kind={}{}", to_text(kind),
                                         paper.empty() ? "" : "&amp;paper=" + html(paper));
    lines += fmt::format("<li><a href=\"{}\">{}</a><small>{}</small>{}</li>\n", link,
                         total.head().empty() ? to_text(kind) + "s" : "<b>" + total.head() + "</b>",
                         group_links(total, link), bar(total));
  }
  return lines.empty() ? "" : "<ul class=scores>\n" + lines + "</ul>\n";
}

std::string front_page(const Findings& findings) {
  const std::vector<Result> all = results(findings);
  std::string body = "<h1>subcert: claims about subdivision schemes, proved or refuted</h1>\n" +
                     origin_html(findings.origin, standing_sentence(counts(all, ResultKind::statement)));
  if (!findings.complete)
    body +=
        "<p class=place>The experiments are still being computed; this page is written anew when they are done.</p>\n";
  body += score_bars(all);
  body += "<nav aria-label=\"Everything\"><a href=\"results.html\">Every result</a> ";
  if (!findings.statements.empty()) body += "<a href=\"errata.html\">Errata and confirmations</a> ";
  body += "<a href=\"summary.txt\">As text</a> <a href=\"#how\">How to read it</a></nav>\n";
  body += findings_html(findings, all) + "<h2>The papers</h2>\n";
  for (const Report& report : findings.reports) body += paper_html(report, all);
  body += how_to_read;
  if (std::ranges::any_of(findings.reports, [](const Report& r) { return !r.experiments.empty(); }))
    body += about_experiments;
  body += how_to_object;
  return formats::html_page("subcert: claims about subdivision schemes, proved or refuted", body);
}

}  // namespace subcert::reports
