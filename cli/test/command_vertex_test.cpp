#include "program.hpp"

#include <fstream>
#include <iterator>

using namespace subcert::testing;

TEST_CASE("vertex: the fields of the contract") {
  const auto answer = run_json("vertex loop --valence 3..4");
  CHECK(answer.at("scheme") == "loop");
  CHECK(answer.at("all") == "unknown");
  REQUIRE(answer.at("valences").size() == 2);
  const auto& at = answer.at("valences")[0];
  CHECK(at.at("valence") == 3);
  CHECK(at.at("c1") == "yes");
  CHECK(has_digits(at.at("subdominant"), "lower", "0.25"));
  CHECK(has_digits(at.at("exponent"), "upper", "1.5"));
  CHECK(at.at("curvature") == "unbounded");
}

TEST_CASE("vertex: one valence that is not C1 decides for all") {
  const auto answer = run_json("vertex butterfly --valence 4,8", 1);
  CHECK(answer.at("all") == "no");
  CHECK(answer.at("valences")[0].at("c1") == "yes");
  CHECK(answer.at("valences")[1].at("c1") == "no");
  CHECK(answer.at("valences")[1].at("frequency") == 2);
  CHECK(answer.at("valences")[1].at("curvature").is_null());
}

TEST_CASE("vertex: every valence") {
  const auto answer = run_json("vertex catmull-clark --all-valences");
  CHECK(answer.at("all") == "yes");
  CHECK(answer.at("valences").size() == 10);
  CHECK(answer.at("rest").at("first") == 13);
  CHECK(answer.at("rest").at("c1") == "yes");
  CHECK(answer.at("rest").at("open").empty());
  const auto open = run_json("vertex butterfly --all-valences", 1);
  CHECK(open.at("all") == "no");
  CHECK(open.at("rest").at("c1") == "unknown");
  CHECK(open.at("rest").at("open")[0].at("last").is_null());
  CHECK(run("vertex loop --all-valences --valence 4").code == 64);
}

TEST_CASE("vertex: stencils in JSON, and as a header that a compiler of C takes") {
  const Folder folder;
  const std::string header = folder / "stencils.h";
  const auto answer = run_json("vertex loop --valence 4,6 --stencils --stencils-header " + header);
  const auto& stencils = answer.at("valences")[1].at("stencils");
  REQUIRE(stencils.at("limit").size() == 7);
  CHECK(stencils.at("limit")[0].at("exact") == "1/2");
  CHECK(stencils.at("limit")[3].at("exact") == "1/12");
  CHECK(stencils.at("limit")[3].at("sector") == 2);
  CHECK(stencils.at("tangents")[0][1].at("exact") == "1/2");
  CHECK(stencils.at("tangents")[1][0].at("exact") == "s*(1)");
  std::ifstream file(header);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  CHECK(text.find("static const int loop_6_data[7][3] = {\n  {0, 0, 0},\n  {1, 0, 0},") != std::string::npos);
  CHECK(text.find("static const double loop_6_limit[7] = {\n  0.5,  /* 1/2 */") != std::string::npos);
  CHECK(text.find("0.8660254037844386,  /* s*(1) */") != std::string::npos);
  CHECK(std::system(("cc -std=c99 -Wall -Werror -Wno-unused -x c -fsyntax-only " + header).c_str()) == 0);
}

TEST_CASE("vertex: what is open for good, and wrong words") {
  CHECK(run_json("vertex midedge --valence 3", 3).at("valences")[0].at("c1") == "unknown");
  for (const std::string words : {"loop --valence 2", "loop --valence 1001", "loop --valence 5..3", "loop --valence x",
                                  "primal:n=3", "quincunx", "nothing", ""}) {
    CAPTURE(words);
    CHECK(run("vertex " + words).code == 64);
  }
}

TEST_CASE("vertex: certificates of what is proved by hulls are written and verified") {
  const Folder folder;
  const std::string place = folder / "proofs";
  const Run page = run("vertex midedge --valence 3..5 --certificate " + place);
  CHECK(page.code == 3);
  CHECK(joined(page.out).find("certificates 2 in " + place + ", verified: ") != std::string::npos);
  const Run verified = run("verify " + place);
  CHECK(verified.code == 0);
  CHECK(joined(verified.out).find("0005-vertex.cert: VERIFIED ") != std::string::npos);
  CHECK(joined(verified.out).find("C^1 limits of almost all data around dual:5;0,0=1/2@0,0,0") != std::string::npos);
  // Of all valences: one more file.
  CHECK(run_json("vertex doo-sabin --all-valences --certificate " + place).at("certificates") == 11);
  const Run of_all = run("verify " + place);
  CHECK(of_all.code == 0);
  CHECK(joined(of_all.out).find("C^1 limits of almost all data around dual:13+;0,0=1/4@0,0,0") != std::string::npos);
  // Those of a run before that are not written again go.
  const auto fits = run_json("vertex butterfly --valence 5 --certificate " + place);
  CHECK(fits.at("certificates") == 0);
  CHECK(run("verify " + place).code != 0);
}
