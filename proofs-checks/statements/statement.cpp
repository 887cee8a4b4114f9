#include "statement.hpp"

namespace subcert::statements {

Outcome check(const Statement& statement, const Context& context) {
  try {
    return statement.check(context);
  } catch (const Undefined& error) {
    return {Verdict::false_claim, "", error.what(), ""};
  }
}

}  // namespace subcert::statements
