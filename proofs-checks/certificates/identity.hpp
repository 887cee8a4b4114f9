#pragma once
/// Names of certificates that follow from their content.

#include <string>
#include <string_view>

namespace subcert {

/// SHA-256 of the text, as 64 hexadecimal digits, as `sha256sum` prints it. Ref: FIPS 180-4.
std::string content_id(std::string_view text);

}  // namespace subcert
