#pragma once
/// The independent checker, a program of its own.

#include <string>
#include <vector>

namespace subcert::cli {

struct CheckerAnswer {
  int code;
  std::string text;  ///< without the last end of line
};

/// subcert-check beside this program, or else the one on the PATH.
std::string checker_program();

/// Runs the checker. Errors: throws missing_file where there is none.
CheckerAnswer run_checker(const std::vector<std::string>& arguments, const std::string& program = checker_program());

}  // namespace subcert::cli
