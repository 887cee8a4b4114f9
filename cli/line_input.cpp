#include "line_input.hpp"

#include "command.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <utility>

namespace subcert::cli {
namespace {

constexpr std::size_t longest_line = 1U << 20U;
constexpr std::size_t block = 1U << 16U;

}  // namespace

LineInput::LineInput(std::string path) : path_(std::move(path)), file_(STDIN_FILENO) {
  if (path_ == standard_stream) return;
  if (!std::filesystem::exists(path_)) fail(ErrorKind::missing_file, "{}: no such file", path_);
  file_ = std::filesystem::is_directory(path_) ? -1 : open(path_.c_str(), O_RDONLY | O_CLOEXEC);
  if (file_ < 0) fail(ErrorKind::data, "{}: cannot be read", path_);
}

LineInput::~LineInput() {
  if (file_ != STDIN_FILENO) close(file_);
}

bool LineInput::read_lines(std::string& lines) {
  lines = std::exchange(rest_, {});
  for (;;) {
    const std::size_t old = lines.size();
    lines.resize(old + block);
    const ssize_t got = read(file_, lines.data() + old, block);
    lines.resize(old + static_cast<std::size_t>(got > 0 ? got : 0));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(ErrorKind::data, "{}: cannot be read", input_name(path_));
    if (got == 0) return !lines.empty();
    if (const std::size_t end = lines.rfind('\n'); end != std::string::npos) {
      rest_ = lines.substr(end + 1);
      lines.resize(end + 1);
      return true;
    }
    if (lines.size() > longest_line)
      fail(ErrorKind::data, "{}: expected lines of at most {} characters", input_name(path_), longest_line);
  }
}

}  // namespace subcert::cli
