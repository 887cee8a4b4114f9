#include "program.hpp"

#include <sstream>

using namespace subcert::testing;

TEST_CASE("the claim is printed as all checkers are asked") {
  const Folder folder;
  const std::string file = folder / "it's a file.cert", matrices = folder / "pair.json";
  const std::string quoted = "'" + std::string(folder / "it'\\''s a file.cert") + "'";
  std::ofstream(matrices) << R"({"matrices": [[["1","1"],["0","1"]], [["1","0"],["1","1"]]]})";
  for (const std::string& command :
       {std::string("regularity dd:n=2"), std::string("regularity loop"), std::string("regularity daubechies:n=2"),
        "jsr " + matrices, "jsr --subradius " + matrices}) {
    CAPTURE(command);
    REQUIRE(run(command + " --certificate " + quoted).code == 0);
    const Run printed = run("verify --print-claim " + quoted);
    CHECK(printed.code == 0);
    CHECK(printed.out.ends_with(" " + quoted + "\n"));
    const std::string answer = run("verify " + quoted).out;
    std::istringstream checkers(SUBCERT_CHECKERS);
    for (std::string checker; std::getline(checkers, checker, '|');) {
      CAPTURE(checker);
      const Run asked = run_command(checker + " " + printed.out.substr(0, printed.out.size() - 1));
      if (asked.code == 2) continue;  // what it was not made for
      CHECK(asked.code == 0);
      CHECK(answer.starts_with(file + ": " + asked.out.substr(0, asked.out.size() - 1)));
    }
    const auto json = nlohmann::json::parse(run("verify --json --print-claim " + quoted).out);
    CHECK(json.at("certificates").at(0).at("arguments").back() == file);
  }
  CHECK(run("verify --print-claim " + quoted + " --claim '1 <= dd:n=2'").out ==
        "--mask '[-1,0,9,16,9,0,-1]/16@-3' --arity 2 --lower 1 " + quoted + "\n");
  std::ofstream(file, std::ios::binary) << "nonsense\n";
  CHECK(run("verify --print-claim " + quoted).code == 65);
}

TEST_CASE("certificates are written and verified") {
  const Folder folder;
  const std::string file = folder / "file.cert";
  for (const char* scheme : {"dd:n=3", "four-point:w=1/20"}) {
    CHECK(run(std::string("regularity ") + scheme + " --certificate " + file).code == 0);
    CHECK(run("verify " + file).code == 0);
  }
  CHECK(run("regularity dual-odd:n=2 --certificate " + file).code == 0);
  const Run verified = run("verify " + file);
  CHECK(verified.code == 0);
  CHECK(verified.out.find(": VERIFIED ") != std::string::npos);
  // One digit of one vertex changed.
  std::string text = content(file);
  const std::size_t vertex = text.find("vertex ") + 12;
  text[vertex] = text[vertex] == '1' ? '2' : '1';
  std::ofstream(file, std::ios::binary) << text;
  const Run rejected = run("verify " + file);
  CHECK(rejected.code == 1);
  CHECK(rejected.out.find(": REJECTED ") != std::string::npos);
  std::ofstream(file, std::ios::binary) << "nonsense\n";
  CHECK(run("verify " + file).code == 65);
  std::filesystem::remove(file);
  CHECK(run("verify " + file).code == 66);
  const Run endless = run("verify /dev/zero");
  CHECK(endless.code == 65);
  CHECK(endless.err == "subcert: /dev/zero: longer than 256 MB\n");
}

