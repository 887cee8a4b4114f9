#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/schemes/data/formats/grid_mesh.hpp>
#include <subcert/schemes/data/formats/table.hpp>
#include <subcert/schemes/data/formats/volume.hpp>
#include <subcert/schemes/data/mesh/mesh_refinement.hpp>

#include <random>

using namespace subcert;
using namespace subcert::data;

namespace {

GridData<double> sample(std::size_t columns, std::size_t rows, bool closed_x, bool closed_y) {
  std::mt19937 engine(7);
  GridData<double> data{{}, 3, {Axis::of(columns, closed_x), Axis::of(rows, closed_y)}};
  for (std::size_t i = 0; i < 3 * data.points(); ++i) data.values.push_back(static_cast<double>(engine()) / 1e9);
  return data;
}

MeshFile mesh_of(GridData<double> data, MeshFormat format, Encoding encoding = Encoding::text) {
  return {mesh_of_grid(std::move(data)), {{"x"}, {"y"}, {"z"}}, format, encoding};
}

Volume read_vtk(std::string_view text, const std::string& file) { return parse_vtk(text, file); }
GridData<double> grid_of(MeshFile mesh) { return take_grid(mesh); }
GridData<double> obj_grid(std::string_view text, const std::string& file) { return grid_of(parse_obj(text, file)); }
GridData<double> ply_grid(std::string_view text, const std::string& file) { return grid_of(parse_ply(text, file)); }

template <class Parse>
std::string error_of(Parse parse, const std::string& text) {
  try {
    parse(text, "f");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::data);
    return error.what();
  }
  return "";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

const std::string vtk =
    "# vtk DataFile Version 2.0\nthe title\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 3 2 2\nORIGIN 1 2 3\n"
    "SPACING 0.5 1 2\nPOINT_DATA 12\nSCALARS density float 1\nLOOKUP_TABLE default\n1 2 3 4 5 6\n7 8 9 10 11\n12\n";

}  // namespace

TEST_CASE("meshes are written and read back, open and closed") {
  for (const auto& [columns, rows] : {std::pair<std::size_t, std::size_t>{4, 6}, {6, 4}, {5, 5}, {3, 7}, {2, 2}})
    for (const bool closed_x : {false, true})
      for (const bool closed_y : {false, true}) {
        if ((closed_x && columns < 3) || (closed_y && rows < 3)) continue;
        const GridData<double> data = sample(columns, rows, closed_x, closed_y);
        CAPTURE(columns, rows, closed_x, closed_y);
        std::vector<GridData<double>> all{obj_grid(to_text(mesh_of(data, MeshFormat::obj)), "f")};
        for (const Encoding encoding : {Encoding::text, Encoding::little_endian, Encoding::big_endian})
          all.push_back(ply_grid(to_text(mesh_of(data, MeshFormat::ply, encoding)), "f"));
        all.push_back(grid_of(parse_off(to_text(mesh_of(data, MeshFormat::off)), "f")));
        for (const GridData<double>& back : all) {
          CHECK(back.values == data.values);
          CHECK(back.axes[0].count == columns);
          CHECK(back.axes[1].count == rows);
          CHECK(back.axes[0].closed == closed_x);
          CHECK(back.axes[1].closed == closed_y);
        }
      }
  // Other orders, orientations, texture and normal numbers, vertices counted from the end.
  const GridData<double> back = obj_grid(
      "o s # name\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn 0 0 1\nv 0 2 0\nv 1 2 0\ns off\n"
      "f -1 -2 3//1 4/2/1\nf 3 1 2 4\n",
      "f");
  CHECK(back.axes[0].count == 2);
  CHECK(back.axes[1].count == 3);
}

