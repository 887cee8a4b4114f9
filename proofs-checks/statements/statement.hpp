#pragma once
/// Statements of papers as executable checks.

#include "transcription.hpp"

#include <subcert/proofs-checks/verdict.hpp>

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace subcert::statements {

/// One printed value.
struct PublishedCell {
  std::string row;
  std::string column;
  std::string scheme;    ///< of which scheme
  std::string quantity;  ///< what it is: `mask`, `support`, `max psi`, ...
  std::optional<int> n;  ///< size and degree of the scheme, where the table has them
  std::optional<int> d;
  std::string printed;
  std::string words;  ///< the transcription that this value is a word of; may be empty
  ValueVerdict recorded;
  std::string source = {};   ///< its key in docs/references.md, where a table is gathered from many
  std::string derived = {};  ///< from what it follows, where it is no printed value of its own
};

struct PublishedTable {
  std::string id;
  std::string title;
  std::string place;
  bool grid;  ///< rows and columns as in the paper; otherwise one cell a line
  std::vector<PublishedCell> cells;
};

/// What a check found. `range` says for which parameters; `witness` is the smallest exact counterexample, empty where
/// there is none; `argument` says why the verdict holds where that is not a finite comparison, or what else is to be
/// said. `edge` names the cases at the edge of the printed range that fail where all others hold; the witness is one of
/// them.
struct Outcome {
  StatementVerdict verdict;
  std::string range;
  std::string witness;
  std::string argument;
  std::string edge = {};
};

/// quick: all statements in a minute; wide: larger ranges.
enum class Tier { quick, wide };

struct Paper;

/// What a check may use: its paper. It remembers which transcriptions were read.
class Context {
 public:
  Context(const Paper& paper, Tier tier);
  /// With other transcriptions than those of the paper.
  Context(const Paper& paper, const Transcriptions& transcriptions, Tier tier)
      : paper_(&paper), transcriptions_(&transcriptions), tier_(tier) {}

  /// The end of a range.
  int reach(int quick, int wide) const { return tier_ == Tier::quick ? quick : wide; }
  Formula formula(const std::string& id, Form form = Form::printed) const { return noted(id).formula(id, form); }
  std::vector<Formula> list(const std::string& id, Form form = Form::printed) const { return noted(id).list(id, form); }
  std::vector<std::string> words(const std::string& id, Form form = Form::printed) const {
    return noted(id).words(id, form);
  }
  /// The cells of the tables whose printed values are the words of a transcription.
  std::vector<PublishedCell> cells(const std::string& id) const;
  /// Errors: throws a domain error for a table that is not there.
  const PublishedTable& table(const std::string& id) const;
  const std::set<std::string>& read() const { return read_; }

 private:
  const Transcriptions& noted(const std::string& id) const {
    read_.insert(id);
    return *transcriptions_;
  }

  const Paper* paper_;
  const Transcriptions* transcriptions_;
  Tier tier_;
  mutable std::set<std::string> read_;
};

using Check = std::function<Outcome(const Context&)>;

/// `printed` and `corrected` are LaTeX, where <<id>> stands for the LaTeX of a transcription in that form. The check
/// depends on nothing but its context, so that statements can be checked in any order and on several threads.
struct Statement {
  std::string id;          ///< PAPER/NAME
  std::string place;       ///< section, equation or page
  std::string paraphrase;  ///< the claim in one line
  std::string checked;     ///< what exactly is checked
  std::string printed;
  std::string corrected;      ///< empty where nothing is to be corrected
  StatementVerdict recorded;  ///< the verdict that this version is known to reach
  Check check;
  std::optional<Grade> grade = {};  ///< how much is wrong; nothing where nothing is
  std::string sentence = {};        ///< the words of the paper, of what is wrong or fails at an edge
  std::string readings = {};        ///< how they were read before they were called wrong
  std::string follows = {};         ///< the id of the statement whose fault this one repeats
  std::string scan = {};  ///< what a slip of the text recognition would explain, where one scan is all there is
  std::vector<std::string> experiments = {};  ///< the ids of those whose claims are about the same sentences

  std::string paper() const { return id.substr(0, id.find('/')); }
};

/// The grade of what was found: that of the record, `edge` where the outcome has one, else nothing.
std::optional<Grade> grade_of(const Statement& statement, const Outcome& outcome);
/// Whether verdict and grade are those on record.
bool is_as_recorded(const Statement& statement, const Outcome& outcome);

/// What no check decides, since only experiments can.
bool is_left_to_experiments(const Statement& statement, const Outcome& outcome);

/// For people: `proved for all n`, `holds, but not at n = 1`, `slip of the pen`, `numbers are off`, `does not hold`,
/// ...
std::string verdict_in_words(const Statement& statement, const Outcome& outcome);

/// Runs the check. A formula that is undefined somewhere in its range is a counterexample. Errors: what the check
/// throws, but for Undefined.
Outcome check(const Statement& statement, const Context& context);

struct Paper {
  std::string key;
  std::string citation;
  Transcriptions transcriptions;
  std::vector<Statement> statements;  ///< in the order of the paper
  std::vector<PublishedTable> tables;

  /// Errors: throws a domain error for an id that is not there.
  const PublishedTable& table(const std::string& id) const;
};

/// The checks of a paper by the id of their statement.
using Checks = std::vector<std::pair<std::string, Check>>;
Checks joined(const std::vector<Checks>& parts);

/// Reads a paper.toml as docs/statements.md describes it. Errors: throws FileError for what is no TOML, an unknown or
/// missing key, a value of the wrong kind, an id that is there twice, and for statements without check and checks
/// without statement, by their ids.
Paper read_paper(const std::string& key, std::string_view text, const Checks& checks);

}  // namespace subcert::statements