TEST_CASE("an answer is not lost where no certificate can be written") {
  const Folder folder;
  const std::string file = folder / "file.cert", matrices = folder / "pair.json";
  std::ofstream(matrices) << R"({"matrices": [[["0","1"],["0","0"]], [["1","1"],["1","1"]]]})";
  // Nothing positive is proved, by curves, surfaces and tensor products; a dilation without certificates.
  for (const char* scheme : {"'mask:[1,1]'", "'mask:[1,0,0,1]'", "'mask2:[[1,1],[1,1]]'",
                             "'tensor:(mask:[1,0,0,2,0,0,1]/2)x(mask:[1,0,0,2,0,0,1]/2)'",
                             "'tensor:(bspline:degree=2)x(bspline:degree=2,a=3)'"}) {
    CAPTURE(scheme);
    const std::string command = std::string("regularity ") + scheme;
    const Run without = run(command), with = run(command + " --certificate " + file);
    CHECK(with.code == without.code);
    CHECK(with.out.find("certificate  not written: ") != std::string::npos);
    CHECK(with.out.substr(0, with.out.find('\n')) == without.out.substr(0, without.out.find('\n')));
    CHECK_FALSE(std::filesystem::exists(file));
    const auto json = nlohmann::json::parse(run(command + " --json --certificate " + file).out);
    CHECK(json.at("certificate").is_null());
    CHECK(json.at("certificate_reason").is_string());
    CHECK(json.contains("sum_rules"));
  }
  // No place for it is said before the work.
  for (const char* command : {"regularity dd:n=2", "jsr"}) {
    const std::string start = std::string(command) + (command[0] == 'j' ? " " + matrices : "") + " --certificate ";
    CHECK(run(start + (folder / "none/file.cert")).code == 66);
    CHECK(run(start + (folder / "")).code == 66);
  }
}

TEST_CASE("a certificate that cannot be written is one line and exit code 66, after the answer") {
  const Folder folder;
  const std::string matrices = folder / "pair.json", file = folder / "file.cert", bundle = folder / "bundle";
  std::ofstream(matrices) << R"({"matrices": [[["0","1"],["0","0"]], [["1","1"],["1","1"]]]})";
  // Folders stand where files should go, a device takes nothing.
  std::filesystem::create_directory(file + ".matrices");
  std::filesystem::create_directories(bundle + "/01-proved.cert");
  std::filesystem::create_directories(bundle + "/00001-piece.cert");
  std::ofstream(bundle + "/07-refuted.cert") << "of a run before\n";
  for (const std::string& command :
       {"jsr " + matrices + " --certificate " + file, std::string("regularity dd:n=2 --certificate /dev/full"),
        std::string("regularity loop --certificate /dev/full"),
        "range dual-four-point:w --over w=0..1/100 --property stable --certificate " + bundle,
        "curve four-point:w --over w=1/20..1/16 --pieces 1 --certificate " + bundle}) {
    CAPTURE(command);
    const Run blocked = run(command);
    CHECK(blocked.code == 66);
    CHECK(blocked.out.find(" not written: ") != std::string::npos);
    CHECK(blocked.out.find("verified") == std::string::npos);
    CHECK(blocked.out.find('\n') < blocked.out.find("certificate"));
    CHECK(blocked.err.starts_with("subcert: "));
    CHECK(std::count(blocked.err.begin(), blocked.err.end(), '\n') == 1);
  }
  CHECK(std::filesystem::exists(bundle + "/07-refuted.cert"));
  CHECK_FALSE(std::filesystem::exists(bundle + "/02-proved.cert"));
}

TEST_CASE("what a certificate says of a product whose leading eigenvalue is a multiple one") {
  const Folder folder;
  const std::string file = folder / "file.cert", matrices = folder / "pair.json";
  const auto line = [&](const char* text) {
    std::ofstream(matrices) << text;
    return joined(run("jsr " + matrices + " --certificate " + file).out);
  };
  CHECK(line(R"({"matrices": [[[0,-2],[-1,0]], [[-2,0],[0,-2]]]})")
            .find("verified: the bounds, and that the product attains the radius") != std::string::npos);
  CHECK(run("verify " + file).code == 0);
  // Of another one, with two leading eigenvalues, the page says what the certificate does not.
  const std::string both = line(R"({"matrices": [[[-2,-2,1],[-2,1,-1],[-2,-2,1]], [[1,-1,-1],[1,-2,-1],[0,-2,1]]]})");
  CHECK(both.find("proved to attain the joint spectral radius") != std::string::npos);
  CHECK(both.find("verified: the bounds, and that the product attains the radius") != std::string::npos);
  CHECK(run("verify " + file).code == 0);
}

TEST_CASE("answers about certificates come before the line about one that is missing") {
  const Folder folder;
  const std::string good = folder / "good.cert", bad = folder / "bad.cert", none = folder / "none.cert";
  CHECK(run("regularity dd:n=2 --certificate " + good).code == 0);
  std::ofstream(bad) << "nonsense\n";
  for (const auto& [missing, code] : {std::pair(none, 66), std::pair(bad, 65)}) {
    const Run both = run("verify " + good + " " + missing);
    CHECK(both.code == code);
    CHECK(both.out.starts_with(good + ": VERIFIED "));
    CHECK(std::count(both.err.begin(), both.err.end(), '\n') == 1);
  }
  CHECK(run("verify " + none).out.empty());
}

