#include "program.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

using namespace subcert::testing;

namespace {

std::vector<std::string> sorted_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  std::ranges::sort(lines);
  return lines;
}

}  // namespace

TEST_CASE("sweep: a line for each scheme, as they come, in order, and continued") {
  const Folder folder;
  const std::string schemes = "sweep 'primal:n=1..3,d={1,3}' --ask regularity,variance ";
  const Run whole = run(schemes + "--in-order");
  CHECK(whole.code == 0);
  CHECK(whole.out.starts_with("scheme,sum_rules,converges,holder.lower,"));
  CHECK(whole.out.find("\"primal:n=2,d=1\",2,yes,1.745589247334424666") != std::string::npos);
  CHECK(sorted_lines(run(schemes).out) == sorted_lines(whole.out));

  std::string journals;
  for (const char* shard : {"1", "2"}) {
    const std::string journal = folder / shard;
    CHECK(run(schemes + "--shard " + shard + "/2 --journal " + journal).code == 0);
    journals += " " + journal;
  }
  const std::string joined = folder / "joined";
  CHECK(run("merge" + journals + " --out " + joined).out == joined + ": 6 cases\n");
  const std::string before = content(joined), table = folder / "table.csv";
  CHECK(run(schemes + "--journal " + joined + " --worker /bin/false --out " + table).code == 0);
  CHECK(content(joined) == before);
  CHECK(content(table) == whole.out);

  const Run lines = run(schemes + "--json --in-order --journal " + joined);
  const auto first = nlohmann::json::parse(lines.out.substr(0, lines.out.find('\n')));
  CHECK(first.at("scheme") == "primal:n=1,d=1");
  CHECK(first.at("keys").at("d") == "1");
  CHECK(first.at("answers").at("variance").contains("mean"));
  CHECK(!first.at("answers").at("regularity").contains("seconds"));
}

TEST_CASE("sweep: a file has a scheme in each line") {
  const Folder folder;
  const std::string list = folder / "schemes";
  std::ofstream(list) << "# two\nDD4\n\nchaikin\n";
  const Run both = run("sweep " + list + " --in-order");
  CHECK(both.code == 0);
  CHECK(both.out.find("\nDD4,4,yes,2,2,") != std::string::npos);
  CHECK(both.out.find("\nchaikin,3,yes,2,2,") != std::string::npos);
  CHECK(run("sweep nowhere.txt").code == 66);
}

TEST_CASE("sweep: a file with the mark of UTF-8, and a folder") {
  const Folder folder;
  const std::string list = folder.write("list.txt",
                                        "\xef\xbb\xbf"
                                        "chaikin\r\ndd:n=2\r\n");
  const Run found = run("sweep " + list + " --in-order");
  CHECK(found.code == 0);
  CHECK(found.out.find("\nchaikin,3,yes,2,2,") != std::string::npos);
  check_fails(run("sweep " + folder / ""), 66, folder / "" + ": expected a file; found a folder");
}

TEST_CASE("sweep: a crash costs its scheme alone") {
  const Folder folder;
  const std::string worker = write_script(
      folder, "worker",
      std::string("case \"$*\" in *n=2*) kill -SEGV $$ ;; esac\nexec ") + SUBCERT_PROGRAM + " \"$@\"\n");
  const Run found = run("sweep 'dd:n=1..3' --in-order --worker " + worker);
  CHECK(found.code == 2);
  CHECK(found.out.find("ended by signal 11") != std::string::npos);
  CHECK(found.out.find("dd:n=3,6,yes,2.83") != std::string::npos);
  CHECK(found.err.find("3 schemes, 1 with errors, the first: dd:n=2: ended by signal 11") != std::string::npos);
  CHECK(run("sweep dd:n=1 --worker " + (folder / "none")).code == 66);
}

