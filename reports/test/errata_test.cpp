#include <subcert/cmake/catch.hpp>
#include <subcert/reports/errata.hpp>

using namespace subcert;
using namespace subcert::reports;

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
