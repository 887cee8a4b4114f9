#pragma once
/// Bytes inside text.

#include <string>

namespace subcert::formats {

/// As in RFC 4648, section 4.
std::string base64(const std::string& bytes);

}  // namespace subcert::formats