TEST_CASE("sweep: expectations, conditions, and input from elsewhere") {
  const Folder folder;
  const Run found = run("sweep 'primal:n=1..3,d=1' --expect 'holder > 1.5' --in-order");
  CHECK(found.code == 1);
  CHECK(found.out.find("\"primal:n=1,d=1\",2,yes,1,1,yes,yes,,no\n") != std::string::npos);
  CHECK(found.err.find("as expected 2, not 1, open 0; the first that are not: primal:n=1,d=1") != std::string::npos);
  CHECK(run("sweep 'primal:n=1..3,d=1' --expect 'holder > 1.5' --where 'n >= 2'").code == 0);
  CHECK(run("sweep 'primal:n=1..3,d=1' --expect 'nothing > 1.5'").code == 2);
  const std::string certificates = folder / "certificates";
  CHECK(contains(run("sweep 'primal:n=1..3,d=1' --expect 'holder > 1.8' --certificates " + certificates).err,
                 "primal:n=2,d=1: certificate " + certificates + "/2.cert, verified"));
  CHECK(run("verify " + certificates + "/2.cert").code == 0);
  const std::string plan = folder.write("plan.toml",
                                        "schemes = [\"dd:n=1..2\"]\ncolumns = [\"n\", \"holder.upper\"]\n");
  CHECK(run("sweep " + plan + " --in-order").out == "n,holder.upper\n1,1\n2,2\n");
  CHECK(run("sweep " + plan + " --in-order --columns n").out == "n\n1\n2\n");
  CHECK(run("sweep " + plan + " dd:n=3").code == 64);
  CHECK(run("sweep - --columns scheme --in-order < " + folder.write("lines", "# two\ndd:n=2\n\n dd:n={2,1}\r\n")).out ==
        "scheme\ndd:n=2\ndd:n=1\n");
  CHECK(run("sweep " + folder.write("wrong.toml", "schemes = [\"a\"]\nseed = 3\n")).code == 65);
  CHECK(run("sweep 'primal:n=3..1'").code == 64);
  CHECK(run("sweep dd:n=1 --where 'n >= 4'").code == 64);
  CHECK(run("sweep nosuch:3").code == 2);
}

TEST_CASE("sweep: what is wrong is told with its place, before anything is computed") {
  const Folder folder;
  const auto refused = [](int code, const std::string& words, const std::string& message) {
    const Run found = run("sweep " + words);
    CAPTURE(words, found.err);
    CHECK(found.code == code);
    CHECK(found.out.empty());
    CHECK(contains(found.err, message));
    CHECK(std::ranges::count(found.err, '\n') == 1);
  };
  const std::string list = folder.write("list.txt", "dd:n=1\n# and\nprimal:n=3..1\n");
  refused(65, list, "list.txt, line 3: scheme specification, position 10: '3..1'; expected A..B");
  refused(65, "- < " + list, "standard input, line 3: scheme");
  refused(65, folder.write("none.txt", "# nothing\n"), "none.txt: there is no scheme; expected one in each line");
  refused(65, folder.write("p.toml", "schemes = [\"dd:n=3..1\"]"), "p.toml, line 1, column 12: scheme specification");
  refused(65, folder.write("w.toml", "schemes = [\"a\"]\nwhere = \"n >\""), "w.toml, line 2, column 9: where, pos");
  refused(65, folder.write("m.toml", "schemes = [\"a\"]\nmemory = 99.5"), "'memory' takes a whole number of MiB");
  refused(64, "dd:n=1 --where 'm > 1'", "no scheme is left; expected schemes for which m > 1");
  refused(64, "masks:length=3,denominator=2", "sweep: no scheme is left; expected schemes\n");
  refused(64, "dd:n=1 --columns ''", "need a name for each column");
  refused(64, "dd:n=1..1000000000", "expected at most 1000000 values");
  refused(66, "dd:n=1 --expect 'holder > 3' --certificates " + list + "/x",
          "--certificates " + list + "/x: expected a folder");
}

