#pragma once
/// Other programs: what they print and how they end.

#include <filesystem>
#include <string>
#include <vector>

namespace subcert::runtime {

struct ProcessEnd {
  int code = 0;    ///< what it left with; 0 where a signal ended it
  int signal = 0;  ///< that ended it; 0 where it left
  std::string output, errors;
};

/// The file of the program that runs; empty where the system does not say.
std::filesystem::path own_program();

/// The program by which run_process starts this one again: the same, also where its file was replaced or removed, so
/// that one run has the answers of one version. Where the system does not say which it is, `subcert` on the PATH.
std::string this_program();

struct ProcessSettings {
  std::string input = {};     ///< that it reads
  double most_seconds = 1e9;  ///< of processor time, after which it is ended by SIGKILL
};

/// Runs a program, looked for on the PATH where its name has no slash, and waits for its end. If this process ends
/// before, so does that program. Errors: throws missing_file where it cannot be started. May be called from several
/// threads.
ProcessEnd run_process(const std::string& program, const std::vector<std::string>& arguments,
                       const ProcessSettings& settings = {});

}  // namespace subcert::runtime
