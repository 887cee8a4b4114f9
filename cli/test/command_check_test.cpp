#include "program.hpp"

#include <array>
#include <set>

using namespace subcert::testing;

TEST_CASE("expected properties as a gate") {
  const std::string example = std::string(SUBCERT_DOCS) + "/examples/properties.toml";
  const Run good = run("check " + example);
  CHECK(good.code == 0);
  CHECK(good.out.find("FAILS") == std::string::npos);
  CHECK(good.out.find("9 properties: 9 hold, 0 fail, 0 undecided.") != std::string::npos);
  CHECK(content(std::string(SUBCERT_DOCS) + "/properties.md").find(content(example)) != std::string::npos);

  const Folder folder;
  const std::string file = folder / "file.toml";
  const auto write = [&](const std::string& text) { std::ofstream(file, std::ios::binary) << text; };
  write("mask = 'dd:n=2'\nreproduces = 5\nstable = true\n");
  const Run bad = run("check " + file);
  CHECK(bad.code == 1);
  CHECK(bad.out.find(":2: dd:n=2: reproduces 5 (it is 3)") != std::string::npos);
  const auto json = run_json("check " + file, 1);
  CHECK(json.at("properties").at(0).at("holds") == "no");
  CHECK(json.at("properties").at(1).at("holds") == "yes");
  write("mask = 'dd:n=2'\nreproduces = three\n");
  const Run broken = run("check " + file);
  CHECK(broken.code == 65);
  CHECK(broken.out.empty());
  CHECK(broken.err.find(", line 2, column ") != std::string::npos);
  std::filesystem::remove(file);
  CHECK(run("check " + file).code == 66);
  CHECK(run("check").code == 64);
}

TEST_CASE("properties from standard input, and files in the place of schemes") {
  const Folder folder;
  const std::string file = folder.write("file.toml", "mask = 'dd:n=2'\nreproduces = 5\n");
  const Run piped = run("check - < " + file);
  CHECK(piped.code == 1);
  CHECK(piped.out.starts_with("FAILS      standard input:2: dd:n=2: reproduces 5 (it is 3)"));
  std::ofstream(file) << "mask = 'dd:n=2'\nreproduces = three\n";
  CHECK(run("check - < " + file).err.starts_with("subcert: standard input, line 2, column "));
  const std::string list = folder.write("masks.txt", "1 3 3 1\n");
  CHECK(run("mask " + list).err.find("it is a file: 'subcert sweep FILE' takes one") != std::string::npos);
  CHECK(run("mask " + file).err.find("it is a file: rules at vertices are for 'subcert vertex FILE'") !=
        std::string::npos);
  CHECK(run("mask " + folder.path.string()).err.find("; it is a folder") != std::string::npos);
  CHECK(run("mask nothing.txt").err.find("it is a file") == std::string::npos);
  CHECK(run("refine " + list + " chaikin")
            .err.ends_with("; it is a file, and the scheme stands before it: 'subcert refine "
                           "chaikin " +
                           list + "'\n"));
}

TEST_CASE("one question that cannot be answered leaves the others alone") {
  const Folder folder;
  const std::string file = folder.write(
      "file.toml",
      "[[scheme]]\nmask = 'dd:n=2'\nreproduces = 3\n"
      "[[scheme]]\nmask = 'mask:[1+w^12,1,1,1,1,-w^12],arity=5'\nfor = '0 < w < 1'\nconvergent = true\n"
      "[[scheme]]\nmask = 'dd:n=3'\nreproduces = 5\n");
  // Too many matrices: an error of the one question.
  const Run result = run("check " + file);
  CHECK(result.code == 2);
  CHECK(result.err.empty());
  CHECK(contains(result.out, "holds      " + file + ":3: dd:n=2: reproduces 3\nerror      " + file + ":7: "));
  CHECK(contains(result.out, "holds      " + file +
                                 ":10: dd:n=3: reproduces 5\n\n3 properties: 2 hold, 0 fail, 0 undecided, 1 error.\n"));
  const auto json = run_json("check " + file, 2).at("properties");
  CHECK(json.at(1).at("holds") == "error");
  CHECK(json.at(2).at("holds") == "yes");
  folder.write("file.toml",
               "[[scheme]]\nmask = 'mask:[w,1/2-w,1/2,1/2,1/2-w,w]'\nfor = '0.2 <= w <= 0.75'\nconvergent = true\n"
               "[[scheme]]\nmask = 'dd:n=2'\nreproduces = 4\n");
  const Run fails = run("check " + file);
  CHECK(fails.code == 1);
  CHECK(contains(fails.out, "FAILS      " + file + ":7: dd:n=2: reproduces 4 (it is 3)"));
  CHECK(run("check " + file + " --out " + (folder / "answer")).out.empty());
  CHECK(content(folder / "answer") == fails.out);
}

