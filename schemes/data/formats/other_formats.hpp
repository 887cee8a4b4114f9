#pragma once
/// Files that are no tables, told by their first bytes.

#include <string>
#include <string_view>

namespace subcert::data {

/// What the content is and what makes a table of it, as `a file packed by gzip (gunzip unpacks it)`; nothing for what
/// may be text in UTF-8.
std::string other_format(std::string_view content);

}  // namespace subcert::data
