#include "trial.hpp"

namespace subcert::statements {

bool Trial::equal(const Rational& printed, const Rational& derived, const std::string& where) {
  return require(printed == derived,
                 where + ": printed " + subcert::to_text(printed) + ", derived " + subcert::to_text(derived));
}

bool Trial::require(bool holds, const std::string& witness) {
  if (failed()) return false;
  if (!holds) failure_ = witness;
  return holds;
}

bool Trial::follow(const Trial& other) {
  if (failed()) return false;
  if (other.failed()) failure_ = other.failure();
  return !other.failed();
}

Trial& Trial::over(const std::string& range) {
  range_ = range;
  return *this;
}

Trial& Trial::for_all(const std::string& range, const std::string& argument) {
  range_ = range;
  argument_ = argument;
  all_ = true;
  return *this;
}

Trial& Trial::but_not(const std::string& edge, const Trial& there) {
  require(there.failed(), "no counterexample at " + edge);
  if (failed()) return *this;
  edge_ = edge;
  edge_witness_ = there.failure();
  return *this;
}

Trial::operator Outcome() const {
  if (failed()) return {StatementVerdict::false_claim, range_, *failure_, ""};
  return {all_ ? StatementVerdict::holds_for_all : StatementVerdict::holds, range_, edge_witness_, argument_, edge_};
}

Outcome Trial::outcome(const Trial& corrected) const {
  if (!failed()) return *this;
  if (corrected.failed())
    return {StatementVerdict::false_claim, range_, *failure_, "the corrected form fails too: " + corrected.failure()};
  return {StatementVerdict::misprint, corrected.range_, *failure_,
          corrected.all_ ? "the corrected form holds for all: " + corrected.argument_ : corrected.argument_};
}

Outcome in_both_forms(const std::function<Trial(Form)>& trial) {
  return trial(Form::printed).outcome(trial(Form::corrected));
}

Outcome not_a_slip(Outcome outcome) {
  if (outcome.verdict == StatementVerdict::misprint) outcome.verdict = StatementVerdict::false_claim;
  return outcome;
}

std::string at(const std::string& name, const Rational& value) { return name + " = " + subcert::to_text(value); }

}  // namespace subcert::statements
