#include "program.hpp"

using namespace subcert::testing;

TEST_CASE("data are refined") {
  const Folder folder;
  const std::string data = folder / "data.csv", out = folder / "out.csv";
  const auto with = [&](const std::string& content, const std::string& arguments) {
    std::ofstream(data, std::ios::binary) << content;
    return run("refine " + arguments);
  };
  const std::string line = "x;y\n0;1\n1;3\n2;5\n3;7\n4;9\n";
  CHECK(with(line, "primal:n=1 " + data + " --levels 1").out ==
        "x;y\n0;1\n0.5;2\n1;3\n1.5;4\n2;5\n2.5;6\n3;7\n3.5;8\n4;9\n");
  CHECK(with(line, "dual:n=1 " + data + " --levels 2 --out " + out + " --plot " + out + ".svg").out.empty());
  CHECK(content(out).starts_with("x;y\n0.125;1.25"));
  CHECK(content(out + ".svg").find("<svg") != std::string::npos);
  CHECK(with("1\n0\n0\n0\n", "dual:n=1 " + data + " --closed --levels 1").out ==
        "0.75\n0.25\n0\n0\n0\n0\n0.25\n0.75\n");
  std::ofstream(data, std::ios::binary) << line;
  CHECK(run("refine primal:n=1 - --levels 1 --out - < " + data).out ==
        run("refine primal:n=1 " + data + " --levels 1").out);
  check_fails(run("refine primal:n=2 - < /dev/null"), 65, "standard input: expected rows of numbers; found none");
  const auto json = run_json("refine dual:n=1 " + data + " --levels 3");
  CHECK(json.at("scheme") == "dual:n=1,d=1");
  CHECK(json.at("count") == 32);
  CHECK(json.at("first") == "1/16");
  CHECK(json.at("step") == "1/8");
  CHECK(json.at("points").at(31).size() == 2);
  const auto written = run("refine dual:n=1 " + data + " --levels 3 --json").out;
  CHECK(written == nlohmann::ordered_json::parse(written).dump(2) + "\n");

  CHECK(with("1\n2\n0\n4\n", "dd:n=2 " + data + " --limit --levels 0").out == "1\n2\n0\n4\n");
  CHECK(with("0\n1\n0\n0\n", "dual:n=1 --closed " + data + " --limit --levels 0").out == "0.125\n0.75\n0.125\n0\n");
  CHECK(run("refine 'mask:[1,1,1,1]/2@-2' " + data + " --limit").code == 0);
  CHECK(run("refine 'mask:[1,0,0,1]' " + data + " --limit").code == 1);
  CHECK(run("refine grid:points=2x2 " + data + " --limit").code == 64);
  const auto fails = [&](const std::string& content, const std::string& arguments, int code,
                         const std::string& message) {
    CAPTURE(arguments);
    check_fails(with(content, arguments), code, message);
  };
  fails("", "primal:n=2 " + data, 65, data + ": expected rows of numbers; found none");
  // The rule of four points on the three of a triangle, and six points on two.
  CHECK(with("0,0\n1,0\n0,1\n", "four-point:w=1/16 " + data + " --closed --levels 1").out ==
        "0,0\n0.5625,-0.125\n1,0\n0.5625,0.5625\n0,1\n-0.125,0.5625\n");
  CHECK(with("0\n1\n", "primal:n=3 " + data + " --closed --levels 2").code == 0);
  fails("1\n", "primal:n=2 " + data, 65, data + ": expected at least 4 rows for primal:n=2,d=1; found 1");
  fails("1,2\n3\n", "primal:n=2 " + data, 65,
        data + ", line 2, column 2: expected 2 columns as in the first row; found 1");
  fails("1\ninf\n", "primal:n=2 " + data, 65, data + ", line 2, column 1: expected a finite number; found 'inf'");
  fails("1,5\n2,6\n3,5\n1,5\n", "primal:n=1 --closed " + data, 65,
        data + ", line 4: expected each point of a closed curve once; found the first row again");
  fails("1\n2\n", "primal:n=1 --levels 100000000 " + data, 64,
        "100000000 levels would make about 10^30103000 numbers of 2; need at most 1000000000");
  fails(line, "primal:n=1 --plot x.eps " + data, 64,
        "--plot x.eps: expected a name that ends in .svg, .png, .pdf, .tex (TikZ) or .html");
  fails(line, "primal:n=1 --closed --boundary shrink " + data, 64,
        "--boundary shrink: closed data have no boundary; leave out one of the two options");
  CHECK(run("refine primal:n=1 " + data + " --boundary other").code == 64);
  CHECK(run("refine primal:n=1 " + folder / "nowhere.csv").code == 66);
  CHECK(run("refine primal:n=1 " + data + " --out /proc/nowhere/file").code == 66);
}

