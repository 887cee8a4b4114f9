#include "program.hpp"

#include <filesystem>

using namespace subcert::testing;

TEST_CASE("ranges of a parameter are proved and refuted") {
  const Run page = run("range four-point:w --over w=-1/4..1/4 --property C1");
  CHECK(page.code == 0);
  CHECK(joined(page.out).find("the zero of -1 + 4*w + 32*w^3 near 0.19272924") != std::string::npos);
  CHECK(joined(page.out).find("special      w = 1/16: more sum rules; proved there") != std::string::npos);
  const Run json = run("range four-point:t --over t=0..1/2 --property convergent --width 1/1000 --json");
  CHECK(json.code == 0);
  const auto range = nlohmann::json::parse(json.out);
  CHECK(range["sum_rules"] == 2);
  CHECK(range["pieces"].front()["verdict"] == "proved");
  CHECK(range["pieces"].front()["from"] == "0");
}

TEST_CASE("a range comes with certificates that one command verifies") {
  const Folder folder;
  const std::string bundle = folder / "bundle";
  const std::string range = "range four-point:w --over w=0..1/4 --property C1 --width 1/100 --certificate " + bundle;
  const Run page = run(range);
  CHECK(page.code == 0);
  CHECK(joined(page.out).find("certificates 2 in " + bundle) != std::string::npos);
  const Run verified = run("verify " + bundle);
  CHECK(verified.code == 0);
  CHECK(joined(verified.out).find("01-proved.cert: VERIFIED 1 < Hoelder exponent of ") != std::string::npos);
  CHECK(joined(verified.out).find("02-refuted.cert: VERIFIED no convergence, or Hoelder exponent < 1 of ") !=
        std::string::npos);
  // Another range leaves no certificate of this one behind.
  CHECK(run("range four-point:w --over w=1/20..1/10 --property C1 --certificate " + bundle).code == 0);
  CHECK(std::distance(std::filesystem::directory_iterator(bundle), {}) == 1);
  std::filesystem::remove_all(bundle);
  std::filesystem::create_directory(bundle);
  CHECK(run("verify " + bundle).code == 66);
  // Not a folder.
  const std::string file = folder / "file";
  std::ofstream(file) << "text";
  CHECK(run("range four-point:w --over w=1/20..1/10 --property C1 --certificate " + file).code == 66);
  CHECK(content(file) == "text");
}

TEST_CASE("what is written of a range is verified, and what the checker refuses is not left") {
  const Folder folder;
  const std::string bundle = folder / "bundle";
  // The last coefficients of both sub-symbols vanish at w = 0, in the range or at its end.
  for (const char* over : {"0..1/100", "-1/100..1/100"}) {
    CAPTURE(over);
    const Run page = run(std::string("range dual-four-point:w --over w=") + over + " --property stable --certificate " +
                         bundle);
    CHECK(page.code == 0);
    CHECK(joined(page.out).find(" in " + bundle + ", verified: subcert verify ") != std::string::npos);
    CHECK(joined(page.out).find("not written") == std::string::npos);
    const Run verified = run("verify " + bundle);
    CHECK(verified.code == 0);
    CHECK(joined(verified.out).find(" of [1,3,3,1]/4") != std::string::npos);
  }
  const auto json = nlohmann::json::parse(
      run("range dual-four-point:w --over w=0..1/100 --property stable --json --certificate " + bundle).out);
  CHECK(json.at("certificates") == 2);
  CHECK_FALSE(json.contains("certificate_reason"));
}

TEST_CASE("a window that moves from a peak to a box") {
  const std::string bundle = std::filesystem::temp_directory_path() / "subcert_window_test";
  const Run page = run(
      "range 'regression:stencils=[-1..1;-1..2],at=[0;1/2],d=1,weights=[w;1;w|w;1;1;w]' --over w=1/4..2 --property C1 "
      "--certificate " +
      bundle);
  CHECK(page.code == 0);
  CHECK(joined(page.out).find("proved       1/4 <= w <= 2\n") != std::string::npos);
  const Run verified = run("verify " + bundle);
  CHECK(verified.code == 0);
  CHECK(joined(verified.out).find("/(1+3*w+2*w^2)@-3 with arity 2 for all w=1/4..2") != std::string::npos);
  std::filesystem::remove_all(bundle);
}

