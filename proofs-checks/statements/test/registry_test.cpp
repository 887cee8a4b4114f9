#include <subcert/cmake/catch.hpp>
#include <subcert/proofs-checks/papers/registry.hpp>

#include <set>

using subcert::Verdict;
using namespace subcert::statements;

TEST_CASE("the registry is complete and well formed") {
  std::set<std::string> ids;
  for (const PaperStatements& paper : papers())
    for (const Statement& statement : paper.statements) {
      CAPTURE(statement.id);
      CHECK(ids.insert(statement.id).second);
      CHECK(statement.paper() == paper.key);
      CHECK_FALSE(statement.place.empty());
      CHECK_FALSE(statement.paraphrase.empty());
      CHECK_FALSE(statement.printed.empty());
      CHECK(static_cast<bool>(statement.check));
      CHECK(statement.corrected.empty() ==
            (statement.recorded != Verdict::misprint && statement.recorded != Verdict::false_claim));
      CHECK_NOTHROW(printed_latex(statement));
      CHECK_NOTHROW(corrected_latex(statement));
    }
}
