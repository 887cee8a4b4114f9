#include "program.hpp"

using namespace subcert::testing;

TEST_CASE("journals are joined") {
  const Folder folder;
  const std::string a = folder / "a", b = folder / "b", out = folder / "out";
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
  CHECK(content(out) == header + line);
  CHECK(run_json("merge " + a + " --out " + out).at("cases") == 1);
  CHECK(run("merge " + a).code == 64);
  CHECK(run("merge --out " + out).code == 64);
  CHECK(run("merge " + a + " " + folder / "nowhere --out " + out).code == 66);
  std::ofstream(b, std::ios::binary) << "thesis\n";
  CHECK(run("merge " + a + " " + b + " --out " + out).code == 65);
  CHECK(run("merge " + a + " --out " + b).code == 65);
  CHECK(content(b) == "thesis\n");
}
