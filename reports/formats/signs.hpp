#pragma once
/// Where the hyphen of a text stands for a minus sign.

#include <cstddef>
#include <string>
#include <string_view>

namespace subcert::formats {

/// U+2212 in UTF-8.
inline constexpr std::string_view minus_sign = "\u2212";

/// Whether the hyphen at this place is a minus: before a number, as in `(-1/16`, `1e-8` and `[-w,`, and between terms:
/// with spaces about it, as in `n - 1`, or behind a letter, `2n-1`. Not in dates, ranges, options, words, nor in what
/// is a scheme's specification, `four-point:w=-1/16`, which readers copy. Where a text begins, a number may. Domain:
/// text[at] is a hyphen; the text may be HTML.
bool is_minus(std::string_view text, std::size_t at);

/// The text with this sign for each minus.
std::string with_minus(std::string_view text, std::string_view sign = minus_sign);

}  // namespace subcert::formats
