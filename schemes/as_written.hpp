#pragma once
/// Schemes as papers and people write them.

#include <string>
#include <string_view>
#include <vector>

namespace subcert {

/// The specification that a text stands for; a text that is one already comes back as it is. Names without regard to
/// case, with _ for -, and other names (`chaikin`, `DD4`); masks without their family (`[1,3,3,1]/4`), with a factor in
/// front (`1/4*[1,3,3,1]`) or rows as in MATLAB (`[1 2 1; 2 4 2; 1 2 1]/4`); symbols without theirs (`(1+z)^3/4z`);
/// pasted characters and LaTeX as plain_text has them. The readers of specifications check the rest. Errors: throws
/// SpecificationError where the text could mean two things. Domain: at most 30,000 characters.
std::string specification_as_written(std::string_view text);

/// The other names of schemes, as `chaikin`.
std::vector<std::string> other_names();

}  // namespace subcert
