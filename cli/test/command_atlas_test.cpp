#include "program.hpp"

#include <filesystem>
#include <fstream>

using namespace subcert::testing;

namespace {

/// Commands about one file.
struct Atlas {
  Folder folder;
  std::string file = folder / "atlas.sqlite";

  Run operator()(const std::string& words, const std::string& more = "") const {
    return run("atlas " + words + " --atlas " + file + " " + more);
  }
};

}  // namespace

TEST_CASE("atlas: a scheme is computed once, and found by all that have its limits") {
  const Atlas atlas;
  CHECK(atlas("dd:n=2", "--no-add").code == 2);
  CHECK_FALSE(std::filesystem::exists(atlas.file));
  const Run first = atlas("dd:n=2", "--json");
  CHECK(first.code == 0);
  const nlohmann::json entry = nlohmann::json::parse(first.out);
  CHECK(entry.at("scheme") == "dd:n=2");
  CHECK(entry.at("holder").at("upper") == "2");
  CHECK(entry.at("interpolatory") == true);
  CHECK(entry.at("attained") == false);
  CHECK(entry.at("names") == nlohmann::json({"dd:n=2"}));
  const auto id = entry.at("id").get<std::string>();
  for (const std::string& same : {std::string("'mask:[-1,0,9,16,9,0,-1]/16@5'"), std::string("four-point:w=1/16"), id})
    CHECK(nlohmann::json::parse(atlas(same, "--json --no-add").out).at("id") == id);
  const Run page = atlas("dd:n=2");
  CHECK(contains(page.out, "\nholder               2\n"));
  CHECK(contains(page.out, "\nlogarithm            power 1, by the growth"));
  const std::string certificate = atlas.folder / "dd.cert";
  CHECK(atlas("dd:n=2", "--certificate " + certificate).code == 0);
  CHECK(run("verify " + certificate).code == 0);
  CHECK(atlas("0123456789ab").code == 2);
  CHECK(run("atlas").code == 64);
  CHECK(atlas("daubechies:n=2").code == 64);
  CHECK(contains(run("atlas --members").out, "\nnoise_factor         largest variance"));
}

TEST_CASE("atlas: several steps are their scheme") {
  const Atlas atlas;
  CHECK(atlas("chaikin").code == 0);
  CHECK(contains(atlas("'mask:[1,3,6,10,12,12,10,6,3,1]/16,arity=4'", "--no-add").out, "mask:[1,3,3,1]/4@0\n"));
}

TEST_CASE("atlas: surfaces, whatever the basis of the lattice") {
  const Atlas atlas;
  const Run loop = atlas("loop", "--json");
  CHECK(loop.code == 0);
  const nlohmann::json entry = nlohmann::json::parse(loop.out);
  CHECK(entry.at("variables") == 2);
  CHECK(entry.at("holder").at("lower") == "3");
  CHECK(entry.at("support").is_null());
  CHECK(entry.at("stable") == "yes");
  const Run slanted = atlas("'box:[1,0;1,0;0,1;0,1;1,-1;1,-1]'", "--no-add");
  CHECK(slanted.code == 0);
  CHECK(contains(slanted.out, "\nnames                loop\n"));
  const std::string certificate = atlas.folder / "loop.cert";
  CHECK(atlas("loop", "--certificate " + certificate).code == 0);
  CHECK(run("verify " + certificate).code == 0);
  CHECK(atlas("build chaikin quincunx 'tensor:(dd:n=2)x(dd:n=2)'").code == 0);
  CHECK(contains(atlas("query 'variables == 2'").err, "3 of 4 entries; open 0"));
  CHECK(contains(atlas("query 'support <= 3'").err, "1 of 4 entries; open 0"));
  CHECK(contains(atlas("query 'arity == 2'").err, "3 of 4 entries; open 0"));
  CHECK(contains(atlas("query 'holder > 2.5 and symmetric'").err, "1 of 4 entries; open 0"));
  CHECK(atlas("site --out " + (atlas.folder / "pages")).code == 0);
  CHECK(contains(content(atlas.folder / "pages/index.html"), "surface, another dilation, interpolatory, symmetric"));
}

TEST_CASE("atlas: built by a plan, continued, asked") {
  const Atlas atlas;
  CHECK(contains(atlas("build 'dd:n=1..3'").out, ": 3 schemes, 3 masks, 3 added; 3 entries\n"));
  const Run more = atlas("build 'dd:n=1..4' daubechies:n=2");
  CHECK(more.code == 0);
  CHECK(contains(more.out, ": 5 schemes, 4 masks, 1 added; 4 entries\n"));
  CHECK(contains(more.err, "not entered: daubechies:n=2: atlas: need a mask of rational numbers"));
  const std::string plan = atlas.folder.write("plan.toml",
                                              "schemes = [\"four-point:w=0..1/8 step 1/16\"]\nbudget = 1\n");
  CHECK(contains(atlas("build " + plan).out, ": 3 schemes, 3 masks, 1 added; 5 entries\n"));

  const Run found = atlas("query 'holder > 2 and support <= 10 and interpolatory'", "--columns scheme,holder.upper");
  CHECK(found.code == 0);
  CHECK(contains(found.out, "\ndd:n=3,2.83007499"));
  CHECK(contains(found.err, "1 of 5 entries; open 0\n"));
  const nlohmann::json all = nlohmann::json::parse(atlas("query 'arity == 2'", "--json").out);
  CHECK(all.at("entries").size() == 5);
  CHECK(all.at("open").empty());
  CHECK(nlohmann::json::parse(atlas("query 'holder > 2.83007499855768763'", "--json").out).at("entries").size() == 2);
  CHECK(atlas("query 'holdr > 2'").code == 64);
  CHECK(contains(atlas("query interpolatory", "--columns id,holdr").err, "'holdr'; expected a member of an entry"));
  CHECK(run("atlas query interpolatory --atlas " + (atlas.folder / "none")).code == 66);
}

