#pragma once
/// What the commands about vertices share.

#include "command.hpp"

#include <subcert/schemes/vertices/vertex_rules.hpp>

#include <string>
#include <vector>

namespace subcert::cli {

/// Whether that is the name of a file with rules at vertices.
inline bool is_rules_file(const std::string& text) { return text.ends_with(".toml") && !text.starts_with("lists:"); }

/// A scheme by its name, or rules that a file says. Errors: throws a usage error, or one of the file.
VertexScheme read_vertex_scheme(const std::string& text);

/// Errors: throws a usage error for rules with a letter without a value, where `task` takes no ranges of it.
void require_values(const VertexScheme& scheme, const std::string& task);

/// Such rules with the letters of these ranges free. Errors: throws a usage error.
VertexScheme read_free_rules(const std::string& text, const std::vector<std::string>& names);

}  // namespace subcert::cli
