#include "refused.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/proofs-checks/sweeps/question.hpp>
#include <subcert/schemes/data/runtime/process.hpp>

using namespace subcert;
using namespace subcert::sweeps;
using Texts = std::vector<std::string>;

TEST_CASE("questions: several, with settings and properties") {
  CHECK(SchemeQuestion::split("regularity, variance") == Texts{"regularity", "variance"});
  CHECK(SchemeQuestion::split("vertex  --valence 3,5..7,check holder >= 3/2 ,limit --level 2 --range") ==
        Texts{"vertex --valence 3,5..7", "check holder >= 3/2", "limit --level 2 --range"});
  CHECK(SchemeQuestion::split("check support [-2, 1],mask") == Texts{"check support [-2, 1]", "mask"});
  CHECK(SchemeQuestion::parse("check stable").members() == Texts{"check.stable", "found.stable"});
  CHECK(SchemeQuestion::parse("variance").members().empty());
  CHECK(SchemeQuestion::parse("regularity --levels 20").has_certificate());
  CHECK_FALSE(SchemeQuestion::parse("check stable").has_certificate());
  for (const std::string& command : SchemeQuestion::commands())
    if (command != "check") CHECK(SchemeQuestion::parse(command).text() == command);
}

TEST_CASE("questions: what is refused, with its place") {
  testing::check_refused({{"", 1},
                          {"jsr", 1},
                          {"regularity variance", 12},
                          {"regularity --certificate x", 12},
                          {"limit --level", 14},
                          {"check", 6},
                          {"check holder1 > 1", 7}},
                         [](const std::string& text) { SchemeQuestion::parse(text); });
  CHECK_THROWS_AS(SchemeQuestion::split("mask,,variance"), ParseError);
}

TEST_CASE("processes: input, both outputs, ends and limits") {
  using runtime::run_process;
  const std::string large(3'000'000, 'x');
  CHECK(run_process("cat", {}, {large}).output == large);
  CHECK(run_process("cat", {}).output.empty());
  CHECK(run_process("true", {}, {large}).code == 0);  // nobody reads it
  const auto end = run_process("sh", {"-c", "echo out; echo err >&2; exit 3"});
  CHECK(end.code == 3);
  CHECK(end.output == "out\n");
  CHECK(end.errors == "err\n");
  CHECK(run_process("sh", {"-c", "kill -SEGV $$"}).signal == 11);
  CHECK(run_process("sh", {"-c", "while :; do :; done"}, {"", 0.2}).signal == 9);
  CHECK_THROWS_AS(run_process("/no/such/program", {}), Error);
  CHECK_THROWS_AS(run_process("/", {}), Error);
}

TEST_CASE("replies: an object, a crash, a message") {
  const auto reply = [](const std::string& script) { return reply_to({"-c", script}, {}, "sh"); };
  CHECK(reply("echo '{\"a\": 1}'; exit 2").answer.at("a") == 1);
  CHECK(reply("kill -ABRT $$").error == "ended by signal 6");
  CHECK(reply("echo first >&2; echo 'subcert: second' >&2").error == "second");
  CHECK(reply("echo '[1]'; exit 7").error == "exit code 7 without an answer");
  CHECK(reply("echo '{\"a\":'").answer.is_null());
}

TEST_CASE("a search leaves time for proofs within a tenth more than the budget of its question") {
  CHECK(searching_seconds(10) == 9.5);
  CHECK(searching_seconds(0.25) == 0.125);
  double before = 0;
  for (const double budget : {0.001, 0.5, 0.9, 1.0, 1.5, 3.0, 7.0, 9.9, 20.0, 1e6}) {
    const double searching = searching_seconds(budget);
    CHECK(searching > before);
    CHECK(searching >= budget / 2);
    if (budget >= 1) CHECK(1.1 * searching + 0.5 <= 1.1 * budget);
    before = searching;
  }
}