TEST_CASE("a scheme that cannot be read is its own error, and the others have their verdicts") {
  const Folder folder;
  const std::string file = folder.write("file.toml",
                                        "[[scheme]]\nmask = 'dd:n=2'\nreproduces = 3\n"
                                        "[[scheme]]\nname = 'mine'\nmask = 'primmal:n=2'\nholder = '>= 1'\n"
                                        "[[scheme]]\nmask = 'dd:n=2'\nholder = 1.9\n");
  const std::string report = folder / "report.xml", answer = folder / "answer.json";
  const Run found = run("check " + file + " --junit " + report);
  CHECK(found.code == 65);
  CHECK(found.err.empty());
  CHECK(contains(found.out, "holds      " + file + ":3: dd:n=2: reproduces 3\nerror      " + file +
                                ":6:8: the scheme (scheme specification, position 1: 'primmal'"));
  CHECK(contains(found.out, "did you mean 'primal'"));
  CHECK(contains(found.out,
                 ":10:10: the scheme ('holder' takes \">= X\", \"<= X\", \"> X\", \"< X\" or \"= X\"; 1.9 alone "
                 "does not say which: \">= 1.9\", \"<= 1.9\", or \"= 1.9\" for exactly that number)"));
  CHECK(contains(found.out, "\n\n3 properties: 1 hold, 0 fail, 0 undecided, 2 errors.\n"));
  CHECK(contains(content(report), "tests=\"3\" failures=\"0\" errors=\"2\">"));
  CHECK(run("check " + file + " --json --out " + answer).code == 65);
  const auto json = nlohmann::json::parse(content(answer)).at("properties");
  CHECK(json.at(1).at("holds") == "error");
  CHECK(json.at(1).at("line") == 6);
  // What fails is worse.
  folder.write("file.toml", "[[scheme]]\nmask = 'x:'\nholder = '>= 1'\n[[scheme]]\nmask = 'dd:n=2'\nreproduces = 4\n");
  CHECK(run("check " + file).code == 1);
}

TEST_CASE("comparisons by the signs of papers, and what was found in the place of one") {
  const Folder folder;
  const std::string file = folder.write(
      "file.toml",
      "[[scheme]]\nmask = 'dd:n=2'\nsmoothness = '\xe2\x89\xa5 1'\nholder = '\xe2\x89\xa4 2'\n"
      "[[scheme]]\nmask = 'dd:n=2'\nsmoothness = 'C1'\n");
  const Run found = run("check " + file);
  CHECK(found.code == 65);
  CHECK(contains(found.out, ":3: dd:n=2: smoothness >= 1\nholds"));
  CHECK(contains(found.out, ":4: dd:n=2: holder <= 2\n"));
  CHECK(contains(found.out, ":7:14: the scheme ('smoothness' takes \">= K\"; found 'C1')"));
}

TEST_CASE("a number that the exponent is to have exactly") {
  const Folder folder;
  const std::string file = folder.write("file.toml",
                                        "[[scheme]]\nmask = 'dd:n=2'\nholder = '= 2'\nsum_rules = '= 4'\n"
                                        "[[scheme]]\nmask = 'dd:n=2'\nholder = '= 1.99'\n"
                                        "[[scheme]]\nmask = 'primal:n=5'\nholder = '= 1.9901439593863'\n");
  const Run found = run("check " + file);
  CHECK(found.code == 1);
  CHECK(contains(found.out, "\n4 properties: 2 hold, 2 fail, 0 undecided.\n"));
  folder.write("file.toml", "mask = 'four-point:w'\nfor = '0.05 < w < 0.1'\nholder = '= 1'\n");
  CHECK(contains(run("check " + file).out, "'holder' over a range of a parameter takes \">= X\""));
}

