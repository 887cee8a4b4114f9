#include "statement.hpp"

#include <stdexcept>

namespace subcert::statements {

std::string to_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds: return "holds";
    case Verdict::holds_for_all: return "holds-for-all-n";
    case Verdict::misprint: return "misprint";
    case Verdict::false_claim: return "false";
    case Verdict::not_checkable: return "not-checkable";
    case Verdict::undecided: break;
  }
  return "undecided";
}

Outcome check(const Statement& statement, const Context& context) {
  try {
    return statement.check(context);
  } catch (const std::domain_error& error) {
    return {Verdict::false_claim, "", error.what(), ""};
  }
}

}  // namespace subcert::statements
