#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/proofs-checks/papers/registry.hpp>

#include <algorithm>
#include <set>

using subcert::Standing;
using namespace subcert::statements;

TEST_CASE("the registry is complete and well formed") {
  std::set<std::string> ids;
  for (const Paper& paper : papers())
    for (const Statement& statement : paper.statements) {
      CAPTURE(statement.id);
      CHECK(ids.insert(statement.id).second);
      CHECK(statement.paper() == paper.key);
      CHECK_FALSE(statement.place.empty());
      CHECK_FALSE(statement.paraphrase.empty());
      CHECK_FALSE(statement.printed.empty());
      CHECK((standing(statement.recorded) != Standing::wrong || !statement.corrected.empty()));
      CHECK((statement.corrected.empty() || statement.grade));
      CHECK_NOTHROW(printed_latex(statement));
      CHECK_NOTHROW(corrected_latex(statement));
    }
}

TEST_CASE("the printed tables are complete and well formed") {
  const Paper& dyn = paper("dyn-2015");
  CHECK(dyn.table("masks").cells.size() == 12);
  CHECK(dyn.table("table1").cells.size() == 9);
  CHECK(dyn.table("table2").cells.size() == 9);
  CHECK(dyn.table("table3").cells.size() == 44);
  for (const Paper& one : papers())
    for (const PublishedTable& table : one.tables) {
      std::set<std::string> places;
      for (const PublishedCell& cell : table.cells) {
        CAPTURE(one.key, table.id, cell.row, cell.column);
        CHECK(places.insert(cell.row + "|" + cell.column).second);
        CHECK(!cell.printed.empty());
        if (!cell.source.empty()) CHECK(reference(cell.source).find_first_of("[\n") == std::string::npos);
      }
    }
  CHECK_FAILS(dyn.table("table4"), domain);
  CHECK_FAILS(paper("nobody-1900"), domain);
}

TEST_CASE("collections have tables and references, and no statements") {
  for (const std::string& key : collection_keys()) {
    CAPTURE(key);
    CHECK(std::ranges::find(paper_keys(), key) == paper_keys().end());
    CHECK(paper(key).statements.empty());
    for (const PublishedTable& table : paper(key).tables)
      for (const PublishedCell& cell : table.cells) CHECK(!cell.source.empty());
  }
  CHECK(reference("VZ01") ==
        "L. Velho, D. Zorin: 4-8 subdivision. Computer Aided Geometric Design 18 (2001), 397-427.");
  CHECK(reference("dBHR93").ends_with("Springer (1993)."));
  CHECK_FAILS(reference("VZ"), domain);
}