TEST_CASE("what is no grid is refused with its place") {
  const std::string obj = to_text(mesh_of(sample(3, 3, false, false), MeshFormat::obj)),
                    ply = to_text(mesh_of(sample(3, 3, false, false), MeshFormat::ply));
  CHECK(error_of(parse_obj, "") == "f: expected vertices and faces; found 0 vertices and no faces");
  CHECK(error_of(obj_grid, replaced(obj, "f 1 2 5 4", "f 1 2 5")) ==
        "f, line 10: expected a face of 4 vertices, as in a grid; found 3");
  CHECK(error_of(parse_obj, replaced(obj, "f 1 2 5 4", "f 1 2 5 44")) ==
        "f, line 10, word 5: expected the number of one of the 9 vertices above; found '44'");
  CHECK(error_of(obj_grid, replaced(obj, "f 1 2 5 4", "f 1 2 6 4")).find("do not") != std::string::npos);
  CHECK(error_of(obj_grid, replaced(obj, "f 1 2 5 4\n", "")).find("the 3 faces on 8 vertices do not") !=
        std::string::npos);
  CHECK(error_of(parse_obj, replaced(obj, "v ", "v x")).find("f, line 1, word 2: expected a finite number") == 0);
  CHECK(error_of(parse_obj, replaced(obj, "v ", "v nan ")) ==
        "f, line 1, word 2: expected a finite number; found 'nan'");
  CHECK(error_of(parse_obj, "v 1 2\n") ==
        "f, line 1, word 4: expected v and x y z, with w, red green blue or both behind them; found nothing");
  CHECK(error_of(parse_obj, "v 1 2 3\nv 1 2 3 4\n") ==
        "f, line 2, word 5: expected v and 3 numbers as in the first vertex; found '4'");
  CHECK(error_of(parse_obj, "curv 1\n") ==
        "f, line 1, word 1: expected v, f, vn, vt, l, p, o, g, s, usemtl or mtllib; found 'curv'");
  CHECK(error_of(parse_ply, "") == "f: expected a PLY file, which begins with the line 'ply'");
  CHECK(error_of(parse_ply, replaced(ply, "ascii", "binary")) ==
        "f, line 2, word 2: expected ascii, binary_little_endian or binary_big_endian; found 'binary'");
  CHECK_FALSE(error_of(parse_ply, replaced(ply, "element vertex 9", "element vertex 10")).empty());
  CHECK_FALSE(error_of(parse_ply, replaced(ply, "element vertex 9", "element vertex 99999999999")).empty());
  CHECK(error_of(parse_ply, replaced(ply, "property double z", "property double red")) ==
        "f: expected the properties x, y and z of the vertices; found no z");
  CHECK(error_of(parse_ply, replaced(ply, "end_header", "end")) ==
        "f, line 9, word 1: expected format, element, property, comment or end_header; found 'end'");
  CHECK(error_of(parse_ply, ply + "4 0 1 2 3\n").find("expected the end of the file") != std::string::npos);
  CHECK(error_of(parse_ply, replaced(ply, "4 0 1 4 3", "4 0 1 4.5 3")) ==
        "f, line 19, word 4: expected the number of a vertex from 0 to 8; found '4.5'");
  CHECK(error_of(parse_ply, replaced(ply, "4 0 1 4 3", "4 0 1 4 3 3")) ==
        "f, line 19, word 6: expected no more numbers for a face; found '3'");
  CHECK(error_of(ply_grid, replaced(ply, "4 0 1 4 3", "3 0 1 4")) ==
        "f, line 19: expected a face of 4 vertices, as in a grid; found 3");
}