TEST_CASE("surfaces and volumes are refined") {
  const Folder folder;
  const auto file = [&](const char* name, const std::string& content) { return folder.write(name, content); };
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
                          folder / "m.png");
  CHECK(refined.out ==
        "v 0 0 0\nv 0.5 0 0\nv 1 0 0\nv 0 0.5 0\nv 0.5 0.5 1\nv 1 0.5 2\nv 0 1 0\nv 0.5 1 2\nv 1 1 4\n"
        "f 1 2 5 4\nf 2 3 6 5\nf 4 5 8 7\nf 5 6 9 8\n");
  CHECK(std::filesystem::file_size(folder / "m.png") > 1000);
  const std::string volume = file("v.vtk",
                                  "# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 2\n"
                                  "POINT_DATA 8\nSCALARS d float\nLOOKUP_TABLE default\n0 1 2 3 4 5 6 7\n");
  const std::string finer = run("refine grid:points=2x2x2 " + volume + " --levels 1").out;
  CHECK(finer.find("DIMENSIONS 2 2 2\nORIGIN 0.25 0.25 0.25\nSPACING 0.5 0.5 0.5\nPOINT_DATA 8\n") !=
        std::string::npos);

  // What is refined beside the coordinates, and what is not.
  const std::string coloured = file("c.obj",
                                    "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 0 0 1\nv 1 1 4 0 0 1\nvn 0 0 1\n"
                                    "f 1//1 2//1 4//1 3//1\n");
  const Run colours = run("refine 'tensor:(primal:n=1)x(primal:n=1)' " + coloured + " --levels 1");
  CHECK(colours.out.find("v 0.5 0.5 1 0.5 0 0.5\n") != std::string::npos);
  CHECK(colours.err == "subcert: note: " + coloured + ": refined as x, y, z are: red, green, blue\nsubcert: note: " +
                           coloured + ": left out: normals and texture coordinates\n");
  CHECK(run("refine 'tensor:(primal:n=1)x(primal:n=1)' " + coloured + " --levels 1 --plot " + folder / "c.svg").code ==
        0);
  CHECK(run_json("refine grid:points=2x2 " + coloured + " --levels 1 --quiet").at("columns") ==
        nlohmann::json({"x", "y", "z", "red", "green", "blue"}));
  const std::string arrays = file("a.vtk",
                                  "# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 1\n"
                                  "CELL_DATA 1\nSCALARS c int\nLOOKUP_TABLE default\n7\nPOINT_DATA 4\n"
                                  "VECTORS v float\n0 0 0 1 0 0 0 1 0 1 1 4\nFIELD f 1\nd 1 4 int\n0 1 2 3\n");
  const Run finer_arrays = run("refine 'tensor:(primal:n=1)x(primal:n=1)' " + arrays + " --levels 1");
  CHECK(finer_arrays.out.ends_with(
      "POINT_DATA 9\nVECTORS v double\n0 0 0\n0.5 0 0\n1 0 0\n0 0.5 0\n0.5 0.5 1\n1 0.5 2\n0 1 0\n0.5 1 2\n1 1 4\n"
      "FIELD FieldData 1\nd 1 9 double\n0\n0.5\n1\n1\n1.5\n2\n2\n2.5\n3\n"));
  CHECK(finer_arrays.err == "subcert: note: " + arrays + ": left out: CELL_DATA\n");

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
  CHECK(code("grid:points=2x2 " + folder / "nowhere.ply") == 66);
  CHECK(code("grid:points=2x2 " + matrix + " --levels 90") == 64);
}

