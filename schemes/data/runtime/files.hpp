#pragma once
/// Output files that are whole or not there.

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>

namespace subcert::runtime {

/// Lets `write` fill a file of a temporary name in the same folder, then renames it to `path`; folders are made.
/// Errors: throws missing_file and names the file; nothing is left behind then, and an older file stays.
void write_file(const std::filesystem::path& path, const std::string& content);
void write_stream(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);
void write_file_with(const std::filesystem::path& path, const std::function<void(const std::filesystem::path&)>& write);

}  // namespace subcert::runtime
