#pragma once
/// What is asked of a scheme: a command that answers with --json, in a process of its own.

#include "journal.hpp"

#include <subcert/schemes/data/runtime/process.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace subcert::sweeps {

/// What an answer may cost.
struct AnswerLimits {
  double budget = 10;        ///< seconds of processor time, with those of proofs
  std::size_t memory = 512;  ///< MiB that a search may hold
};

/// The JSON object that a program answered; where it did not, null, and why. Beside an answer: which file could not be
/// written.
struct Reply {
  Json answer;
  std::string error;
};

/// Asks a program. A crash is an error of this reply alone. Errors: throws missing_file where the program cannot be
/// started.
Reply reply_to(const std::vector<std::string>& arguments, const runtime::ProcessSettings& settings,
               const std::string& program);

/// The words of a question to `subcert check` about one scheme with its expected properties, a file as
/// docs/properties.md has it: `input` of the process. The program answers it itself, without further processes.
std::vector<std::string> check_arguments(const AnswerLimits& limits);
/// Processor seconds after which a process that has this budget is ended; a search that heeds it never needs them.
double most_seconds(double budget);
/// What a command gets as its budget, so that what proofs may take beyond it ends within a tenth more than this one:
/// half a second less, but of less than a second half, of which that does not hold.
double searching_seconds(double budget);

/// `regularity`, `vertex --valence 3..50`, `levels --over w=0..1/8 --property C1`, `check smoothness >= 1`.
class SchemeQuestion {
 public:
  /// The first word is one of commands(), others are settings of that command that change its answer, or for `check`
  /// a property and what is expected of it. Errors: throws ParseError.
  static SchemeQuestion parse(std::string_view text);
  /// The texts of several, separated by commas; a comma within a setting stays. Errors: as parse().
  static std::vector<std::string> split(std::string_view texts);
  static std::vector<std::string> commands();

  /// Its words with one blank between them.
  const std::string& text() const { return text_; }
  /// Of a question to `check`, where its answer stands.
  std::vector<std::string> members() const;
  /// Of a command that can write one.
  bool has_certificate() const;

  /// The answer about the scheme without the time that it took and the program's name, so that it is the same each
  /// time. `certificate`: a file for it; none where empty. An answer of `check` is {"check": {PROPERTY: true, false or
  /// null}, "found": {PROPERTY: text}}. Errors: as reply_to().
  Reply ask(const std::string& scheme, const AnswerLimits& limits, const std::string& program,
            const std::string& certificate = {}) const;

 private:
  std::string text_, command_;
  std::vector<std::string> settings_;
  std::string property_, expected_;  ///< of `check`
};

}  // namespace subcert::sweeps
