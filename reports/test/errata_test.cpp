#include <subcert/cmake/catch.hpp>
#include <subcert/reports/experiments/experiment.hpp>
#include <subcert/reports/pages.hpp>
#include <subcert/reports/results.hpp>

#include <algorithm>

using namespace subcert;
using namespace subcert::reports;

namespace {

std::vector<CheckedStatement> checked_now(const std::vector<const char*>& ids) {
  std::vector<const statements::Statement*> chosen;
  for (const char* id : ids) chosen.push_back(statements::find_statements(id).front());
  return check_statements(chosen, statements::Tier::quick, 2, {});
}

}  // namespace

TEST_CASE("the page shows what holds before what is to be corrected") {
  const auto checked = checked_now({"dyn-2015/remark-9", "dyn-2015/eq-2", "dyn-2015/figs-3-7", "dyn-2015/corollary-4"});
  REQUIRE(checked.size() == 4);
  for (const CheckedStatement& one : checked) CHECK(one.as_recorded());
  const std::string page = errata_page(checked, {});
  const auto wrong = page.find("id=\"dyn-2015/remark-9\""), right = page.find("id=\"dyn-2015/eq-2\"");
  const auto open = page.find("id=\"dyn-2015/figs-3-7\"");
  const auto edge = page.find("id=\"dyn-2015/corollary-4\"");
  CHECK(right < edge);
  CHECK(edge < wrong);
  CHECK(wrong < open);
  CHECK(page.find("holds, but not at&nbsp;n&nbsp;=&nbsp;1") != std::string::npos);
  CHECK(page.find("slip of the pen") != std::string::npos);
  CHECK(open != std::string::npos);
  CHECK(page.find("mustafa-bari-2016") == std::string::npos);
  // Where one scan is all there is, the words say so.
  CHECK(verdict_in_words(*statements::find_statements("dyn-2015/eq-26").front(),
                         {StatementVerdict::misprint, "", "", ""}) == "slip of the pen, or of the scan");
}

TEST_CASE("what repeats a fault stands under it, with the words of the paper and of the reader") {
  const auto checked = checked_now({"mustafa-bari-2016/eq-2.5", "mustafa-bari-2016/eq-2.5-positions",
                                    "mustafa-bari-2016/eq-2.6", "mustafa-bari-2016/eq-2.6-positions",
                                    "mustafa-bari-2016/sums-odd"});
  for (const CheckedStatement& one : checked) {
    CAPTURE(one.statement->id);
    CHECK(one.as_recorded());
  }
  const std::string page = errata_page(checked, {});
  const auto place = [&](const std::string& id) { return page.find("id=\"mustafa-bari-2016/" + id + "\""); };
  CHECK(place("eq-2.5") < place("eq-2.6"));
  CHECK(place("eq-2.6") < place("sums-odd"));
  CHECK(place("sums-odd") < place("eq-2.6-positions"));
  for (const char* label : {"the paper says", "read as", "as the scan has it", "witness", "follows from"})
    CHECK(page.find(std::string("<dt>") + label + "</dt>") != std::string::npos);
}

TEST_CASE("statements and experiments about the same sentences name each other, and agree") {
  std::vector<std::string> linked;
  for (const statements::Statement& one : statements::statements())
    for (const std::string& id : one.experiments) {
      CAPTURE(one.id, id);
      const experiments::Experiment& experiment = experiments::experiment(id);
      CHECK(experiment.paper == one.paper());
      linked.push_back(id);
      // What is decided in both places is decided in one way.
      for (const experiments::Claim& claim : experiment.claims) {
        CAPTURE(claim.sentence);
        CHECK_FALSE((standing(one.recorded) == Standing::right && standing(claim.recorded) == Standing::wrong));
        CHECK_FALSE((standing(one.recorded) == Standing::wrong && standing(claim.recorded) == Standing::right));
      }
    }
  for (const experiments::Experiment& one : experiments::experiments()) {
    CAPTURE(one.id);
    CHECK(std::ranges::find(linked, one.id) != linked.end());
  }
}

TEST_CASE("the page shows the claims that are about a statement's sentences as they were found") {
  const auto checked = checked_now({"dyn-2015/figs-3-7", "dyn-2015/dual-cubic-benefit"});
  const auto claim = [](const std::string& item, const std::string& words) {
    return Result{.kind = ResultKind::claim, .item = item, .key = item + "-claim-1", .page = "a.html", .words = words};
  };
  const std::string page = errata_page(checked, {claim("fig3", "depends on a choice"), claim("fig10", "other")});
  const auto has = [&](const std::string& part) { return page.find(part) != std::string::npos; };
  CHECK(has("<a href=\"a.html#fig3-claim-1\"></a> <b>depends on a choice</b>"));
  CHECK(has("<code>subcert experiment fig4</code>"));  // of which no claim was at hand
  CHECK_FALSE(has("fig10"));
  CHECK(has("see the experiments"));
  CHECK(has("cannot be checked"));
  const Counts found = counts(results(checked), ResultKind::statement);
  CHECK(found.text() == "2 statements: 1 left to experiments, 1 cannot be checked");
}
