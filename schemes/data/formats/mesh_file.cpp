#include "mesh_parts.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <bit>
#include <charconv>
#include <filesystem>
#include <unordered_map>

namespace subcert::data {
namespace {

/// Takes away the vertices whose number is none, and gives the others their numbers, which rise.
void renumber(PolygonMesh& mesh, const std::vector<std::uint32_t>& number, const std::vector<bool>& kept) {
  const std::size_t size = mesh.dimension;
  std::size_t used = 0;
  for (std::size_t v = 0; v < kept.size(); ++v)
    if (kept[v])
      std::copy_n(mesh.values.begin() + static_cast<std::ptrdiff_t>(v * size), size,
                  mesh.values.begin() + static_cast<std::ptrdiff_t>(used++ * size));
  mesh.values.resize(used * size);
  for (std::uint32_t& vertex : mesh.corners) vertex = number[vertex];
}

/// How many vertices no face has; they are taken away.
std::size_t drop_unused(PolygonMesh& mesh) {
  const std::size_t vertices = mesh.vertices();
  std::vector<bool> used(vertices, false);
  for (const std::uint32_t vertex : mesh.corners) used[vertex] = true;
  std::vector<std::uint32_t> number(vertices, 0);
  std::uint32_t count = 0;
  for (std::size_t v = 0; v < vertices; ++v)
    if (used[v]) number[v] = count++;
  if (count < vertices) renumber(mesh, number, used);
  return vertices - count;
}

/// The numbers of a vertex, by their bits.
struct VertexNumbers {
  const double* begin;
  std::size_t size;

  bool operator==(const VertexNumbers& other) const { return std::equal(begin, begin + size, other.begin); }
};

struct HashOfNumbers {
  std::size_t operator()(const VertexNumbers& numbers) const {
    std::uint64_t hash = 0;
    for (std::size_t c = 0; c < numbers.size; ++c) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(numbers.begin[c] + 0.0)) * 0x9e3779b97f4a7c15U;  // -0 is 0
      hash ^= hash >> 32;
    }
    return hash;
  }
};

void require_faces(const MeshFile& file) {
  require_faces(file.mesh, [&](std::size_t face) { return file.place(face); });
}

}  // namespace

std::string MeshFile::place(std::size_t face) const {
  if (face < lines.rows()) return file + ", line " + std::to_string(lines.at(face));
  return file + ", face " + std::to_string(face);
}

std::optional<MeshFormat> mesh_format(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  constexpr const char* endings[] = {".obj", ".ply", ".off", ".stl"};
  const auto found = std::ranges::find(endings, ending);
  if (found == std::end(endings)) return std::nullopt;
  return static_cast<MeshFormat>(found - std::begin(endings));
}

MeshFile parse_mesh(MeshFormat format, std::string_view text, const std::string& file) {
  constexpr MeshFile (*parsers[])(std::string_view, const std::string&) = {parse_obj, parse_ply, parse_off, parse_stl};
  return parsers[static_cast<std::size_t>(format)](text, file);
}

std::string joined(const std::vector<std::string>& texts) {
  std::string text;
  for (const std::string& one : texts) text += (text.empty() ? "" : ", ") + one;
  return text;
}

bool is_normal(const std::string& name) { return name == "nx" || name == "ny" || name == "nz"; }

void end_face(MeshFile& mesh, std::size_t line) {
  if (mesh.mesh.corners.size() > 4'000'000'000U)
    fail(ErrorKind::data, "{}: expected at most 4000000000 corners of faces", mesh.file);
  mesh.mesh.end_face();
  if (line > 0) mesh.lines.add(line);
}

void join_equal_vertices(MeshFile& file) {
  PolygonMesh& mesh = file.mesh;
  const std::size_t vertices = mesh.vertices(), size = mesh.dimension;
  std::vector<std::uint32_t> number(vertices);
  std::vector<bool> kept(vertices, false);
  std::unordered_map<VertexNumbers, std::uint32_t, HashOfNumbers> numbers;
  numbers.reserve(vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    const auto [found, is_new] = numbers.emplace(VertexNumbers{mesh.values.data() + v * size, size},
                                                 static_cast<std::uint32_t>(numbers.size()));
    number[v] = found->second;
    kept[v] = is_new;
  }
  if (numbers.size() == vertices) return;
  numbers.clear();
  renumber(mesh, number, kept);
  require_faces(file);
}

MeshFile finished(MeshFile mesh, std::vector<std::string> left_out, const TextLines& lines) {
  if (mesh.mesh.faces() == 0)
    lines.fail_file("vertices and faces; found " + std::to_string(mesh.mesh.vertices()) + " vertices and no faces");
  require_faces(mesh);
  if (const std::size_t unused = drop_unused(mesh.mesh); unused > 0)
    left_out.push_back("vertices without faces (" + std::to_string(unused) + ")");
  std::vector<std::string> beside;
  for (std::size_t k = 3; k < mesh.properties.size(); ++k) beside.push_back(mesh.properties[k].name);
  if (!beside.empty()) mesh.remarks.push_back("refined as x, y, z are: " + joined(beside));
  if (!left_out.empty()) mesh.remarks.push_back("left out: " + joined(left_out));
  return mesh;
}

}  // namespace subcert::data
