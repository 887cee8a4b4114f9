#include "input.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <utility>

namespace subcert::runtime {
namespace {

constexpr std::size_t longest_line = 1U << 20U;
constexpr std::size_t block_of_lines = 1U << 16U;
constexpr std::size_t most_bytes = std::size_t{1} << 28;  // of an input: some, as /dev/zero, have no end

InputListener& listener() {
  static InputListener one;
  return one;
}

std::string read_to_the_end(std::istream& stream, const std::string& name) {
  std::string text;
  for (std::size_t block = std::size_t{1} << 16; stream; block = std::min(2 * block, std::size_t{1} << 24)) {
    const std::size_t old = text.size();
    if (old > most_bytes) fail(ErrorKind::data, "{}: longer than {} MB", name, most_bytes >> 20);
    text.resize(old + block);
    stream.read(text.data() + old, static_cast<std::streamsize>(block));
    text.resize(old + static_cast<std::size_t>(stream.gcount()));
  }
  if (!stream.eof()) fail(ErrorKind::data, "{}: cannot be read", name);
  if (listener()) listener()(name, text);
  return text;
}

void require_file(const std::string& path) {
  if (!std::filesystem::exists(path)) fail(ErrorKind::missing_file, "{}: no such file", path);
  if (std::filesystem::is_directory(path)) fail(ErrorKind::missing_file, "{}: expected a file; found a folder", path);
}

}  // namespace

void set_input_listener(InputListener one) { listener() = std::move(one); }

std::string read_file(const std::string& path) {
  require_file(path);
  std::ifstream stream(path, std::ios::binary);
  return read_to_the_end(stream, path);
}

std::string input_name(const std::string& path) { return path == standard_stream ? "standard input" : path; }

std::string read_input(const std::string& path) {
  return path == standard_stream ? read_to_the_end(std::cin, input_name(path)) : read_file(path);
}

LineInput::LineInput(std::string path) : path_(std::move(path)), file_(STDIN_FILENO) {
  if (path_ == standard_stream) return;
  require_file(path_);
  file_ = open(path_.c_str(), O_RDONLY | O_CLOEXEC);
  if (file_ < 0) fail(ErrorKind::missing_file, "{}: cannot be read", path_);
}

LineInput::~LineInput() {
  if (file_ != STDIN_FILENO) close(file_);
}

bool LineInput::read_lines(std::string& lines) {
  lines = std::exchange(rest_, {});
  for (;;) {
    const std::size_t old = lines.size();
    lines.resize(old + block_of_lines);
    const ssize_t got = read(file_, lines.data() + old, block_of_lines);
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

}  // namespace subcert::runtime
