#pragma once
/// A proof as it is run: constants are stated one after the other, each from those before it, for the sources of this
/// floor.

#include "check.hpp"
#include "constants.hpp"

#include <subcert/analysis/symbol/numbers/balls.hpp>

namespace subcert::theorems {

constexpr slong proof_bits = 192;

inline Ball exactly(const Rational& value) { return Ball(value, proof_bits); }

/// Either checks given constants or finds them: a found constant is the number it stands for, rounded to a few digits
/// towards its proved side. What is found depends on the constants before it as stated, so that a text with these
/// constants can be followed line by line.
class Ledger {
 public:
  /// Finds the constants where none are given.
  explicit Ledger(const Constants* given = nullptr) : given_(given) {}

  /// `number` lies on the proved side of the constant; returns the constant.
  Ball state(const std::string& name, Side side, const std::string& id, const std::string& meaning,
             const std::string& formula, const Ball& number, int digits = 4);
  /// An inequality between proved numbers.
  void check(Check one) { checks_.push_back(std::move(one)); }
  /// An inequality that the proof needs of its bounds: where it fails, nothing is refuted, but the bounds do not
  /// suffice.
  void need(Check one);

  /// As stated so far. Errors: throws a domain error with the name.
  Rational operator[](const std::string& name) const { return Constants(list_)[name]; }

  bool holds() const;
  const std::vector<Check>& checks() const { return checks_; }
  Constants constants() const { return Constants(list_); }

 private:
  const Constants* given_;
  std::vector<Constant> list_;
  std::vector<Check> checks_;
};

}  // namespace subcert::theorems