TEST_CASE("a surface with unstable shifts has a certificate that proves convergence, too") {
  const Folder folder;
  const std::string file = folder / "file.cert";
  for (const char* scheme : {"zwart-powell:", "'mask2:[[1,3,3,1],[1,3,3,1],[0,0,0,0],[1,3,3,1],[1,3,3,1]]/8'"}) {
    CAPTURE(scheme);
    CHECK(run(std::string("regularity ") + scheme + " --certificate " + file).code == 0);
    const std::string text = content(file);
    const std::size_t second = text.find("\nsum-rules ");
    REQUIRE(text.find("\nvalues ") < second);
    REQUIRE(second != std::string::npos);
    CHECK(run("verify " + file).code == 0);
    std::ofstream(file, std::ios::binary) << text.substr(0, second) + "\nend\n";
    CHECK(run("verify " + file).code == 1);
  }
}

TEST_CASE("the certificate of a surface is verified by its claim line") {
  const Folder folder;
  const std::string file = folder / "hat.cert";
  const std::string text =
      "subcert-certificate 3\nsurface [1,2,1]/2@-1 [2]\nbounds 1 1\nsum-rules 2\ndigits 0 1\nspace 1\n"
      "vector -1:1 0:-2 1:1\ngram 0:4 1:1\nproduct 0 1/2 0 0\nblock 0 norm 1\nend\n";
  std::ofstream(file, std::ios::binary) << text;
  const Run verified = run("verify " + file);
  CHECK(verified.code == 0);
  CHECK(verified.out.find(": VERIFIED 1 <= Hoelder exponent <= 1 of [1,2,1]/2@-1 with dilation [2]") !=
        std::string::npos);
  std::ofstream(file, std::ios::binary) << text.substr(0, text.find("gram")) + text.substr(text.find("product"));
  CHECK(run("verify " + file).code == 1);
  // Bounds that no claim about a surface has.
  for (const char* bounds : {"bounds - -", "bounds - 1"}) {
    std::ofstream(file, std::ios::binary) << std::string(text).replace(text.find("bounds 1 1"), 10, bounds);
    const Run none = run("verify " + file);
    CHECK(none.code == 65);
    CHECK(none.err.find(std::string("line 3: expected a bound, as no claim of this kind has '") + bounds) !=
          std::string::npos);
    CHECK(run("verify " + file + " --claim '1 <= mask2:[[1,2,1]]'").code != 0);
  }
}

TEST_CASE("the exponent of a vector of functions has a certificate") {
  const Folder folder;
  const std::string file = folder / "file.cert", hermite = "[[[4,6],[-1,-1]],[[8,0],[0,4]],[[4,-6],[1,-1]]]/8@-1",
                    of_scheme = "[[[4,-1],[6,-1]],[[8,0],[0,4]],[[4,1],[-6,-1]]]/8@-1";
  const auto asked = [&](const std::string& claim) { return run("verify " + file + " --claim '" + claim + "'"); };
  CHECK(run("regularity 'refinable:" + hermite + "' --certificate " + file).code == 0);
  const std::string proved = ": VERIFIED 2 <= Hoelder exponent <= 2 of the refinable functions of " + hermite +
                             " with dilation [2]\n";
  CHECK(run("verify " + file).out == file + proved);
  CHECK(
      run("verify --print-claim " + file).out.starts_with("--refinable '" + hermite + "' --dilation '[2]' --lower 2"));
  for (const std::string& scheme : {"refinable:" + hermite, "vector:" + of_scheme, "hermite:" + of_scheme})
    CHECK(asked("2 <= " + scheme + " <= 2").out == file + proved);
  CHECK(asked("2.1 <= refinable:" + hermite).code == 1);
  CHECK(asked("2 <= refinable:" + hermite + " <= 1.9").code == 1);
  CHECK(asked("2 <= refinable:" + of_scheme).code == 1);
  // One function of them, and a space of solutions.
  const std::string knots = "bspline:degree=4,multiplicity=4";
  CHECK(run("regularity " + knots + " --component 2 --certificate " + file).code == 0);
  CHECK(contains(run_command("cat " + file).out, "\nunobservable 1\n"));
  CHECK(asked("2 <= component 2 of " + knots + " <= 2")
            .out.find(": VERIFIED 2 <= Hoelder exponent <= 2 of component 1 "
                      "of the refinable functions of ") != std::string::npos);
  CHECK(asked("2 <= component 1 of " + knots).code == 1);
  CHECK(asked("1 <= " + knots).code == 1);
  for (const char* wrong : {"component 5 of ", "component 0 of ", "component x of "})
    CHECK(asked("1 <= " + (wrong + knots)).code == 64);
  CHECK(asked("1 <= component 1 of dd:n=2").code == 64);
  CHECK(joined(run("regularity 'refinable:[[[1,0],[0,1]],[[2,0],[0,2]],[[1,0],[0,1]]]/2@-1' --certificate " + file).out)
            .find("the only one up to a factor, got up to 2") != std::string::npos);
}