TEST_CASE("rules of a file refine meshes") {
  const Folder folder;
  const auto file = [&](const std::string& name, const std::string& text) {
    std::ofstream(folder / name, std::ios::binary) << text;
    return folder / name;
  };
  const std::string tetrahedron = file("t.obj",
                                       "v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nf 1 2 3\nf 1 3 4\nf 1 4 2\n"
                                       "f 2 4 3\n");
  const std::string half = file("half.toml",
                                "scheme = \"loop\"\n[[rule]]\nvalence = 3\n"
                                "weights = {vertex = \"1/2\", neighbours = \"1/(2*n)\"}\n");
  const auto json = run_json("refine " + half + " " + tetrahedron + " --levels 1");
  CHECK(json.at("scheme") == half);
  CHECK(json.at("points").at(0).at(0).get<double>() == Approx(1.0 / 3));  // 1/2 - 1/2 1/3
  CHECK(run("refine " + half + " " + tetrahedron + " --levels 2 --limit --normals --out " + folder / "o.ply").code ==
        0);
  const std::string star = file("s.obj",
                                "v 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nf 1 2 3\nf 1 3 4\nf 1 4 5\nf 1 5 2\n");
  check_fails(
      run("refine " + half + " " + star + " --levels 1"), 65,
      half +
          ", line 4, column 11, 'weights': no rule of the point (0,0) is for valence 4; expected one, as the file "
          "replaces the scheme's rules of this point at all valences");
  check_fails(run("refine " + half + " samples.csv"), 64,
              half + ": rules at vertices refine meshes, .obj, .ply, .off, .stl; got samples.csv");
  check_fails(run("refine " + half + " " + star + " --start v0=1"), 64,
              half + ": rules at vertices are the same on all levels");
  const std::string loose = std::string(SUBCERT_DOCS) + "/examples/vertices/loop-weight.toml";
  check_fails(run("refine " + loose + " " + star), 64,
              loose + ": the letter b has no value; refine needs one in the file, as value = \"3/8\"");
  check_fails(run("refine " + folder / "none.toml" + " " + star), 66, folder / "none.toml" + ": no such file");
}

