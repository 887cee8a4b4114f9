#pragma once
// The program as its users meet it: output and exit code.

#include <subcert/analysis/symbol/numbers/numbers.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/folder.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <regex>
#include <string>

namespace subcert::testing {

struct Run {
  int code;
  std::string out;
  std::string err;
};

/// Runs a command, given as a shell would read it.
Run run_command(const std::string& command);

/// Runs the program with these arguments.
inline Run run(const std::string& arguments) { return run_command(std::string(SUBCERT_PROGRAM) + " " + arguments); }

/// Writes a script of the shell that can be run; its path.
inline std::string write_script(const Folder& folder, const std::string& name, const std::string& text) {
  const std::string path = folder.write(name, "#!/bin/sh\n" + text);
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  return path;
}

/// The lines of a page of facts, those that go on in the next line as one.
inline std::string joined(const std::string& page) {
  return std::regex_replace(page, std::regex("\n {13}(?=[^ ])"), " ");
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// The object on standard output. code -1: done or undecided, as the machine's speed has it.
nlohmann::json run_json(const std::string& arguments, int code = 0);

/// The run leaves with this code, prints nothing and says this on standard error.
void check_fails(const Run& run, int code, const std::string& message);

/// An enclosure of the output, read back.
Enclosure enclosure_of(const nlohmann::json& json);

/// Whether this end of an enclosure of the output, which must hold together, lies within one unit of the last place of
/// the number.
bool has_digits(const nlohmann::json& enclosure, const std::string& end, const std::string& number);

}  // namespace subcert::testing