TEST_CASE("properties of vectors of functions and Hermite schemes") {
  const Folder folder;
  const std::string file = folder.write(
      "file.toml",
      "[[scheme]]\nmask = 'merrien:lambda=-1/8,mu=1/2'\nconvergent = true\n"
      "interpolatory = true\nHC = '>= 1'\nreproduces = 2\nholder = '> 1.415'\nsmoothness = '>= 1'\n"
      "sobolev = '> 1.4'\n[[scheme]]\nmask = 'ghm'\nconvergent = true\n"
      "interpolatory = false\nholder = '>= 1'\n");
  CHECK(run("check " + file).out.find("\n10 properties: 10 hold, 0 fail, 0 undecided.\n") != std::string::npos);
  // one certificate for each scheme, of HC or convergence
  const std::string proofs = folder / "proofs";
  CHECK(contains(run("check " + file + " --certificate " + proofs).out, "certificates 2 in " + proofs));
  CHECK(run("verify " + proofs + "/00001-scheme.cert --claim '1 <= HC of merrien:lambda=-1/8,mu=1/2'").code == 0);
  CHECK(run("verify " + proofs + "/00002-scheme.cert --claim '0 <= scheme of ghm'").code == 0);
  // what it has none for is said; those of the run before are gone
  folder.write("file.toml",
               "[[scheme]]\nmask = 'cl:2'\nconvergent = true\n[[scheme]]\nmask = 'dd:n=2'\nconvergent = "
               "true\n[[scheme]]\nmask = 'merrien:lambda=-1/8,mu=1'\nHC = '>= 1'\n"
               "[[scheme]]\nmask = 'tensor:(ghm)x(ghm)'\nconvergent = true\n"
               "[[scheme]]\nmask = 'hermite:[[[1,0],[0,1]],[[2,0],[0,1]],[[1,0],[0,1]]]/2@-1'\nHC = '>= 1'\n");
  const auto json = run_json("check " + file + " --certificate " + proofs, 1);
  CHECK(json.at("certificates") == 3);
  CHECK(run("verify " + proofs + "/00001-scheme.cert --claim '0 <= scheme of cl:2'").code == 0);
  CHECK(run("verify " + proofs + "/00002-scheme.cert --claim 'HC of merrien:lambda=-1/8,mu=1 <= 1'").code == 0);
  CHECK(run("verify " + proofs + "/00003-scheme.cert --claim '0 <= scheme of tensor:(ghm)x(ghm)'").code == 0);
  CHECK_FALSE(std::filesystem::exists(proofs + "/00004-scheme.cert"));
  CHECK(contains(run("check " + file + " --certificate " + proofs).out,
                 "no certificate of hermite:[[[1,0],[0,1]],[[2,0],[0,1]],[[1...: need a Hermite scheme that keeps"));
  folder.write(
      "file.toml",
      "[[scheme]]\nmask = 'hermite-dd:points=4,order=2'\nHC = '>= 3'\nsmoothness = '>= 3'\nholder = '> 3'\n"
      "[[scheme]]\nmask = 'refinable:[[[1,0],[0,0]],[[0,0],[1,0]]]'\nsmoothness = '>= 0'\nconvergent = true\n");
  const Run fails = run("check " + file);
  CHECK(fails.code == 1);
  CHECK(contains(fails.out, "\n5 properties: 0 hold, 5 fail, 0 undecided.\n"));
  CHECK(contains(fails.out, ":3: hermite-dd:points=4,order=2: HC >= 3 (HC^2 is proved, HC^3 refuted)"));
  for (const auto& [text, message] : std::vector<std::pair<std::string, std::string>>{
           {"mask = 'ghm'\nvariance = '<= 1'\n", ":2:1: the scheme ('variance' is no property of vectors of functions"},
           {"mask = 'ghm'\nHC = '>= 1'\n", ":2:1: the scheme ('HC' is no property of vectors of functions"},
           {"mask = 'chaikin'\nHC = '>= 1'\n", ":2:1: the scheme ('HC' is no property of schemes of one variable"},
           {"mask = 'loop'\nsupport = [0, 1]\n", ":2:1: the scheme ('support' is no property of surfaces"}}) {
    folder.write("file.toml", text);
    const Run refused = run("check " + file);
    CHECK(refused.code == 65);
    CHECK(contains(refused.out, message));
  }
}

