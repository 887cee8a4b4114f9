#pragma once
/// Lists of integers as a command line states them: `1..40`, `1,3,5`, `1..5,10,20..22`.

#include <string>
#include <string_view>
#include <vector>

namespace subcert {

/// Reads integers and ranges A..B with A <= B, separated by commas; gives them in increasing order, each once. Domain:
/// 0 <= lowest <= highest. Errors: throws ParseError with the subject, the token, its position and what would be right.
std::vector<int> parse_number_list(const std::string& subject, std::string_view text, int lowest, int highest);

/// The shortest such text, with ranges for three and more neighbours. Domain: increasing.
std::string number_list_text(const std::vector<int>& numbers);

}  // namespace subcert
