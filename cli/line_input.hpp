#pragma once
/// Lines of a file or of standard input, as they come.

#include <string>

namespace subcert::cli {

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

}  // namespace subcert::cli
