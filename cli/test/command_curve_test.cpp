#include "program.hpp"

using namespace subcert::testing;

TEST_CASE("a curve is drawn, tabulated and verified") {
  const Folder folder;
  const std::string csv = folder / "curve.csv", picture = folder / "curve.svg", bundle = folder / "bundle";
  const Run page = run("curve four-point:w --over w=1/100..1/10 --pieces 12 --csv " + csv + " --plot " + picture +
                       " --certificate " + bundle);
  CHECK(page.code == 0);
  CHECK(joined(page.out).find("special      w = 1/16: more sum rules; exponent 2") != std::string::npos);
  const std::string table = content(csv);
  CHECK(std::count(table.begin(), table.end(), '\n') == 13);
  CHECK(table.starts_with("from,to,lower,upper,product,convergence\n1/100,"));
  CHECK(content(picture).find("<svg") != std::string::npos);
  const std::string touched = folder / "curve.html";
  REQUIRE(run("curve four-point:w --over w=1/20..1/10 --pieces 4 --plot " + touched).code == 0);
  CHECK(content(touched).find("class=\"key band colour-1\"") != std::string::npos);
  const Run verified = run("verify " + bundle);
  CHECK(verified.code == 0);
  CHECK(joined(verified.out).find("00001-piece.cert: VERIFIED ") != std::string::npos);
  const Run json = run("curve four-point:t --over t=0..1/20 --pieces 4 --json");
  const auto curve = nlohmann::json::parse(json.out);
  CHECK(curve["family"] == "four-point:t");
  CHECK(curve["pieces"].size() == 4);
  CHECK(curve["pieces"][0]["product"] == "0");
  CHECK(curve["pieces"][0].contains("holder"));
  CHECK(curve["largest"]["to"] == "1/20");
  CHECK(curve["largest"]["holder"]["upper"] == curve["pieces"][3]["holder"]["upper"]);
}

TEST_CASE("the largest exponent, and where alone it can be") {
  // At w = 1/16 the four-point scheme has two sum rules more, and smaller exponents about it.
  CHECK(contains(run("curve four-point:w --over w=1/20..1/10 --pieces 20").out,
                 "\nlargest      exponent 2, within 399/6400 <= w <= 51/800\n"));
  const Run open = run("curve 'mask:[w,1/2-w,1/2,1/2,1/2-w,w]' --over w=2..3 --pieces 2");
  CHECK(contains(open.out, "undecided"));
  CHECK_FALSE(contains(open.out, "largest"));
}

TEST_CASE("curves that make no sense are refused in one line") {
  for (const char* arguments :
       {"four-point:w --over w=1..0", "four-point:w --over t=0..1", "four-point:w", "primal:n=3 --over w=0..1",
        "four-point:w --over w=0..1 --pieces 0", "four-point:w --over w=0..1 --plot curve.eps"}) {
    CAPTURE(arguments);
    CHECK(run(std::string("curve ") + arguments).code == 64);
  }
}
