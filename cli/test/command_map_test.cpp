#include "program.hpp"

#include <filesystem>
#include <fstream>

using namespace subcert::testing;

namespace {

const std::string six_points = "'mask:[t,0,-w-3*t,0,1/2+w+2*t,1,1/2+w+2*t,0,-w-3*t,0,t]'";

}  // namespace

TEST_CASE("a map of two parameters, as text, JSON, table and picture") {
  const std::string folder = std::filesystem::temp_directory_path() / "subcert_map_test";
  std::filesystem::create_directories(folder);
  const std::string map = "map " + six_points + " --over w=-1/8..1/4 --over t=-1/16..1/16 --property C1 --resolution 8";
  const Run page = run(map + " --plot " + folder + "/map.svg --csv " + folder + "/map.csv");
  CHECK(page.code == 0);
  CHECK(page.out.find("sum rules    2 for all w and t\n") != std::string::npos);
  CHECK(page.out.find("proved       ") != std::string::npos);
  CHECK(std::filesystem::file_size(folder + "/map.svg") > 1000);
  CHECK(std::filesystem::file_size(folder + "/map.csv") > 300);
  std::filesystem::remove_all(folder);
  const auto json = run_json(map);
  CHECK(json.at("cells").size() > 10);
  // The scheme may stand behind the ranges.
  CHECK(run("map --over w=0..1/8 --over t=0..1/64 " + six_points + " --property C1 --resolution 2").code == 0);
  CHECK(json.at("shares").at("proved").is_string());
  CHECK(json.at("cells")[0].at("verdict").is_string());
}

TEST_CASE("a map of three parameters, as text, JSON and table") {
  const std::string file = (std::filesystem::temp_directory_path() / "subcert_map_test.csv").string();
  const std::string map =
      "map 'mask:[-w,0,1/2+w+s*t,1,1/2+w-s*t,0,-w]' --over w=-1/8..1/8 --over s=0..1/4 --over t=0..1/4 "
      "--property convergent --resolution 2";
  const Run page = run(map + " --csv " + file);
  CHECK(page.code == 0);
  CHECK(page.out.find("sum rules    1 for all w, s and t\n") != std::string::npos);
  CHECK(page.out.find(" % of the volume, ") != std::string::npos);
  CHECK(std::filesystem::file_size(file) > 40);
  std::filesystem::remove(file);
  CHECK(run_json(map).at("cells")[0].at("from").size() == 3);
  const Run refused = run(map + " --plot map.svg");
  CHECK(refused.code == 64);
  CHECK(refused.err.find("--plot: expected two ranges, got 3") != std::string::npos);
}

TEST_CASE("a map of Merrien's scheme, whose coefficients are matrices") {
  const std::string map =
      "map merrien:lambda,mu --over lambda=-3/16..-1/16 --over mu=-3/2..-1/2 --property HC1 --resolution 2";
  const auto json = run_json(map);
  CHECK(json.at("sum_rules") == 2);
  CHECK(json.at("family") == "merrien:lambda,mu");
  CHECK(json.at("shares").at("proved") == "1");
  CHECK(run_json("map 'hermite:[[[1/2,l],[1/2-m/2,m/4]],[[1,0],[0,1/2]],[[1/2,-l],[m/2-1/2,m/4]]]@-1' "
                 "--over l=-3/16..-1/16 --over m=-3/2..-1/2 --property HC1 --resolution 2")
            .at("cells") == json.at("cells"));
}

TEST_CASE("a map of two weights at a vertex, as text, JSON, table and picture") {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "subcert_weight_map_test";
  std::filesystem::create_directories(folder);
  const std::string file = std::string(SUBCERT_DOCS) + "/examples/vertices/catmull-clark-weights.toml";
  const std::string map = "map " + file + " --over a=0..1 --over b=-1/2..1/2 --valence 5 --resolution 4 --property ";
  const Run page = run(map + "C1 --plot " + (folder / "map.svg").string() + " --csv " + (folder / "map.csv").string());
  CHECK(page.code == 0);
  CHECK(page.out.find("valence      5\n") != std::string::npos);
  CHECK(std::filesystem::file_size(folder / "map.svg") > 1000);
  const auto json = run_json(map + "C1");
  CHECK(json.at("valence") == 5);
  CHECK(json.at("cells")[0].at("from").size() == 2);
  // Curvature is bounded at fewer values, and cells with the letters in another order are the same.
  CHECK(run_json(map + "bounded-curvature").at("shares").at("proved") != json.at("shares").at("proved"));
  CHECK(run_json("map " + file + " --over b=-1/2..1/2 --over a=0..1 --valence 5 --resolution 4 --property C1")
            .at("shares") == json.at("shares"));
  // A letter with a value may keep it.
  const std::string rules = (folder / "rules.toml").string();
  std::ofstream(rules) << "scheme = \"loop\"\nletter = [\"a\", \"b\", \"d\"]\nvalue = [\"1\", 0, \"3/8\"]\n[[rule]]\n"
                          "weights = {vertex = \"1 - a*d - b\", neighbours = \"(a*d + b)/n\"}\n";
  CHECK(run("map " + rules + " --over a=0..2 --over b=0..1 --valence 3 --resolution 2 --property C1").code == 0);
  CHECK(run("vertex " + rules + " --over d=3/10..1/2 --valence 4").code == 0);
  CHECK(run("map " + rules + " --over a=0..2 --over b=0..1 --over d=1/4..1/2 --valence 3 --resolution 2 --property C1")
            .code == 0);
  for (const std::string words : {" --valence 5", " --valence 5 --property C2", " --valence 4,5 --property C1",
                                  " --property C1", " --valence 2 --property C1"}) {
    CAPTURE(words);
    CHECK(run("map " + file + " --over a=0..1 --over b=0..1" + words).code == 64);
  }
  const Run unknown = run("map " + file + " --over a=0..1 --over x=0..1 --valence 5 --property C1");
  CHECK(unknown.code == 64);
  CHECK(unknown.err.find("need a range for each letter without a value") != std::string::npos);
  CHECK(run("vertex " + file + " --over a=0..1").code == 64);
  CHECK(run("map four-point:w --over w=0..1 --over t=0..1 --property C1 --valence 5").code == 64);
  std::filesystem::remove_all(folder);
}

TEST_CASE("maps that make no sense are refused in one line") {
  for (const std::string& arguments : std::initializer_list<std::string>{
           six_points + " --over w=0..1 --property C1", six_points + " --over w=0..1 --over w=0..1 --property C1",
           six_points + " --over w=0..1 --over s=0..1 --property C1",
           six_points + " --over w=1..0 --over t=0..1 --property C1",
           six_points + " --over w=0..1 --over t=0..1 --property D1",
           six_points + " --over w=0..1 --over t=0..1 --property C2", six_points + " --over w=0..1 --over t=0..1",
           std::string("four-point:w --over w=0..1 --over t=0..1 --property C1"),
           std::string("hermite-dd:points=w,order=t --over w=0..1 --over t=0..1 --property HC1"),
           std::string("merrien:lambda,mu --over lambda=0..1 --over nu=0..1 --property HC1"),
           std::string("merrien:lambda,mu --over lambda=0..1 --over mu=0..1 --property HC2"),
           std::string("merrien:lambda,mu --over lambda=0..1 --over mu=0..1 --property stable"),
           six_points + " --over w=0..1 --over t=0..1 --property HC1",
           six_points + " --over w=0..1 --over t=0..1 --property C1 --plot map.gif"}) {
    CAPTURE(arguments);
    const Run refused = run("map " + arguments);
    CHECK(refused.code == 64);
  }
}