TEST_CASE("sweep: names that no answer has, schemes that diverge") {
  const Run found = run("sweep dd:n=1 --expect 'holdr > 1' --columns scheme,holder.lower,nothing");
  CHECK(found.code == 2);
  CHECK(contains(found.err, "subcert: note: 1 scheme; as expected 0, not 0, open 1\n"));
  CHECK(contains(found.err, "subcert: note: no answer has 'holdr'; did you mean 'holder'?\n"));
  CHECK(contains(found.err, "subcert: note: no answer has 'nothing'\n"));
  CHECK(run("sweep 'mask:[4,4,3,0,-3]/4' --expect 'holder > 1'").code == 1);
}

TEST_CASE("sweep: commands with settings, and properties") {
  const Run found = run(
      "sweep dd:n=1..3 loop --in-order --ask 'check smoothness >= 1, check reproduces 3,check symmetry "
      "even,vertex --valence 3,5' --columns "
      "scheme,check.smoothness,check.reproduces,check.symmetry,valences.1.valence");
  CHECK(found.code == 2);
  CHECK(
      found.out ==
      "scheme,check.smoothness,check.reproduces,check.symmetry,valences.1.valence\ndd:n=1,no,no,no,\ndd:n=2,yes,yes,no,"
      "\ndd:n=3,yes,no,no,\nloop,yes,no,,5\n");
  CHECK(contains(found.err, "4 schemes, 4 with errors, the first: dd:n=1: dd:n=1: has no rules at vertices"));
  CHECK(run("sweep dd:n=2..3 --ask 'check smoothness >= 1' --expect check.smoothness").code == 0);
  CHECK(run("sweep dd:n=1..2 --ask 'check smoothness >= 1' --expect check.smoothness").code == 1);
  // undecided is open
  CHECK(run("sweep primal:n=20,d=5 --ask 'check holder >= 4' --budget 0.001 --expect check.holder").code == 2);
  CHECK(contains(run("sweep four-point:w --ask 'levels --over w=1/1000..19/100 --property C1' --in-order").out,
                 "four-point:w,\"C1 for every sequence of w from 1/1000 to 19/100"));
  for (const auto& [ask, message] : std::vector<std::pair<std::string, std::string>>{
           {"vertx", "position 1: 'vertx'; expected one of regularity, "},
           {"check", "position 6: ''; expected a property, one of convergent, "},
           {"mask --out x", "position 6: '--out'; expected no more"},
           {"vertex --valence", "position 17: ''; expected the value of --valence"}}) {
    const Run refused = run("sweep loop --ask '" + ask + "'");
    CHECK(refused.code == 64);
    CHECK(contains(refused.err, message));
  }
}

TEST_CASE("sweep: the program that asks is the one that answers, also where its file is replaced") {
  const Folder folder;
  const std::string program = folder / "subcert";
  std::filesystem::copy_file(SUBCERT_PROGRAM, program);
  const Run found = run_command("(sleep 1; rm " + program + "; echo dd:n=1) | " + program +
                                " sweep - --columns holder.upper");
  CHECK(found.code == 0);
  CHECK(found.out == "holder.upper\n1\n");
}

TEST_CASE("sweep: processes end with the program that asked") {
  const Folder folder;
  const std::string number = folder / "number",
                    worker = write_script(folder, "worker",
                                          "[ $1 = --version ] || echo $$ >" + number + "\nexec sleep 100\n");
  const std::string quiet = write_script(folder, "quiet", "[ $1 = --version ] && exit; exec " + worker + " \"$@\"\n");
  run_command("(" + std::string(SUBCERT_PROGRAM) + " sweep dd:n=1 --worker " + quiet + " >" + (folder / "out") +
              " & parent=$!; while ! [ -s " + number + " ]; do sleep 0.1; done; kill -9 $parent)");
  // Whoever collects orphans may leave what has ended in the list.
  const std::string alive = "grep -q '^State:.[^ZX]' /proc/$(cat " + number + ")/status";
  CHECK(run_command("for i in 1 2 3 4 5 6 7 8 9; do " + alive + " || exit 0; sleep 0.2; done; exit 1").code == 0);
}
