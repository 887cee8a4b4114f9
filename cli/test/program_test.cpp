#include "program.hpp"

#include <regex>

using namespace subcert::testing;

namespace {

/// Compares with an approved file; SUBCERT_APPROVE=1 in the environment writes it instead.
void check_baseline(const std::string& name, const std::string& arguments, int code = 0) {
  const Run result = run(arguments);
  CAPTURE(arguments, result.err);
  CHECK(result.code == code);
  const std::string file = std::string(SUBCERT_BASELINES) + "/" + name;
  // Which program made an answer changes from commit to commit.
  const std::string out = std::regex_replace(result.out, std::regex(R"(,\n  "subcert": \{[^]*?\n  \})"), "");
  if (std::getenv("SUBCERT_APPROVE")) std::ofstream(file, std::ios::binary) << out;
  CHECK(out == content(file));
}

}  // namespace

TEST_CASE("approved output") {
  check_baseline("mask-dual-odd.txt", "mask 'dual-odd:n=2'");
  check_baseline("mask-ary.txt", "mask 'ary:a=3,points=4,d=3'");
  check_baseline("mask-primal.json", "mask 'primal:n=3' --json");
  check_baseline("analyze-chaikin.txt", "analyze 'mask:[1,3,3,1]/4'");
  check_baseline("analyze-dd.txt", "analyze dd:n=2");
  check_baseline("analyze-divergent.txt", "analyze 'mask:[1,1]'", 1);
  check_baseline("analyze-grid.txt", "analyze grid:points=3x3,d=2 --budget 100");
  check_baseline("analyze-tensor.json", "analyze 'tensor:(primal:n=2)x(dual:n=1)' --json");
  check_baseline("mask-grid.txt", "mask grid:points=4x4");
  check_baseline("limit-primal.json", "limit 'primal:n=2' --level 3 --json");
  check_baseline("regularity-dual.txt", "regularity dual:n=2");
  check_baseline("regularity-dd.txt", "regularity dd:n=2");
  check_baseline("variance-primal.txt", "variance primal:n=5");
  check_baseline("theorem-list.txt", "theorem list");
  check_baseline("theorem-degree-three.txt", "theorem conjecture-8-n --d 3");
  check_baseline("statements-list.txt", "statements list");
  check_baseline("statements-check.txt", "statements check mustafa-bari-2016/eq-2.6 dyn-2015/eq-2 dyn-2015/figs-3-7");
}

TEST_CASE("wrong usage is one line and exit code 64") {
  for (const char* arguments : {"",
                                "nonsense",
                                "mask",
                                "mask nobody:n=3",
                                "mask primal:n=100000",
                                "mask primal:n=3,n=3",
                                "mask 'mask:[1,1]/0'",
                                "mask 'mask:[1,3,3,2]/4'",
                                "mask primal:n=3 --nonsense",
                                "mask primal:n=3 extra",
                                "limit primal:n=2 --level -1",
                                "limit primal:n=2 --level 50",
                                "limit primal:n=2000",
                                "regularity dual:n=2 --levels 0",
                                "regularity dual:n=2 --levels x",
                                "regularity dual:n=2 --budget 0",
                                "variance dd:n=2 --width 0",
                                "variance dd:n=2 --width x",
                                "reproduce nobody-1900",
                                "reproduce dyn-2015 --only table9",
                                "experiment fig999",
                                "experiment fig3 --runs 1",
                                "mask primal:n=3 --jobs 0",
                                "conjecture",
                                "conjecture 9",
                                "conjecture 7 --n 0",
                                "conjecture 7 --n 4..1",
                                "conjecture 7 --n 1,,2",
                                "conjecture 7 --d x",
                                "conjecture 7 --shard 0/8",
                                "conjecture 7 --shard 9/8",
                                "theorem conjecture-9",
                                "theorem conjecture-7 --d x",
                                "theorem conjecture-7 --d 302",
                                "conjecture 7 --n 1 --d 3",
                                "conjecture 8 --n 2 --d 1",
                                "analyze $'mask:[1,\\n]'"}) {
    const Run result = run(arguments);
    CAPTURE(arguments, result.out, result.err);
    CHECK(result.code == 64);
    CHECK(result.out.empty());
    CHECK(result.err.starts_with("subcert: "));
    CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
  }
  CHECK(run("mask primal:m=3").err ==
        "subcert: scheme specification, position 8: 'm'; expected the key 'n', as in primal:n=3,d=1\n");
  CHECK(contains(run("mask primal:N=3").err, "position 8: 'N'; expected the key 'n'"));
  CHECK(run("mask 'primal:n = 3'").out == run("mask primal:n=3").out);
  CHECK(contains(run("mask primal:d=3").err, "position 1: 'primal'; expected the key 'n'"));
  CHECK(contains(run("mask primal:n=3,D=1").err, "position 12: 'D'; expected a key of primal:n=3,d=1"));
}

