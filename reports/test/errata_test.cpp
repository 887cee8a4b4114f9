#include <subcert/cmake/catch.hpp>
#include <subcert/reports/errata.hpp>
#include <subcert/reports/formats/published.hpp>

using namespace subcert;
using namespace subcert::reports;

// Tables 1 to 3 were typed in twice: as data of the report and as transcriptions of the statements.
TEST_CASE("both transcriptions of the tables agree") {
  const formats::PublishedPaper paper = formats::published_paper("dyn-2015");
  const auto words = [](const std::string& id) {
    return statements::transcriptions().words("dyn-2015/" + id, statements::Form::printed);
  };
  const auto cells = [&](const std::string& table, const std::string& quantity) {
    std::vector<std::string> printed;
    for (const formats::PublishedCell& cell : paper.table(table).cells)
      if (cell.quantity == quantity) printed.push_back(cell.printed);
    return printed;
  };
  CHECK(cells("table1", "holder16") == words("table-1"));
  CHECK(cells("table2", "holder16") == words("table-2"));
  CHECK(cells("table3", "variance") == words("table-3-sup"));
  CHECK(cells("table3", "n*variance") == words("table-3-n-sup"));
  CHECK(cells("table3", "slope") == words("table-3-slope"));
  CHECK(cells("table3", "n^2*slope") == words("table-3-n2-slope"));
}

TEST_CASE("the page shows what is wrong before what holds") {
  std::vector<const statements::Statement*> chosen;
  for (const char* id : {"dyn-2015/remark-9", "dyn-2015/eq-2", "dyn-2015/figs-3-7"})
    chosen.push_back(statements::find_statements(id).front());
  const auto checked = check_statements(chosen, statements::Tier::quick, 2, {});
  REQUIRE(checked.size() == 3);
  for (const CheckedStatement& one : checked) CHECK(one.as_recorded());
  const std::string page = errata_page(checked);
  const auto wrong = page.find("id=\"dyn-2015/remark-9\""), right = page.find("id=\"dyn-2015/eq-2\"");
  const auto open = page.find("id=\"dyn-2015/figs-3-7\"");
  CHECK(wrong < right);
  CHECK(right < open);
  CHECK(open != std::string::npos);
  CHECK(page.find("mustafa-bari-2016") == std::string::npos);
}
