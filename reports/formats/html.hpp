#pragma once
/// What the pages share.

#include <string>

namespace subcert::formats {

/// The text with &, <, > and quotes escaped.
std::string html(const std::string& text);

/// A page: its title, the style sheet of all pages, and the body.
std::string html_page(const std::string& title, const std::string& body);

}  // namespace subcert::formats
