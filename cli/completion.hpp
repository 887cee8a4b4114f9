#pragma once
/// Scripts with which shells complete the command line: commands, options, and the words suggested for their values.

#include "options.hpp"

#include <string>

namespace subcert::cli {

/// For bash 4 or later.
std::string bash_completion(const CommandHelp& program);
/// For zsh 5.1 or later; to be sourced, or as a file `_subcert` on the fpath.
std::string zsh_completion(const CommandHelp& program);
/// For fish 3 or later.
std::string fish_completion(const CommandHelp& program);

}  // namespace subcert::cli
