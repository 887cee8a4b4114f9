#include <subcert/cmake/catch.hpp>
#include <subcert/reports/results.hpp>

using namespace subcert;
using namespace subcert::reports;

namespace {

const statements::Statement& statement(const char* id) { return *statements::find_statements(id).front(); }

CheckedStatement checked(const char* id, const statements::Outcome& outcome) { return {&statement(id), outcome, 0}; }

Result value(Standing standing, const std::string& group, const std::string& derived = "") {
  Result result{.kind = ResultKind::value, .paper = "a", .verdict = group, .standing = standing, .group = group};
  result.derived = derived;
  return result;
}

const statements::Outcome misprint{StatementVerdict::misprint, "", "n = 2", ""};

}  // namespace

TEST_CASE("values that follow from others are compared and not counted") {
  const std::vector<Result> all{value(Standing::right, "match"), value(Standing::wrong, "wrong"),
                                value(Standing::wrong, "wrong", "n times the column before"),
                                value(Standing::aside, "rest on data that were not published")};
  const Counts found = counts(all, ResultKind::value);
  CHECK(found.all() == 3);
  CHECK(found.checked() == 2);
  CHECK(found.text() == "1 of 2 printed values match; 1 wrong; beside them 1 rests on data that were not published");
  CHECK(counts(all, ResultKind::value, "b").text().empty());
  CHECK(counts({all.back()}, ResultKind::value).head().empty());
}

TEST_CASE("statements count by what is known, and a cause once") {
  const std::vector<Result> all = results({
      checked("dyn-2015/eq-2", {StatementVerdict::holds_for_all, "", "", ""}),
      checked("dyn-2015/eq-21", {StatementVerdict::holds, "", "", ""}),
      checked("dyn-2015/corollary-4", {StatementVerdict::holds_for_all, "", "n = 1", "", "n = 1"}),
      checked("mustafa-bari-2016/eq-2.5", misprint),
      checked("mustafa-bari-2016/eq-2.6", misprint),
      checked("dyn-2015/figs-3-7", {StatementVerdict::not_checkable, "", "", "why"}),
  });
  const Counts found = counts(all, ResultKind::statement);
  CHECK(found.text() ==
        "3 of 5 statements hold (1 proved for all n, 1 on the range tried, 1 but for an edge); 2 slips of the pen; "
        "beside them 1 left to experiments");
  CHECK(counts({all.front()}, ResultKind::statement).text() == "1 of 1 statements hold (1 proved for all n)");
  CHECK(found.causes == 1);
  CHECK(errata_sentence(found).starts_with("2 of 5 statements do not hold, from 1 cause: 2 slips of the pen;"));
  CHECK(standing_sentence(found).starts_with("3 of 5 statements hold, 1 of them now with proofs"));
  CHECK(standing_sentence(counts({all.back()}, ResultKind::statement)) ==
        "What does not hold is named with its reason.");
  CHECK(standing_sentence(counts({all[3]}, ResultKind::statement)).starts_with("0 of 1 statements hold; what"));
  CHECK(errata_sentence(counts({all.front()}, ResultKind::statement)).empty());
}

TEST_CASE("a statement is as recorded with verdict and grade") {
  Findings findings;
  findings.statements = {checked("dyn-2015/corollary-4", {StatementVerdict::holds_for_all, "", "n = 1", "", "n = 1"})};
  CHECK(findings.as_recorded());
  CHECK(results(findings.statements).front().as_recorded);
  findings.statements.front().outcome.edge = "";  // the edge is lost
  CHECK_FALSE(findings.as_recorded());
  CHECK_FALSE(results(findings.statements).front().as_recorded);
  findings.statements = {checked("dyn-2015/eq-2", {StatementVerdict::holds, "", "", ""})};  // no longer proved
  CHECK_FALSE(findings.as_recorded());
  CHECK_FALSE(results(findings.statements).front().as_recorded);
}
