// Refinement of meshes: a torus of 10^6 triangles, or as many corners of quadrilaterals. BM_read and BM_write are the
// file before and after two levels, as text.

#include <subcert/schemes/data/formats/mesh_file.hpp>
#include <subcert/schemes/data/mesh/mesh_refinement.hpp>

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

namespace {

using namespace subcert::data;

constexpr std::uint32_t columns = 1000, rows = 500;

std::string place(std::size_t face) { return std::to_string(face); }

PolygonMesh torus(bool triangles) {
  PolygonMesh mesh;
  for (std::uint32_t j = 0; j < rows; ++j)
    for (std::uint32_t i = 0; i < columns; ++i) {
      const double u = 2 * std::numbers::pi * i / columns, v = 2 * std::numbers::pi * j / rows, r = 3 + std::cos(v);
      mesh.values.insert(mesh.values.end(), {r * std::cos(u), r * std::sin(u), std::sin(v)});
      const std::uint32_t right = (i + 1) % columns, up = (j + 1) % rows;
      const std::uint32_t a = j * columns + i, b = j * columns + right, c = up * columns + right, d = up * columns + i;
      if (triangles) {
        mesh.corners.insert(mesh.corners.end(), {a, b, c});
        mesh.end_face();
        mesh.corners.insert(mesh.corners.end(), {a, c, d});
      } else {
        mesh.corners.insert(mesh.corners.end(), {a, b, c, d});
      }
      mesh.end_face();
    }
  return mesh;
}

MeshFile file_of(PolygonMesh mesh) { return {std::move(mesh), {{"x"}, {"y"}, {"z"}}}; }

void BM_mesh(benchmark::State& state, const char* scheme, bool limit) {
  const PolygonMesh mesh = torus(std::string(scheme) != "catmull-clark" && std::string(scheme) != "doo-sabin");
  std::size_t faces = 0;
  for (auto _ : state) faces = refine_mesh(mesh, scheme, {2, limit, false}, place).faces();
  state.counters["faces/s"] = benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(faces),
                                                 benchmark::Counter::kIsRate);
}
BENCHMARK_CAPTURE(BM_mesh, loop, "loop", false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_mesh, loop_limit, "loop", true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_mesh, butterfly, "butterfly:w=1/16", false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_mesh, sqrt3, "sqrt3", false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_mesh, catmull_clark, "catmull-clark", false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_mesh, doo_sabin, "doo-sabin", false)->Unit(benchmark::kMillisecond);

void BM_topology(benchmark::State& state) {
  const PolygonMesh mesh = torus(true);
  for (auto _ : state) benchmark::DoNotOptimize(Topology(mesh, place).edges());
}
BENCHMARK(BM_topology)->Unit(benchmark::kMillisecond);

void BM_read(benchmark::State& state) {
  const std::string text = to_text(file_of(torus(true)));
  for (auto _ : state) benchmark::DoNotOptimize(parse_obj(text, "torus").mesh.faces());
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(text.size()));
}
BENCHMARK(BM_read)->Unit(benchmark::kMillisecond);

void BM_write(benchmark::State& state) {
  const MeshFile file = file_of(refine_mesh(torus(true), "loop", {2, false, false}, place));
  std::size_t bytes = 0;
  for (auto _ : state) bytes = to_text(file).size();
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(bytes));
}
BENCHMARK(BM_write)->Unit(benchmark::kMillisecond);

}  // namespace
