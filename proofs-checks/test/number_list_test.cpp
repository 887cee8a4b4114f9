#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/proofs-checks/number_list.hpp>

using namespace subcert;

TEST_CASE("lists of integers are read, put in order and printed back") {
  const auto read = [](const char* text) { return parse_number_list("--n", text, 0, 100); };
  CHECK(read("7") == std::vector<int>{7});
  CHECK(read("1..4") == std::vector<int>{1, 2, 3, 4});
  CHECK(read("5,1,3") == std::vector<int>{1, 3, 5});
  CHECK(read("20..22,1..3,2,10") == std::vector<int>{1, 2, 3, 10, 20, 21, 22});
  CHECK(read("0..0,100") == std::vector<int>{0, 100});
  for (const char* text : {"1", "1,2", "1..3", "1..3,5,7,9..11", "0,100"}) CHECK(number_list_text(read(text)) == text);
}

TEST_CASE("malformed lists name the token and its position") {
  for (const char* text :
       {"",  ",",  "1,",     ",1",  "1..", "..1", "4..1", "1...3", "1..2..3",     "1.5",
        "a", "-1", "1..101", "101", "+1",  " 1",  "1 ",   "1;2",   "99999999999", "1..99999999999"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(parse_number_list("--n", text, 0, 100), ParseError);
  }
  try {
    parse_number_list("--n", "1..5,8,9..7", 1, 60);
    FAIL("no exception");
  } catch (const ParseError& error) {
    CHECK(
        std::string(error.what()) ==
        "--n, position 8: '9..7'; expected an integer from 1 to 60 or a range A..B of such with A <= B, as in 1..5,8");
  }
}
