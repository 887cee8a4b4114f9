#include <subcert/cmake/catch.hpp>

#include <boost/multiprecision/cpp_int.hpp>
#include <nlohmann/json.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
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

/// The decimal number in units of 10^-places, cut after them.
boost::multiprecision::cpp_int in_units(const std::string& text, std::size_t places) {
  const std::size_t point = std::min(text.find('.'), text.size());
  std::string decimals = point < text.size() ? text.substr(point + 1) : "";
  decimals.resize(places, '0');
  std::string digits = text.substr(0, point) + decimals;
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
  return boost::multiprecision::cpp_int(digits);
}

/// Whether the positive number lies within one unit of the last place of `expected`.
bool has_digits(const nlohmann::json& number, const std::string& expected) {
  const std::size_t places = expected.size() - expected.find('.') - 1;
  return abs(in_units(number.get<std::string>(), places) - in_units(expected, places)) <= 1;
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
  check_baseline("analyze-grid.txt", "analyze grid:points=3x3,d=2");
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
  CHECK(has_digits(regularity.at("bound").at("holder").at("lower"), "2.633"));
  CHECK(regularity.at("stable") == true);
  CHECK(regularity.at("product").is_string());
  CHECK(has_digits(regularity.at("holder").at("upper"), "2.994"));

  const auto closed = run_json("regularity primal:n=5");
  CHECK(closed.at("closed") == true);
  CHECK(closed.at("exact") == true);
  CHECK(closed.at("method") == "invariant polytope");
  CHECK(has_digits(closed.at("holder").at("lower"), "1.99014395938"));

  const auto single = run_json("regularity 'mask:[-5,-7,35,105,105,35,-7,-5]/128'");
  CHECK(single.at("method") == "single spectral radius");
  CHECK(single.at("exact") == true);
  CHECK(has_digits(single.at("holder").at("lower"), "2.830074998557"));
  CHECK(single.at("logarithm").at("at_most") == 0);
  CHECK(run_json("regularity four-point:w=1/16").at("logarithm").at("at_least") == 1);
  for (const char* command : {"regularity", "analyze"}) {
    const auto sobolev = run_json(std::string(command) + " dd:n=2").at("sobolev");
    CHECK(has_digits(sobolev.at("exponent").at("lower"), "2.440765"));
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
  CHECK(has_digits(variance.at("derivative_sup").at("upper"), "2.00000000"));
  const auto smooth = run_json("variance dd:n=2");
  CHECK(smooth.at("sup").at("lower") == "1");
  CHECK(smooth.at("complete") == true);
  CHECK(has_digits(smooth.at("derivative_sup").at("lower"), "1.09267"));
  CHECK(run_json("variance four-point:w=1/5").at("derivative_sup").is_null());
  CHECK(run_json("variance primal:n=10 --budget 0.000001", 2).at("complete") == false);

  const auto reproduce = run_json("reproduce dyn-2015 --only table1,table2");
  CHECK(reproduce.at("comparisons").size() == 18);
  for (const auto& comparison : reproduce.at("comparisons")) CHECK(comparison.at("verdict") == "match");
  const auto star = run_json("reproduce dyn-2015 --only fig17");
  CHECK(star.at("comparisons").empty());
  REQUIRE(star.at("experiments").size() == 1);
  CHECK(star.at("experiments").at(0).at("runs") == 50);
  for (const auto& claim : star.at("experiments").at(0).at("claims"))
    CHECK(claim.at("finding") == claim.at("recorded"));
}

TEST_CASE("theorems: proved, and unknown with what is missing") {
  const auto proved = run_json("theorem conjecture-8-n --d 1");
  CHECK(proved.at("theorem") == "conjecture-8-n");
  CHECK(proved.at("d").at(0) == 1);
  CHECK(proved.at("verdict") == "holds");
  CHECK(proved.at("constants").size() == 13);
  for (const auto& check : proved.at("checks")) CHECK(check.at("verdict") == "holds");
  const auto unknown = run_json("theorem conjecture-7 --d 7", 2);
  CHECK(unknown.at("verdict") == "unknown");
  CHECK_FALSE(unknown.at("missing").empty());
  CHECK(run_json("theorem list").at("theorems").size() == 4);
  CHECK(run("theorem").out == run("theorem list").out);
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
                                "theorem conjecture-7 --d 99",
                                "conjecture 7 --n 1 --d 3",
                                "conjecture 8 --n 2 --d 1",
                                "analyze $'mask:[1,\\n]'"}) {
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
  CHECK(has_digits(seven.at("limits").at(0).at("constant").at("lower"), "0.40443676798398528146"));
  CHECK(has_digits(seven.at("rows").at(3).at("limit_deviation").at("lower"), "0.0736"));
  REQUIRE(seven.at("rows").size() == 7);
  CHECK(seven.at("rows").at(2).at("n") == 3);
  CHECK(has_digits(seven.at("rows").at(2).at("sup").at("lower"), "0.1489"));
  CHECK(seven.at("rows").at(2).at("derivative_sup").at("upper").is_string());
  CHECK(seven.at("skipped").at(0).at("scheme") == "primal:n=1,d=3");
  CHECK(seven.at("verdict") == "holds");

  std::string journals;
  for (int shard = 1; shard <= 3; ++shard) {
    const std::string journal = (folder / std::to_string(shard)).string();
    const auto part = run_json("conjecture 7 --n 1..4 --d 1,3 --shard " + std::to_string(shard) + "/3 --journal " +
                               journal);
    CHECK(part.at("verdict").is_null());
    CHECK(part.at("rows").size() == (shard == 1 ? 3 : 2));
    journals += " " + journal;
  }
  const std::string whole = (folder / "whole").string();
  CHECK(run("merge" + journals + " --out " + whole).out == whole + ": 7 cases\n");
  const std::string before = read(whole);
  CHECK(run_json("conjecture 7 --n 1..4 --d 1,3 --journal " + whole) == seven);
  CHECK(read(whole) == before);
  CHECK(run("conjecture 7 --n 1..4 --d 1,3").out ==
        run("conjecture 7 --n 1..4 --d 1,3 --jobs 1 --journal " + whole).out);

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
  const std::string line = "494ce316 " + id +
                           R"( {"version":"toy 1","case":"toy n=6","result":{"n":6,"value":"1","long":"xxx"}})" + "\n";
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
  const std::string file = (fs::temp_directory_path() / ("subcert-cli-test-" + std::to_string(getpid()) + ".cert"))
                               .string();
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
  const std::string file = (fs::temp_directory_path() / ("subcert-cli-test-" + std::to_string(getpid()) + ".json"))
                               .string();
  const auto with = [&](const std::string& text, const std::string& options = "") {
    std::ofstream(file, std::ios::binary) << text;
    return run("jsr " + file + options);
  };
  const Run golden = with(R"({"matrices": [[["1","1"],["0","1"]], [[1,0],["2/2",1]]]})",
                          " --json --certificate " + file + ".cert");
  CHECK(golden.code == 0);
  CHECK(nlohmann::json::parse(golden.out).at("product").size() == 2);
  CHECK(has_digits(nlohmann::json::parse(golden.out).at("radius").at("lower"), "1.6180339887"));
  CHECK(run("verify " + file + ".cert").code == 0);
  const Run blocks = with(R"({"matrices": [[["2","7"],["0","1"]], [["1","5"],["0","-3"]]]})",
                          " --json --certificate " + file + ".cert");
  CHECK(blocks.code == 0);
  CHECK(nlohmann::json::parse(blocks.out).at("blocks") == nlohmann::json({1, 1}));
  CHECK(nlohmann::json::parse(blocks.out).at("exact") == true);
  CHECK(nlohmann::json::parse(blocks.out).at("radius").at("upper") == "3");
  CHECK(run("verify " + file + ".cert").code == 0);
  const Run nilpotent = with(R"({"matrices": [[["0","7"],["0","0"]], [["0","5"],["0","0"]]]})",
                             " --json --certificate " + file + ".cert");
  CHECK(nilpotent.code == 0);
  CHECK(nlohmann::json::parse(nilpotent.out).at("radius").at("upper") == "0");
  CHECK(run("verify " + file + ".cert").code == 0);
  for (const char* text :
       {"", "{", "[]", "{}", R"({"matrices": []})", R"({"matrices": 5})", R"({"matrices": [[]]})",
        R"({"matrices": [[["1","0"],["1"]]]})", R"({"matrices": [[["1/0"]]]})", R"({"matrices": [[[1.5]]]})",
        R"({"matrices": [[["1"]],[["1","0"],["0","1"]]]})", R"({"matrices": [[[null]]]})"}) {
    CAPTURE(text);
    CHECK(with(text).code == 65);
  }
  for (const char* ending : {"", ".cert", ".cert.matrices"}) fs::remove(file + ending);
  CHECK(run("jsr " + file).code == 66);
}

