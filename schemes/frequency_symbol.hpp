#pragma once
/// Symbols as functions of a frequency.

#include <optional>
#include <string>
#include <string_view>

namespace subcert {

/// `2 cos^4(w/2) e^{-iw}` as `symbol:` in z = e^{iw}; nothing for a text without exp, e^{i...}, cos or sin. The
/// frequency is a letter, but not i or j, or a Greek name; its multiples are those of 1/2, and powers of a sine even.
/// `a(w) =` may stand in front, fields of a symbol behind, and parameters beside where no odd multiple of w/2 is left.
/// Domain: at most 30,000 characters. Errors: throws SpecificationError for another argument, and for what is no
/// Laurent polynomial in z.
std::optional<std::string> frequency_symbol_as_written(std::string_view written);

}  // namespace subcert