TEST_CASE("lines are there before the last question is answered") {
  const Folder folder;
  const std::string file = folder.write("file.toml",
                                        "[[scheme]]\nmask = 'dd:n=2'\nreproduces = 3\n"
                                        "[[scheme]]\nmask = 'primal:n=30,d=5'\nholder = '>= 7'\n");
  // As someone who interrupts it.
  const Run first = run("check " + file + " --budget 1000 --jobs 1 & sleep 3; kill -TERM $!");
  CHECK(first.out == "holds      " + file + ":3: dd:n=2: reproduces 3\n");
}

TEST_CASE("check: a crash costs its question alone") {
  const Folder folder;
  const std::string file = folder.write("file.toml",
                                        "[[scheme]]\nmask = 'dd:n=2'\nreproduces = 3\nsum_rules = 4\n"
                                        "[[scheme]]\nmask = 'dd:n=3'\nreproduces = 5\n"
                                        "[[scheme]]\nname = 'again'\nmask = 'dd:n=3'\nreproduces = 5\n");
  // it reads the question, crashes on one and notes the others
  const std::string notes = folder / "notes",
                    worker = write_script(folder, "worker",
                                          "[ $1 = --version ] && exit\nquestion=$(cat)\ncase \"$question\" in "
                                          "*sum_rules*) kill -SEGV $$ ;; esac\necho x >>" +
                                              notes + "\necho \"$question\" | " + SUBCERT_PROGRAM + " \"$@\"\n"),
                    report = folder / "report.xml", journal = folder / "journal";
  const Run found = run("check " + file + " --worker " + worker + " --junit " + report + " --journal " + journal);
  CHECK(found.code == 2);
  CHECK(found.out == "holds      " + file + ":3: dd:n=2: reproduces 3\nerror      " + file +
                         ":4: dd:n=2: sum_rules 4 (ended by signal 11)\nholds      " + file +
                         ":7: dd:n=3: reproduces 5\nholds      " + file +
                         ":11: again: reproduces 5\n\n4 properties: 3 hold, 0 fail, 0 undecided, 1 error.\n");
  CHECK(contains(content(report), "<error message=\"ended by signal 11\"/>"));
  CHECK(content(notes) == "x\nx\n");  // the same question is asked once
  // what is in the journal is not asked again; two shards are the whole
  CHECK(run("check " + file + " --worker /bin/false --journal " + journal).out == found.out);
  CHECK(content(notes) == "x\nx\n");
  CHECK(contains(run("check " + file + " --shard 1/2").out, "\n\n3 properties: 3 hold, "));
  CHECK(contains(run("check " + file + " --shard 2/2").out, "\n\n1 property: 1 hold, "));
  CHECK(run("check " + file + " --worker " + (folder / "none")).code == 66);
  // without processes the same
  const Run processes = run("check " + file), alone = run("check " + file + " --in-process");
  CHECK(processes.code == 0);
  CHECK(alone.code == 0);
  CHECK(alone.out == processes.out);
}

TEST_CASE("check: questions reach the processes whatever they are about") {
  const Folder folder;
  const std::string file = folder.write(
      "file.toml",
      "[[scheme]]\nname = 'Δ \"1\"'\nmask = \"\"\"\nmask:[1, 3,\n3, 1]/4\"\"\"\nsupport = [-2, '1']\nconvergent = "
      "true\n"
      "symmetry = \"even\"\n[[scheme]]\nmask = 'four-point:w'\nlevels = '0.001 <= w <= 0.19'\nsmoothness = '>= 1'\n"
      "[[scheme]]\nmasks = ['dd:n=2', 'bspline:degree=3']\nperiod = [0, 1]\nholder = '>= 1'\n"
      "[[scheme]]\nmasks = ['dd:n=2', 'bspline:degree=3']\nfollows = [[0, 1], [1, 0]]\nholder = '>= 1'\n"
      "[[scheme]]\nmask = 'conic-four-point:v'\nlevels = '9/20 <= v <= 1000'\nrecurrence = 'v=sqrt((1+v)/2)'\n"
      "start = '1/4 <= v0 <= 1000'\nholder = '>= 2'\n[[scheme]]\nmask = 'four-point:w'\nfor = '0.001 <= w < "
      "0.1927'\nsmoothness = '>= 1'\n[[scheme]]\nmask = 'four-point:w'\npoints = '0.001 <= w <= 0.15'\n"
      "smoothness = '>= 1'\n");
  const Run found = run("check " + file);
  CHECK(found.code == 0);
  CHECK(contains(found.out, ":6: Δ \"1\": support [-2, 1]\n"));
  CHECK(contains(found.out, "\n\n9 properties: 9 hold, 0 fail, 0 undecided.\n"));
  CHECK(run("check " + file + " --in-process").out == found.out);
}

