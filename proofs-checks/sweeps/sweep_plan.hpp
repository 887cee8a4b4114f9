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

struct SweepPlan : AnswerLimits {
  std::vector<std::string> schemes;               ///< grids, as schemes_of_grid() reads them
  std::vector<std::string> ask = {"regularity"};  ///< texts of questions
  std::string where, expect;                      ///< conditions; empty: none
  std::vector<std::string> columns = {};          ///< of a table; empty: those of the commands
  bool certificates = false;                      ///< of the exponents go with the answers to `regularity`
};

/// Reads a plan: `schemes = ["primal:n=1..60,d={1,3}"]` and perhaps `ask`, `where`, `expect`, `columns`, `budget` and
/// `memory`. Errors: throws FileError.
SweepPlan read_sweep_plan(std::string_view toml);

/// The schemes of the plan that meet its `where`, each once, in the order of the plan. Errors: throws ParseError.
std::vector<std::string> schemes_of_plan(const SweepPlan& plan);

/// The case of a scheme: its name and all that its answers depend on.
SweepCase case_of(const SweepPlan& plan, const std::string& scheme);

/// What answered, a scheme's answers beside each other: {"scheme", "keys", "answers": {QUESTION: ...}, "errors":
/// {QUESTION: text}}. With certificates there is "certificate", the text of one that the checker accepted, where there
/// is one.
Json answers_of_scheme(const SweepPlan& plan, const std::string& scheme, const std::string& program);

/// Lets the program write a certificate of the exponent; whether it did, and the checker accepted it.
bool write_certificate(const SweepPlan& plan, const std::string& scheme, const std::string& program,
                       const std::string& file);

/// What a name stands for in a scheme's answers: a member of the whole, of an answer in the order of the plan, or a key
/// of the scheme; nullptr where it is none. Of an object without "answers" and "keys", a member.
const Json* value_of(const Json& answers, std::string_view name);

}  // namespace subcert::sweeps
