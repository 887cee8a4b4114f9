// One fact, one exit code, whichever command finds it: docs/errors-and-exit-codes.md.

#include "program.hpp"

#include <vector>

using namespace subcert::testing;

namespace {

/// The ways to ask something of a scheme of one variable, with SCHEME and DATA in place of these.
struct Question {
  const char* arguments;
  bool of_the_limit;  ///< so that there is no answer without one
};

const std::vector<Question>& questions() {
  static const std::vector<Question> all{{"mask SCHEME", false},
                                         {"analyze SCHEME", true},
                                         {"analyze SCHEME --latex", true},
                                         {"analyze SCHEME --plot PICTURE", true},
                                         {"regularity SCHEME", true},
                                         {"limit SCHEME --level 1", true},
                                         {"limit SCHEME --range", true},
                                         {"variance SCHEME", true},
                                         {"smooth DATA --scheme SCHEME", true},
                                         {"smooth DATA --scheme SCHEME --stream", true},
                                         {"refine SCHEME DATA", false},
                                         {"refine SCHEME DATA --limit", true},
                                         {"compare SCHEME chaikin", true},
                                         {"compare chaikin SCHEME --markdown", true},
                                         {"gallery chaikin SCHEME --json", true}};
  return all;
}

/// Data, and a place for pictures.
struct Place {
  Folder folder;
  std::string data = folder.write("data.csv", "x,y\n0,3\n1,4\n2,1\n3,5\n4,9\n5,2\n6,6\n7,5\n8,3\n9,5\n10,8\n11,9\n");

  Run ask(std::string arguments, const std::string& scheme) const {
    for (const auto& [word, value] : {std::pair<std::string, std::string>{"SCHEME", "'" + scheme + "'"},
                                      {"DATA", data},
                                      {"PICTURE", folder / "picture.svg"}})
      if (const auto at = arguments.find(word); at != std::string::npos) arguments.replace(at, word.size(), value);
    return run(arguments + " --quiet");
  }
};

/// An answer without a message, or a message of one line without an answer.
void check_one_of_two(const Run& run) {
  if (run.out.empty())
    CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
  else if (run.code == 0)
    CHECK(run.err.empty());
}

}  // namespace

TEST_CASE("exit codes: a scheme that converges, and one that does not") {
  const Place place;
  struct Case {
    const char* scheme;
    int of_the_limit;
  };
  // By positive coefficients, by norms, with unstable shifts; by a product that does not shrink, in each of its ways.
  for (const Case& one : {Case{"chaikin", 0},
                          {"dd:n=2", 0},
                          {"mask:[1,1,1,1]/2", 0},
                          {"mask:[1,1]", 1},
                          {"mask:[1,0,0,1]", 1},
                          {"mask:[2,1,1,0,-1,1]/2@-2", 1},
                          {"mask:[-3,1,8,8,1,-3]/6", 1}})
    for (const Question& question : questions()) {
      CAPTURE(one.scheme, question.arguments);
      const Run found = place.ask(question.arguments, one.scheme);
      CHECK(found.code == (question.of_the_limit ? one.of_the_limit : 0));
      check_one_of_two(found);
    }
}

TEST_CASE("exit codes: convergence that the exponent proves, and 16 levels of norms do not") {
  const Place place;
  for (const Question& question : questions()) {
    const std::string arguments = question.arguments;
    if (contains(arguments, "--range") || contains(arguments, "variance")) continue;  // enclosures need norms
    CAPTURE(arguments);
    CHECK(place.ask(arguments, "four-point:w=49/100").code == 0);
  }
}

TEST_CASE("exit codes: what is no scheme, or none of the kind that is asked for") {
  const Place place;
  for (const char* scheme : {"nosuch:n=3", "mask:[0]", "mask:[]", "mask:[nan,1]", "mask:[1,1,1]/2", "primal:n=2,d=-1",
                             "primal:n=0", "four-point:w", "mask:[1,1/0]", "dd:n=2,n=3", "primal:m=3"})
    for (const Question& question : questions()) {
      CAPTURE(scheme, question.arguments);
      if (std::string(scheme) == "four-point:w" && contains(question.arguments, "analyze")) continue;  // families, too
      const Run found = place.ask(question.arguments, scheme);
      CHECK(found.code == 64);
      CHECK(found.out.empty());
      check_one_of_two(found);
    }
}

