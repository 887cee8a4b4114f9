#include "ledger.hpp"

#include "patience.hpp"

#include <algorithm>

namespace subcert::theorems {

Ball Ledger::state(const std::string& name, Side side, const std::string& id, const std::string& meaning,
                   const std::string& formula, const Ball& number, int digits) {
  next_step("(" + id + ") " + name);
  const Enclosure actual = number.enclosure();
  const bool above = side == Side::above;
  Constant constant{name, 1, side, id, meaning};
  if (given_)
    constant.value = (*given_)[name];
  else if (actual.is_bounded()) {
    // A little outside, so that a short decimal is not taken for its own bound.
    const Rational little = power(Rational(10), -30);
    constant.value = above ? decimal(to_decimal(*actual.upper * (1 + little), digits, Rounding::up))
                           : decimal(to_decimal(*actual.lower * (1 - little), digits, Rounding::down));
  }
  const Enclosure stated = Enclosure::exactly(constant.value);
  checks_.push_back(above ? less(id, formula + " < " + name, actual, stated)
                          : less(id, name + " < " + formula, stated, actual));
  list_.push_back(constant);
  return exactly(constant.value);
}

void Ledger::need(Check one) {
  next_step("(" + one.id + ") " + one.claim);
  if (one.decision.is_no()) one.decision = {Truth::unknown, "the bounds do not suffice"};
  checks_.push_back(std::move(one));
}

bool Ledger::holds() const {
  return std::all_of(checks_.begin(), checks_.end(), [](const Check& one) { return one.decision.is_yes(); });
}

}  // namespace subcert::theorems
