#include "files.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <system_error>

namespace subcert::runtime {

namespace {

/// Where a name leads: a link stays, and the file behind it is written.
std::filesystem::path behind_links(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_symlink(path, error)) return path;
  std::filesystem::path target = std::filesystem::weakly_canonical(path, error);
  return error ? path : target;
}

/// `reason` as errno has it; 0 where nobody knows.
[[noreturn]] void cannot_write(const std::filesystem::path& path, int reason) {
  fail(ErrorKind::missing_file, "cannot write {}{}", path.string(),
       reason == 0 ? "" : ": " + std::generic_category().message(reason));
}

}  // namespace

void write_file_with(const std::filesystem::path& path,
                     const std::function<void(const std::filesystem::path&)>& write) {
  std::error_code error;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
  if (error)
    fail(ErrorKind::missing_file, "cannot write {}: cannot make its folder: {}", path.string(), error.message());
  const std::filesystem::path target = behind_links(path);
  const std::filesystem::file_status old = std::filesystem::status(target, error);
  if (std::filesystem::is_directory(old)) cannot_write(path, EISDIR);
  if (std::filesystem::exists(old) && !std::filesystem::is_regular_file(old)) {  // nothing takes the place of a device
    write(target);
    return;
  }
  std::filesystem::path temporary = target;
  temporary += ".part" + std::to_string(getpid());
  const int file = open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) cannot_write(path, errno);
  close(file);
  try {
    write(temporary);
    if (std::filesystem::exists(old)) std::filesystem::permissions(temporary, old.permissions(), error);
    std::filesystem::rename(temporary, target, error);
    if (error) cannot_write(path, error.value());
  } catch (...) {
    std::filesystem::remove(temporary, error);
    throw;
  }
}

void write_stream(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write) {
  write_file_with(path, [&](const std::filesystem::path& temporary) {
    errno = 0;
    std::ofstream stream(temporary, std::ios::binary);
    if (stream) {
      write(stream);
      stream.close();
    }
    if (!stream) cannot_write(path, errno);
  });
}

void write_file(const std::filesystem::path& path, const std::string& content) {
  write_stream(path, [&](std::ostream& stream) { stream << content; });
}

TemporaryFolder::TemporaryFolder() {
  const char* temporary = std::getenv("TMPDIR");
  path_ = std::string(temporary && *temporary ? temporary : "/tmp") + "/subcert-XXXXXX";
  if (!mkdtemp(path_.data()))
    fail(ErrorKind::missing_file, "cannot make a folder for temporary files, {}: {}", path_,
         std::generic_category().message(errno));
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code error;
  std::filesystem::remove_all(path_, error);
}

}  // namespace subcert::runtime