TEST_CASE("one of several vectors of functions has a certificate") {
  const Folder folder;
  const std::string file = folder / "file.cert",
                    both = "refinable:[[[2,0],[0,1]],[[4,0],[0,3]],[[2,0],[0,3]],[[0,0],[0,1]]]/4@-1",
                    spline = both + ",integral=[0,2/3]";
  const auto asked = [&](const std::string& claim) { return run("verify " + file + " --claim '" + claim + "'").code; };
  CHECK(run("regularity '" + spline + "' --certificate " + file).code == 0);
  CHECK(contains(run("verify " + file).out, "VERIFIED 2 <= Hoelder exponent <= 2 of the refinable functions of "));
  CHECK(asked("2 <= " + spline + " <= 2") == 0);
  CHECK(asked("2 <= " + both) == 1);
  CHECK(asked("2 <= " + both + ",integral=[1,2/3]") == 1);
  CHECK(run("regularity '" + both + ",integral=[1,1]' --component 2 --certificate " + file).code == 0);
  CHECK(asked("2 <= component 2 of " + both + ",integral=[1,1] <= 2") == 0);
  CHECK(asked("2 <= component 2 of " + both) == 1);
}

TEST_CASE("a certificate is asked for the claim that is stated") {
  const Folder folder;
  const std::string file = folder / "file.cert";
  const auto asked = [&](const std::string& claim) { return run("verify " + file + " --claim '" + claim + "'"); };
  CHECK(run("regularity four-point:w=1/16 --certificate " + file).code == 0);
  CHECK(asked("2 <= four-point:w=1/16 <= 2").out ==
        file + ": VERIFIED 2 <= Hoelder exponent <= 2 of " + "[-1,0,9,16,9,0,-1]/16@-3 with arity 2\n");
  CHECK(asked("1.5 <= dd:n=2").code == 0);
  CHECK(asked("2.1 <= dd:n=2").code == 1);
  CHECK(asked("1 <= primal:n=2").code == 1);
  CHECK(asked("3/2<=dd:n=2<=5/2").code == 0);
  const std::string number = "four-point:w=1/16 = 4-log|[-4,1]@4,0,1/1000|^1/1";
  CHECK(asked(number).code == 0);
  CHECK(asked("1 <= " + number + " with |log h|^1 <= 2").code == 0);
  CHECK(asked(number + " with |log h|^0").code == 1);
  CHECK(asked("four-point:w=1/16 = 3-log|[-4,1]@4,0,1/1000|^1/1").code == 1);
  for (const char* bad : {"dd:n=2 = 4-log", "dd:n=2 with |log h|^1", "dd:n=2 = 4-log|[-4,1]@4,0,1|^1/1 with |log h|^x",
                          "", "1 <= ", "x <= dd:n=2 <= 3", "1 <= dd:n=2 <= 2 <= 3", "dd:n=2 <= D2", "1 <= dd:n=", "1",
                          "1 <= daubechies:n=2", "1 <= four-point:w for w"}) {
    CAPTURE(bad);
    CHECK(asked(bad).code == (*bad ? 64 : 0));  // an empty one is none
  }
  CHECK(run("regularity 'tensor:(dd:n=2)x(dd:n=2)' --certificate " + file).code == 0);
  CHECK(asked("3/2 <= tensor:(dd:n=2)x(dd:n=2)").code == 0);
  const std::string bundle = folder / "bundle";
  CHECK(run("range four-point:w --over w=1/20..1/10 --property C1 --certificate " + bundle).code == 0);
  const auto proved = [&](const std::string& claim) {
    return run("verify " + bundle + " --claim '" + claim + "'").code == 0;
  };
  CHECK(proved("1 <= four-point:w for w=1/20..1/10"));
  CHECK_FALSE(proved("1 <= four-point:w for w=1/20..1/9"));
  const std::string matrices = folder / "golden.mat";
  std::ofstream(matrices, std::ios::binary) << "matrices 2 2\nrow 1 1\nrow 0 1\nrow 1 0\nrow 1 1\n";
  CHECK(run("jsr " + matrices + " --certificate " + file).code == 0);
  CHECK(asked("1.618 <= radius " + matrices + " <= 1.6181").code == 0);
  CHECK(asked("radius " + matrices + " <= 1.618").code == 1);
}

