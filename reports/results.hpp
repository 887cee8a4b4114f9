#pragma once
/// Everything a run has found, result by result.

#include "errata.hpp"
#include "report.hpp"

#include <optional>
#include <string>
#include <vector>

namespace subcert::reports {

/// `statements` is empty where they were not checked.
struct Findings {
  std::vector<Report> reports;
  std::vector<CheckedStatement> statements = {};

  /// Whether all verdicts are the recorded ones.
  bool as_recorded() const;
};

enum class ResultKind { value, claim, statement };

/// `value`, `claim`, `statement`.
std::string to_text(ResultKind kind);

/// One printed value, one claim about an experiment or one statement, and what became of it.
struct Result {
  ResultKind kind;
  std::string paper;
  std::string item;  ///< the table, the experiment or the statement
  std::string key;   ///< unique in a run, and the same in every run: the end of its link
  std::string page;  ///< the file of that link
  std::string subject;
  std::string scheme;                  ///< of a value
  std::string printed;                 ///< empty for claims
  std::string computed;                ///< for people
  std::optional<Enclosure> enclosure;  ///< of a number
  Verdict verdict;
  Verdict recorded;
  std::string note;     ///< witness, reason or remark
  std::string command;  ///< that computes it again

  std::string link() const { return page + "#" + key; }
};

/// Of every report its values, then its claims, then its statements.
std::vector<Result> results(const Findings& findings);
std::vector<Result> results(const Report& report, const std::vector<CheckedStatement>& statements);

/// The results of one table, in the order of its cells.
std::vector<Result> results(const formats::ComparisonTable& table);

/// The results of one experiment, in the order of its claims.
std::vector<Result> results(const experiments::RanExperiment& ran);

/// How many of some kind there are, and how many the papers have right.
struct Score {
  int right = 0, wrong = 0, open = 0, uncheckable = 0;

  void add(Verdict verdict);
  int checked() const { return right + wrong + open; }
  int all() const { return checked() + uncheckable; }
  /// `81 of 114 values match (1 open, 18 cannot be checked)`: of those that can be checked, and what is left.
  std::string text(const std::string& what, const std::string& hold) const;
};

/// The score of the results of a kind, of one paper or of all.
Score score(const std::vector<Result>& results, ResultKind kind, const std::string& paper = "");

}  // namespace subcert::reports
