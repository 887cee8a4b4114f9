#pragma once
/// A claim tried on its cases, from the smallest on, until one fails.

#include "statement.hpp"

#include <optional>

namespace subcert::statements {

/// The members that try a case return whether the trial goes on; after a failure nothing more is tried.
class Trial {
 public:
  /// Both values are named in the witness.
  bool equal(const Rational& printed, const Rational& derived, const std::string& where);
  bool require(bool holds, const std::string& witness);
  /// Goes on with another trial: its failure is ours.
  bool follow(const Trial& other);
  /// No case failed on this range.
  Trial& over(const std::string& range);
  /// No case failed, and this argument proves all others.
  Trial& for_all(const std::string& range, const std::string& argument);
  /// The cases at the edge of the printed range, which have to fail: where they hold the trial fails.
  Trial& but_not(const std::string& edge, const Trial& there);

  bool failed() const { return failure_.has_value(); }
  const std::string& failure() const { return *failure_; }

  /// The verdict about a form without correction; implicit, so that a check returns its trial.
  operator Outcome() const;
  /// The verdict about a printed form, given how its correction did.
  Outcome outcome(const Trial& corrected) const;

 private:
  std::optional<std::string> failure_;
  std::string range_;
  std::string argument_;
  std::string edge_, edge_witness_;
  bool all_ = false;
};

/// The verdict about a form that is tried as printed and as corrected.
Outcome in_both_forms(const std::function<Trial(Form)>& trial);

/// The same where what fails is the claim or a number, not a letter of it: a misprint becomes false.
Outcome not_a_slip(Outcome outcome);

/// `n = 2`, as in witnesses.
std::string at(const std::string& name, const Rational& value);

}  // namespace subcert::statements
