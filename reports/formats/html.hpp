#pragma once
/// What the pages share.

#include <string>

namespace subcert::formats {

/// The text with &, <, > and quotes escaped.
std::string html(const std::string& text);

/// The style sheet of all pages.
const std::string& page_style();

}  // namespace subcert::formats