TEST_CASE("data are refined") {
  const fs::path folder = fs::temp_directory_path() / ("subcert-cli-refine-" + std::to_string(getpid()));
  fs::create_directories(folder);
  const std::string data = (folder / "data.csv").string(), out = (folder / "out.csv").string();
  const auto with = [&](const std::string& content, const std::string& arguments) {
    std::ofstream(data, std::ios::binary) << content;
    return run("refine " + arguments);
  };
  const std::string line = "x;y\n0;1\n1;3\n2;5\n3;7\n4;9\n";
  CHECK(with(line, "primal:n=1 " + data + " --levels 1").out ==
        "x;y\n0;1\n0.5;2\n1;3\n1.5;4\n2;5\n2.5;6\n3;7\n3.5;8\n4;9\n");
  CHECK(with(line, "dual:n=1 " + data + " --levels 2 --out " + out + " --plot " + out + ".svg").out.empty());
  CHECK(read(out).substr(0, 14) == "x;y\n0.125;1.25");
  CHECK(read(out + ".svg").find("<svg") != std::string::npos);
  CHECK(with("1\n0\n0\n0\n", "dual:n=1 " + data + " --closed --levels 1").out ==
        "0.75\n0.25\n0\n0\n0\n0\n0.25\n0.75\n");
  std::ofstream(data, std::ios::binary) << line;
  const auto json = run_json("refine dual:n=1 " + data + " --levels 3");
  CHECK(json.at("scheme") == "dual:n=1,d=1");
  CHECK(json.at("count") == 32);
  CHECK(json.at("first") == "1/16");
  CHECK(json.at("step") == "1/8");
  CHECK(json.at("points").at(31).size() == 2);

  CHECK(with("1\n2\n0\n4\n", "dd:n=2 " + data + " --limit --levels 0").out == "1\n2\n0\n4\n");
  CHECK(with("0\n1\n0\n0\n", "dual:n=1 --closed " + data + " --limit --levels 0").out == "0.125\n0.75\n0.125\n0\n");
  CHECK(run("refine 'mask:[1,1,1,1]/2@-2' " + data + " --limit").code == 0);
  CHECK(run("refine 'mask:[1,0,0,1]' " + data + " --limit").code == 1);
  CHECK(run("refine grid:points=2x2 " + data + " --limit").code == 64);
  const auto fails = [&](const std::string& content, const std::string& arguments, int code,
                         const std::string& message) {
    const Run result = with(content, arguments);
    CAPTURE(arguments);
    CHECK(result.code == code);
    CHECK(result.out.empty());
    CHECK(result.err == "subcert: " + message + "\n");
  };
  fails("", "primal:n=2 " + data, 65, data + ": expected rows of numbers; found none");
  fails("1\n", "primal:n=2 " + data, 65, data + ": expected at least 4 rows for primal:n=2,d=1; found 1");
  fails("1,2\n3\n", "primal:n=2 " + data, 65,
        data + ", line 2, column 2: expected 2 columns as in the first row; found 1");
  fails("1\ninf\n", "primal:n=2 " + data, 65, data + ", line 2, column 1: expected a finite number; found 'inf'");
  fails("1,5\n2,6\n3,5\n1,5\n", "primal:n=1 --closed " + data, 65,
        data + ", line 4: expected each point of a closed curve once; found the first row again");
  fails("1\n2\n", "primal:n=1 --levels 100000000 " + data, 64,
        "100000000 levels would make about 10^30103000 numbers of 2; need at most 100000000");
  fails(line, "primal:n=1 --plot x.pdf " + data, 64, "--plot x.pdf: expected a name that ends in .svg or .png");
  fails(line, "primal:n=1 --closed --boundary shrink " + data, 64,
        "--boundary shrink: closed data have no boundary; leave out one of the two options");
  CHECK(run("refine primal:n=1 " + data + " --boundary other").code == 64);
  CHECK(run("refine primal:n=1 " + folder.string() + "/nowhere.csv").code == 66);
  CHECK(run("refine primal:n=1 " + data + " --out /proc/nowhere/file").code == 66);
  fs::remove_all(folder);
}