TEST_CASE("verdicts have exit codes of their own") {
  CHECK(run("limit 'mask:[1,1]'").code == 1);
  CHECK(run("regularity 'mask:[1,1]'").code == 1);
  CHECK(run("variance 'mask:[1,0,0,1]'").code == 1);
  CHECK(run("regularity primal:n=300 --budget 0.01").code == 2);
}

TEST_CASE("help names an example in every subcommand") {
  for (const char* command : {"reproduce", "analyze", "mask", "regularity", "range", "jsr", "l1", "verify", "limit",
                              "variance", "refine", "smooth", "experiment", "completion"}) {
    const Run result = run(std::string(command) + " --help");
    CAPTURE(command);
    CHECK(result.code == 0);
    CHECK(result.out.find("Example:\n  subcert " + std::string(command)) != std::string::npos);
  }
  // What an answer says of the program is what the program says.
  const std::string version = run_json("mask chaikin").at("subcert").at("version");
  CHECK(run("--version").out == "subcert " + version + "\n");
}

TEST_CASE("help of the program has the exit codes, and hides what only the build calls") {
  const std::string help = run("--help").out;
  CHECK(help.find("\nExit status:\n  0   done") != std::string::npos);
  CHECK(help.find("manual") == std::string::npos);
  CHECK(run("mask --help").out.find("Exit status") == std::string::npos);
  check_fails(run("completion csh"), 64,
              "SHELL: 'csh'; expected bash, zsh, fish; did you mean 'zsh'?; see 'subcert completion --help'");
}

TEST_CASE("answers go to a file when asked") {
  const Folder folder;
  const std::string file = folder / "file.txt";
  const Run result = run("mask dual:n=1 --out " + file);
  CHECK(result.code == 0);
  CHECK(result.out.empty());
  CHECK(content(file) == "[1,3,3,1]/4@-2\n");
  CHECK(run("mask dual:n=1 --out /proc/nowhere/file").code == 66);
}

TEST_CASE("every option that takes a number refuses what is not one, or not finite") {
  const auto words = [](const std::string& text, const std::string& pattern) {
    std::vector<std::string> found;
    const std::regex regex(pattern);
    for (auto at = std::sregex_iterator(text.begin(), text.end(), regex); at != std::sregex_iterator(); ++at)
      found.push_back((*at)[1]);
    return found;
  };
  const std::string help = run("--help").out;
  std::size_t tried = 0;
  for (const std::string& command : words(help.substr(help.find("Subcommands:")), "\n  ([a-z0-9]+) "))
    for (const std::string& option : words(run(command + " --help").out, "\n  (--[a-z-]+) (?:INT|UINT|FLOAT|NUMBER)"))
      for (const char* value : {"nan", "inf", "-inf", "1e999", "''", "-nan", "0x1p3", "1,5"}) {
        const Run result = run(command + " " + option + " " + value);
        CAPTURE(command, option, value, result.err);
        CHECK(result.code == 64);
        CHECK(result.out.empty());
        CHECK(result.err.starts_with("subcert: " + option));
        ++tried;
      }
  CHECK(tried > 8 * 60);
}