TEST_CASE("range and curve: matrices with a parameter") {
  const Run page = run("range merrien:lambda=-1/8,mu --over mu=-5..3 --property HC1");
  CHECK(page.code == 0);
  CHECK(page.out.find("scheme       merrien:lambda=-1/8,mu  (Merrien's Hermite scheme with the parameter mu)\n") == 0);
  CHECK(page.out.find("answer       HC1 for -3 < mu < 1, and for no other mu from -5 to 3") != std::string::npos);
  const std::string folder = (std::filesystem::temp_directory_path() / "subcert_range_test").string();
  const auto all_accepted = [&](const std::string& what) {
    std::filesystem::remove_all(folder);
    CHECK(run(what + " --certificate " + folder).code == 0);
    const Run verified = run("verify " + folder);
    CHECK(verified.code == 0);
    return verified.out;
  };
  const std::string hermite = all_accepted("range merrien:lambda=-1/8,mu --over mu=-5..3 --property HC1");
  CHECK(contains(hermite, ": VERIFIED no HC^1 of the Hermite scheme of "));
  CHECK(contains(hermite, ": VERIFIED HC^1 of the Hermite scheme of "));
  CHECK(contains(all_accepted("range merrien:lambda=-1/8,mu --over mu=-2..1/2 --property 'holder>=5/4'"),
                 ": VERIFIED 5/4 < Hoelder exponent of the vector scheme of "));
  const auto asked = [&](const std::string& claim) {
    return run("verify " + folder + "/01-proved.cert --claim '" + claim + " for mu=-2..1/2'").code;
  };
  CHECK(asked("5/4 <= merrien:lambda=-1/8,mu") == 0);
  CHECK(asked("3/2 <= merrien:lambda=-1/8,mu") == 1);
  CHECK(asked("1 <= HC of merrien:lambda=-1/8,mu") == 1);
  CHECK(asked("1 <= HC of four-point:mu") == 64);
  all_accepted("curve merrien:lambda=-1/8,mu --over mu=-2..1/2 --pieces 8");
  std::filesystem::remove_all(folder);
  CHECK(run("range merrien:lambda=-1/8,mu --over mu=0..1 --property C1").code == 0);
  const Run refused = run("analyze merrien:lambda=-1/8,mu");
  CHECK(refused.code == 64);
  CHECK(refused.err.find("'subcert range' and 'curve'") != std::string::npos);
}

TEST_CASE("ranges that make no sense are refused in one line") {
  for (const char* arguments :
       {"four-point:w --over w=1..0 --property C1", "four-point:w --over t=0..1 --property C1",
        "four-point:w --over w=0..1 --property D1", "mask:[w,v,1-w,1-v] --over w=0..1 --property C1",
        "mask:[w,1-w] --over w=0..1 --property C1", "four-point:w=1/16 --over w=0..1 --property C1",
        "mask:[w,1,1-w] --over w=0..1/0 --property C1", "primal:n=3 --over w=0..1 --property C1",
        "four-point:w --over w=0..1 --property C1 --width 0", "four-point:w --property C1",
        "four-point:w --over w=0..1", "'mask:[1,v,v,1]/(1+v)' --over v=-2..1 --property C1",
        "'mask:[1,v,v,1]/(1+v)' --over v=-1..1 --property C1", "'mask:[1,v,v,1]/(1+v' --over v=0..1 --property C1"}) {
    CAPTURE(arguments);
    CHECK(run(std::string("range ") + arguments).code == 64);
  }
}