TEST_CASE("surfaces and volumes are refined") {
  const fs::path folder = fs::temp_directory_path() / ("subcert-cli-surfaces-" + std::to_string(getpid()));
  fs::create_directories(folder);
  const auto file = [&](const char* name, const std::string& content) {
    std::ofstream(folder / name, std::ios::binary) << content;
    return (folder / name).string();
  };
  const std::string matrix = file("m.csv", "0,1,2\n4,5,6\n8,9,10\n");
  CHECK(run("refine 'tensor:(primal:n=1)x(primal:n=1)' " + matrix + " --levels 1").out ==
        "0,0.5,1,1.5,2\n2,2.5,3,3.5,4\n4,4.5,5,5.5,6\n6,6.5,7,7.5,8\n8,8.5,9,9.5,10\n");
  CHECK(run("refine grid:points=2x2 " + matrix + " --levels 1").out ==
        "1.25,1.75,2.25,2.75\n3.25,3.75,4.25,4.75\n5.25,5.75,6.25,6.75\n7.25,7.75,8.25,8.75\n");
  const auto json = run_json("refine grid:points=3x2 " + matrix + " --levels 2 --closed-x");
  CHECK(json.at("axes").at(0).at("count") == 12);
  CHECK(json.at("axes").at(0).at("closed") == true);
  CHECK(json.at("axes").at(1).at("count") == 8);
  CHECK(json.at("points").size() == 96);

  const std::string mesh = file("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 4\nf 1 2 4 3\n");
  const Run refined = run("refine 'tensor:(primal:n=1)x(primal:n=1)' " + mesh + " --levels 1 --plot " +
                          (folder / "m.png").string());
  CHECK(refined.out ==
        "v 0 0 0\nv 0.5 0 0\nv 1 0 0\nv 0 0.5 0\nv 0.5 0.5 1\nv 1 0.5 2\nv 0 1 0\nv 0.5 1 2\nv 1 1 4\n"
        "f 1 2 5 4\nf 2 3 6 5\nf 4 5 8 7\nf 5 6 9 8\n");
  CHECK(fs::file_size(folder / "m.png") > 1000);
  const std::string volume = file("v.vtk",
                                  "# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 2\n"
                                  "POINT_DATA 8\nSCALARS d float\nLOOKUP_TABLE default\n0 1 2 3 4 5 6 7\n");
  const std::string finer = run("refine grid:points=2x2x2 " + volume + " --levels 1").out;
  CHECK(finer.find("DIMENSIONS 2 2 2\nORIGIN 0.25 0.25 0.25\nSPACING 0.5 0.5 0.5\nPOINT_DATA 8\n") !=
        std::string::npos);

  const auto code = [&](const std::string& arguments) { return run("refine " + arguments).code; };
  CHECK(code("primal:n=1 " + mesh) == 64);
  CHECK(code("grid:points=2x2 " + volume) == 64);
  CHECK(code("grid:points=2x2x2 " + matrix) == 64);
  CHECK(code("grid:points=2x2 " + mesh + " --closed-x") == 64);
  CHECK(code("grid:points=2x2 " + matrix + " --closed-z") == 64);
  CHECK(code("grid:points=4x4 " + matrix) == 65);
  CHECK(code("grid:points=2x2 " + file("bad.obj", "v 0 0 0\nf 1 1 1 1\n")) == 65);
  CHECK(code("grid:points=2x2 " + file("bad.ply", "ply\nformat ascii 1.0\n")) == 65);
  CHECK(code("grid:points=2x2 " + file("bad.vtk", "nothing")) == 65);
  CHECK(code("grid:points=2x2 " + folder.string() + "/nowhere.ply") == 66);
  CHECK(code("grid:points=2x2 " + matrix + " --levels 90") == 64);
  fs::remove_all(folder);
}

