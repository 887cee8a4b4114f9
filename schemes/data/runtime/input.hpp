#pragma once
/// Files and standard input, whole or by lines as they come.

#include <functional>
#include <string>
#include <string_view>

namespace subcert::runtime {

/// The name that means standard input where data are read, and standard output where answers are written.
constexpr const char* standard_stream = "-";

/// The content of a file. Errors: throws a data error, or missing_file.
std::string read_file(const std::string& path);

/// The same, or the content of standard input.
std::string read_input(const std::string& path);

/// What errors call an input: the path, or `standard input`.
std::string input_name(const std::string& path);

/// Hears of the name and the content of each input that is read whole, on the thread that reads it.
using InputListener = std::function<void(const std::string& name, std::string_view content)>;

/// One for the process; set before anything is read.
void set_input_listener(InputListener listener);

class LineInput {
 public:
  /// Opens a file, or takes standard input. Errors: throws missing_file, or a data error.
  explicit LineInput(std::string path);
  ~LineInput();
  LineInput(const LineInput&) = delete;
  LineInput& operator=(const LineInput&) = delete;

  /// Sets `lines` to the whole lines that can be had, waiting for one; the last may lack its end. False at the end.
  /// Errors: throws a data error where reading fails or a line is longer than a mebibyte.
  bool read_lines(std::string& lines);

 private:
  std::string path_;
  int file_;
  std::string rest_;  // of a line that is not whole
};

}  // namespace subcert::runtime