TEST_CASE("atlas: the one that came with the program") {
  const Folder folder;
  const std::string shipped = folder / "share/subcert/atlas.sqlite", program = folder / "bin/subcert";
  CHECK(run("atlas build chaikin --atlas " + shipped).code == 0);
  std::filesystem::create_directories(folder / "bin");
  std::filesystem::copy_file(SUBCERT_PROGRAM, program);
  const std::string before = content(shipped);
  const Run found = run_command("env -i " + program + " atlas bspline:degree=2 --no-add");
  CHECK(found.code == 0);
  CHECK(contains(found.out, "\nmask                 mask:[1,3,3,1]/4@0\n"));
  CHECK(contains(run_command("env -i " + program + " atlas query 'arity == 2'").err, "1 of 1 entries"));
  // what it has not is added to the user's own
  CHECK(contains(run_command("env -i " + program + " atlas dd:n=2").err, "neither XDG_DATA_HOME nor HOME is set"));
  const std::string own = "env XDG_DATA_HOME=" + (folder / "data ") + program;
  CHECK(run_command(own + " atlas dd:n=2").code == 0);
  CHECK(contains(run_command(own + " atlas query 'arity == 2'").err, "2 of 2 entries"));
  CHECK(std::filesystem::exists(folder / "data/subcert/atlas.sqlite"));
  CHECK(content(shipped) == before);
  CHECK(!contains(run_command(own + " atlas query 'arity == 2'").err, "no atlas came"));
  std::filesystem::remove(shipped);
  CHECK(
      contains(run_command(own + " atlas query 'arity == 2'").err, "no atlas came with this program; 'subcert atlas"));
}

TEST_CASE("atlas: shards, joined, are the whole") {
  const Atlas atlas;
  const std::string schemes = "build 'masks:length=2..4,numerators=5,denominator=4'", all = "query 'arity == 2'";
  CHECK(atlas(schemes).code == 0);
  const std::string whole = atlas(all).out;
  std::string journals;
  for (const char* shard : {"1", "2"}) {
    const std::string journal = atlas.folder / shard;
    CHECK(
        run("atlas " + schemes + " --atlas " + journal + ".sqlite --shard " + shard + "/2 --journal " + journal).code ==
        0);
    journals += " " + journal;
  }
  const std::string merged = atlas.folder / "merged";
  CHECK(run("merge" + journals + " --out " + merged).code == 0);
  CHECK(run("atlas " + schemes + " --journal " + merged + " --atlas " + merged + ".sqlite").code == 0);
  CHECK(run("atlas " + all + " --atlas " + merged + ".sqlite").out == whole);
  CHECK(whole.size() > 500);
}

TEST_CASE("atlas: pages") {
  const Atlas atlas;
  CHECK(atlas("build 'dd:n=1..4' 'mask:[1,0,0,1]' 'mask:[1,2,1]/2'", "--certificates").code == 0);
  const std::string pages = atlas.folder / "pages", index = pages + "/index.html";
  CHECK(atlas("site --out " + pages, "--where interpolatory").out == index + ": 5 entries\n");
  const std::string table = content(index);
  for (const char* row :
       {"4.html#4e12bc63ac43\">4e12bc63ac43</a>", "<td>dd:n=4<br>", "interpolatory, symmetric, stable"})
    CHECK(contains(table, row));
  const std::string page = content(pages + "/4.html"), certificate = pages + "/certificates/4e12bc63ac43.cert";
  CHECK(contains(page, "<article class=plate id=\"4e12bc63ac43\">"));
  CHECK(contains(page, "<svg class=\"picture"));
  CHECK(contains(page, "data-certificate=\"certificates/4e12bc63ac43.cert.js\""));
  CHECK(run("verify " + certificate).code == 0);
  CHECK(content(certificate + ".js").starts_with("subcert_file(\"certificates/4e12bc63ac43.cert.js\", {"));
  const std::string divergent = content(pages + "/6.html");  // no picture, no proof
  CHECK_FALSE(contains(divergent, "<svg class=\"picture"));
  CHECK_FALSE(contains(divergent, "data-certificate"));
  CHECK(atlas("site").code == 64);
  CHECK(atlas("site --out " + (atlas.folder / "two"), "--where 'dimension == 2'").code == 64);
}

TEST_CASE("atlas: what cannot be read or written is one line") {
  const Atlas atlas;
  const auto refused = [&](int code, const std::string& words) {
    const Run result = atlas("dd:n=1");
    CAPTURE(result.err);
    CHECK(result.code == code);
    CHECK(contains(result.err, "atlas " + atlas.file + ": " + words));
  };
  std::ofstream(atlas.file) << std::string(5000, 'x');
  refused(65, "is no atlas, but something else\n");
  std::filesystem::remove(atlas.file);
  std::filesystem::create_directory(atlas.file);
  CHECK(atlas("dd:n=1").code == 66);
  std::filesystem::remove(atlas.file);
  CHECK(atlas("build dd:n=1").code == 0);
  const std::string whole = content(atlas.file);
  std::ofstream(atlas.file) << whole.substr(0, 5000);
  CHECK(atlas("query interpolatory").code == 65);
  // A full disk.
  std::ofstream(atlas.file) << whole;
  const Run full = run_command("ulimit -f 24; " SUBCERT_PROGRAM " atlas build 'dd:n=2..9' --atlas " + atlas.file);
  CHECK(full.code == 66);
  CHECK(contains(full.err, "atlas " + atlas.file + ": "));
  CHECK(atlas("query interpolatory").code == 0);
}
