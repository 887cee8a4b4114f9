#include "files.hpp"

#include <subcert/analysis/symbol/error.hpp>

#include <unistd.h>

#include <fstream>
#include <system_error>

namespace subcert::runtime {

void write_file_with(const std::filesystem::path& path,
                     const std::function<void(const std::filesystem::path&)>& write) {
  std::error_code error;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
  if (error)
    fail(ErrorKind::missing_file, "cannot make the folder {}: {}", path.parent_path().string(), error.message());
  std::filesystem::path temporary = path;
  temporary += ".part" + std::to_string(getpid());
  try {
    write(temporary);
    std::filesystem::rename(temporary, path, error);
    if (error) fail(ErrorKind::missing_file, "cannot write {}: {}", path.string(), error.message());
  } catch (...) {
    std::filesystem::remove(temporary, error);
    throw;
  }
}

void write_stream(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write) {
  write_file_with(path, [&](const std::filesystem::path& temporary) {
    std::ofstream stream(temporary, std::ios::binary);
    write(stream);
    stream.close();
    if (!stream) fail(ErrorKind::missing_file, "cannot write {}", path.string());
  });
}

void write_file(const std::filesystem::path& path, const std::string& content) {
  write_stream(path, [&](std::ostream& stream) { stream << content; });
}

}  // namespace subcert::runtime
