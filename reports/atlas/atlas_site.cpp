#include "atlas_site.hpp"

#include "entry_facts.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>
#include <subcert/proofs-checks/certificates/claim.hpp>
#include <subcert/reports/formats/html.hpp>
#include <subcert/reports/formats/limit_figure.hpp>
#include <subcert/reports/formats/section.hpp>
#include <subcert/reports/formats/svg.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <fmt/format.h>

#include <map>

namespace subcert::reports {
namespace {

using atlas::Json;
using formats::html;

constexpr std::size_t entries_of_page = 125, longest = 200;  // bytes of a text
constexpr const char* certificates = "certificates";

std::string text_of(const Json& entry, const char* name) { return entry.at(name).get<std::string>(); }

/// What a reader may search for beside numbers.
std::string words_of(const Json& entry) {
  std::string words = entry.at("variables") == 1 ? "" : "surface, ";
  words += entry.at("arity").is_null() ? "another dilation" : "arity " + entry.at("arity").dump();
  for (const char* name : {"interpolatory", "symmetric"})
    if (entry.at(name) == true) words += std::string(", ") + name;
  if (entry.at("non_negative") == true) words += ", non-negative";
  if (entry.at("stable") == "yes") words += ", stable";
  if (entry.at("attained") == true) words += ", attained";
  if (entry.at("converges") == "no") words += ", diverges";
  return words;
}

std::string row(const Json& entry, const std::string& page) {
  const facts::Facts list = facts::entry_facts(entry);
  const auto* holder = facts::find(list, "holder");
  const std::string id = text_of(entry, "id"), title = facts::title_of_entry(entry), mask = text_of(entry, "mask");
  return fmt::format(
      "<tr><td><a href=\"{}.html#{}\">{}</a></td><td>{}{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
      page, id, id, formats::shortened_html(title, longest),
      title == mask ? "" : "<br><small>" + formats::shortened_html(mask, longest) + "</small>",
      holder ? html(holder->text) : "none", entry.at("sum_rules").dump(),
      entry.at("support").is_null() ? "" : html(text_of(entry, "support")), words_of(entry));
}

/// Nothing where there are no limits, or no values of them.
std::string picture(const Json& entry) {
  if (entry.at("converges") != "yes") return "";
  try {
    formats::Panel panel = formats::limit_panel(make_scheme(text_of(entry, "mask")).mask.curve(), "");
    panel.title = "The basic limit function" + panel.title;
    return "<div class=pictures><figure>" + formats::svg(panel) +
           "<figcaption><i>φ</i>, the basic limit function</figcaption></figure></div>\n";
  } catch (const Error&) {
    return "";
  }
}

/// The proof of the exponent, as the checker is asked about it.
formats::RowProof proof_of(const std::string& id, const std::string& certificate) {
  const std::string name = id + ".cert";
  return {name, checker_arguments(read_claim(certificate, name), name), {{name, certificate}}};
}

std::string article(const Json& entry, const formats::RowProof& proof) {
  const std::string id = text_of(entry, "id");
  std::string known;
  for (const facts::Fact& fact : facts::entry_facts(entry))
    if (!fact.label.empty() && fact.key != "id")
      known += fmt::format("<dt>{}</dt><dd{}>{}</dd>\n", html(fact.label), fact.key == "mask" ? " class=mask" : "",
                           html(fact.text));
  if (!proof.name.empty())
    known += "<dt>proof</dt><dd class=proof>" + formats::check_button(certificates, proof) + "</dd>\n";
  return fmt::format(
      "<article class=plate id=\"{0}\">\n<h2><a href=\"#{0}\">{0}</a></h2>\n<p class=subtitle>{1}</p>\n<dl>\n"
      "{2}</dl>\n{3}</article>\n",
      id, formats::shortened_html(facts::title_of_entry(entry), longest), known, picture(entry));
}

/// The entries of a page, and the files of their proofs.
void write_page(const atlas::Atlas& atlas, const std::string& name, const std::vector<std::string>& ids,
                const std::filesystem::path& folder, int jobs) {
  std::vector<Json> entries;
  std::vector<formats::RowProof> proofs;
  for (const std::string& id : ids) {
    entries.push_back(*atlas.find(id));
    const auto certificate = atlas.certificate(id);
    proofs.push_back(certificate ? proof_of(id, *certificate) : formats::RowProof{});
    if (!certificate) continue;
    const std::filesystem::path file = folder / certificates / proofs.back().name;
    runtime::write_file(file, *certificate);
    runtime::write_file(file.string() + ".js", formats::certificate_script(certificates, proofs.back()));
  }
  std::vector<std::string> articles(entries.size());
  parallel_tasks(entries.size(), jobs, [&](std::size_t i) { articles[i] = article(entries[i], proofs[i]); });
  std::string body = "<p class=up><a href=\"index.html\">All entries</a></p>\n<h1>Entries " + name + "...</h1>\n";
  for (const std::string& one : articles) body += one;
  runtime::write_file(folder / (name + ".html"), formats::html_page("Atlas of masks: " + name, body));
}

std::string index_page(const std::string& rows, std::size_t count) {
  return formats::html_page(
      "An atlas of masks",
      fmt::format(
          "<h1>An atlas of masks</h1>\n<p>{} masks of subdivision schemes, each for all that are the same up to a "
          "shift, a reflection and several steps, with what is proved about them. The id of an entry depends on "
          "its mask alone, so it may be cited.</p>\n<form class=filter hidden>\n<label>search <input "
          "type=search name=search></label>\n<button type=reset>all</button> <output></output></form>\n<div "
          "class=scroll tabindex=0 role=region aria-label=\"Entries\"><table "
          "class=entries>\n<thead><tr><th>id</th><th>scheme</th><th>Hoelder exponent</th><th>sum "
          "rules</th><th>support</th><th>what it is</th></tr></thead>\n<tbody>\n{}</tbody>\n</table></div>\n",
          count, rows));
}

}  // namespace

std::size_t write_atlas_site(const atlas::Atlas& atlas, const std::function<bool(const Json&)>& is_wanted,
                             const std::filesystem::path& folder, int jobs) {
  std::vector<std::string> wanted;
  atlas.for_each([&](const Json& entry) {
    if (is_wanted(entry)) wanted.push_back(text_of(entry, "id"));
  });
  std::size_t digits = 1;
  for (std::size_t pages = 16; pages * entries_of_page < wanted.size(); pages *= 16) ++digits;
  std::string rows;
  std::map<std::string, std::vector<std::string>> pages;
  for (const std::string& id : wanted) {
    const std::string page = id.substr(0, digits);
    pages[page].push_back(id);
    rows += row(*atlas.find(id), page);
  }
  for (const auto& [name, ids] : pages) write_page(atlas, name, ids, folder, jobs);
  runtime::write_file(folder / "index.html", index_page(rows, wanted.size()));
  return wanted.size();
}

}  // namespace subcert::reports
