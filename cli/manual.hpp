#pragma once
/// Manual pages, from what help says.

#include "options.hpp"

#include <string>

namespace subcert::cli {

/// The page of the program, or of a command of it, as groff source with the macros of man(7). Commands of a group are
/// sections of its page. `checker_usage`: what subcert-check says of itself, for the page of that name, which the
/// command `check` and that program share.
std::string manual_page(const CommandHelp& program, const CommandHelp& command, const std::string& checker_usage);

/// `subcert-range` of the command `range`.
std::string page_name(const CommandHelp& command);

}  // namespace subcert::cli
