#pragma once
/// Output files that are whole or not there.

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>

namespace subcert::runtime {

/// Lets `write` fill a file of a temporary name, `path` with .part and the number of the process, in the same folder,
/// then renames it to `path`; folders are made. Where `path` is a link, the file that it leads to is written; a device
/// or a pipe is written as it is. Errors: throws missing_file and names the file and the reason; nothing is left behind
/// then, and an older file stays.
void write_file(const std::filesystem::path& path, const std::string& content);
void write_stream(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);
void write_file_with(const std::filesystem::path& path, const std::function<void(const std::filesystem::path&)>& write);

/// A folder of its own among the temporary files, those that TMPDIR names or else /tmp, removed with all that is in it.
class TemporaryFolder {
 public:
  /// Errors: throws missing_file where it cannot be made.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string operator/(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

}  // namespace subcert::runtime
