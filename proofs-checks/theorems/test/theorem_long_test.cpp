#include "theorem_checks.hpp"

using namespace subcert::theorems;

TEST_CASE("degree 5: every inequality holds, and fails if its constant moves in the wrong direction", "[long]") {
  for (const char* id : {"conjecture-7", "conjecture-8-n"}) check_theorem(id, 5);
}

TEST_CASE("degrees from 5 to 13 are ordered for every n", "[long]") {
  for (int degree : {5, 7, 9, 11}) check_theorem("conjecture-8-d", degree);
}
