#pragma once
/// What the pages share.

#include <string>
#include <vector>

namespace subcert::formats {

/// The text with &, <, > and quotes escaped.
std::string html(const std::string& text);

/// A page: its title, the style sheet of all pages, and the body.
std::string html_page(const std::string& title, const std::string& body);

/// What a summary counts: its place on the page, its name, the counts.
struct SummaryRow {
  std::string anchor, title;
  std::vector<std::size_t> counts;
};

/// A table of counts; nothing where there are no rows.
std::string summary_html(const std::vector<std::string>& head, const std::vector<SummaryRow>& rows);

}  // namespace subcert::formats
