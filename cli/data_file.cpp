#include "data_file.hpp"

#include "command.hpp"

#include <subcert/schemes/data/quad_mesh.hpp>

#include <algorithm>
#include <filesystem>

namespace subcert::cli {
namespace {

constexpr const char* direction_names[] = {"x", "y", "z"};
constexpr const char* variables_text[] = {"", "one variable", "two variables", "three variables"};

DataFile read_csv(const std::string& path, std::size_t variables) {
  if (variables > 2) throw UsageError(path + ": a scheme of three variables needs a volume in a .vtk file");
  Table table = parse_table(read_file(path), path);
  GridData<double> data;
  if (variables == 1) {
    data = curve_data(std::move(table.values), table.columns);
  } else {
    if (!table.header.empty())
      throw DataFormatError(path + ", line 1: expected a number; a matrix of heights has no header");
    const std::size_t columns = table.columns, rows = table.rows();
    data = {std::move(table.values), 1, {Axis::of(columns), Axis::of(rows)}};
  }
  table.values.clear();
  return {variables == 1 ? DataKind::curve : DataKind::matrix, std::move(data), std::move(table), {}};
}

DataFile read_any(const std::string& path, std::size_t variables) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == ".obj") return {DataKind::obj, parse_obj(read_file(path), path)};
  if (ending == ".ply") return {DataKind::ply, parse_ply(read_file(path), path)};
  if (ending != ".vtk") return read_csv(path, variables);
  Volume volume = parse_vtk(read_file(path), path);
  GridData<double> data = std::move(volume.data);
  return {DataKind::vtk, std::move(data), {}, std::move(volume)};
}

/// Whether the last points in direction `axis` are the first ones again. One number alone proves nothing.
bool repeats_first(const GridData<double>& data, std::size_t axis) {
  if (data.values.size() == data.axes[axis].count) return false;
  std::size_t inner = data.dimension, outer = 1;
  for (std::size_t v = 0; v < axis; ++v) inner *= data.axes[v].count;
  for (std::size_t v = axis + 1; v < data.axes.size(); ++v) outer *= data.axes[v].count;
  const std::size_t slab = inner * data.axes[axis].count;
  for (std::size_t o = 0; o < outer; ++o) {
    const double* const first = data.values.data() + o * slab;
    if (!std::equal(first, first + inner, first + slab - inner)) return false;
  }
  return true;
}

}  // namespace

DataFile read_data_file(const std::string& path, std::size_t variables, const std::array<bool, 3>& closed) {
  DataFile file = read_any(path, variables);
  const std::size_t axes = file.data.axes.size();
  if (axes != variables)
    throw UsageError(path + ": data in " + variables_text[axes] + ", but the scheme has " + variables_text[variables]);
  for (std::size_t v = 0; v < 3; ++v) {
    if (!closed[v]) continue;
    if (file.kind == DataKind::obj || file.kind == DataKind::ply)
      throw UsageError(path + ": the faces of a mesh say which directions are closed; leave out --closed");
    if (v >= axes)
      throw UsageError(std::string("--closed-") + direction_names[v] + ": the data have " + variables_text[axes]);
    file.data.axes[v] = Axis::of(file.data.axes[v].count, true);
  }
  return file;
}

void check_data(const DataFile& file, const std::string& path, const std::string& scheme,
                const std::vector<std::size_t>& fewest) {
  const std::size_t axes = file.data.axes.size();
  for (std::size_t v = 0; v < axes; ++v) {
    const Axis& axis = file.data.axes[v];
    const std::string direction = file.kind == DataKind::curve
                                      ? "rows"
                                      : std::string("points in direction ") + direction_names[v];
    if (axis.count < fewest[v])
      throw DataFormatError(path + ": expected at least " + std::to_string(fewest[v]) + " " + direction + " for " +
                            scheme + "; found " + std::to_string(axis.count));
    if (axis.closed && repeats_first(file.data, v))
      throw DataFormatError(path +
                            (file.kind == DataKind::curve ? ", line " + std::to_string(file.table.lines.back()) : "") +
                            ": expected each point of a closed " +
                            (axes == 1   ? "curve"
                             : axes == 2 ? "surface"
                                         : "volume") +
                            " once; found the first " + (axes == 1 ? "row" : direction) + " again");
  }
}

std::string file_text(const DataFile& file, const GridData<double>& data) {
  if (file.kind == DataKind::obj) return to_obj(data);
  if (file.kind == DataKind::ply) return to_ply(data);
  if (file.kind == DataKind::vtk) {
    Volume volume = file.volume;
    volume.data = data;
    return to_vtk(volume);
  }
  Table table = file.table;
  table.values = data.values;
  if (file.kind == DataKind::matrix) table.columns = data.axes[0].count;
  return to_text(table);
}

}  // namespace subcert::cli
