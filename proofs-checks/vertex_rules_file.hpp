#pragma once
/// Files with rules at vertices.

#include <subcert/schemes/vertices/vertex_rules.hpp>

#include <string>
#include <string_view>

namespace subcert {

/// Reads a tuned scheme from TOML: which scheme it changes, and the rules at vertices that are its own
/// (docs/vertices.md, section 6). Errors: throws Error that names the file, line and key. Cost: reading each rule once.
VertexScheme read_vertex_rules(std::string_view toml, const std::string& file);

}  // namespace subcert
