#include <subcert/cmake/catch.hpp>

#include <nlohmann/json.hpp>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace fs = std::filesystem;

namespace {

struct Run {
  int code;
  std::string out;
  std::string err;
};

std::string read(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// Runs the program with these arguments, given as a shell would read them.
Run run(const std::string& arguments) {
  const fs::path errors = fs::temp_directory_path() / ("subcert-cli-test-" + std::to_string(getpid()) + ".err");
  const std::string command = std::string(SUBCERT_PROGRAM) + " " + arguments + " 2>" + errors.string();
  FILE* pipe = popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  Run result;
  char buffer[4096];
  for (std::size_t n; (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;) result.out.append(buffer, n);
  const int status = pclose(pipe);
  result.code = WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + status;
  result.err = read(errors);
  fs::remove(errors);
  return result;
}

/// code -1: done or undecided, as the machine's speed has it.
nlohmann::json run_json(const std::string& arguments, int code = 0) {
  const Run result = run(arguments + " --json");
  CAPTURE(arguments, result.err);
  REQUIRE((result.code == code || (code == -1 && (result.code == 0 || result.code == 2))));
  CHECK(result.err.empty());
  return nlohmann::json::parse(result.out);
}

/// Compares with an approved file; SUBCERT_APPROVE=1 in the environment writes it instead.
void check_baseline(const std::string& name, const std::string& arguments) {
  const Run result = run(arguments);
  CAPTURE(arguments, result.err);
  CHECK(result.code == 0);
  const fs::path file = fs::path(SUBCERT_BASELINES) / name;
  if (std::getenv("SUBCERT_APPROVE")) std::ofstream(file, std::ios::binary) << result.out;
  CHECK(result.out == read(file));
}

}  // namespace

TEST_CASE("approved output") {
  check_baseline("mask-dual-odd.txt", "mask 'dual-odd:n=2'");
  check_baseline("mask-ary.txt", "mask 'ary:a=3,points=4,d=3'");
  check_baseline("mask-primal.json", "mask 'primal:n=3' --json");
  check_baseline("analyze-chaikin.txt", "analyze 'mask:[1,3,3,1]/4'");
  check_baseline("analyze-dd.txt", "analyze dd:n=2");
  check_baseline("analyze-divergent.txt", "analyze 'mask:[1,1]'");
  check_baseline("limit-primal.json", "limit 'primal:n=2' --level 3 --json");
  check_baseline("regularity-dual.txt", "regularity dual:n=2");
  check_baseline("regularity-dd.txt", "regularity dd:n=2");
  check_baseline("variance-primal.txt", "variance primal:n=5");
}

TEST_CASE("the fields of the contract") {
  const auto mask = run_json("mask 'dual:n=2'");
  CHECK(mask.at("first_index") == -4);
  CHECK(mask.at("coefficients").size() == 8);
  CHECK(mask.at("coefficients").at(0) == "7/40");
  CHECK(mask.at("support").at("upper") == "3");

  const auto limit = run_json("limit 'primal:n=2' --level 0");
  CHECK(limit.at("first_index") == -3);
  CHECK(limit.at("values").at(3) == "9/31");

  const auto regularity = run_json("regularity 'dual:n=7' --levels 16 --budget 4", -1);
  CHECK(regularity.at("sum_rules") == 3);
  CHECK(regularity.at("bound").at("levels") == 16);
  CHECK(regularity.at("bound").at("norm").is_string());
  CHECK(regularity.at("bound").at("holder").at("lower").get<std::string>().substr(0, 5) == "2.633");
  CHECK(regularity.at("stable") == true);
  CHECK(regularity.at("product").is_string());
  CHECK(regularity.at("holder").at("upper").get<std::string>().substr(0, 5) == "2.994");

  const auto closed = run_json("regularity primal:n=5");
  CHECK(closed.at("closed") == true);
  CHECK(closed.at("exact") == true);
  CHECK(closed.at("method") == "invariant polytope");
  CHECK(closed.at("holder").at("lower").get<std::string>().substr(0, 13) == "1.99014395938");

  const auto single = run_json("regularity 'mask:[-5,-7,35,105,105,35,-7,-5]/128'");
  CHECK(single.at("method") == "single spectral radius");
  CHECK(single.at("exact") == true);
  CHECK(single.at("holder").at("lower").get<std::string>().substr(0, 14) == "2.830074998557");
  CHECK(single.at("logarithm").at("at_most") == 0);
  CHECK(run_json("regularity four-point:w=1/16").at("logarithm").at("at_least") == 1);
  for (const char* command : {"regularity", "analyze"}) {
    const auto sobolev = run_json(std::string(command) + " dd:n=2").at("sobolev");
    CHECK(sobolev.at("exponent").at("lower").get<std::string>().substr(0, 8) == "2.440765");
    CHECK(sobolev.at("stable") == true);
    // Dependent shifts: no upper end.
    const auto unstable = run_json(std::string(command) + " 'mask:[1,2,2,2,1]/4'", -1).at("sobolev");
    CHECK(unstable.at("exponent").at("upper") == "inf");
    CHECK(unstable.at("stable") == false);
  }

  const auto variance = run_json("variance primal:n=1");
  CHECK(variance.at("mean") == "2/3");
  CHECK(variance.at("sup").at("lower") == "1");
  CHECK(variance.at("sup").at("upper") == "1");
  CHECK(variance.at("inf").at("upper") == "0.5");
  CHECK(variance.at("derivative_sup").at("upper").get<std::string>().substr(0, 10) == "2.00000000");
  const auto smooth = run_json("variance dd:n=2");
  CHECK(smooth.at("sup").at("lower") == "1");
  CHECK(smooth.at("complete") == true);
  CHECK(smooth.at("derivative_sup").at("lower").get<std::string>().substr(0, 7) == "1.09267");
  CHECK(run_json("variance four-point:w=1/5").at("derivative_sup").is_null());
  CHECK(run_json("variance primal:n=10 --budget 0.000001", 2).at("complete") == false);

  const auto reproduce = run_json("reproduce dyn-2015 --only table1,table2");
  CHECK(reproduce.at("comparisons").size() == 18);
  for (const auto& comparison : reproduce.at("comparisons")) CHECK(comparison.at("verdict") == "match");
}

TEST_CASE("wrong usage is one line and exit code 64") {
  for (const char* arguments :
       {"", "nonsense", "mask", "mask nobody:n=3", "mask primal:n=100000", "mask primal:n=3,n=3", "mask 'mask:[1,1]/0'",
        "mask 'mask:[1,3,3,2]/4'", "mask primal:n=3 --nonsense", "mask primal:n=3 extra", "limit primal:n=2 --level -1",
        "limit primal:n=2 --level 50", "limit primal:n=2000", "regularity dual:n=2 --levels 0",
        "regularity dual:n=2 --levels x", "regularity dual:n=2 --budget 0", "variance dd:n=2 --width 0",
        "variance dd:n=2 --width x", "reproduce nobody-1900",
        "reproduce dyn-2015 --only table9", "mask primal:n=3 --jobs 0", "conjecture", "conjecture 9", "conjecture 7 --n 0",
        "conjecture 7 --n 4..1", "conjecture 7 --n 1,,2", "conjecture 7 --d x", "conjecture 7 --shard 0/8",
        "conjecture 7 --shard 9/8", "conjecture 7 --n 1 --d 3", "conjecture 8 --n 2 --d 1", "analyze $'mask:[1,\\n]'"}) {
    const Run result = run(arguments);
    CAPTURE(arguments, result.out, result.err);
    CHECK(result.code == 64);
    CHECK(result.out.empty());
    CHECK(result.err.substr(0, 9) == "subcert: ");
    CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
  }
  CHECK(run("mask primal:m=3").err ==
        "subcert: scheme specification, position 11: 'primal'; expected the key 'n', as in primal:n=3,d=1\n");
}

TEST_CASE("verdicts have exit codes of their own") {
  CHECK(run("limit 'mask:[1,1]'").code == 1);
  CHECK(run("regularity 'mask:[1,1]'").code == 1);
  CHECK(run("variance 'mask:[1,0,0,1]'").code == 1);
  CHECK(run("limit dd:n=2 --derivative 2").code == 2);
  CHECK(run("regularity primal:n=300 --budget 0.01").code == 2);
}

TEST_CASE("conjectures over a range, whole, split and continued") {
  const fs::path folder = fs::temp_directory_path() / ("subcert-cli-conjecture-" + std::to_string(getpid()));
  fs::create_directories(folder);
  const auto seven = run_json("conjecture 7 --n 1..4 --d 1,3");
  CHECK(seven.at("conjecture") == 7);
  CHECK(seven.at("limits").size() == 2);
  CHECK(seven.at("limits").at(0).at("constant").at("lower").get<std::string>().substr(0, 22) == "0.40443676798398528146");
  CHECK(seven.at("rows").at(3).at("limit_deviation").at("lower").get<std::string>().substr(0, 4) == "0.06");
  REQUIRE(seven.at("rows").size() == 7);
  CHECK(seven.at("rows").at(2).at("n") == 3);
  CHECK(seven.at("rows").at(2).at("sup").at("lower").get<std::string>().substr(0, 6) == "0.1489");
  CHECK(seven.at("rows").at(2).at("derivative_sup").at("upper").is_string());
  CHECK(seven.at("skipped").at(0).at("scheme") == "primal:n=1,d=3");
  CHECK(seven.at("verdict") == "holds");

  std::string journals;
  for (int shard = 1; shard <= 3; ++shard) {
    const std::string journal = (folder / std::to_string(shard)).string();
    const auto part = run_json("conjecture 7 --n 1..4 --d 1,3 --shard " + std::to_string(shard) + "/3 --journal " + journal);
    CHECK(part.at("verdict").is_null());
    CHECK(part.at("rows").size() == (shard == 1 ? 3 : 2));
    journals += " " + journal;
  }
  const std::string whole = (folder / "whole").string();
  CHECK(run("merge" + journals + " --out " + whole).out == whole + ": 7 cases\n");
  const std::string before = read(whole);
  CHECK(run_json("conjecture 7 --n 1..4 --d 1,3 --journal " + whole) == seven);
  CHECK(read(whole) == before);
  CHECK(run("conjecture 7 --n 1..4 --d 1,3").out == run("conjecture 7 --n 1..4 --d 1,3 --jobs 1 --journal " + whole).out);

  const auto eight = run_json("conjecture 8 --n 1..4 --d 1..3");
  CHECK(eight.at("rows").size() == 8);
  CHECK(eight.at("verdict") == "holds");
  fs::remove_all(folder);
}

TEST_CASE("journals are joined") {
  const fs::path folder = fs::temp_directory_path() / ("subcert-cli-merge-" + std::to_string(getpid()));
  fs::create_directories(folder);
  const std::string a = (folder / "a").string(), b = (folder / "b").string(), out = (folder / "out").string();
  const std::string header = "subcert journal 1\n";
  const std::string id = "d6577dd8-55dc-533f-954a-d4b797e9f6ab";
  const std::string line = "494ce316 " + id + R"( {"version":"toy 1","case":"toy n=6","result":{"n":6,"value":"1","long":"xxx"}})" + "\n";
  std::ofstream(a, std::ios::binary) << header << line;
  std::ofstream(b, std::ios::binary) << header << "damaged\n" << line;
  const Run merged = run("merge " + a + " " + b + " --out " + out);
  CHECK(merged.code == 0);
  CHECK(merged.out == out + ": 1 case\n");
  CHECK(merged.err == "subcert: " + b + " line 2 is damaged; its case is left out\n");
  CHECK(read(out) == header + line);
  CHECK(run_json("merge " + a + " --out " + out).at("cases") == 1);
  CHECK(run("merge " + a).code == 64);
  CHECK(run("merge --out " + out).code == 64);
  CHECK(run("merge " + a + " " + folder.string() + "/nowhere --out " + out).code == 66);
  std::ofstream(b, std::ios::binary) << "thesis\n";
  CHECK(run("merge " + a + " " + b + " --out " + out).code == 65);
  CHECK(run("merge " + a + " --out " + b).code == 65);
  CHECK(read(b) == "thesis\n");
  fs::remove_all(folder);
}

TEST_CASE("certificates are written and verified") {
  const std::string file = (fs::temp_directory_path() / ("subcert-cli-test-" + std::to_string(getpid()) + ".cert")).string();
  for (const char* scheme : {"dd:n=3", "four-point:w=1/20"}) {
    CHECK(run(std::string("regularity ") + scheme + " --certificate " + file).code == 0);
    CHECK(run("verify " + file).code == 0);
  }
  CHECK(run("regularity dual-odd:n=2 --certificate " + file).code == 0);
  const Run verified = run("verify " + file);
  CHECK(verified.code == 0);
  CHECK(verified.out.find(": VERIFIED ") != std::string::npos);
  // One digit of one vertex changed.
  std::string text = read(file);
  const std::size_t vertex = text.find("vertex ") + 12;
  text[vertex] = text[vertex] == '1' ? '2' : '1';
  std::ofstream(file, std::ios::binary) << text;
  const Run rejected = run("verify " + file);
  CHECK(rejected.code == 1);
  CHECK(rejected.out.find(": REJECTED ") != std::string::npos);
  std::ofstream(file, std::ios::binary) << "nonsense\n";
  CHECK(run("verify " + file).code == 65);
  fs::remove(file);
  CHECK(run("verify " + file).code == 66);
  CHECK(run("regularity 'mask:[1,1]' --certificate " + file).code == 64);
  CHECK_FALSE(fs::exists(file));
}

TEST_CASE("matrices from a file") {
  const std::string file = (fs::temp_directory_path() / ("subcert-cli-test-" + std::to_string(getpid()) + ".json")).string();
  const auto with = [&](const std::string& text, const std::string& options = "") {
    std::ofstream(file, std::ios::binary) << text;
    return run("jsr " + file + options);
  };
  const Run golden = with(R"({"matrices": [[["1","1"],["0","1"]], [[1,0],["2/2",1]]]})", " --json --certificate " + file + ".cert");
  CHECK(golden.code == 0);
  CHECK(nlohmann::json::parse(golden.out).at("product").size() == 2);
  CHECK(nlohmann::json::parse(golden.out).at("radius").at("lower").get<std::string>().substr(0, 12) == "1.6180339887");
  CHECK(run("verify " + file + ".cert").code == 0);
  const Run blocks = with(R"({"matrices": [[["2","7"],["0","1"]], [["1","5"],["0","-3"]]]})", " --json --certificate " + file + ".cert");
  CHECK(blocks.code == 0);
  CHECK(nlohmann::json::parse(blocks.out).at("blocks") == nlohmann::json({1, 1}));
  CHECK(nlohmann::json::parse(blocks.out).at("exact") == true);
  CHECK(nlohmann::json::parse(blocks.out).at("radius").at("upper") == "3");
  CHECK(run("verify " + file + ".cert").code == 0);
  const Run nilpotent = with(R"({"matrices": [[["0","7"],["0","0"]], [["0","5"],["0","0"]]]})", " --json --certificate " + file + ".cert");
  CHECK(nilpotent.code == 0);
  CHECK(nlohmann::json::parse(nilpotent.out).at("radius").at("upper") == "0");
  CHECK(run("verify " + file + ".cert").code == 0);
  for (const char* text : {"", "{", "[]", "{}", R"({"matrices": []})", R"({"matrices": 5})", R"({"matrices": [[]]})",
                           R"({"matrices": [[["1","0"],["1"]]]})", R"({"matrices": [[["1/0"]]]})",
                           R"({"matrices": [[[1.5]]]})", R"({"matrices": [[["1"]],[["1","0"],["0","1"]]]})",
                           R"({"matrices": [[[null]]]})"}) {
    CAPTURE(text);
    CHECK(with(text).code == 65);
  }
  for (const char* ending : {"", ".cert", ".cert.matrices"}) fs::remove(file + ending);
  CHECK(run("jsr " + file).code == 66);
}

TEST_CASE("help names an example in every subcommand") {
  for (const char* command : {"reproduce", "analyze", "mask", "regularity", "jsr", "verify", "limit", "variance"}) {
    const Run result = run(std::string(command) + " --help");
    CAPTURE(command);
    CHECK(result.code == 0);
    CHECK(result.out.find("Example:\n  subcert " + std::string(command)) != std::string::npos);
  }
  CHECK(run("--version").out.substr(0, 8) == "subcert ");
}

TEST_CASE("answers go to a file when asked") {
  const fs::path file = fs::temp_directory_path() / ("subcert-cli-test-" + std::to_string(getpid()) + ".txt");
  const Run result = run("mask dual:n=1 --out " + file.string());
  CHECK(result.code == 0);
  CHECK(result.out.empty());
  CHECK(read(file) == "[1,3,3,1]/4@-2\n");
  fs::remove(file);
  CHECK(run("mask dual:n=1 --out /proc/nowhere/file").code == 70);
}