TEST_CASE("meshes of any topology are refined") {
  const Folder folder;
  const auto file = [&](const char* name, const std::string& content) { return folder.write(name, content); };
  const std::string tetrahedron = file("t.obj",
                                       "v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nvn 0 0 1\nf 1 2 3\nf 1 3 4\n"
                                       "f 1 4 2\nf 2 4 3\n");
  const Run once = run("refine loop " + tetrahedron + " --levels 1");
  CHECK(once.out.starts_with("v 0.25 0.25 0.25\nv 0.25 -0.25 -0.25\n"));
  CHECK(once.err == "subcert: note: " + tetrahedron + ": left out: normals and texture coordinates\n");
  // Another format by the name of the answer; limits stay from level to level.
  const auto written = [&](const char* name, const std::string& arguments) {
    const std::string path = folder / name;
    const Run refined = run("refine " + arguments + " --quiet --out " + path);
    CHECK(refined.code == 0);
    CHECK(refined.err.empty());
    return content(path);
  };
  CHECK(written("a.ply", "loop: " + tetrahedron + " --levels 2 --limit")
            .starts_with("ply\nformat ascii 1.0\nelement vertex 34\nproperty double x\n"));
  CHECK(written("a.off", "doo-sabin " + tetrahedron + " --levels 1").starts_with("OFF\n12 14 0\n"));
  CHECK(
      written("a.off", "triangular:L=17/10,d=2 " + tetrahedron + " --levels 1 --limit").starts_with("OFF\n10 16 0\n"));
  CHECK(written("a.stl", "sqrt3 " + tetrahedron + " --levels 1").starts_with("solid mesh\nfacet normal "));
  CHECK(written("b.obj", "catmull-clark " + folder / "a.off" + " --levels 1 --normals").find("vn ") !=
        std::string::npos);
  CHECK(run("refine loop " + folder / "a.stl" + " --levels 1 --json --quiet").code == 0);
  const auto json = run_json("refine catmull-clark " + folder / "b.obj" + " --levels 0 --limit --normals --quiet");
  CHECK(json.at("columns") == nlohmann::json({"x", "y", "z", "nx", "ny", "nz"}));
  CHECK(json.at("faces").size() == 48);
  CHECK(json.at("points").at(0).size() == 6);
  // All edges of a tetrahedron are sharp: its corners stay.
  CHECK(run("refine loop " + tetrahedron + " --levels 2 --limit --crease 60 --quiet")
            .out.starts_with("v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\n"));
  check_fails(run("refine loop " + tetrahedron + " --crease 60 --normals --quiet"), 64,
              "crease: loop: creases are made by loop and catmull-clark, in space and without normals");
  const std::string text = run("refine loop " + tetrahedron + " --levels 1 --json --quiet").out;
  CHECK(text == nlohmann::ordered_json::parse(text).dump(2) + "\n");

  const auto fails = [&](const std::string& arguments, int code, const std::string& message) {
    CAPTURE(arguments);
    check_fails(run("refine " + arguments + " --quiet"), code, message);
  };
  const std::string square = file("s.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"),
                    turned = file("u.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 3 1 4\n"),
                    seam = file("d.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 0\nv 1 1 0\nf 1 2 3\nf 5 6 4\n");
  fails("loop " + square, 65, square + ", line 5: expected triangles for loop; found a face of 4 vertices");
  fails("loop " + turned, 65,
        turned +
            ", line 5: expected faces that go around alike, so that two have their edge in opposite directions; "
            "found one in the same direction; " +
            turned + ", line 6 has it, too");
  fails("loop " + seam, 65,
        seam +
            ", line 7: expected each vertex once; found an edge of the boundary whose ends are at the same places as "
            "those of another one (--join makes one vertex of equal ones); " +
            seam + ", line 8 has it, too");
  CHECK(run("refine loop " + seam + " --join --levels 1").out.find("f 1 ") != std::string::npos);
  fails("catmull-clark " + square + " --boundary shrink", 64,
        "--boundary: catmull-clark: a mesh has the boundary rules of the scheme");
  fails("catmull-clark " + square + " --closed", 64,
        "--closed: catmull-clark: the faces of a mesh say where it is closed");
  fails("catmull-clark " + square + " --plot " + folder / "x.svg", 64,
        "--plot: catmull-clark: meshes that are no grids are not drawn; --out writes .obj, .ply, .off, .stl");
  fails("catmull-clark " + square + " --out " + folder / "x.stl", 64,
        "--out: an STL file holds triangles; catmull-clark makes other faces: write .obj, .ply or .off");
  fails("loop " + tetrahedron + " --normals --out " + folder / "x.stl", 64,
        "--normals: an STL file has none at vertices; write .obj, .ply or .off");
  fails(
      "'tensor:(primal:n=1)x(primal:n=1)' " + square + " --normals", 64,
      "--normals: of a mesh and one of butterfly, catmull-clark, doo-sabin, loop, midedge, modified-butterfly, sqrt3, "
      "triangular; tensor:(primal:n=1,d=1)x(primal:n=1,d=1) refines grids");
  const Run smoothed = run("smooth " + tetrahedron + " --scheme loop --steps 2 --quiet");
  CHECK(smoothed.out.starts_with("v 0.0625 0.0625 0.0625\nv 0.0625 -0.0625 -0.0625\n"));
  CHECK(smoothed.out.ends_with("f 2 4 3\n"));
  const auto refused = [&](const std::string& arguments, int code, const std::string& line) {
    const Run told = run("smooth " + tetrahedron + " " + arguments);
    CHECK(told.code == code);
    CHECK(told.err.ends_with("subcert: " + line + "\n"));
  };
  refused("--scheme butterfly:w=1/16", 64,
          "smooth: butterfly:w=1/16: need a scheme of meshes that moves their vertices, as loop and triangular: do");
  for (const char* option : {"--bands 0.9", "--level 3", "--select cv", "--at data", "--irregular fit", "--json"})
    refused("--scheme loop " + std::string(option), 64,
            tetrahedron + ": " + std::string(option).substr(0, std::string(option).find(' ')) +
                ": a mesh is smoothed by --scheme, --steps and --out alone");
  fails("four-eight " + square, 64,
        "refine: need a scheme that makes a grid finer along its axes, not one with the dilation [1,-1;1,1]");
  refused("--scheme kobbelt", 64,
          "--scheme kobbelt: expected, for a mesh, one of butterfly, catmull-clark, doo-sabin, loop, midedge, "
          "modified-butterfly, sqrt3, triangular");
  refused("", 64,
          "--scheme : expected, for a mesh, one of butterfly, catmull-clark, doo-sabin, loop, midedge, "
          "modified-butterfly, sqrt3, triangular");
  fails("triangular:L=2,d=1 " + tetrahedron, 64,
        "rules at a vertex: need triangular: with 3/2 < L < 1.732, d <= 2 and a power, not weights, on the equilateral "
        "grid, got L = 2, d = 1");
  CHECK(run("refine loop " + tetrahedron + " --levels 30").code == 64);
  CHECK(run("refine loop " + folder / "nowhere.off").code == 66);
}