TEST_CASE("claims that follow from certificates, contradict them, or are open") {
  const Folder folder;
  const std::string file = folder / "file.cert", bundle = folder / "bundle", golden = folder / "golden.mat";
  const auto asked = [](const std::string& where, const std::string& claim) {
    const Run answer = run("verify " + where + " --claim '" + claim + "'");
    const std::size_t word = answer.out.find(": ") + 2;
    return answer.out.substr(word, answer.out.find(' ', word) - word) + " " + std::to_string(answer.code);
  };
  // An exponent of 1.99014395938625..., with both ends.
  CHECK(run("regularity primal:n=5 --certificate " + file).code == 0);
  CHECK(run("verify " + file).out.ends_with(" (1.9901439593863)\n"));
  for (const auto& [claim, verdict] :
       std::vector<std::pair<std::string, std::string>>{{"1.99 < primal:n=5", "VERIFIED 0"},
                                                        {"primal:n=5 > 1.99", "VERIFIED 0"},
                                                        {"2 > primal:n=5 >= 1.9", "VERIFIED 0"},
                                                        {"primal:n=5 <= 1.9902", "VERIFIED 0"},
                                                        {"primal:n=5 < 2", "VERIFIED 0"},
                                                        {"primal:n=5 <= C2", "VERIFIED 0"},
                                                        {"1.9902 <= primal:n=5", "FALSE 1"},
                                                        {"primal:n=5 <= 1.99", "FALSE 1"},
                                                        {"primal:n=5 <= C1", "FALSE 1"},
                                                        {"1 <= primal:n=5 <= 1.5", "FALSE 1"},
                                                        {"1.9 <= primal:n=4", "REJECTED 1"}}) {
    CAPTURE(claim);
    CHECK(asked(file, claim) == verdict);
  }
  const std::string same = run("verify " + file + " --claim '1.99 <= primal:n=5 > 1'").err;
  CHECK(contains(same, "expected [NUMBER <=] SUBJECT"));
  CHECK(run("verify --print-claim " + file + " --claim '1.99 < primal:n=5'").code == 64);
  CHECK(run_json("verify " + file + " --claim '2.1 <= primal:n=5'", 1).at("certificates")[0].at("verdict") == "false");
  // At the number itself strict signs are false, others not.
  CHECK(run("regularity dd:n=2 --certificate " + file).code == 0);
  CHECK(asked(file, "dd:n=2 <= 2") == "VERIFIED 0");
  CHECK(asked(file, "dd:n=2 < 2") == "FALSE 1");
  CHECK(asked(file, "2 < dd:n=2") == "FALSE 1");
  CHECK(asked(file, "dd:n=2 <= C2") == "REJECTED 1");  // |log h| decides it, of which these numbers say nothing
  // Of a range: subranges, other letters, single values; `<` and `<=`.
  CHECK(run("range four-point:w --over w=1/20..1/10 --property C1 --certificate " + bundle).code == 0);
  for (const auto& [claim, verdict] :
       std::vector<std::pair<std::string, std::string>>{{"1 <= four-point:w for w=3/50..2/25", "VERIFIED 0"},
                                                        {"1 < four-point:t for all t=0.05..0.1", "VERIFIED 0"},
                                                        {"1 < four-point:mu for 1/20 < mu <= 0.1", "VERIFIED 0"},
                                                        {"1/2 < four-point:w for w=1/16", "VERIFIED 0"},
                                                        {"1 <= four-point:w for w=1/20..1/9", "REJECTED 1"},
                                                        {"3/2 <= four-point:w for w=1/20..1/10", "REJECTED 1"},
                                                        {"four-point:w <= 1 for w=1/10..1/9", "FALSE 1"},
                                                        {"four-point:w <= 1 for w=1/9..1/8", "REJECTED 1"},
                                                        {"four-point:w <= C1 for 1/10 < w < 1/9", "REJECTED 1"},
                                                        {"1 <= dual-four-point:w for w=3/50..2/25", "REJECTED 1"}}) {
    CAPTURE(claim);
    CHECK(asked(bundle, claim) == verdict);
  }
  for (const char* bad : {"1 <= four-point:w <= 2 for w=0..1 <= 3", "1 <= four-point:w for v=0..1/16",
                          "1 <= four-point:w for w=1/8..1/16", "1 <= four-point:w for w", "1 <= dd:n=2 for w=0..1"})
    CHECK(run("verify " + bundle + " --claim '" + std::string(bad) + "'").code == 64);
  // All sequences of levels: those of a subrange, and constant ones.
  CHECK(run("levels four-point:w --over w=1/20..3/40 --property C1 --certificate " + bundle).code == 0);
  CHECK(asked(bundle, "1 <= four-point:v for all levels v=3/50..7/100") == "VERIFIED 0");
  CHECK(asked(bundle, "1 <= four-point:v for all v=3/50..7/100") == "VERIFIED 0");
  std::ofstream(golden, std::ios::binary) << "matrices 2 2\nrow 1 1\nrow 0 1\nrow 1 0\nrow 1 1\n";
  CHECK(run("jsr " + golden + " --certificate " + file).code == 0);
  CHECK(asked(file, "radius " + golden + " < 1.6181") == "VERIFIED 0");
  CHECK(asked(file, "1.6181 <= radius " + golden) == "FALSE 1");
  std::ofstream(golden, std::ios::binary) << "matrices 2 2\nrow 1 1\nrow 0 1\nrow 1 0\nrow 2 1\n";
  CHECK(asked(file, "radius " + golden + " < 1.6181") == "REJECTED 1");
}