TEST_CASE("data are refined by l1 regression") {
  const fs::path file = fs::temp_directory_path() / ("subcert-cli-l1-" + std::to_string(getpid()) + ".csv");
  const std::string data = file.string();
  std::ofstream(data) << "x,y\n0,0\n1,2\n2,4\n3,6\n4,999\n5,10\n6,12\n7,14\n8,16\n";
  const auto json = run_json("refine l1:points=8,iterations=60 " + data + " --levels 1");
  CHECK(json.at("scheme") == "l1:points=8,d=1,iterations=60,delta=1e-8");
  REQUIRE(json.at("count") == 16);
  for (const auto& point : json.at("points"))
    CHECK(std::abs(point[1].get<double>() - 2 * point[0].get<double>()) < 1e-3);
  CHECK(run("refine l1:points=8 " + data + " --closed --levels 2").code == 0);
  CHECK(run("refine l1:points=9,residuals=joint " + data + " --boundary reflect").code == 0);
  const auto fails = [&](const std::string& arguments, int code, const std::string& message) {
    const Run result = run("refine " + arguments);
    CAPTURE(arguments);
    CHECK(result.code == code);
    CHECK(result.err == "subcert: " + message + "\n");
  };
  fails("l1:points=10 " + data, 65,
        data + ": expected at least 10 rows for l1:points=10,d=1,iterations=6,delta=1e-8; found 9");
  fails("l1:points=6,d=4 " + data, 64, "scheme specification, position 15: '4'; expected d as an integer from 0 to 3");
  std::string matrix;
  for (int j = 0; j < 7; ++j)
    for (int i = 0; i < 8; ++i) matrix += (i == 3 && j == 3 ? "500" : std::to_string(i + 2 * j)) + (i < 7 ? "," : "\n");
  std::ofstream(data) << matrix;
  const auto surface = run_json("refine l1:points=4x4,iterations=60 " + data + " --levels 1");
  REQUIRE(surface.at("points").size() == 14 * 12);
  for (int o = 0; o < 14 * 12; ++o) {
    const int i = o % 14, j = o / 14;
    CHECK(std::abs(surface["points"][o][0].get<double>() - (0.25 + 0.5 * i + 2 * (0.25 + 0.5 * j))) < 1e-3);
  }
  CHECK(run("mask l1:points=6").code == 64);
  fs::remove(file);
}

