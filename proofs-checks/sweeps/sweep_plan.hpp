#pragma once
/// Which schemes a sweep is about, and what is asked of each.

#include "condition.hpp"
#include "question.hpp"
#include "sweep.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace subcert::sweeps {

/// A text that names schemes, as schemes_of_grid() reads it.
struct SchemeText {
  std::string text;
  std::string place = {};  ///< in a file, for errors; empty: on the command line
};

struct SweepPlan : AnswerLimits {
  std::vector<SchemeText> schemes;
  std::vector<std::string> ask = {"regularity"};  ///< texts of questions
  std::string where, expect;                      ///< conditions; empty: none
  std::vector<std::string> columns = {};          ///< of a table; empty: those of the commands
  bool certificates = false;                      ///< of the exponents go with the answers to `regularity`
};

/// Reads a plan: `schemes = ["primal:n=1..60,d={1,3}"]` and perhaps `ask`, `where`, `expect`, `columns`, `budget` and
/// `memory`. Errors: throws FileError.
SweepPlan read_sweep_plan(std::string_view toml);

/// The schemes of the plan that meet its `where`, each once, in the order of the plan. Domain: at most a million.
/// Errors: throws ParseError; a data error with the place for a text in a file.
std::vector<std::string> schemes_of_plan(const SweepPlan& plan);

/// The case of a scheme: its name and all that its answers depend on.
SweepCase case_of(const SweepPlan& plan, const std::string& scheme);

/// What answered, a scheme's answers beside each other: {"scheme", "keys", "answers": {QUESTION: ...}, "errors":
/// {QUESTION: text}}. With certificates there is "certificate", the text of one that the checker accepted, where there
/// is one.
Json answers_of_scheme(const SweepPlan& plan, const std::string& scheme, const std::string& program);

/// The certificate of the exponent that the program makes and the checker accepts; nothing where there is none. Errors:
/// throws missing_file where it could not be written, or no checker is there.
std::optional<std::string> certificate_of(const SweepPlan& plan, const std::string& scheme, const std::string& program);

/// Whether the answers meet the condition, as Condition::meets.
Truth meets(const Json& answers, const Condition& condition);

/// What a name stands for in a scheme's answers: a member of the whole, of an answer in the order of the plan, or a key
/// of the scheme; nullptr where it is none. Of an object without "answers" and "keys", a member.
const Json* value_of(const Json& answers, std::string_view name);

}  // namespace subcert::sweeps
