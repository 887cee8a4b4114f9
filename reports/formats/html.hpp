#pragma once
/// What the pages share.

#include <string>
#include <vector>

namespace subcert::formats {

/// The text with &, <, > and quotes escaped.
std::string html(const std::string& text);
/// The same of at most so many bytes, and dots in place of the rest. No character of UTF-8 is cut.
std::string shortened_html(const std::string& text, std::size_t longest);

/// What stays of a text in a link: letters, digits, and single hyphens for the rest; at most 60 characters.
std::string slug(const std::string& text);

/// A page: its title, the style sheet of all pages, the body as typeset() has it, which program made it, and those
/// scripts that something in the body needs. The footer has the SHA-256 of the inputs, as lines of a file.
std::string html_page(const std::string& title, const std::string& body, const std::vector<std::string>& inputs = {});

/// Data for the scripts of a page, as the JSON text of an element with this id.
std::string data_script(const std::string& id, const std::string& json);

/// What a summary counts: its place on the page, its name, the counts.
struct SummaryRow {
  std::string anchor, title;
  std::vector<std::size_t> counts;
};

/// A table of counts; nothing where there are no rows.
std::string summary_html(const std::vector<std::string>& head, const std::vector<SummaryRow>& rows);

/// As in RFC 4648, section 4.
std::string base64(const std::string& bytes);

}  // namespace subcert::formats