TEST_CASE("data are smoothed") {
  const fs::path folder = fs::temp_directory_path() / ("subcert-cli-smooth-" + std::to_string(getpid()));
  fs::create_directories(folder);
  const std::string data = (folder / "data.csv").string(), out = (folder / "out.csv").string();
  const auto with = [&](const std::string& content, const std::string& arguments) {
    std::ofstream(data, std::ios::binary) << content;
    return run("smooth " + data + " " + arguments);
  };
  std::string line = "t,v,w\n", wave = "t,v\n";
  for (int i = 0; i < 12; ++i) line += std::to_string(i) + "," + std::to_string(2 * i + 1) + ",1\n";
  for (int i = 0; i < 60; ++i)
    wave += std::to_string(0.1 * i) + "," + std::to_string(std::sin(0.1 * i) + 0.1 * ((i * 7919) % 13 - 6) / 6) + "\n";

  CHECK(with("0,1\n1,3\n2,5\n3,7\n4,9\n", "--scheme primal:n=1 --level 1 --quiet --bands 0").out ==
        "column 1,column 2,sd\n0,1,0\n0.5,2,0\n1,3,0\n1.5,4,0\n2,5,0\n2.5,6,0\n3,7,0\n3.5,8,0\n4,9,0\n");
  CHECK(with(wave, "--out " + out + " --plot " + out + ".svg").out.empty());
  CHECK(read(out).find("# chosen for the smallest estimated mean squared error") != std::string::npos);
  CHECK(read(out + ".svg").find("<svg") != std::string::npos);
  std::ofstream(data, std::ios::binary) << wave;
  const auto json = run_json("smooth " + data + " --level 0 --boundary mirror");
  CHECK(json.at("auto") == true);
  CHECK(json.at("spacing") == "1/10");
  CHECK(json.at("choice").at("candidates").size() == 15 + 14 + 13);
  CHECK(json.at("choice").at("chosen").at("scheme") == json.at("scheme"));
  CHECK(json.at("columns") == nlohmann::json({"t", "v", "sd", "lower", "upper"}));
  REQUIRE(json.at("rows").size() == 60);
  for (const auto& row : json.at("rows")) {
    CHECK(row[3].get<double>() < row[1].get<double>());
    CHECK(row[1].get<double>() < row[4].get<double>());
    CHECK(std::abs(row[1].get<double>() - std::sin(row[0].get<double>())) < 0.1);
  }
  std::ofstream(data, std::ios::binary) << line;
  const auto slope = run_json("smooth " + data + " --scheme primal:n=3 --derivative 1 --y v --weights w");
  for (const auto& row : slope.at("rows")) CHECK(std::abs(row[1].get<double>() - 2) < 1e-12);
  for (const char* boundary : {"interp", "mirror", "nearest", "constant", "wrap"})
    CHECK(run("smooth " + data + " --y v --weights w --scheme dual:n=2 --boundary " + boundary).code == 0);
  const auto gap = with("0,1\n1,3\n2,\n3,7\n4,9\n5,11\n",
                        "--scheme primal:n=2 --missing drop --level 0 --bands 0 --quiet");
  CHECK(gap.code == 0);
  CHECK(gap.out.find("\n2,5") != std::string::npos);
  CHECK(with(line, "--y v --scheme l1:points=6 --level 1").code == 0);

  const auto fails = [&](const std::string& content, const std::string& arguments, int code,
                         const std::string& message) {
    const Run result = with(content, arguments);
    CAPTURE(arguments);
    CHECK(result.code == code);
    CHECK(result.out.empty());
    CHECK(result.err == "subcert: " + message + "\n");
  };
  fails("0,1\n1,2\n3,3\n4,5\n", "", 65,
        data +
            ", lines 2 and 3: expected a uniform grid, the mean spacing is 1.33333333; found the spacing 2 between 1 "
            "and 3");
  fails("0,1\n2,2\n1,3\n", "", 65, data + ", line 3, column 1: expected increasing positions; found 1 after 2");
  fails("0,1\n1,\n2,3\n", "", 65,
        data + ", line 2, column 2: expected a number; found a missing value (--missing drop leaves it out)");
  fails("0,1\n,2\n2,3\n", "--missing drop", 65,
        data + ", line 2, column 1: expected a position; found a missing value");
  fails("0,1,1\n1,2,-1\n2,3,1\n", "--weights 3", 65, data + ", line 2, column 3: expected a weight >= 0; found -1");
  fails("0,1\n1,2\n", "", 65, data + ": expected at least 4 rows to choose a scheme; found 2; name one with --scheme");
  fails(line, "--weights u", 64, "--weights u: expected a column from 1 to 3 or one of t, v, w");
  fails(line, "--y v --scheme primal:n=2 --derivative 3", 64,
        "--derivative 3: primal:n=2,d=1 is not proved to have continuous "
        "derivatives of that order; the mask has only 2 sum rules");
  fails(line, "--y v --weights w --scheme bspline:degree=3", 64,
        "smoothing: prior weights and missing data need a scheme of local regressions");
  fails(line, "--y v --scheme l1:points=6 --bands 0.9", 64,
        "--bands needs a linear scheme; l1:points=6,d=1,iterations=6,delta=1e-8 is none");
  fails("", "", 65, data + ": expected rows of numbers; found none");
  CHECK(with("5\n", "--scheme primal:n=2 --quiet").out == "x,column 1\n0,5\n");
  CHECK(run("smooth " + folder.string() + "/nowhere.csv").code == 66);
  CHECK(run("smooth " + data + " --boundary other").code == 64);
  CHECK(run("smooth " + data + " --auto --scheme primal:n=2").code == 64);
  fs::remove_all(folder);
}

