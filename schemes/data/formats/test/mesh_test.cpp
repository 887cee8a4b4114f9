#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/schemes/data/formats/quad_mesh.hpp>
#include <subcert/schemes/data/formats/table.hpp>
#include <subcert/schemes/data/formats/volume.hpp>

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
        for (const GridData<double>& back : {parse_obj(to_obj(data), "f"), parse_ply(to_ply(data), "f")}) {
          CHECK(back.values == data.values);
          CHECK(back.axes[0].count == columns);
          CHECK(back.axes[1].count == rows);
          CHECK(back.axes[0].closed == closed_x);
          CHECK(back.axes[1].closed == closed_y);
        }
      }
  // Other orders, orientations, texture and normal numbers, vertices counted from the end.
  const GridData<double> back = parse_obj(
      "o s # name\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn 0 0 1\nv 0 2 0\nv 1 2 0\ns off\n"
      "f -1 -2 3//1 4/2/1\nf 3 1 2 4\n",
      "f");
  CHECK(back.axes[0].count == 2);
  CHECK(back.axes[1].count == 3);
}

TEST_CASE("what is no grid is refused with its place") {
  const std::string obj = to_obj(sample(3, 3, false, false)), ply = to_ply(sample(3, 3, false, false));
  CHECK(error_of(parse_obj, "").find("f: expected vertices and four-sided faces") == 0);
  CHECK(error_of(parse_obj, replaced(obj, "f 1 2 5 4", "f 1 2 5")) ==
        "f, line 10, word 5: expected f and four vertices; found nothing");
  CHECK(error_of(parse_obj, replaced(obj, "f 1 2 5 4", "f 1 2 5 44")) ==
        "f, line 10, word 5: expected the number of one of the 9 vertices above; found '44'");
  CHECK(error_of(parse_obj, replaced(obj, "f 1 2 5 4", "f 1 2 6 4")).find("do not") != std::string::npos);
  CHECK(error_of(parse_obj, replaced(obj, "f 1 2 5 4\n", "")).find("the 3 faces on 9 vertices do not") !=
        std::string::npos);
  CHECK(error_of(parse_obj, replaced(obj, "v ", "v x")).find("f, line 1, word 2: expected a finite number") == 0);
  CHECK(
      error_of(parse_obj, replaced(obj, "v ", "v nan ")).find("f, line 1, word 5: expected v and three coordinates") ==
      0);
  CHECK(error_of(parse_obj, "curv 1\n") ==
        "f, line 1, word 1: expected v, f, vn, vt, o, g, s, usemtl or mtllib; found 'curv'");
  CHECK(error_of(parse_ply, "") == "f: expected a PLY file, which begins with the line 'ply'");
  CHECK(error_of(parse_ply, replaced(ply, "ascii", "binary_little_endian")).find("expected ascii") !=
        std::string::npos);
  CHECK(error_of(parse_ply, replaced(ply, "element vertex 9", "element vertex 10")) != "");
  CHECK(error_of(parse_ply, replaced(ply, "element vertex 9", "element vertex 99999999999")) != "");
  CHECK(error_of(parse_ply, replaced(ply, "property double z", "property double red")) ==
        "f, line 6, word 3: expected the properties x, y, z of the vertices and no others; found 'red'");
  CHECK(error_of(parse_ply, replaced(ply, "end_header", "end")) ==
        "f, line 9, word 1: expected format, element, property, comment or end_header; found 'end'");
  CHECK(error_of(parse_ply, ply + "4 0 1 2 3\n").find("expected the end of the file") != std::string::npos);
  CHECK(error_of(parse_ply, replaced(ply, "4 0 1 4 3", "3 0 1 4"))
            .find("word 1: expected 4 and four vertices; found '3'") != std::string::npos);
}

TEST_CASE("volumes are read and written") {
  const Volume volume = parse_vtk(vtk, "f");
  CHECK(volume.title == "the title");
  CHECK(volume.name == "density");
  CHECK(volume.data.axes.size() == 3);
  CHECK(volume.data.values.size() == 12);
  CHECK(volume.spacing == std::array<double, 3>{0.5, 1, 2});
  const Volume back = parse_vtk(to_vtk(volume), "f");
  CHECK(back.data.values == volume.data.values);
  CHECK(back.origin == volume.origin);
  const Volume vectors = parse_vtk(
      "# vtk DataFile Version 3.0\n\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 1 1\nPOINT_DATA 2\n"
      "VECTORS v double\n1 2 3 4 5 6\n",
      "f");
  CHECK(vectors.data.dimension == 3);
  CHECK(vectors.data.axes.size() == 2);
}

TEST_CASE("damaged volumes are refused with their place") {
  CHECK(error_of(parse_vtk, "").find("f: expected a legacy VTK file") == 0);
  CHECK(error_of(parse_vtk, replaced(vtk, "ASCII", "BINARY")) ==
        "f, line 3, word 1: expected ASCII (binary files are not read); found 'BINARY'");
  CHECK(error_of(parse_vtk, replaced(vtk, "STRUCTURED_POINTS", "POLYDATA")) ==
        "f, line 4, word 2: expected STRUCTURED_POINTS; found 'POLYDATA'");
  CHECK(error_of(parse_vtk, replaced(vtk, "DIMENSIONS 3 2 2", "DIMENSIONS 3 2")).find("line 5, word 4") !=
        std::string::npos);
  CHECK(error_of(parse_vtk, replaced(vtk, "3 2 2", "99999999 99999999 9")).find("at most 100000000 points") !=
        std::string::npos);
  CHECK(error_of(parse_vtk, replaced(vtk, "POINT_DATA 12", "POINT_DATA 11")) ==
        "f, line 8, word 2: expected 12 as DIMENSIONS say; found '11'");
  CHECK(error_of(parse_vtk, replaced(vtk, "11\n12", "11")) == "f: expected 12 values; found 11");
  CHECK(error_of(parse_vtk, vtk + "13\n") ==
        "f, line 14, word 1: expected the end of the file after one array; found '13'");
  CHECK(error_of(parse_vtk, replaced(vtk, "7 8", "7 inf")) ==
        "f, line 12, word 2: expected a finite number; found 'inf'");
}
