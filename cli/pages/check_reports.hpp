#pragma once
/// How the answers of `check` are printed: lines, JSON, reports for servers of continuous integration.

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/cli/command.hpp>
#include <subcert/proofs-checks/file_error.hpp>

#include <string>
#include <vector>

namespace subcert::cli {

/// One property of one scheme of one file, or a scheme of which nothing can be asked, and what is known of it.
struct CheckedProperty {
  std::string file;
  Place place;
  std::string specification, name, property, expected;
  bool unreadable = false;
  Decision decision;
  bool error = false;  ///< it could not be computed; the message is the reason

  std::string claim() const { return unreadable ? "the scheme" : name + ": " + property + " " + expected; }
  bool is(Truth truth) const { return !error && decision.truth == truth; }
  /// `yes`, `no`, `unknown` or `error`.
  std::string holds() const { return error ? "error" : to_text(decision.truth); }
};

Json property_json(const CheckedProperty& one);
/// With the end of line.
std::string property_line(const CheckedProperty& one);
/// `\n3 properties: 2 hold, 0 fail, 1 undecided.`
std::string counts_text(const std::vector<CheckedProperty>& all);
/// The report of JUnit, a test for each property.
std::string junit_text(const std::vector<CheckedProperty>& all);
/// The report in SARIF 2.1.0, which servers show at the lines of the file: what does not hold.
std::string sarif_text(const std::vector<CheckedProperty>& all);

}  // namespace subcert::cli