TEST_CASE("range: one sentence that says what is known, and reasons for what is not") {
  CHECK(contains(run("range corner-cutting:w --over w=0..1 --property convergent").out,
                 "answer       convergent exactly for 0 < w < 1, of all w from 0 to 1\n"));
  CHECK(contains(run("range four-point:w --over w=-1..1 --property stable").out,
                 "answer       stable exactly for -1 <= w < -1/2 and -1/2 < w <= 1, of all w from -1 to 1\n"));
  CHECK(contains(run("range four-point:w --over w=1..2 --property C1").out, "answer       C1 for no w from 1 to 2\n"));
  const Run smooth = run("range four-point:r --over r=-1..1 --property C1");
  CHECK(contains(joined(smooth.out),
                 "\nanswer       C1 for 0 < r < r1, and for no other r from -1 to 1; open on both sides within "));
  CHECK(contains(joined(smooth.out), " of -1/2, 0, r1; r1 is the zero of -1 + 4*r + 32*r^3 near 0.1927"));
  const Run open = run("range 'mask:[w,1/2-w,1/2,1/2,1/2-w,w]' --over w=-1..1 --property C1");
  CHECK(open.code == 3);  // no budget changes the reason
  CHECK_FALSE(contains(joined(open.out), "answer"));
  CHECK(contains(joined(open.out), "common zero for all values of the parameter"));
  CHECK(run("range four-point:w --over w=-1..1 --property C1 --budget 0.01").code == 2);
  const auto json = nlohmann::json::parse(
      run("range 'mask:[w,1/2-w,1/2,1/2,1/2-w,w]' --over w=-1..1 --property C1 --json").out);
  CHECK(json.at("summary") == "");
  CHECK(contains(json.at("pieces").at(0).at("reason"), "common zero"));
}

TEST_CASE("range, curve and map: parameters with names of several letters") {
  const auto same = [](const std::string& command, const std::string& named) {
    const Run one = run(command + " --json"), other = run(named + " --json");
    CAPTURE(command, one.err, other.err);
    CHECK(one.code == 0);
    CHECK(other.code == 0);
    CHECK(nlohmann::json::parse(one.out).at("pieces") == nlohmann::json::parse(other.out).at("pieces"));
  };
  same("range four-point:w --over w=0..1/2 --property stable",
       "range '[-μ,0,½+μ,1,½+μ,0,-μ]' --over mu=0..½ --property stable");
  const std::string bundle = std::filesystem::temp_directory_path() / "subcert_name_test";
  const Run named = run("range four-point:omega --over omega=1/16..1/8 --property C1 --certificate " + bundle);
  CHECK(
      contains(joined(named.out), "answer       C1 exactly for 1/16 <= omega <= 1/8, of all omega from 1/16 to 1/8\n"));
  CHECK(run("verify " + bundle).code == 0);
  CHECK(run("verify " + bundle + "/01-proved.cert --claim 'four-point:omega for omega=1/16..1/8 <= C1'").code == 1);
  std::filesystem::remove_all(bundle);
  CHECK(contains(run("curve four-point:mu --over mu=1/16..1/8 --pieces 4").out, " <= mu <= 1/8: exponent"));
  const Run map = run(
      "map '[tau,0,-mu-3tau,0,1/2+mu+2tau,1,1/2+mu+2tau,0,-mu-3tau,0,tau]' --over μ=0..1/8 "
      "--over tau=-1/64..1/64 --property convergent --resolution 2");
  CHECK(contains(joined(map.out), "2 for all mu and tau"));
}

TEST_CASE("range: families of surfaces are said to have no search") {
  for (const char* family : {"butterfly:w", "kobbelt:w"})
    CHECK(contains(run(std::string("range ") + family + " --over w=0..1/8 --property C1").err,
                   "expected a family of curves: of surfaces values are answered one by one, as by subcert sweep"));
}

TEST_CASE("range: --over names the letter of the family, and one range") {
  check_fails(run("range four-point:w --over v=0..1 --property C1"), 64,
              "--over 'v=0..1': the parameter of the family is w, not 'v'");
  for (const char* wrong : {"w=0...1", "w=0....1", "w=1..0", "w=0..", "w=..1", "0..1", "w=0..1..2", "w=nan..1"}) {
    const Run result = run(std::string("range four-point:w --property C1 --over ") + wrong);
    CAPTURE(wrong, result.err);
    CHECK(result.code == 64);
    CHECK(contains(result.err, "--over"));
  }
  CHECK(run("range four-point:w --property stable --over w=.5..1").code == 0);
}
