#include "program.hpp"

using namespace subcert::testing;

TEST_CASE("matrices from a file") {
  const Folder folder;
  const std::string file = folder / "file.json";
  const auto with = [&](const std::string& text, const std::string& options = "") {
    std::ofstream(file, std::ios::binary) << text;
    return run("jsr " + file + options);
  };
  const Run golden = with(R"({"matrices": [[["1","1"],["0","1"]], [[1,0],["2/2",1]]]})",
                          " --json --certificate " + file + ".cert");
  CHECK(golden.code == 0);
  CHECK(nlohmann::json::parse(golden.out).at("product").size() == 2);
  CHECK(has_digits(nlohmann::json::parse(golden.out).at("radius"), "lower", "1.6180339887"));
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
  std::filesystem::remove(file);
  CHECK(run("jsr " + file).code == 66);
}