TEST_CASE("answers as a report of JUnit") {
  const Folder folder;
  const std::string file = folder.write("file.toml",
                                        "[[scheme]]\nname = 'a <b> & \"c\"'\nmask = 'dd:n=2'\nreproduces = 3\n"
                                        "[[scheme]]\nmask = 'dd:n=2'\nreproduces = 5\n"
                                        "[[scheme]]\nmask = 'primal:n=20,d=5'\nholder = '>= 4'\n");
  const std::string report = folder / "report.xml";
  CHECK(run("check " + file + " --budget 0.001 --junit " + report).code == 1);
  const std::string text = content(report);
  CAPTURE(text);
  CHECK(contains(text, "tests=\"3\" failures=\"1\" errors=\"1\">"));
  CHECK(contains(text, "name=\"a &lt;b&gt; &amp; &quot;c&quot;: reproduces 3\" file=\"" + file + "\" line=\"4\"/>\n"));
  CHECK(contains(text, "line=\"7\"><failure message=\"it is 3\"/></testcase>\n"));
  CHECK(contains(text, "line=\"10\"><error message=\"undecided: "));
}

TEST_CASE("what does not hold as a report in SARIF") {
  const Folder folder;
  const std::string file = folder.write("a b.toml",
                                        "[[scheme]]\nmask = 'dd:n=2'\nreproduces = 3\n"
                                        "[[scheme]]\nmask = 'dd:n=2'\nreproduces = 5\n"
                                        "[[scheme]]\nmask = 'primal:n=20,d=5'\nholder = '>= 4'\n"
                                        "[[scheme]]\nmask = 'primmal:n=2'\nholder = '>= 1'\n");
  const std::string report = folder / "report.sarif";
  CHECK(run("check '" + file + "' --budget 0.001 --sarif " + report).code == 1);
  const auto json = nlohmann::json::parse(content(report));
  CHECK(json.at("version") == "2.1.0");
  const auto& one = json.at("runs").at(0);
  CHECK(one.at("tool").at("driver").at("name") == "subcert");
  std::set<std::string> rules;
  for (const auto& rule : one.at("tool").at("driver").at("rules")) CHECK(rules.insert(rule.at("id")).second);
  const auto& results = one.at("results");
  REQUIRE(results.size() == 3);
  const std::vector<std::array<std::string, 3>> wanted{
      {"reproduces", "fail", "error"}, {"holder", "open", "none"}, {"scheme", "fail", "error"}};
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    CAPTURE(results[i].dump());
    CHECK(results[i].at("ruleId") == wanted[i][0]);
    CHECK(rules.contains(wanted[i][0]));
    CHECK(results[i].at("kind") == wanted[i][1]);
    CHECK(results[i].at("level") == wanted[i][2]);
    const auto& place = results[i].at("locations").at(0).at("physicalLocation");
    CHECK(place.at("artifactLocation").at("uri").get<std::string>().ends_with("/a%20b.toml"));
    CHECK(place.at("region").at("startLine") == std::vector{6, 9, 11}[i]);
  }
  CHECK(results[0].at("message").at("text") == "dd:n=2: reproduces 5: it is 3");
}

TEST_CASE("check: masks that change from level to level, with a report") {
  const Folder folder;
  const std::string report = folder / "report.xml",
                    file = folder.write(
                        "levels.toml",
                        "[[scheme]]\nname = 'slider'\nmask = 'four-point:w'\nlevels = '0.001 <= w <= 0.19'\n"
                        "smoothness = '>= 1'\n[[scheme]]\nmasks = ['dd:n=2', 'bspline:degree=3']\n"
                        "holder = '>= 5/2'\n");
  const Run found = run("check " + file + " --junit " + report);
  CHECK(found.code == 1);
  CHECK(contains(found.out, "holds      " + file + ":5: slider: smoothness >= 1\n"));
  CHECK(contains(found.out, "FAILS      " + file + ":8: dd:n=2, bspline:degree=3 in any order: holder >= 5/2"));
  CHECK(content(report).find("failures=\"1\" errors=\"0\"") != std::string::npos);
}
