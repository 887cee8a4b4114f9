#include "theorem_checks.hpp"

using namespace subcert::theorems;

TEST_CASE("the higher degrees: every inequality holds, and fails if its constant moves in the wrong direction",
          "[long]") {
  for (int degree : {7, 9, 11, 13})
    for (const char* id : {"conjecture-7", "conjecture-8-n", "conjecture-8-d"})
      if (degree < 13 || std::string(id) != "conjecture-8-d") check_theorem(id, degree);
}

TEST_CASE("the other families: every inequality holds, and fails if its constant moves in the wrong direction",
          "[long]") {
  for (const char* family : {"primal-odd", "dual", "dual-odd"})
    for (int degree : {1, 2, 3})
      if (degree != 2 || std::string(family) != "primal-odd")
        for (const char* id : {"conjecture-7", "conjecture-8-n", "conjecture-8-d"}) check_theorem(id, degree, family);
}
