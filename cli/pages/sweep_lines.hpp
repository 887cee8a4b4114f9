#pragma once
/// How the answers of a sweep are printed: lines of JSON, or a table of comma separated values.

#include <subcert/cli/command.hpp>

#include <string>
#include <vector>

namespace subcert::cli {

/// One line for each answer.
class SweepLines {
 public:
  /// `columns` are paths of members; for lines of JSON there are none.
  SweepLines(bool json, std::vector<std::string> columns) : json_(json), columns_(std::move(columns)) {}

  /// The first line of a table; empty for JSON.
  std::string head() const;
  /// With the end of line.
  std::string line(const Json& result) const;

 private:
  bool json_;
  std::vector<std::string> columns_;
};

/// The columns of a table of answers to these questions.
std::vector<std::string> usual_columns(const std::vector<std::string>& asked);

}  // namespace subcert::cli
