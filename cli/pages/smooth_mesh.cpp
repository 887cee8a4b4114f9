#include "smooth_mesh.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cli/data_file.hpp>
#include <subcert/schemes/data/formats/mesh_file.hpp>
#include <subcert/schemes/data/mesh/mesh_refinement.hpp>

#include <fmt/ranges.h>

#include <utility>

namespace subcert::cli {

void smooth_mesh_file(const SmoothOptions& options) {
  if (!data::has_mesh_rules(options.scheme))
    fail(ErrorKind::usage, "--scheme {}: expected, for a mesh, one of {}", options.scheme,
         fmt::join(data::schemes_with_mesh_rules(), ", "));
  const data::SampleOptions& samples = options.samples;
  for (const std::string& name : options.given())
    if (name != "--scheme" && name != "--steps" && name != "--out" && name != "--quiet" && name != "--jobs")
      fail(ErrorKind::usage, "{}: {}: a mesh is smoothed by --scheme, --steps and --out alone", samples.name(), name);
  data::MeshFile file = read_mesh_file(samples.file, options.out, false);
  for (const std::string& line : file.remarks) options.remark(samples.name() + ": " + line);
  const data::PolygonMesh smoothed = refine_mesh(std::exchange(file.mesh, {}), options.scheme,
                                                 {options.steps, false, false, std::nullopt, true},
                                                 [&](std::size_t face) { return file.place(face); });
  options.answer([&](std::ostream& stream) { write_mesh(stream, file, smoothed); });
}

}  // namespace subcert::cli
