#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/cmake/folder.hpp>
#include <subcert/proofs-checks/sweeps/journal.hpp>

#include <sys/resource.h>
#include <unistd.h>

#include <boost/crc.hpp>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <functional>

using namespace subcert;
using namespace subcert::sweeps;
using subcert::testing::content;
using subcert::testing::Folder;
namespace fs = std::filesystem;

namespace {

void overwrite(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

JournalEntry entry(int n) { return {"1.0", "case " + std::to_string(n), Json{{"n", n}, {"x", "1/3"}}}; }

/// A journal with the cases 0, ..., count - 1 on the lines 2, ..., count + 1.
fs::path make_journal(const fs::path& path, int first, int count) {
  Journal journal(path);
  for (int n = first; n < first + count; ++n) journal.append(entry(n));
  return path;
}

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("the format is the documented one") {
  const Folder folder;
  const fs::path path = folder.path / "journal";
  {
    Journal journal(path);
    journal.append({"1.0", "case \xc3\xa9", Json{{"sup", "1/3"}, {"text", "a\nb \xe2\x82\xac"}}});
  }
  // Made with Python: zlib.crc32 and uuid.uuid5(uuid.uuid5(uuid.NAMESPACE_URL, "subcert journal 1\n"), "1.0\ncase é").
  CHECK(content(path) ==
        "subcert journal 1\n"
        "5c7f4745 3a6a47d5-a688-5a4e-a975-5be87ffe4ec9 "
        R"({"version":"1.0","case":"case \u00e9","result":{"sup":"1/3","text":"a\nb \u20ac"}})"
        "\n");
  const JournalContent read = read_journal(path);
  REQUIRE(read.entries.size() == 1);
  CHECK(read.entries[0].specification == "case \xc3\xa9");
  CHECK(read.entries[0].result.at("text") == "a\nb \xe2\x82\xac");
  CHECK(read.entries[0].line == 2);
}

TEST_CASE("every part of the specification is in the name of a case") {
  CHECK(case_id("1", "a") != case_id("1", "b"));
  CHECK(case_id("1", "a") != case_id("2", "a"));
  CHECK(case_id("1", "2 a") != case_id("1 2", "a"));
}

TEST_CASE("a torn last line is forgotten, wherever it was torn") {
  const Folder folder;
  const std::string text = content(make_journal(folder.path / "whole", 0, 3));
  const fs::path torn = folder.path / "torn";
  for (std::size_t size = 0; size <= text.size(); ++size) {
    CAPTURE(size);
    overwrite(torn, text.substr(0, size));
    const std::size_t lines = static_cast<std::size_t>(
        std::count(text.begin(), text.begin() + static_cast<long>(size), '\n'));
    const std::size_t kept = lines > 0 ? lines - 1 : 0;
    {
      Journal journal(torn);
      CHECK(journal.content().entries.size() == kept);
      CHECK(journal.content().damaged.empty());
      for (int n = static_cast<int>(kept); n < 3; ++n) journal.append(entry(n));
    }
    CHECK(content(torn) == text);
  }
}

TEST_CASE("a flipped bit anywhere is noticed") {
  const Folder folder;
  const std::string text = content(make_journal(folder.path / "whole", 0, 3));
  const fs::path flipped = folder.path / "flipped";
  const std::size_t begin = text.find('\n') + 1;
  for (std::size_t i = begin; i < text.size(); ++i) {
    CAPTURE(i);
    std::string changed = text;
    changed[i] = static_cast<char>(changed[i] ^ 1);
    overwrite(flipped, changed);
    const JournalContent read = read_journal(flipped);
    // A flip within a line costs that line, one of a line feed two lines.
    CHECK(read.entries.size() >= 1);
    CHECK(read.entries.size() <= 2);
    for (const JournalEntry& e : read.entries) CHECK(e.result == entry(e.result.at("n").get<int>()).result);
  }
}

TEST_CASE("a damaged line in the middle is named, skipped and left where it is") {
  const Folder folder;
  const fs::path path = make_journal(folder.path / "journal", 0, 4);
  std::string text = content(path);
  text[text.find("case 1")] = 'C';
  overwrite(path, text);
  {
    Journal journal(path);
    CHECK(journal.content().damaged == std::vector<std::size_t>{3});
    CHECK(journal.content().entries.size() == 3);
    CHECK(damage_reports(path, journal.content(), "so what")[0] == path.string() + " line 3 is damaged; so what");
    journal.append(entry(1));
  }
  CHECK(content(path).substr(0, text.size()) == text);
  CHECK(read_journal(path).entries.size() == 4);

  // The last line with its line feed, but damaged, is overwritten; the one before it is named.
  text[text.find("case 2")] = text[text.find("case 3")] = 'C';
  overwrite(path, text);
  {
    Journal journal(path);
    CHECK(journal.content().damaged == std::vector<std::size_t>{3, 4});
    CHECK(journal.content().entries.size() == 1);
    journal.append(entry(3));
  }
  const JournalContent read = read_journal(path);
  CHECK(read.damaged == std::vector<std::size_t>{3, 4});
  CHECK(read.entries.back().line == 5);
}

TEST_CASE("a file that is no journal stays as it is") {
  const Folder folder;
  const fs::path path = folder.path / "thesis.txt";
  for (const char* text : {"x", "subcert journal 2\n", "subcert journal 1", "four\nyears\nof\nwork"}) {
    CAPTURE(text);
    overwrite(path, text);
    if (std::string(text) == "subcert journal 1") {
      CHECK_NOTHROW(Journal(path));
      continue;
    }
    CHECK(message_of([&] { Journal journal(path); }) == path.string() + ": not a journal of subcert");
    CHECK(message_of([&] { merge_journals({path}, folder.path / "out"); }) ==
          path.string() + ": not a journal of subcert");
    make_journal(folder.path / "good", 0, 1);
    CHECK_FAILS(merge_journals({folder.path / "good"}, path), data);
    CHECK(content(path) == text);
    CHECK_FALSE(fs::exists(folder.path / "out"));
  }
  CHECK_FAILS(Journal(folder.path), missing_file);
  CHECK_FAILS(Journal("/proc/no/such/place"), missing_file);
  CHECK_FAILS(read_journal(folder.path / "nowhere"), data);
  CHECK_FAILS(read_journal(folder.path), data);
  CHECK_FAILS(Journal("/dev/null"), data);
}

TEST_CASE("one journal, one writer") {
  const Folder folder;
  const fs::path path = make_journal(folder.path / "journal", 0, 2);
  {
    const Journal held(path);
    CHECK_FAILS(Journal(path), usage);
    CHECK(message_of([&] { Journal second(path); }).find("another process is using this journal") != std::string::npos);
    make_journal(folder.path / "other", 2, 1);
    CHECK_FAILS(merge_journals({folder.path / "other"}, path), usage);
    CHECK(read_journal(path).entries.size() == 2);  // reading is free
  }
  CHECK_NOTHROW(Journal(path));
}

TEST_CASE("a full disk leaves whole lines") {
  const Folder folder;
  const fs::path path = folder.path / "journal";
  Journal journal(path);
  journal.append(entry(0));
  const std::string before = content(path);
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit old;
  REQUIRE(getrlimit(RLIMIT_FSIZE, &old) == 0);
  const rlimit small{before.size() + 20, old.rlim_max};
  REQUIRE(setrlimit(RLIMIT_FSIZE, &small) == 0);
  const std::string message = message_of([&] { journal.append(entry(1)); });
  REQUIRE(setrlimit(RLIMIT_FSIZE, &old) == 0);
  CHECK(message.find("cannot be written") != std::string::npos);
  CHECK(content(path) == before);
  journal.append(entry(1));
  CHECK(read_journal(path).entries.size() == 2);
}

TEST_CASE("journals are joined") {
  const Folder folder;
  const fs::path a = make_journal(folder.path / "a", 0, 3), b = make_journal(folder.path / "b", 2, 3);
  const fs::path out = folder.path / "out";
  CHECK(merge_journals({a, b}, out).cases == 5);
  CHECK(content(out) == content(make_journal(folder.path / "expected", 0, 5)));
  CHECK(merge_journals({b, a, out}, out).damage.empty());
  CHECK(read_journal(out).entries.size() == 5);

  SECTION("an existing target is kept") {
    const fs::path c = make_journal(folder.path / "c", 7, 1);
    merge_journals({c}, out);
    CHECK(read_journal(out).entries.size() == 6);
  }
  SECTION("two results for one case are an error that names both places") {
    const fs::path c = folder.path / "c";
    {
      Journal journal(c);
      journal.append(entry(9));
      journal.append({"1.0", "case 1", Json{{"n", 1}, {"x", "1/4"}}});
    }
    const std::string before = content(out);
    CHECK(message_of([&] {
            merge_journals({a, c}, out);
          }) == a.string() + " line 3 and " + c.string() + " line 3 have different results for the case 'case 1'");
    CHECK(content(out) == before);
    CHECK(message_of([&] {
            Journal journal(c);
            journal.append(entry(1));
          }) == "no error");
    CHECK(message_of([&] { Journal journal(c); }) ==
          c.string() + " line 3 and " + c.string() + " line 4 have different results for the case 'case 1'");
  }
  SECTION("damaged lines are reported") {
    std::string text = content(a);
    text[text.find("case 1")] = 'C';
    overwrite(a, text);
    CHECK(merge_journals({a}, folder.path / "d").damage ==
          std::vector<std::string>{a.string() + " line 3 is damaged; its case is left out"});
    CHECK(read_journal(folder.path / "d").entries.size() == 2);
  }
}

TEST_CASE("keys that no journal has, or that are there twice, are refused with their place") {
  const Folder folder;
  const fs::path path = folder.path / "journal";
  const auto refused = [&](const std::string& json) {
    const std::string body = case_id("1.0", "case 1") + " " + json;
    boost::crc_32_type crc;
    crc.process_bytes(body.data(), body.size());
    overwrite(path, fmt::format("subcert journal 1\n{:08x} {}\n{}", crc.checksum(), body, "rest"));
    return message_of([&] { read_journal(path); });
  };
  const std::string good = R"("version":"1.0","case":"case 1","result":)";
  CHECK(refused("{" + good + "1}") == "no error");
  CHECK(refused("{" + good + R"(1,"seed":2})") ==
        path.string() + " line 2: unknown key 'seed'; the keys of a line of a journal are version, case, result");
  CHECK(refused("{" + good + R"(1,"case":"case 1"})") == path.string() + " line 2: the key 'case' is there twice");
  CHECK(refused("{" + good + R"({"n":1,"n":2}})") == path.string() + " line 2: the key 'n' is there twice");
  CHECK(refused("{" + good) == "no error");  // damaged, as other lines are
}