TEST_CASE("exit codes: derivatives") {
  const Place place;
  struct Case {
    const char* scheme;
    int order, code;
  };
  const std::vector<Case> cases{
      {"chaikin", 1, 0},               // C^1
      {"chaikin", 2, 1},               // the exponent is 2, and the shifts are stable
      {"dd:n=2", 2, 1},                //
      {"dd:n=2", 9, 1},                // more than the sum rules
      {"dd:n=3", 2, 0},                //
      {"mask:[1,1,1,1]/2", 1, 1},      // by the mask without its factor, a hat
      {"mask:[1,1,2,2,1,1]/4", 1, 3},  // C^1, but divided differences do not converge to the derivative
      {"mask:[1,1,2,2,1,1]/4", 2, 1},  //
      {"mask:[1,1]", 1, 1},            // no limits at all
      {"primal:n=20,d=5", 6, 1}};      // at once, by the sum rules
  for (const Case& one : cases)
    for (const char* question : {"limit SCHEME --level 1", "smooth DATA --scheme SCHEME"}) {
      if (std::string(one.scheme) == "primal:n=20,d=5" && std::string(question).starts_with("smooth")) continue;
      CAPTURE(one.scheme, one.order, question);
      const Run found = place.ask(std::string(question) + " --derivative " + std::to_string(one.order), one.scheme);
      CHECK(found.code == one.code);
      CHECK(found.out.empty() == (one.code != 0));
      check_one_of_two(found);
    }
  CHECK(place.ask("limit SCHEME --derivative 2,0", "loop").code == 0);
  CHECK(place.ask("limit SCHEME --derivative 3,0", "loop").code == 3);  // the exponent is 3
  CHECK(place.ask("limit SCHEME --derivative 1,1", "tensor:(chaikin)x(dd:n=2)").code == 0);
  CHECK(place.ask("limit SCHEME --derivative 1,2", "tensor:(chaikin)x(dd:n=2)").code == 1);
  CHECK(place.ask("limit SCHEME --derivative 0,0", "tensor:(chaikin)x(mask:[1,1])").code == 1);
}

TEST_CASE("exit codes: surfaces and rules for data") {
  const Place place;
  for (const char* question : {"analyze SCHEME", "regularity SCHEME", "limit SCHEME", "limit SCHEME --range",
                               "compare chaikin SCHEME", "gallery SCHEME --json"}) {
    CAPTURE(question);
    CHECK(place.ask(question, "box:[1,0;0,1;1,1]").code == 0);
    CHECK(place.ask(question, "mask2:[[1,1],[1,1]]").code == 1);
    CHECK(place.ask(question, "tensor:(mask:[1,1])x(chaikin)").code == 1);
  }
  for (const char* question : {"analyze SCHEME", "l1 SCHEME"}) {
    CAPTURE(question);
    CHECK(place.ask(question, "l1:points=6,d=1").code == 0);
    CHECK(place.ask(question, "l1:points=4,d=0").code == 1);
  }
}

TEST_CASE("exit codes: files") {
  const Place place;
  const std::string binary = place.folder.write("binary", std::string("\0\1\2", 3));
  for (const char* command : {"smooth FILE", "refine chaikin FILE", "jsr FILE", "verify FILE", "check FILE"}) {
    CAPTURE(command);
    const auto ask = [&](const std::string& file) {
      std::string arguments = command;
      return run(arguments.replace(arguments.find("FILE"), 4, file) + " --quiet").code;
    };
    CHECK(ask(place.folder / "missing") == 66);
    CHECK(ask(binary) == 65);
    CHECK(ask(place.folder / ".") == 66);  // a folder, without a certificate
  }
}