TEST_CASE("help names an example in every subcommand") {
  for (const char* command : {"reproduce", "analyze", "mask", "regularity", "jsr", "verify", "limit", "variance",
                              "refine", "smooth", "experiment"}) {
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
  CHECK(run("mask dual:n=1 --out /proc/nowhere/file").code == 66);
}

TEST_CASE("statements: the fields of the contract") {
  const auto json = run_json("statements check dyn-2015/corollary-4 mustafa-bari-2016/eq-2.6");
  REQUIRE(json.at("statements").size() == 2);
  const auto& proved = json.at("statements").at(0);
  CHECK(proved.at("id") == "dyn-2015/corollary-4");
  CHECK(proved.at("verdict") == "holds-for-all-n");
  CHECK(proved.at("range") == "all n >= 2");
  const auto& misprint = json.at("statements").at(1);
  CHECK(misprint.at("verdict") == "misprint");
  CHECK(misprint.at("witness") == "n = 2, a = 3, q = 0, r = -2: printed 37/35, derived -3/35");
  CHECK_FALSE(misprint.at("corrected").get<std::string>().empty());

  const Run unknown = run("statements check nobody-1900/eq-1");
  CHECK(unknown.code == 64);
  CHECK(unknown.err.find("no statement or paper 'nobody-1900/eq-1'") != std::string::npos);
  CHECK(run("statements").out == run("statements list").out);

  const fs::path page = fs::temp_directory_path() / ("subcert-errata-" + std::to_string(getpid()) + ".html");
  CHECK(run("statements check dyn-2015/remark-9 --page " + page.string()).code == 0);
  const std::string text = read(page);
  fs::remove(page);
  CHECK(text.find("<h1>Errata and confirmations</h1>") != std::string::npos);
  CHECK(text.find("A^\\dagger = A^T (A A^T)^{-1}") != std::string::npos);
}

TEST_CASE("expected properties as a gate") {
  const std::string example = std::string(SUBCERT_DOCS) + "/examples/properties.toml";
  const Run good = run("check " + example);
  CHECK(good.code == 0);
  CHECK(good.out.find("FAILS") == std::string::npos);
  CHECK(good.out.find("9 properties: 9 hold, 0 fail, 0 undecided.") != std::string::npos);
  CHECK(read(std::string(SUBCERT_DOCS) + "/properties.md").find(read(example)) != std::string::npos);

  const fs::path file = fs::temp_directory_path() / ("subcert-properties-" + std::to_string(getpid()) + ".toml");
  const auto write = [&](const std::string& text) { std::ofstream(file, std::ios::binary) << text; };
  write("mask = 'dd:n=2'\nreproduces = 5\nstable = true\n");
  const Run bad = run("check " + file.string());
  CHECK(bad.code == 1);
  CHECK(bad.out.find(":2: dd:n=2: reproduces 5 (it is 3)") != std::string::npos);
  const auto json = run_json("check " + file.string(), 1);
  CHECK(json.at("properties").at(0).at("holds") == "no");
  CHECK(json.at("properties").at(1).at("holds") == "yes");
  write("mask = 'dd:n=2'\nreproduces = three\n");
  const Run broken = run("check " + file.string());
  CHECK(broken.code == 65);
  CHECK(broken.out.empty());
  CHECK(broken.err.find(", line 2, column ") != std::string::npos);
  fs::remove(file);
  CHECK(run("check " + file.string()).code == 66);
  CHECK(run("check").code == 64);
}
