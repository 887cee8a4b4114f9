#pragma once
/// Everything a run has found, result by result, and the one count of it.

#include "report.hpp"

#include <subcert/proofs-checks/papers/registry.hpp>

#include <optional>
#include <string>
#include <vector>

namespace subcert::reports {

using statements::CheckedStatement;

/// Which program made a page, from what and when.
struct Origin {
  std::string version;  ///< empty where it is not known
  std::string commit;   ///< of the sources; empty where it is not known
  std::string input;    ///< what was asked for
  std::string when;     ///< a date
};

/// `Made by subcert 0.3.0 (COMMIT), from subcert reproduce, on 2026-11-23.` and an empty line, for files of text.
std::string to_text(const Origin& origin);

/// `statements` is empty where they were not checked.
struct Findings {
  std::vector<Report> reports;
  std::vector<CheckedStatement> statements = {};
  Origin origin = {};
  bool complete = true;  ///< or the experiments are being computed

  /// Whether all verdicts are the recorded ones.
  bool as_recorded() const;
};

enum class ResultKind { value, statement, claim };

/// `value`, `statement`, `claim`.
std::string to_text(ResultKind kind);

/// One printed value, one claim about an experiment or one statement, and what became of it.
struct Result {
  ResultKind kind;
  std::string paper = {};
  std::string item = {};  ///< the table, the experiment or the statement
  std::string key = {};   ///< unique in a run, and the same in every run: the end of its link
  std::string page = {};  ///< the file of that link
  std::string subject = {};
  std::string scheme = {};                  ///< of a value
  std::string printed = {};                 ///< empty for claims
  std::string computed = {};                ///< for people
  std::optional<Enclosure> enclosure = {};  ///< of a number
  std::string verdict = {};                 ///< a word of verdict.hpp
  std::string recorded = {};
  std::string grade = {};  ///< of a statement, a word of verdict.hpp; empty where nothing is wrong
  Standing standing = Standing::aside;
  std::string words = {};    ///< the verdict for people
  std::string group = {};    ///< what counts() calls all that are like it
  std::string derived = {};  ///< from what a value follows that is none of its own; it is not counted
  std::string follows = {};  ///< the key of the statement whose fault it repeats
  bool as_recorded = true;
  std::string note = {};     ///< witness, reason or remark
  std::string remark = {};   ///< of a statement: how far off it is, or what holds instead
  std::string command = {};  ///< that computes it again

  std::string link() const { return page + "#" + key; }
};

/// Of every report its values, then its claims, then its statements.
std::vector<Result> results(const Findings& findings);
std::vector<Result> results(const Report& report, const std::vector<CheckedStatement>& statements);

std::vector<Result> results(const std::vector<CheckedStatement>& statements);

/// The results of one table, in the order of its cells.
std::vector<Result> results(const formats::ComparisonTable& table);

/// The results of one experiment, in the order of its claims.
std::vector<Result> results(const experiments::RanExperiment& ran);

/// How many results of a kind there are, and what became of them: what page, terminal and JSON all say. Values that
/// only follow from other printed ones are left out.
struct Counts {
  /// Results that count alike.
  struct Group {
    std::string name;
    Standing standing;
    int count;
    /// `8 slips of the pen`, `1 slip of the pen`.
    std::string text() const;
  };
  ResultKind kind;
  std::vector<Group> groups;  ///< those that are not empty, from the best to the worst
  int causes = 0;             ///< of the wrong statements: faults that repeat another one are not counted

  int of(Standing standing) const;
  int all() const;
  /// Without those that nothing decides.
  int checked() const { return all() - of(Standing::aside); }
  /// `81 of 114 printed values match`; empty where there are none to be checked.
  std::string head() const;
  /// `97 of 109 statements hold (60 proved for all n, 37 on the range tried); 12 slips of the pen; beside them 6 cannot
  /// be checked`: what nothing decides is in no total.
  std::string text() const;
  /// What is wrong: `8 slips of the pen, 4 numbers off`; empty where nothing is.
  std::string wrong_text() const;
};

/// The counts of a kind, of one paper or of all.
Counts counts(const std::vector<Result>& results, ResultKind kind, const std::string& paper = "");

/// `94 of 109 statements hold, 41 of them now with proofs for all parameters; ...`: the first news of the front page.
std::string standing_sentence(const Counts& statements);
/// `12 of 109 statements do not hold, from 9 causes: ...`; empty where all hold.
std::string errata_sentence(const Counts& statements);

}  // namespace subcert::reports
