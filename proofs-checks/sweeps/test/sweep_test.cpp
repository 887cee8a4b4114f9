#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/folder.hpp>
#include <subcert/proofs-checks/sweeps/sweep.hpp>

#include <fmt/format.h>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

using namespace subcert;
using namespace subcert::sweeps;
using subcert::testing::content;
using subcert::testing::Folder;
namespace fs = std::filesystem;

namespace {

std::vector<SweepCase> make_cases(int count) {
  std::vector<SweepCase> cases;
  for (int i = 0; i < count; ++i) cases.push_back({"case " + std::to_string(i), static_cast<double>(i % 5)});
  return cases;
}

Json square(std::size_t i) {
  return {{"index", i}, {"square", std::to_string(i * i)}, {"half", 0.5 * static_cast<double>(i)}};
}

std::string text_of(const SweepResults& results) {
  std::string text;
  for (const auto& value : results.values) text += value ? value->dump() + "\n" : "-\n";
  return text;
}

std::string whole_text(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += square(static_cast<std::size_t>(i)).dump() + "\n";
  return text;
}

/// Starts a program with its standard output in a file.
pid_t start(const std::vector<std::string>& words, const fs::path& out) {
  const pid_t child = fork();
  if (child != 0) return child;
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  if (!std::freopen(out.c_str(), "w", stdout) || !std::freopen((out.string() + ".err").c_str(), "w", stderr)) _exit(99);
  execv(arguments[0], arguments.data());
  _exit(99);
}

int end_of(pid_t child) {
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  return status;
}

/// Waits until `ready` holds, half a minute at most.
bool wait_until(const std::function<bool()>& ready) {
  for (int i = 0; i < 3000; ++i) {
    if (ready()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

std::size_t finished(const fs::path& journal) { return fs::exists(journal) ? read_journal(journal).entries.size() : 0; }

}  // namespace

TEST_CASE("results come in the order of the cases, for any number of threads") {
  for (int jobs : {0, 1, 2, 7}) {
    SweepOptions options;
    options.jobs = jobs;
    const auto results = run_sweep(make_cases(40), square, options);
    REQUIRE(results);
    CHECK(text_of(*results) == whole_text(40));
    CHECK(results->computed == 40);
  }
  CHECK(run_sweep({}, square, {})->values.empty());
  CHECK_THROWS_AS(run_sweep({{"a"}, {"a"}}, square, {}), std::logic_error);
}

TEST_CASE("expensive cases are begun first") {
  std::vector<std::size_t> order;
  SweepOptions options;
  options.jobs = 1;
  run_sweep(
      {{"a", 1}, {"b", 3}, {"c", 2}, {"d", 3}},
      [&](std::size_t i) {
        order.push_back(i);
        return Json(i);
      },
      options);
  CHECK(order == std::vector<std::size_t>{1, 3, 2, 0});
}

TEST_CASE("finished cases are not computed again") {
  const Folder folder;
  SweepOptions options;
  options.journal = folder.path / "deep" / "journal";
  options.version = "1";
  std::atomic<int> calls = 0;
  const auto compute = [&](std::size_t i) {
    ++calls;
    return square(i);
  };
  CHECK(text_of(*run_sweep(make_cases(10), compute, options)) == whole_text(10));
  CHECK(calls == 10);
  // The sweep may grow; a new version begins anew; without the journal everything is computed.
  const auto grown = run_sweep(make_cases(14), compute, options);
  CHECK(text_of(*grown) == whole_text(14));
  CHECK(grown->from_journal == 10);
  CHECK(calls == 14);
  options.version = "2";
  CHECK(run_sweep(make_cases(14), compute, options)->computed == 14);
  CHECK(calls == 28);
}

TEST_CASE("a damaged line is computed again, with a warning") {
  const Folder folder;
  SweepOptions options;
  options.journal = folder.path / "journal";
  options.jobs = 1;
  run_sweep(make_cases(5), square, options);
  std::string text = content(options.journal);
  text[text.find("square")] = 'S';
  std::ofstream(options.journal, std::ios::binary) << text;
  std::vector<std::string> warnings;
  options.warn = [&](const std::string& line) { warnings.push_back(line); };
  const auto results = run_sweep(make_cases(5), square, options);
  CHECK(text_of(*results) == whole_text(5));
  CHECK(results->computed == 1);
  CHECK(warnings == std::vector<std::string>{options.journal.string() +
                                             " line 2 is damaged; its case is computed again where it is needed"});
}

TEST_CASE("a failing case does not stop the others") {
  const Folder folder;
  SweepOptions options;
  options.journal = folder.path / "journal";
  options.jobs = 1;
  const auto failing = [](std::size_t i) -> Json {
    if (i == 3 || i == 4) throw std::runtime_error("no");
    return square(i);
  };
  try {
    run_sweep({{"case 0"}, {"case 1"}, {"case 2"}, {"case 3"}, {"case 4"}, {"case 5"}}, failing, options);
    FAIL("no exception");
  } catch (const std::runtime_error& error) {
    CHECK(std::string(error.what()) == "case 'case 3': no (and 1 more cases failed)");
  }
  CHECK(finished(options.journal) == 4);
  CHECK(run_sweep(make_cases(6), square, options)->computed == 2);
}

TEST_CASE("progress tells how far the sweep is") {
  const Folder folder;
  SweepOptions options;
  options.journal = folder.path / "journal";
  options.jobs = 1;
  run_sweep(make_cases(1), square, options);
  std::vector<std::string> lines;
  options.progress = [&](const std::string& line) { lines.push_back(line); };
  run_sweep(make_cases(3), square, options);
  CHECK(lines == std::vector<std::string>{"1 of 3 cases, 1 of them from the journal",
                                          "2 of 3 cases, 1 of them from the journal",
                                          "3 of 3 cases, 1 of them from the journal"});
}

TEST_CASE("cases are told in their order and are not held, whatever failed, was known or belongs to another shard") {
  const Folder folder;
  constexpr int count = 40;
  for (const int jobs : {1, 3})
    for (const std::size_t shards : {1u, 3u}) {
      SweepOptions options;
      options.journal = folder.path / fmt::format("{}-{}", jobs, shards);
      options.shard = {1, shards};
      options.jobs = jobs;
      std::vector<std::size_t> told;
      options.in_order = [&](std::size_t i, const Json& value) {
        CHECK(value == square(i));
        told.push_back(i);
      };
      const auto failing = [](std::size_t i) {
        if (i == 0 || i == 9 || i == 39) throw std::runtime_error("no");
        return square(i);
      };
      CHECK_THROWS(run_sweep(make_cases(count), failing, options));
      std::vector<std::size_t> wanted;
      for (std::size_t i = 0; i < count; i += shards)
        if (i != 0 && i != 9 && i != 39) wanted.push_back(i);
      CHECK(told == wanted);
      told.clear();
      const auto results = run_sweep(make_cases(count), square, options);
      wanted.clear();
      for (std::size_t i = 0; i < count; i += shards) wanted.push_back(i);
      CHECK(told == wanted);
      CHECK(std::ranges::none_of(results->values, [](const auto& value) { return value.has_value(); }));
    }
}

TEST_CASE("only the cases of the shard that are wanted are computed") {
  const Folder folder;
  for (const char* journal : {"", "journal"}) {
    SweepOptions options;
    options.shard = {1, 2};
    if (*journal) options.journal = folder / journal;
    options.is_wanted = [](std::size_t i) { return i % 3 == 0; };
    std::vector<std::size_t> told;
    options.in_order = [&](std::size_t i, const Json&) { told.push_back(i); };
    for (int again = 0; again < 2; ++again) {
      told.clear();
      const auto results = run_sweep(make_cases(20), square, options);
      CHECK(told == std::vector<std::size_t>{0, 6, 12, 18});
      CHECK(results->computed == (again && *journal ? 0 : 4));
    }
    options.is_wanted = [](std::size_t i) { return i == 2 || i == 6; };  // one is in the journal
    told.clear();
    CHECK(run_sweep(make_cases(20), square, options)->from_journal == (*journal ? 1 : 0));
    CHECK(told == std::vector<std::size_t>{2, 6});
  }
}

TEST_CASE("shards are disjoint, and joined they are the whole") {
  const Folder folder;
  const int count = 23;
  for (std::size_t shards : {1u, 2u, 3u, 30u}) {
    std::vector<fs::path> journals;
    std::size_t computed = 0;
    for (std::size_t i = 1; i <= shards; ++i) {
      SweepOptions options;
      options.journal = folder.path / (std::to_string(i) + "-of-" + std::to_string(shards));
      options.shard = {i, shards};
      const auto results = run_sweep(make_cases(count), square, options);
      for (std::size_t k = 0; k < results->values.size(); ++k)
        CHECK(results->values[k].has_value() == ((k + 1) % shards == i % shards));
      computed += results->computed;
      journals.push_back(options.journal);
    }
    CHECK(computed == count);
    SweepOptions options;
    options.journal = folder.path / ("joined-" + std::to_string(shards));
    CHECK(merge_journals(journals, options.journal).cases == count);
    const auto results = run_sweep(make_cases(count), square, options);
    CHECK(results->computed == 0);
    CHECK(text_of(*results) == whole_text(count));
  }
}

TEST_CASE("shards are counted from 1") {
  CHECK(parse_shard("1/1").is_whole());
  CHECK(parse_shard("8/8").number == 8);
  CHECK(parse_shard("3/1000000").count == 1000000);
  for (const char* text : {"", "/", "1", "1/", "/1", "0/8", "9/8", "-1/8", "1/0", "0/0", "1/8/8", " 1/8", "1/8 ",
                           "+1/8", "a/b", "1.5/8", "1/1000001", "99999999999999999999/99999999999999999999"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(parse_shard(text), ParseError);
  }
  try {
    static_cast<void>(parse_shard("0/8"));
  } catch (const ParseError& error) {
    CHECK(std::string(error.what()).find("counted from 1") != std::string::npos);
  }
}

TEST_CASE("kill -9 in the middle loses at most the running cases") {
  const Folder folder;
  const fs::path journal = folder.path / "journal", out = folder.path / "out";
  const std::vector<std::string> command{TOY_SWEEP, "60", "20", journal.string(), "1/1", "2"};
  std::size_t before = 0;
  for (int round = 0; round < 3; ++round) {
    const pid_t child = start(command, out);
    REQUIRE(wait_until([&] { return finished(journal) >= before + 5; }));
    REQUIRE(kill(child, round == 2 ? SIGINT : SIGKILL) == 0);
    CHECK(WIFSIGNALED(end_of(child)));
    const std::size_t now = finished(journal);
    CHECK(now >= before + 5);
    CHECK(now < 60);
    CHECK(read_journal(journal).damaged.empty());
    before = now;
  }
  CHECK(end_of(start(command, out)) == 0);
  CHECK(content(out.string() + ".err") ==
        "computed " + std::to_string(60 - before) + ", from the journal " + std::to_string(before) + "\n");
  const fs::path straight = folder.path / "straight";
  CHECK(end_of(start({TOY_SWEEP, "60", "0", (folder.path / "other").string(), "1/1", "1"}, straight)) == 0);
  CHECK(content(out) == content(straight));
  CHECK(content(out).size() > 60 * 20);
}

TEST_CASE("two processes do not share a journal") {
  const Folder folder;
  const fs::path journal = folder.path / "journal", out = folder.path / "out";
  const pid_t holder = start({TOY_SWEEP, "-1", "100", journal.string()}, folder.path / "holder");
  REQUIRE(wait_until([&] { return content(folder.path / "holder") == "held\n"; }));
  const pid_t second = start({TOY_SWEEP, "5", "0", journal.string()}, out);
  CHECK(WEXITSTATUS(end_of(second)) == 1);
  CHECK(content(out.string() + ".err").find("another process is using this journal") != std::string::npos);
  CHECK(content(out).empty());
  REQUIRE(kill(holder, SIGKILL) == 0);
  end_of(holder);
  CHECK(end_of(start({TOY_SWEEP, "5", "0", journal.string()}, out)) == 0);  // a killed holder holds no lock
}
