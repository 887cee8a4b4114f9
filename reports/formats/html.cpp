#include "html.hpp"

#include <fmt/ranges.h>

namespace subcert::formats {
namespace {

const std::string& page_style() {
  static const std::string style = R"css(
:root { color-scheme: light dark; --ink: #1c2733; --page: #fff; --quiet: #5a6773; --line: #d9dfe5; --link: #0b559f;
        --band: #eef3f7; --good: #1e7a43; --bad: #b3261e; --bad-band: #fdecea; --open: #8a5a00; --open-band: #fff7e0;
        --curve-1: #0b559f; --curve-2: #c0392b; --curve-3: #1e8449; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e3e8ee; --page: #12171d; --quiet: #9aa7b4; --line: #323c47; --link: #7fb8f0; --band: #1b232c;
          --good: #6fce95; --bad: #ff8f85; --bad-band: #3a1f1d; --open: #e7b75a; --open-band: #33290f;
          --curve-1: #7fb8f0; --curve-2: #ff8f7a; --curve-3: #6fce95; }
  figure img { background: #fff; }
}
* { box-sizing: border-box; }
body { font: 16px/1.55 system-ui, "DejaVu Sans", sans-serif; color: var(--ink); background: var(--page); margin: 0 auto;
       padding: 2rem 1.25rem 5rem; max-width: 64rem; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 .5rem; }
h1.paper { font-size: 1.25rem; margin: 4rem 0 1rem; padding: .9rem 1rem; background: var(--band); }
h2 { font-size: 1.4rem; margin: 3rem 0 .75rem; padding-top: .75rem; border-top: 2px solid var(--ink); }
h3 { font-size: 1.05rem; margin: 2rem 0 .1rem; }
p { max-width: 46rem; }
.place, figcaption, .citation { color: var(--quiet); font-size: .9rem; margin-top: 0; }
.citation { margin-top: 1rem; }
nav a { margin-right: 1.2rem; }
a { color: var(--link); }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: .92rem; margin: .5rem 0 1rem; }
th, td { padding: .35rem .7rem; border-bottom: 1px solid var(--line); text-align: right; vertical-align: top;
         white-space: nowrap; }
th:first-child, th.left { text-align: left; }
th { font-weight: 600; }
td.wide { white-space: normal; text-align: left; overflow-wrap: anywhere; font-family: "DejaVu Sans Mono", monospace;
          font-size: .82rem; min-width: 14rem; }
td span { display: block; }
.computed { color: var(--quiet); font-size: .82rem; }
.verdict { font-size: .75rem; font-weight: 600; letter-spacing: .02em; }
.match .verdict { color: var(--good); }
.mismatch { background: var(--bad-band); }
.mismatch .verdict { color: var(--bad); }
.open { background: var(--open-band); }
.open .verdict { color: var(--open); }
td.proof { white-space: normal; text-align: left; min-width: 14rem; max-width: 26rem; }
td.proof output { display: block; font-size: .78rem; overflow-wrap: anywhere; max-height: 9rem; overflow-y: auto; }
output.proved { color: var(--good); }
output.refused { color: var(--bad); }
figure { margin: 1.5rem 0; }
figure img { max-width: 100%; height: auto; display: block; }
details { margin: .5rem 0 1rem; }
summary { cursor: pointer; }
details li { margin: .2rem 0; }
.summary td, .summary th { text-align: left; }
@media print { body { max-width: none; } .scroll { overflow: visible; } }
td.text, th.text { white-space: normal; text-align: left; min-width: 12rem; }
.holds .verdict, .holds-for-all-n .verdict { color: var(--good); }
.misprint .verdict, .false .verdict { color: var(--bad); }
.not-checkable .verdict, .undecided .verdict { color: var(--open); }
/* formulas and statements: begin */
:root { --good-band: #e6f5ec; }
@media (prefers-color-scheme: dark) { :root { --good-band: #173325; } }
math { font-family: "STIX Two Math", "Latin Modern Math", "Cambria Math", "TeX Gyre Termes Math",
       "DejaVu Math TeX Gyre", math; font-size: 1.1em; line-height: normal; }
.formula { overflow-x: auto; overflow-y: hidden; padding: .15rem .25rem; line-height: 1.7; }
.formula math { margin-block: .3em; }
.formula .quad { margin-inline-end: 1em; }
.statement { margin: 1.5rem 0; padding: .2rem 0 .2rem 1rem; border-left: 4px solid var(--line); }
.statement.misprint, .statement.false { border-left-color: var(--bad); }
.statement p { margin: .25rem 0; }
.statement .head { font-weight: 600; }
.statement dl { display: grid; grid-template-columns: 6rem minmax(0, 1fr); margin: .25rem 0; font-size: .92rem; }
.statement dt, .label { color: var(--quiet); font-size: .82rem; }
.statement dd { margin: 0; overflow-wrap: anywhere; }
.statement details { margin: .25rem 0; font-size: .82rem; color: var(--quiet); }
.statement pre { white-space: pre-wrap; overflow-wrap: anywhere; margin: .4rem 0; }
.statement code, td code { font-family: "DejaVu Sans Mono", monospace; font-size: .82rem; overflow-wrap: anywhere; }
.forms { display: flex; flex-wrap: wrap; gap: .5rem; margin: .5rem 0; }
.forms > div { flex: 1 1 19rem; max-width: 100%; padding: .25rem .75rem; background: var(--band); }
.changed { outline: 1px solid; border-radius: 2px; padding-block: .06em; }
mo.changed { padding-block: .2em; }
.printed .changed { color: var(--bad); background: var(--bad-band); }
.corrected .changed { color: var(--good); background: var(--good-band); }
@media (max-width: 40rem) { .statement dl { grid-template-columns: minmax(0, 1fr); } }
@media print { .formula { overflow: visible; } }
/* formulas and statements: end */
)css";
  return style;
}

}  // namespace

std::string html(const std::string& text) {
  std::string result;
  for (char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

std::string html_page(const std::string& title, const std::string& body) {
  return "<!doctype html>\n<html lang=en>\n<head>\n<meta charset=utf-8>\n<meta name=viewport "
         "content=\"width=device-width, initial-scale=1\">\n<title>" +
         title + "</title>\n<style>" + page_style() + "</style>\n</head>\n<body>\n" + body + "</body>\n</html>\n";
}

std::string summary_html(const std::vector<std::string>& head, const std::vector<SummaryRow>& rows) {
  if (rows.empty()) return "";
  std::string result = fmt::format("<div class=scroll><table class=summary>\n<tr><th>{}</th></tr>\n",
                                   fmt::join(head, "</th><th>"));
  for (const auto& [anchor, title, counts] : rows)
    result += fmt::format("<tr><th><a href=\"#{}\">{}</a></th><td>{}</td></tr>\n", anchor, html(title),
                          fmt::join(counts, "</td><td>"));
  return result + "</table></div>\n";
}

}  // namespace subcert::formats
