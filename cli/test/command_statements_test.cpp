#include "program.hpp"

using namespace subcert::testing;

TEST_CASE("statements: the fields of the contract") {
  const auto json = run_json("statements check dyn-2015/corollary-4 mustafa-bari-2016/eq-2.6");
  REQUIRE(json.at("statements").size() == 2);
  const auto& proved = json.at("statements").at(0);
  CHECK(proved.at("id") == "dyn-2015/corollary-4");
  CHECK(proved.at("verdict") == "holds-for-all-n");
  CHECK(proved.at("range") == "all n >= 2");
  const auto& misprint = json.at("statements").at(1);
  CHECK(misprint.at("verdict") == "misprint");
  CHECK(misprint.at("witness") == "n = 2, a = 3, q = 0, r = -2: printed 37/35, derived -3/35");
  CHECK_FALSE(misprint.at("corrected").get<std::string>().empty());

  const Run unknown = run("statements check nobody-1900/eq-1");
  CHECK(unknown.code == 64);
  CHECK(unknown.err.find("no statement or paper 'nobody-1900/eq-1'") != std::string::npos);
  check_fails(run("statements check conjecture-7"), 64,
              "no statement or paper 'conjecture-7'; did you mean dyn-2015/conjecture-7?");
  check_fails(run("statements check conjecture7"), 64,
              "no statement or paper 'conjecture7'; did you mean dyn-2015/conjecture-7?");
  CHECK(contains(run("statements check dyn2015").err, "; did you mean 'dyn-2015'?"));
  CHECK(run("statements").out == run("statements list").out);
  // What an id begins with means all of these; a whole id that one alone.
  CHECK(run("statements list --ids dyn-2015/table-3").out ==
        "dyn-2015/table-3-sup\ndyn-2015/table-3-n-sup\ndyn-2015/table-3-slope\ndyn-2015/table-3-n2-slope\n"
        "dyn-2015/table-3-rates\ndyn-2015/table-3-rates-slope\n");
  CHECK(run("statements list --ids dyn-2015/table-1").out == "dyn-2015/table-1\n");
  CHECK(run("statements list dyn-2015/table-").code == 64);
  const auto wrong = run_json("statements list --verdict misprint,false").at("statements");
  CHECK(wrong.size() > 10);
  std::size_t all = 0;
  const auto listed = run_json("statements list").at("statements");
  for (const auto& one : listed) all += one.at("recorded") == "misprint" || one.at("recorded") == "false" ? 1 : 0;
  CHECK(wrong.size() == all);
  for (const auto& one : wrong) CHECK((one.at("recorded") == "misprint" || one.at("recorded") == "false"));
  check_fails(run("statements list --verdict wrong"), 64,
              "--verdict wrong: expected false, holds, holds-for-all-n, misprint, not-checkable");
  check_fails(run("statements check dyn-2015/eq-1 --verdict false"), 64, "--verdict: none of these statements has it");

  const Folder folder;
  const std::string page = folder / "page.html";
  CHECK(run("statements check dyn-2015/remark-9 --page " + page).code == 0);
  const std::string text = content(page);
  CHECK(text.find("<h1>Errata and confirmations</h1>") != std::string::npos);
  CHECK(text.find("A^\\dagger = A^T (A A^T)^{-1}") != std::string::npos);
}