TEST_CASE("polygons are read and written in every form") {
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 2 0.25\nf 1 2 3 4\nf -3 -1 -2\n";
  const MeshFile mesh = parse_obj(obj, "f");
  CHECK(mesh.mesh.corners == std::vector<std::uint32_t>{0, 1, 2, 3, 2, 4, 3});
  CHECK(mesh.mesh.first == std::vector<std::uint32_t>{0, 4, 7});
  CHECK(mesh.place(1) == "f, line 7");
  for (const MeshFormat format : {MeshFormat::obj, MeshFormat::ply, MeshFormat::off})
    for (const Encoding encoding : {Encoding::text, Encoding::little_endian, Encoding::big_endian}) {
      MeshFile form = mesh;
      form.encoding = encoding;
      change_format(form, format);
      const std::string text = to_text(form);
      const MeshFile back = parse_mesh(format, text, "f");
      CHECK(back.mesh.values == mesh.mesh.values);
      CHECK(back.mesh.corners == mesh.mesh.corners);
      CHECK(back.mesh.first == mesh.mesh.first);
      CHECK(to_text(back) == text);
    }
  CHECK(to_text(mesh) == replaced(obj, "f -3 -1 -2", "f 3 5 4"));

  const MeshFile colours = parse_off(
      "CNOFF # with normals\n3 1 0\n0 0 0 0 0 1 1 0 0 0.5\n1 0 0 0 0 1 0 1 0 1\n0 1 0 0 0 1 0 0 1 1\n3 0 1 2 255 0 0\n",
      "f");
  CHECK(colours.remarks == std::vector<std::string>{"refined as x, y, z are: red, green, blue, alpha",
                                                    "left out: normals, what faces have beside their vertices"});
  CHECK(to_text(colours) == "COFF\n3 1 0\n0 0 0 1 0 0 0.5\n1 0 0 0 1 0 1\n0 1 0 0 0 1 1\n3 0 1 2\n");
  MeshFile plain = colours;
  change_format(plain, MeshFormat::obj);
  CHECK(to_text(plain) == "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  CHECK(plain.remarks.back() == "left out, as the file that is written has no place for it: red, green, blue, alpha");
  MeshFile with_normals = colours;
  with_normals.properties = {{"x"}, {"y"}, {"z"}, {"red"}, {"nx"}, {"ny"}, {"nz"}};
  with_normals.mesh = {{0, 0, 0, .5, 0, 0, 1, 1, 0, 0, .5, 0, 0, 1, 0, 1, 0, .5, 0, 0, 1}, 7, {0, 1, 2}, {0, 3}};
  CHECK(to_text(with_normals).starts_with("CNOFF\n3 1 0\n0 0 0 0 0 1 0.5\n"));
  change_format(with_normals, MeshFormat::obj);
  CHECK(to_text(with_normals) == "v 0 0 0\nvn 0 0 1\nv 1 0 0\nvn 0 0 1\nv 0 1 0\nvn 0 0 1\nf 1//1 2//2 3//3\n");
}

TEST_CASE("facets of STL files are joined where their corners are equal") {
  const auto facet = [](const std::string& a, const std::string& b, const std::string& c) {
    return "  facet normal 0 0 1\n    outer loop\n      vertex " + a + "\n      vertex " + b + "\n      vertex " + c +
           "\n    endloop\n  endfacet\n";
  };
  const std::string text = "solid two parts\n" + facet("0 0 0", "1 0 0", "0 1 0") + facet("1 0 -0", "1 1 0", "0 1 0") +
                           "endsolid two parts\n";
  const MeshFile mesh = parse_stl(text, "f");
  CHECK(mesh.mesh.vertices() == 4);
  CHECK(mesh.mesh.corners == std::vector<std::uint32_t>{0, 1, 2, 1, 3, 2});
  CHECK(mesh.place(1) == "f, line 9");
  CHECK(parse_stl(to_text(mesh), "f").mesh.values == mesh.mesh.values);
  CHECK(to_text(mesh).starts_with("solid mesh\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"));
  MeshFile bytes = mesh;
  bytes.encoding = Encoding::little_endian;
  std::string content = to_text(bytes);
  CHECK(content.size() == 84 + 2 * 50);
  CHECK(parse_stl(content, "f").mesh.corners == mesh.mesh.corners);
  std::string named = content;
  named.replace(0, 5, "solid");
  CHECK(parse_stl(named, "f").mesh.corners == mesh.mesh.corners);
  for (std::size_t length = 0; length < content.size(); ++length)
    CHECK_FALSE(error_of(parse_stl, content.substr(0, length)).empty());
  CHECK(error_of(parse_stl, content.substr(0, 150)) == "f: expected 50 bytes of facet 1 after line 0; found 16");
  CHECK(error_of(parse_stl, content + "x") == "f: expected the end of the file after the facets");
  CHECK(error_of(parse_stl, "solid\n" + facet("0 0 0", "1 0 0", "1 0 0") + "endsolid\n") ==
        "f, line 2: expected a face of different vertices; found one of them twice");
  CHECK(error_of(parse_stl, replaced(text, "endfacet", "end")) == "f, line 8, word 1: expected ENDFACET; found 'end'");
  CHECK(error_of(parse_stl, "solid\nendsolid\n") == "f: expected vertices and faces; found 0 vertices and no faces");
}

TEST_CASE("damaged OFF files and faces are refused with their place") {
  const std::string off = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
  CHECK(parse_off(off, "f").mesh.faces() == 2);
  CHECK(parse_off(replaced(off, "OFF\n4", "OFF 4"), "f").mesh.faces() == 2);
  CHECK(error_of(parse_off, replaced(off, "OFF", "OFG")).find("f, line 1, word 1: expected an OFF file") == 0);
  CHECK(error_of(parse_off, replaced(off, "4 2 0", "4 3 0")) == "f: expected 3 faces; found 2");
  CHECK(error_of(parse_off, replaced(off, "4 2 0", "4 1 0")).find("expected the end of the file") != std::string::npos);
  CHECK(error_of(parse_off, replaced(off, "4 2 0", "1000000000000000000 2 0")).find("from 0 to 100000000") !=
        std::string::npos);
  CHECK(error_of(parse_off, replaced(off, "3 0 1 2", "3 0 1 4")) ==
        "f, line 7, word 4: expected the number of a vertex from 0 to 3; found '4'");
  CHECK(error_of(parse_off, replaced(off, "3 0 1 2", "3 0 1")) ==
        "f, line 7, word 4: expected the number of a vertex from 0 to 3; found nothing");
  CHECK(error_of(parse_off, replaced(off, "1 1 0", "1 inf 0")) ==
        "f, line 5, word 2: expected a finite number; found 'inf'");
  CHECK(error_of(parse_off, replaced(off, "3 0 1 2", "2 0 1")) ==
        "f, line 7: expected a face of three or more vertices; found 2");
  CHECK(error_of(parse_off, replaced(off, "3 0 1 2", "3 0 1 0")) ==
        "f, line 7: expected a face of different vertices; found one of them twice");
  CHECK(error_of(parse_obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n") ==
        "f, line 4: expected a face of three or more vertices; found 2");
  CHECK(error_of(parse_obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 1\n") ==
        "f, line 4: expected a face of different vertices; found one of them twice");
  MeshFile twice = parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 -0\nv 1 1 0\nf 1 2 3\nf 4 5 3\n", "f");
  join_equal_vertices(twice);
  CHECK(twice.mesh.corners == std::vector<std::uint32_t>{0, 1, 2, 1, 3, 2});
}

TEST_CASE("whatever is changed in a mesh, it is refined or refused") {
  MeshFile mesh = parse_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\nv 3 3 1\nf 1 2 3\nf 1 3 4\nf 4 3 5\nf 5 3 2\n", "f");
  std::mt19937 engine(11);
  for (const MeshFormat format : {MeshFormat::obj, MeshFormat::ply, MeshFormat::off, MeshFormat::stl})
    for (const Encoding encoding : {Encoding::text, Encoding::little_endian}) {
      MeshFile form = mesh;
      form.encoding = encoding;
      change_format(form, format);
      const std::string whole = to_text(form);
      for (int i = 0; i < 3000; ++i) {
        std::string text = whole;
        for (std::size_t edits = engine() % 4 + 1; edits-- > 0 && !text.empty();) {
          const std::size_t at = engine() % text.size();
          switch (engine() % 4) {
            case 0: text[at] = static_cast<char>(engine()); break;
            case 1: text.erase(at, engine() % 9); break;
            case 2: text.insert(at, text.substr(engine() % text.size(), engine() % 9)); break;
            default: text[at] = "0123456789 -.\n"[engine() % 14]; break;
          }
        }
        const auto parse = [&](const std::string& edited, const char* file) {
          const MeshFile read = parse_mesh(format, edited, file);
          CHECK(read.mesh.is_canonical());
          const PolygonMesh finer = refine_mesh(read.mesh, "catmull-clark", {1, true, true},
                                                [&](std::size_t face) { return read.place(face); });
          CHECK(finer.is_canonical());
        };
        error_of(parse, text);
      }
    }
}

TEST_CASE("volumes are read and written") {
  const Volume volume = parse_vtk(vtk, "f");
  CHECK(volume.title == "the title");
  REQUIRE(volume.arrays.size() == 1);
  CHECK(volume.arrays[0].name == "density");
  CHECK(volume.data.axes.size() == 3);
  CHECK(volume.data.values.size() == 12);
  CHECK(volume.spacing == std::array<double, 3>{0.5, 1, 2});
  const Volume back = parse_vtk(to_text(volume), "f");
  CHECK(back.data.values == volume.data.values);
  CHECK(back.origin == volume.origin);
  const Volume vectors = parse_vtk(
      "# vtk DataFile Version 3.0\n\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 1 1\nPOINT_DATA 2\n"
      "VECTORS v double\n1 2 3 4 5 6\n",
      "f");
  CHECK(vectors.data.dimension == 3);
  CHECK(vectors.data.axes.size() == 2);
  CHECK(to_text(vectors).find("VECTORS v double\n1 2 3\n4 5 6\n") != std::string::npos);
}

TEST_CASE("numbers of volumes may be missing where somebody asks for it") {
  const std::string text = replaced(vtk, "1 2 3 4 5 6", "1 NaN 3 4 5 6");
  CHECK(error_of(read_vtk, text).find("a finite number; found 'NaN'") != std::string::npos);
  Volume volume = parse_vtk(text, "f", true);
  CHECK(std::isnan(volume.data.values[1]));
  CHECK(volume.data.values[2] == 3);
  volume.encoding = Encoding::big_endian;
  const std::string bytes = to_text(volume);
  CHECK(error_of(read_vtk, bytes).find("finite numbers") != std::string::npos);
  CHECK(std::isnan(parse_vtk(bytes, "f", true).data.values[1]));
  CHECK_THROWS(parse_vtk(replaced(text, "NaN", "inf"), "f", true));
}

TEST_CASE("damaged volumes are refused with their place") {
  CHECK(error_of(read_vtk, "").find("f: expected a legacy VTK file") == 0);
  CHECK(error_of(read_vtk, replaced(vtk, "ASCII", "BINARY")) ==
        "f: expected 48 bytes of numbers after line 10; found 27");
  CHECK(error_of(read_vtk, replaced(vtk, "STRUCTURED_POINTS", "POLYDATA")) ==
        "f, line 4, word 2: expected STRUCTURED_POINTS; found 'POLYDATA'");
  CHECK(error_of(read_vtk, replaced(vtk, "DIMENSIONS 3 2 2", "DIMENSIONS 3 2")).find("line 5, word 4") !=
        std::string::npos);
  CHECK(error_of(read_vtk, replaced(vtk, "3 2 2", "99999999 99999999 9")).find("at most 100000000 points") !=
        std::string::npos);
  CHECK(error_of(read_vtk, replaced(vtk, "POINT_DATA 12", "POINT_DATA 11")) ==
        "f, line 8, word 2: expected 12 as DIMENSIONS say; found '11'");
  CHECK(error_of(read_vtk, replaced(vtk, "11\n12", "11")) == "f: expected 12 values; found 11");
  CHECK(error_of(read_vtk, vtk + "13\n") ==
        "f, line 14, word 1: expected the end of the file, or another array; found '13'");
  CHECK(error_of(read_vtk, replaced(vtk, "7 8", "7 inf")) ==
        "f, line 12, word 2: expected a finite number; found 'inf'");
}

TEST_CASE("what vertices have beside their place is read in every form") {
  // As MeshLab writes colours, with a weight, a byte order mark, a continued line, a vertex without faces.
  const MeshFile obj = parse_obj(
      "\xef\xbb\xbf# MeshLab\r\nv 0 0 0 1 0.5 0 0\r\nv 9 9 9 1 0 0 0\r\nv 1 0 0 1 \\\r\n 0.25 0 0\r\n"
      "vn 0 0 1\r\nv 0 1 0 1 0 1 0\r\nv 1 1 0 1 0 0 2\r\nf 1 3 \\\r\n5 4\r\n",
      "f");
  CHECK(obj.mesh.values ==
        std::vector<double>{0, 0, 0, 1, .5, 0, 0, 1, 0, 0, 1, .25, 0, 0, 0, 1, 0, 1, 0, 1, 0, 1, 1, 0, 1, 0, 0, 2});
  CHECK(obj.properties[3].name == "w");
  CHECK(obj.remarks ==
        std::vector<std::string>{"refined as x, y, z are: w, red, green, blue",
                                 "left out: normals and texture coordinates, vertices without faces (1)"});
  CHECK(to_text(obj).ends_with("v 1 1 0 1 0 0 1\nf 1 2 4 3\n"));  // colours end at 1

  const std::string header =
      "element vertex 4\nproperty uchar red\nproperty float x\nproperty float y\nproperty float nx\n"
      "property float z\nproperty list uchar int neighbours\nproperty float quality\nelement face 1\n"
      "property list uchar uint vertex_indices\nproperty double quality\nelement edge 1\nproperty int vertex1\n"
      "end_header\n";
  const MeshFile ascii = parse_ply("ply\nformat ascii 1.0\ncomment x\n" + header +
                                       "255 0 0 1 0 2 7 8 0.5\n0 1 0 1 0 0 0.5\n0 0 1 1 0 1 9 0.5\n9 1 1 1 4 0 0.5\n"
                                       "4 0 1 3 2 0.75\n17\n",
                                   "f");
  CHECK(ascii.mesh.values == std::vector<double>{0, 0, 0, 255, .5, 1, 0, 0, 0, .5, 0, 1, 0, 0, .5, 1, 1, 4, 9, .5});
  CHECK(ascii.remarks == std::vector<std::string>{"refined as x, y, z are: red, quality",
                                                  "left out: nx, neighbours of the vertices, what faces have beside "
                                                  "their vertices, elements edge"});
  CHECK(to_text(ascii).find("property uchar red\nproperty double quality\n") != std::string::npos);
  MeshFile bright = ascii;
  bright.mesh.values[3] = 260.4;
  CHECK(to_text(bright).find("\n0 0 0 255 0.5\n") != std::string::npos);
  for (const Encoding encoding : {Encoding::little_endian, Encoding::big_endian}) {
    std::string bytes;
    const auto add = [&](double value, const NumberType& type) { append_number(value, type, encoding, bytes); };
    const NumberType uchar{1, true, false}, real{4, false, true}, whole{4, true, true};
    for (std::size_t v = 0; v < 4; ++v) {
      const double* const p = ascii.mesh.values.data() + 5 * v;
      add(p[3], uchar);
      add(p[0], real);
      add(p[1], real);
      add(1, real);
      add(p[2], real);
      add(static_cast<double>(v % 2), uchar);
      if (v % 2 == 1) add(7, whole);
      add(p[4], real);
    }
    add(4, uchar);
    for (const int vertex : {0, 1, 3, 2}) add(vertex, whole);
    add(0.75, {});
    add(17, whole);
    const std::string name = encoding == Encoding::little_endian ? "little" : "big";
    const std::string file = "ply\r\nformat binary_" + name + "_endian 1.0\r\n" + header + bytes;
    const MeshFile back = parse_ply(file, "f");
    CHECK(back.mesh.values == ascii.mesh.values);
    CHECK(back.encoding == encoding);
    CHECK(parse_ply(to_text(back), "f").mesh.values == ascii.mesh.values);
    for (std::size_t length = 0; length < file.size() - 4; ++length)
      CHECK_FALSE(error_of(parse_ply, file.substr(0, length)).empty());
    CHECK(error_of(parse_ply, file.substr(0, file.size() - 20)).find("bytes of face 0 after line ") !=
          std::string::npos);
  }
}

TEST_CASE("whole numbers are rounded and cut off at the ends of their type") {
  const NumberType uchar{1, true, false}, schar{1, true, true}, real{4, false, true};
  CHECK(fitted(-3, uchar) == 0);
  CHECK(fitted(254.6, uchar) == 255);
  CHECK(fitted(300, uchar) == 255);
  CHECK(fitted(-300, schar) == -128);
  CHECK(fitted(0.1, real) == 0.1);
  for (const Encoding encoding : {Encoding::little_endian, Encoding::big_endian})
    for (const std::size_t size : {1, 2, 4, 8})
      for (const bool with_sign : {false, true}) {
        const NumberType type{size, true, with_sign};
        for (const double value : {0.0, 1.0, 100.0, with_sign ? -100.0 : 200.0}) {
          std::string bytes;
          append_number(value, type, encoding, bytes);
          CHECK(bytes.size() == size);
          CHECK(read_number(bytes.data(), type, encoding) == value);
        }
      }
  std::string bytes;
  append_number(258, {2, true, false}, Encoding::big_endian, bytes);
  CHECK(bytes == std::string("\x01\x02"));
}

TEST_CASE("volumes have many arrays, fields, cells, bytes") {
  const std::string begin =
      "# vtk DataFile Version 4.2\nt\nascii\ndataset structured_points\nFIELD FieldData 1\n"
      "TimeValue 1 1 double\n0.5\nMETADATA\nINFORMATION 0\n\ndimensions 2 2 1\nspacing 1 1 1\n"
      "origin 0 0 0\n";
  const std::string file = begin +
                           "CELL_DATA 1\nSCALARS c int 1\nLOOKUP_TABLE default\n7\n"
                           "POINT_DATA 4\nFIELD FieldData 2\na 1 4 float\n1 2 3 4\nMETADATA\nINFORMATION 1\n"
                           "NAME L2_NORM_RANGE LOCATION vtkDataArray\nDATA 2 0 1\n\nb 2 4 int\n1 1 2 2 3 3 4 4\n"
                           "scalars d unsigned_char\nlookup_table mine\n5\n6 7 8\nLOOKUP_TABLE mine 1\n0 0 0 1\n"
                           "COLOR_SCALARS e 3\n0 0 0.5 0 0 1 0 0 0 1 1 1\nNORMALS n float\n0 0 1 0 0 1 0 0 1 0 0 1\n"
                           "VECTORS v float\n1 2 3 1 2 3 1 2 3 1 2 3\nMETADATA\nINFORMATION 0\n\n";
  const Volume volume = parse_vtk(file, "f");
  CHECK(volume.remarks ==
        std::vector<std::string>{"left out: fields of the data set, lookup tables, NORMALS, CELL_DATA"});
  REQUIRE(volume.arrays.size() == 5);
  CHECK(volume.data.dimension == 1 + 3 + 3 + 1 + 2);
  const std::vector<double> first(volume.data.values.begin(), volume.data.values.begin() + 10);
  CHECK(first == std::vector<double>{5, 0, 0, .5, 1, 2, 3, 1, 1, 1});
  const std::string text = to_text(volume);
  CHECK(text.find("COLOR_SCALARS e 3\n0 0 0.5\n0 0 1\n") != std::string::npos);
  CHECK(text.find("FIELD FieldData 2\na 1 4 double\n1\n2\n3\n4\nb 2 4 double\n1 1\n") != std::string::npos);
  CHECK(parse_vtk(text, "f").data.values == volume.data.values);
  Volume binary = volume;
  binary.encoding = Encoding::big_endian;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t c = 1; c < 4; ++c) binary.data.values[10 * i + c] *= 255;
  const std::string bytes = to_text(binary);
  const Volume back = parse_vtk(bytes, "f");
  CHECK(back.encoding == Encoding::big_endian);
  CHECK(back.data.values[3] == 128);  // of 127.5
  CHECK(back.data.values[7] == 1);
  CHECK(back.arrays[4].name == "b");
  CHECK(to_text(back) == bytes);
  std::size_t whole = 0;  // beginnings that end with an array
  for (std::size_t length = 0; length < bytes.size() - 1; ++length)
    if (error_of(read_vtk, bytes.substr(0, length)).empty()) ++whole;
  CHECK(whole == 6);

  const Volume cells = parse_vtk(
      replaced(begin, "2 2 1", "3 4 1") + "CELL_DATA 6\nSCALARS c float\nLOOKUP_TABLE default\n1 2 3 4 5 6\n", "f");
  CHECK(cells.data.axes[0].count == 2);
  CHECK(cells.data.axes[1].count == 3);
  CHECK(cells.origin == std::array<double, 3>{0.5, 0.5, 0});
  CHECK(cells.remarks.front() == "CELL_DATA are taken as data at the middles of the cells");
  CHECK(error_of(read_vtk, begin + "POINT_DATA 4\nFIELD f 1\ns 1 4 string\na\nb\nc\nd\n") ==
        "f, line 16, word 4: expected a type of numbers, as unsigned_char, int, float or double; found 'string'");
  CHECK(error_of(read_vtk, begin + "POINT_DATA 4\nFIELD f 1\na 1 3 int\n1 2 3\n") ==
        "f, line 16, word 3: expected 4, one for each point; found '3'");
  const std::string shorts = replaced(begin, "ascii", "binary").substr(0, begin.find("FIELD") + 1);
  for (const auto& [type, value] : {std::pair("unsigned_short", 65535.0), {"short", -1.0}})
    CHECK(parse_vtk(shorts + "dimensions 1 1 1\nPOINT_DATA 1\nSCALARS a " + type + "\nLOOKUP_TABLE d\n\xff\xff\n", "f")
              .data.values.front() == value);
  CHECK(error_of(read_vtk, begin + "POINT_DATA 4\n") == "f: expected an array of POINT_DATA or CELL_DATA; found none");
}
