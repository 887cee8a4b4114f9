#include "html.hpp"

#include "provenance.hpp"
#include "typeset.hpp"

#include <subcert/proofs-checks/certificates/identity.hpp>

#include <fmt/ranges.h>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include <cctype>
#include <map>
#include <set>
#include <string_view>

namespace subcert {

extern const std::map<std::string, std::string_view> page_files;  // by their names without ending

}  // namespace subcert

namespace subcert::formats {
namespace {

/// A script, and a piece of HTML that needs it.
struct PageScript {
  const char* name;
  const char* needed_by;
};

constexpr const char* check_button = "class=check";
constexpr PageScript page_scripts[] = {
    {"load", check_button},        {"load", "class=turn"},           {"check_here", check_button},
    {"surface", "class=turn"},     {"surface", "data-surface="},     {"signs", "<svg class=\"picture"},
    {"signs", "id=\"details\""},   {"signs", "<form class="},        {"plot", "<svg class=\"picture"},
    {"details", "id=\"details\""}, {"filter", "<form class=filter"}, {"explorer", "<form class=explorer"}};

/// The checker runs in a worker, which gets it as a text.
constexpr const char* worker = "checker";

std::string scripts_for(const std::string& body) {
  const auto needs = [&](const char* piece) { return body.find(piece) != std::string::npos; };
  std::string result;
  if (needs(check_button))
    result = fmt::format("<script type=\"text/plain\" id={}>\n{}</script>\n", worker, page_files.at(worker));
  std::set<std::string> there;
  for (const auto& [name, needed_by] : page_scripts)
    if (needs(needed_by) && there.insert(name).second)
      result += fmt::format("<script>\n{}</script>\n", page_files.at(name));
  return result;
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

std::string shortened_html(const std::string& text, std::size_t longest) {
  if (text.size() <= longest) return html(text);
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;  // inside a character
  return html(text.substr(0, end)) + " ...";
}

std::string slug(const std::string& text) {
  constexpr std::size_t longest = 60;
  std::string result;
  for (const char c : text)
    if (std::isalnum(static_cast<unsigned char>(c)))
      result += c;
    else if (!result.empty() && result.back() != '-' && result.size() < longest)
      result += '-';
  if (result.size() > longest) result.resize(longest);
  while (!result.empty() && result.back() == '-') result.pop_back();
  return result;
}

namespace {

/// `, from chaikin (SHA-256 of that line e2d2...)`
std::string origin_html(const std::vector<std::string>& inputs) {
  if (inputs.empty()) return "";
  const std::string lines = fmt::format("{}\n", fmt::join(inputs, "\n"));
  const bool one = inputs.size() == 1;
  return fmt::format(", from {} (SHA-256 of {} <code>{}</code>)",
                     one ? "<code>" + html(inputs.front()) + "</code>" : fmt::format("{} schemes", inputs.size()),
                     one ? "that line" : "these, one a line,", content_id(lines));
}

}  // namespace

std::string html_page(const std::string& title, const std::string& body, const std::vector<std::string>& inputs) {
  const std::string from = commit(), made = std::string("subcert ") + version() +
                                            (from.empty() ? "" : ", commit " + from + " of " + date());
  return fmt::format(
      "<!doctype html>\n<html lang=en>\n<head>\n<meta charset=utf-8>\n<meta name=viewport "
      "content=\"width=device-width, initial-scale=1\">\n<meta name=generator content=\"{}\">\n<title>{}</title>\n"
      "<style>\n{}</style>\n</head>\n<body>\n<main>\n{}<footer class=place>Made by {}{}.</footer>\n</main>\n{}"
      "</body>\n</html>\n",
      made, title, page_files.at("style"), typeset(body), made, origin_html(inputs), scripts_for(body));
}

std::string data_script(const std::string& id, const std::string& json) {
  std::string text;
  for (const char c : json) text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return fmt::format("<script type=\"application/json\" id=\"{}\">{}</script>\n", html(id), text);
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

std::string base64(const std::string& bytes) {
  using boost::archive::iterators::base64_from_binary;
  using boost::archive::iterators::transform_width;
  using Sextets = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  std::string text(Sextets(bytes.begin()), Sextets(bytes.end()));
  text.append((3 - bytes.size() % 3) % 3, '=');
  return text;
}

}  // namespace subcert::formats