TEST_CASE("schemes that turn the grid have no data on it") {
  const Folder folder;
  const std::string heights = folder.write("heights.csv", "1,2,3,4\n2,3,4,5\n3,4,5,6\n4,5,6,7\n");
  check_fails(run("refine sqrt3 " + heights), 64,
              "refine: need a scheme that makes a grid finer along its axes, not one with the dilation [1,2;-2,-1]");
}

TEST_CASE("data are refined by l1 regression") {
  const Folder folder;
  const std::string data = folder / "data.csv";
  std::ofstream(data) << "x,y\n0,0\n1,2\n2,4\n3,6\n4,999\n5,10\n6,12\n7,14\n8,16\n";
  const auto json = run_json("refine l1:points=8,iterations=60 " + data + " --levels 1");
  CHECK(json.at("scheme") == "l1:points=8,d=1,iterations=60,delta=1e-8");
  REQUIRE(json.at("count") == 16);
  for (const auto& point : json.at("points"))
    CHECK(std::abs(point[1].get<double>() - 2 * point[0].get<double>()) < 1e-3);
  CHECK(run("refine l1:points=8 " + data + " --closed --levels 2").code == 0);
  CHECK(run("refine l1:points=9,residuals=joint " + data + " --boundary reflect").code == 0);
  const auto fails = [&](const std::string& arguments, int code, const std::string& message) {
    CAPTURE(arguments);
    check_fails(run("refine " + arguments), code, message);
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
}

TEST_CASE("values and derivatives are refined") {
  const Folder folder;
  const std::string data = folder / "data.csv", hermite = "hermite-dd:points=2,order=2 " + data;
  const auto with = [&](const std::string& content, const std::string& arguments) {
    std::ofstream(data, std::ios::binary) << content;
    return run("refine " + arguments);
  };
  // x^3 at 0, 1, 2; the same at 0, 1/2, 1; a curve in the plane, closed.
  CHECK(with("f;slope\n0;0\n1;3\n8;12\n", hermite + " --levels 1").out ==
        "f;slope\n0;0\n0.125;0.75\n1;3\n3.375;6.75\n8;12\n");
  const std::string cubic = "x,y,dy\n0,0,0\n0.5,0.125,0.75\n1,1,3\n";
  CHECK(with(cubic, hermite + " --levels 1 --plot " + folder / "y.svg").out ==
        "x,y,dy\n0,0,0\n0.25,0.015625,0.1875\n0.5,0.125,0.75\n0.75,0.421875,1.6875\n1,1,3\n");
  CHECK(content(folder / "y.svg").find("<svg") != std::string::npos);
  CHECK(with("0,0,1,0\n1,1,0,1\n", hermite + " --closed --levels 1").out ==
        "0,0,1,0\n0.625,0.375,1.25,1.25\n1,1,0,1\n0.375,0.625,-1.75,-1.75\n");
  // x^2, by Merrien's scheme with mu = sqrt(2)/4
  CHECK(
      with("f,slope\n0,0\n1,2\n4,4\n",
           "'hermite:[[[1/2,-1/8],[1/2-sqrt(2)/8,sqrt(2)/16]],[[1,0],[0,1/2]],[[1/2,1/8],[sqrt(2)/8-1/2,sqrt(2)/16]]]@"
           "-1' --levels 1 " +
               data)
          .out == "f,slope\n0,0\n0.25,1\n1,2\n2.25,3\n4,4\n");
  CHECK(with("1,0\n0,1\n", "'vector:[[[1,0],[0,1]],[[0,1],[1,0]]]@0' --closed --levels 1 " + data).out ==
        "1,0\n0,1\n0,1\n1,0\n");
  const auto json = run_json("refine hermite-dd:points=2,order=2 --closed --levels 1 " + data);
  CHECK(json.at("scheme") == "hermite-dd:points=2,order=2");
  CHECK(json.at("count") == 4);
  CHECK(json.at("points").at(1).size() == 2);
  const auto fails = [&](const std::string& content, const std::string& arguments, int code,
                         const std::string& message) {
    CAPTURE(arguments);
    check_fails(with(content, arguments), code, message);
  };
  fails("1\n2\n", hermite, 65,
        data +
            ": expected a multiple of 2 columns for hermite-dd:points=2,order=2, values, then their first "
            "derivatives and so on, or one column of positions before them; found 1");
  fails("x,y,dy\n0,0,0\n1,0,0\n3,0,0\n", hermite, 65,
        data + ", line 3: expected positions in equal steps, in the mean 1.5; found the step 1");
  fails("2,0,0\n1,0,0\n", hermite, 65, data + ", line 2: expected a position above 2 in the first column; found 1");
  fails("1,2\n3,4\n", "ghm " + data, 64,
        "refine: need boundary shrink or periodic, or closed data, for vectors, got "
        "regression");
  fails("1,2\n3,4\n", hermite + " --limit", 64,
        "--limit: hermite-dd:points=2,order=2: limits are of schemes of numbers in one variable and their tensor "
        "products");
  fails("1,2\n3,4\n", hermite + " --boundary reflect", 64,
        "refine: need boundary regression, shrink or periodic, or closed data, for a Hermite scheme, got reflect");
}

TEST_CASE("refine: axes with one scale have numbers with one step") {
  const Folder folder;
  const std::string data = folder.write("square.csv", "0,0\n4,0\n4,4\n0,4\n"), picture = folder / "square.svg";
  CHECK(run("refine chaikin " + data + " --closed --quiet --plot " + picture).code == 0);
  // A side of the picture is wider than the other, and alone would have steps of 1/2.
  CHECK(contains(content(picture), ">3</tspan>"));
  CHECK_FALSE(contains(content(picture), ">0.5</tspan>"));
}

TEST_CASE("refine: several schemes in one picture of the same data") {
  const Folder folder;
  const std::string data = folder.write("path.csv", "x,y\n0,0\n4,0\n4,4\n0,4\n2,1\n"), picture = folder / "p.svg";
  const std::string plot = data + " --closed --quiet --plot " + picture, alone = run("refine chaikin " + plot).out;
  CHECK(contains(content(picture), ">refined<"));
  for (const char* limit : {"", " --limit"}) {
    const Run several = run("refine chaikin " + plot + limit + " --beside dd:n=2 --beside cubic");
    CHECK(several.code == 0);
    if (*limit == 0) CHECK(several.out == alone);
    for (const char* name : {">data<", ">bspline:degree=2<", ">dd:n=2<", ">bspline:degree=3<"})
      CHECK(contains(content(picture), name));
  }
  const std::string heights = folder.write("h.csv", "0,1,4,2\n1,2,3,0\n3,1,0,1\n2,2,1,0\n");
  const std::string page = folder / "s.html", cubic = "'tensor:(cubic)x(cubic)'";
  CHECK(run("refine " + cubic + " " + heights + " --levels 1 --plot " + page + " --beside 'tensor:(dd:n=1)x(cubic)'")
            .code == 0);
  CHECK(contains(content(page), "tensor:(dd:n=1)x(bspline:degree=3)"));
  check_fails(run("refine chaikin " + data + " --beside dd:n=2"), 64,
              "--beside: expected --plot, whose picture has these schemes, too");
  check_fails(run("refine chaikin " + plot + " --beside " + cubic), 64,
              "--beside tensor:(cubic)x(cubic): expected a scheme of as many variables as chaikin");
  CHECK(run("refine chaikin " + plot + " --beside nonsense").code == 64);
}

TEST_CASE("refine: data go on as the nearest datum, or as a constant") {
  const Folder folder;
  const std::string data = folder.write("d.csv", "1\n3\n"),
                    command = "refine bspline:degree=3 " + data + " --levels 1 ";
  CHECK(run(command + "--boundary nearest").out == "1.25\n2\n2.75\n");
  CHECK(run(command + "--boundary constant").out == "1.125\n2\n2.375\n");
  CHECK(run(command + "--boundary constant --constant 9").out == "2.25\n2\n3.5\n");
  CHECK(run(command + "--boundary nearest --limit").out.substr(0, 6) == "1.3333");
  check_fails(run(command + "--boundary nearest --closed"), 64,
              "--boundary nearest: closed data have no boundary; leave out one of the two options");
  check_fails(run("refine merrien:lambda=-1/8,mu=1/2 " + folder.write("h.csv", "1,2\n3,2\n") + " --boundary nearest"),
              64, "refine: need boundary regression, reflect, periodic or shrink, got nearest");
}

TEST_CASE("titles of pictures are whole: in lines, and no sign of a specification is markup") {
  const Folder folder;
  std::string rows;
  for (int i = 0; i < 20; ++i) rows += std::to_string(i * 7 % 5) + "\n";
  const std::string data = folder.write("data.csv", rows), plot = folder / "plot.svg";
  const std::string mask = "mask:[1,13,78,286,715,1287,1716,1716,1287,715,286,78,13,1]/4096@0";  // longer than a line
  REQUIRE(run("refine '" + mask + "' " + data + " --out " + (folder / "out.csv") + " --plot " + plot).code == 0);
  const std::string picture = content(plot);
  CHECK(contains(picture, "mask:[1,13,78,286,715,1287,1716,1716,1287,715,286,78,13,"));
  CHECK(contains(picture, ">1]/4096@0<"));
}

TEST_CASE("values and derivatives are refined with a mask for each level") {
  const Folder folder;
  const std::string merrien = "merrien:lambda=-1/8,mu=",
                    list = "lists:" + folder.write("list.toml", "masks = [\"" + merrien + "3/2\", \"" + merrien +
                                                                    "-1/2\"]\nperiod = [0, 1]\n"),
                    data = folder.write("data.csv", "x,y,s\n0,1,0\n2,3,1\n4,0,-2\n6,1,1\n");
  const std::string once = folder.write("once.csv", run("refine " + merrien + "3/2 " + data + " --levels 1").out),
                    twice = run("refine " + list + " " + data + " --levels 2").out;
  CHECK(twice == run("refine " + merrien + "-1/2 " + once + " --levels 1").out);
  CHECK(run("refine merrien:lambda=-1/8,mu=w " + data + " --values w=3/2,-1/2 --levels 2").code == 64);
  // Closed curves, pictures, what a vector scheme needs.
  const std::string closed = folder.write("closed.csv", "1,0\n0,1\n-1,0\n"), plot = folder / "plot.svg";
  CHECK(run_json("refine " + list + " " + closed + " --closed --levels 3 --plot " + plot).at("count") == 24);
  CHECK(std::filesystem::exists(plot));
  const std::string splines = "lists:" + folder.write("splines.toml",
                                                      "masks = [\"ghm\", \"bspline:degree=3,multiplicity=2\"]\n"
                                                      "period = [0, 1]\n");
  CHECK(run_json("refine " + splines + " " + closed + " --closed --levels 2").at("count") == 12);
  check_fails(run("refine " + splines + " " + data + " --levels 2"), 65,
              data +
                  ": expected a multiple of 2 columns for ghm, bspline:degree=3,multiplicity=2 again and again, "
                  "the first numbers of all vectors, then the second and so on; found 3");
  CHECK(run("refine " + splines + " " + closed + " --levels 2").code == 64);
  CHECK(run("refine " + list + " " + folder.write("one.csv", "1,0\n")).code == 65);
  CHECK(run("refine " + list + " " + folder.write("text.csv", "1,nan\n2,3\n")).code == 65);
  check_fails(run("refine " + list + " " + data + " --limit"), 64,
              "--limit: " + merrien + "3/2, " + merrien +
                  "-1/2 again and again: limits are of schemes of numbers in one variable and their tensor products");
  CHECK(run("refine lists:" + folder.write("any.toml", "masks = [\"ghm\"]") + " " + closed).code == 64);
}

TEST_CASE("data are refined with a mask for each level") {
  const Folder folder;
  const std::string line = folder.write("line.csv", "5\n3\n1\n2\n4\n2\n"), halving = " --recurrence 'v=sqrt((1+v)/2)'";
  CHECK(run("refine four-point:w " + line + " --values w=1/16,1/16 --levels 3").out ==
        run("refine four-point:w=1/16 " + line + " --levels 3").out);
  CHECK(run("refine four-point:w " + line + " --recurrence w=w/2 --start w0=1/8 --levels 2").out ==
        run("refine four-point:w " + line + " --values w=1/8,1/16,5 --levels 2").out);
  const std::string pair = folder.write("pair.toml", "masks = [\"dd:n=2\", \"bspline:degree=3\"]\nperiod = [0, 1]\n"),
                    once = folder.write("once.csv", run("refine dd:n=2 " + line + " --levels 1").out);
  const auto json = run_json("refine lists:" + pair + " " + line + " --levels 2");
  CHECK(json.at("scheme") == "dd:n=2, bspline:degree=3 again and again");
  CHECK(json.at("count") == 21);
  const std::string twice = run("refine lists:" + pair + " " + line + " --levels 2").out;
  CHECK(twice == run("refine bspline:degree=3 " + once + " --levels 1").out);
  // A mask for v = 1/2, and the one data that are there for no level.
  CHECK(run_json("refine conic-four-point:v " + line + halving + " --start v0=1/2 --levels 0").at("count") == 6);
  CHECK(run_json("refine conic-four-point:v " + line + halving + " --start v0=1/2 --levels 1").at("scheme") ==
        "conic-four-point:v with v = sqrt((1+v)/2), v0 = 1/2");
  const auto fails = [&](const std::string& rest, int code, const std::string& message) {
    check_fails(run("refine " + rest), code, message);
  };
  fails("four-point:w " + line + " --values 1/16", 64,
        "--values: expected w=VALUE,VALUE,... with exact numbers, got '1/16'");
  fails("four-point:w " + line + " --values w=1/16,", 64,
        "--values: expected w=VALUE,VALUE,... with exact numbers, got 'w=1/16,'");
  fails("four-point:w " + line + " --start w0=1/16", 64, "--recurrence and --start: expected both or none");
  fails("four-point:w " + line + " --recurrence w=w --start w0=0..1", 64,
        "--start: expected one value, w0=VALUE, got 'w0=0..1'");
  fails("four-point:w " + line + " --recurrence w=w --start w0=1/16 --values w=1", 64,
        "--values: cannot be asked for with --recurrence");
  fails("lists:" + pair + " " + line + " --values w=1", 64, "--values: cannot be asked for with a list of masks");
  fails("conic-four-point:v " + line + halving + " --start v0=0", 64,
        "levels: need a mask for each level, got none for level 0");
  fails("conic-four-point:v " + line + " --values v=0", 64, "conic-four-point:v: there is no mask for v = 0");
  CHECK(run("refine four-point:w " + line + " --recurrence w=w --start w0=1/16 --levels 100000000").code == 64);
  CHECK(run("refine lists:" + folder.write("any.toml", "masks = [\"dd:n=2\"]") + " " + line).code == 64);
  CHECK(run("refine four-point:w " + line + " --values w=1/16 --limit").code == 64);
  CHECK(run("refine dd:n=2 " + line + " --values w=1/16").code == 64);
}