TEST_CASE("contractions of fits of least absolute deviations are verified, stated and printed") {
  const Folder folder;
  const std::string file = folder / "l1.cert";
  std::ofstream(file, std::ios::binary)
      << "subcert-certificate 3\nl1 3 1\nbounds - -\ncontraction 1 1 1\nstart 0\nsplit 0\nleaf 8 -2 0 2\nagain 0\n"
         "start 1\nsplit 0\nsplit 1\nleaf 8 -3 0 -5 5 0 3\nagain 0\nsplit 1\nagain 0\nagain 0\nend\n";
  const std::string proved = file + ": VERIFIED |D^1 S^1 f| <= 1 |D^1 f| of least absolute deviations 3,1\n";
  const auto asked = [&](const std::string& claim) { return run("verify " + file + " --claim '" + claim + "'"); };
  CHECK(run("verify " + file).out == proved);
  CHECK(run("verify --print-claim " + file).out == "--l1 3,1 --contraction 1,1,1 " + file + "\n");
  CHECK(asked("contraction 1,1 of l1:points=3,d=1 <= 1").out == proved);
  CHECK(asked("contraction 1,1 of l1:points=3,d=1 <= 0.9").code == 1);
  CHECK(asked("contraction 2,1 of l1:points=3 <= 1").code == 1);
  CHECK(asked("1/2 <= l1:points=3,d=1").code == 1);
  CHECK(asked("1/2 <= l1:points=3,d=1 <= 1").code == 1);
  CHECK(asked("l1:points=3 <= 1").code == 1);
  CHECK(contains(asked("contraction 1,1 of l1:points=3,d=1 <= 9/8").out, ": VERIFIED contraction 1,1 of "));
  for (const char* bad : {"contraction 1,1 of l1:points=3", "contraction 1,1 l1:points=3 <= 1",
                          "contraction 1,1 of dd:n=2 <= 1", "1 <= contraction 1,1 of l1:points=3 <= 1",
                          "contraction 1,1 of l1:points=3x3 <= 1", "contraction 0,1 of l1:points=3 <= 1"}) {
    CAPTURE(bad);
    CHECK(asked(bad).code == 64);
  }
  std::ofstream(file, std::ios::binary) << "subcert-certificate 3\nl1 3 1\nbounds - -\nstart 0\n";
  const Run none = run("verify " + file);
  CHECK(none.code == 65);
  CHECK(none.err.find("line 4: expected contraction STEPS ORDER BOUND") != std::string::npos);
}