TEST_CASE("commands and families that are meant") {
  CHECK(contains(run("analyse dd:n=2").err, "there is no command 'analyse'; did you mean 'analyze'?"));
  CHECK(run("analyse dd:n=2").code == 64);
  CHECK(contains(run("range four-point:w --ovr w=0..1").err,
                 "there is no option '--ovr'; did you mean '--over'?; see 'subcert range --help'"));
  CHECK(contains(run("statements check --jsn").err, "there is no option '--jsn'; did you mean '--json'?"));
  CHECK(contains(run("range four-point:w --property=C1").err, "--over is required"));
  CHECK(contains(run("mask duall:n=2").err, "did you mean 'dual'?"));
  CHECK(contains(run("mask fourpoint:w=1/16").err, "did you mean 'four-point'?"));
  CHECK(contains(run("mask chaikn").err, "did you mean 'chaikin'?"));
  CHECK(contains(run("levls four-point:w").err, "did you mean 'levels'?"));
  CHECK(contains(run("chaikin").err, "it is a scheme, as in 'subcert analyze chaikin'; see 'subcert --help'"));
  CHECK(contains(run("reproduce dyn-2015 --only tabel1").err, "did you mean 'table1'?"));
  CHECK(contains(run("reproduce dyn2015").err, "did you mean 'dyn-2015'?"));
  CHECK(contains(run("experiment fig33").err, "did you mean 'fig3'?"));
  CHECK(contains(run("statement list").err, "did you mean 'statements'?"));
  for (const char* word : {"list", "schemes", "families"})
    CHECK(contains(run(word).err, "'; 'subcert mask --help' lists the schemes; see 'subcert --help'"));
  CHECK(
      contains(run("plot").err, "there is no command 'plot'; 'analyze', 'compare', 'refine' and 'smooth' draw, with"));
  CHECK(contains(run("license").err, "; the file LICENSE has it"));
  const Folder folder;
  const std::string points = folder.write("points.csv", "0,0\n1,0\n");
  CHECK(contains(run("refine " + points).err,
                 "points.csv is a file: name a scheme before it, as in 'subcert refine chaikin "));
  CHECK(contains(run("analyze chaikin dd4").err, "; 'subcert compare' takes several schemes; see 'subcert analyze"));
  CHECK(contains(run("exponent chaikin").err, "there is no command 'exponent'; did you mean one of 'regularity', "));
  CHECK(contains(run("regularity chaikin --juntt x").err, "there is no option '--juntt'; see 'subcert regularity"));
  CHECK(contains(run("regularity chaikin --junit x").err, "there is no option '--junit'; it is one of 'check'; see"));
  CHECK(contains(run("smooth x --robust").err, "'--robust'; did you mean --scheme local:d=1,robust=3?; see"));
  CHECK(contains(run("refine x --steps 2").err, "did you mean --levels?"));
  CHECK(contains(run("range x --over a=0..1 --over b=0..1 --property C1").err,
                 "--over: expected once; found 2 values; see 'subcert range --help'"));
  CHECK(contains(run("mask x --paces 2").err, "there is no option '--paces'; see"));
  CHECK(contains(run("polish loop").err, "there is no command 'polish'; see 'subcert --help'"));
  for (const char* root : {"mask:[sqrt2,1]/2", "mask:[sqrt(2),1]/2", "four-point:w=sqrt2/16", "mask:[√2,1]/2"})
    CHECK(contains(run("mask '" + std::string(root) + "'").err, ",where=t^2-3:1.7..1.8"));
  CHECK(contains(run("--nosuch").err, "there is no option '--nosuch' before a command"));
  CHECK(run("help").out == run("--help").out);
  CHECK(run("help mask").out == run("mask --help").out);
  CHECK(contains(run("smooth").err, "see 'subcert smooth --help'"));
}

TEST_CASE("what a reader that leaves early is told: nothing") {
  const Run result = run("limit dd:n=2 --level 13 | head -c 10");
  CHECK(result.err.empty());
  CHECK(result.out.size() == 10);
}

TEST_CASE("standard output takes one answer") {
  for (const char* command :
       {"regularity dd:n=2 --certificate -", "range four-point:w --over w=0..1 --property C1 --certificate -",
        "analyze dd:n=2 --html -", "curve four-point:w --over w=0..1 --plot -"}) {
    const Run result = run(command);
    CHECK(result.code == 64);
    CHECK(result.out.empty());
    CHECK(contains(result.err, " -: standard output takes the answer of the command; expected another place\n"));
  }
}

TEST_CASE("answers do not go to a file that is read") {
  const Folder folder;
  const std::string data = folder.write("data.csv", "x,y\n0,1\n1,2\n2,3\n3,5\n4,4\n");
  for (const std::string& command :
       {"smooth " + data + " --scheme chaikin --out ", "refine chaikin " + data + " --out "}) {
    const Run result = run(command + (folder / ".") + "/data.csv");
    CHECK(result.code == 64);
    CHECK(contains(result.err, "/data.csv: it is read, and would be overwritten; expected another file"));
    CHECK(content(data).starts_with("x,y\n0,1\n"));
  }
}

TEST_CASE("two answers do not go to one file") {
  const Folder folder;
  const std::string file = folder / "x.html";
  const Run result = run("analyze dd:n=2 --plot " + file + " --out " + (folder / ".") + "/x.html");
  CHECK(result.code == 64);
  CHECK(contains(result.err, "--plot " + file + ": --out is to write there, too; expected another file"));
  CHECK_FALSE(std::filesystem::exists(file));
}
