#include "../trial.hpp"

#include <subcert/cmake/catch.hpp>

using namespace subcert;
using namespace subcert::statements;

namespace {

Trial tried(bool holds, const std::string& where) {
  Trial trial;
  trial.require(holds, where);
  return trial;
}

Statement recorded(StatementVerdict verdict, std::optional<Grade> grade) {
  return {.id = "paper/a",
          .place = "",
          .paraphrase = "",
          .checked = "",
          .printed = "",
          .corrected = "",
          .recorded = verdict,
          .check = {},
          .grade = grade};
}

}  // namespace

TEST_CASE("an edge is what fails where all else holds") {
  const Outcome edge = tried(true, "").for_all("all n >= 2", "why").but_not("n = 1", tried(false, "n = 1: 0 < 0"));
  CHECK(edge.verdict == StatementVerdict::holds_for_all);
  CHECK(edge.edge == "n = 1");
  CHECK(edge.witness == "n = 1: 0 < 0");
  // An edge that holds is none, and a statement that fails elsewhere is wrong.
  const Outcome none = tried(true, "").over("n = 2").but_not("n = 1", tried(true, ""));
  CHECK(none.verdict == StatementVerdict::false_claim);
  const Outcome wrong = tried(false, "n = 2").over("n = 2").but_not("n = 1", tried(false, "n = 1"));
  CHECK(wrong.verdict == StatementVerdict::false_claim);
  CHECK(wrong.witness == "n = 2");
  CHECK(wrong.edge.empty());
}

TEST_CASE("what is wrong is as recorded with its grade") {
  const Outcome misprint = tried(false, "n = 2").outcome(tried(true, "").over("n = 2"));
  CHECK(misprint.verdict == StatementVerdict::misprint);
  CHECK(not_a_slip(misprint).verdict == StatementVerdict::false_claim);
  const Statement slip = recorded(StatementVerdict::misprint, Grade::slip);
  CHECK(grade_of(slip, misprint) == Grade::slip);
  CHECK(is_as_recorded(slip, misprint));
  CHECK(verdict_in_words(slip, misprint) == "slip of the pen");
  const Outcome holds = tried(true, "").over("n = 2");
  CHECK_FALSE(grade_of(slip, holds));
  CHECK_FALSE(is_as_recorded(slip, holds));
  const Statement edge = recorded(StatementVerdict::holds, Grade::edge);
  CHECK_FALSE(is_as_recorded(edge, holds));
  Outcome at_edge = tried(true, "").over("n = 2").but_not("n = 1", tried(false, "n = 1"));
  CHECK(is_as_recorded(edge, at_edge));
  CHECK_FALSE(is_as_recorded(recorded(StatementVerdict::holds, {}), at_edge));
  CHECK(verdict_in_words(edge, at_edge) == "holds, but not at n = 1");
  CHECK(verdict_in_words(recorded(StatementVerdict::false_claim, Grade::number), not_a_slip(misprint)) ==
        "numbers are off");
  CHECK(verdict_in_words(recorded(StatementVerdict::false_claim, Grade::claim), not_a_slip(misprint)) ==
        "does not hold");
}
