#include "program.hpp"

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
