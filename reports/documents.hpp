#pragma once
/// The documents of the project that pages of a run name, `docs/l1.md`, and which stand beside them.

#include <filesystem>
#include <string>

namespace subcert::reports {

/// The page with each name of a document in its texts as a link to what write_documents() writes; names of others stay,
/// as do scripts and what is in a link. Domain: well-formed.
std::string with_documents(const std::string& page);

/// Writes FOLDER/docs/NAME.html for each document, its text as it is.
void write_documents(const std::filesystem::path& folder);

}  // namespace subcert::reports
