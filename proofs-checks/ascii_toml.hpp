#pragma once
/// TOML without characters that its parser does not expect. Inner header.

#include <string>
#include <string_view>

namespace subcert {

/// The TOML text in ASCII: characters beyond it are escaped in strings, and left out in comments. (The behaviour of
/// toml++ 3.3 is undefined for some where they do not belong.) Errors: throws FileError for such characters elsewhere,
/// and for what is not UTF-8.
std::string ascii_toml(std::string_view text);

}  // namespace subcert
