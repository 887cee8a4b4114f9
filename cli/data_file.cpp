#include "data_file.hpp"

#include "command.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

namespace subcert::cli {
namespace {

constexpr std::array<const char*, 3> direction_names = {"x", "y", "z"};
constexpr const char* variables_text[] = {"", "one variable", "two variables", "three variables"};

/// About how many numbers a file holds of which these are the first rows.
std::size_t expected_numbers(const std::string& path, std::size_t bytes, std::size_t numbers) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  if (path == standard_stream || error || bytes == 0) return 0;
  return static_cast<std::size_t>(1.05 * static_cast<double>(size) / static_cast<double>(bytes) *
                                  static_cast<double>(numbers));
}

/// The table, whose text need not be held.
data::Table read_pieces(const std::string& path, data::RowLines& lines, const data::TableForm& form) {
  data::TableReader reader(input_name(path), form);
  runtime::LineInput input(path);
  std::optional<data::Table> all;
  for (std::string text; input.read_lines(text);) {
    const data::Table& rows = reader.read(text);
    if (rows.rows() == 0) continue;
    for (const std::size_t line : rows.lines) lines.add(line);
    if (!all) {
      all = rows;
      all->lines.clear();
      all->values.reserve(expected_numbers(path, text.size(), rows.values.size()));
      continue;
    }
    all->values.insert(all->values.end(), rows.values.begin(), rows.values.end());
  }
  reader.finish();
  return std::move(*all);
}

DataFile read_csv(const std::string& path, std::size_t variables, bool pieces, data::Missing missing) {
  if (variables > 2) fail(ErrorKind::usage, "{}: a scheme of three variables needs a volume in a .vtk file", path);
  data::RowLines lines;
  data::TableForm form(missing);
  form.gaps = variables == 1 ? " (subcert smooth fills gaps, with --missing drop)"
                             : " (subcert smooth --grid fills gaps, with --missing drop)";
  data::Table table = pieces && variables == 1 ? read_pieces(path, lines, form)
                                               : data::parse_table(read_input(path), input_name(path), form);
  for (const std::size_t line : std::exchange(table.lines, {})) lines.add(line);
  data::GridData<double> data;
  if (variables == 1) {
    data = data::curve_data(std::move(table.values), table.columns);
  } else {
    if (!table.header.empty())
      fail(ErrorKind::data, "{}, line 1: expected a number; a matrix of heights has no header", path);
    const std::size_t columns = table.columns, rows = table.rows();
    data = {std::move(table.values), 1, {data::Axis::of(columns), data::Axis::of(rows)}};
  }
  table.values.clear();
  return {
      variables == 1 ? DataKind::curve : DataKind::matrix, std::move(data), std::move(table), {}, {}, std::move(lines)};
}

DataFile read_any(const std::string& path, std::size_t variables, bool pieces = false,
                  data::Missing missing = data::Missing::refuse) {
  if (data::mesh_format(path)) {
    data::MeshFile mesh = read_mesh_file(path, path, false);
    data::GridData<double> data = take_grid(mesh);
    return {DataKind::mesh, std::move(data), {}, std::move(mesh)};
  }
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending != ".vtk") return read_csv(path, variables, pieces, missing);
  data::Volume volume = data::parse_vtk(read_input(path), input_name(path), missing == data::Missing::keep);
  data::GridData<double> data = std::move(volume.data);
  volume.data.values.clear();
  return {DataKind::volume, std::move(data), {}, {}, std::move(volume)};
}

/// Whether the last points in direction `axis` are the first ones again. One number alone proves nothing.
bool repeats_first(const data::GridData<double>& data, std::size_t axis) {
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

data::MeshFile read_mesh_file(const std::string& path, const std::string& out, bool join) {
  data::MeshFile mesh = data::parse_mesh(*data::mesh_format(path), read_input(path), input_name(path));
  if (join) join_equal_vertices(mesh);
  if (const auto format = data::mesh_format(out)) change_format(mesh, *format);
  return mesh;
}

DataFile read_data_file(const std::string& path, std::size_t variables, const std::array<bool, 3>& closed,
                        bool pieces) {
  DataFile file = read_any(path, variables, pieces);
  const std::size_t axes = file.data.axes.size();
  if (axes != variables)
    fail(ErrorKind::usage, "{}: data in {}, but the scheme has {}", path, variables_text[axes],
         variables_text[variables]);
  for (std::size_t v = 0; v < 3; ++v) {
    if (!closed[v]) continue;
    if (file.kind == DataKind::mesh)
      fail(ErrorKind::usage, "{}: the faces of a mesh say which directions are closed; leave out --closed", path);
    if (v >= axes) fail(ErrorKind::usage, "--closed-{}: the data have {}", direction_names[v], variables_text[axes]);
    file.data.axes[v] = data::Axis::of(file.data.axes[v].count, true);
  }
  return file;
}

DataFile read_grid_file(const std::string& path, data::Missing missing) {
  DataFile file = read_any(path, 2, false, missing);
  if (file.kind == DataKind::mesh)
    fail(ErrorKind::usage, "{}: expected a matrix of heights or a .vtk file; found a mesh, whose places are data, too",
         path);
  return file;
}

void check_data(const DataFile& file, const std::string& path, const std::string& scheme,
                const std::vector<std::size_t>& fewest, const std::vector<std::size_t>& fewest_closed) {
  const std::size_t axes = file.data.axes.size();
  for (std::size_t v = 0; v < axes; ++v) {
    const data::Axis& axis = file.data.axes[v];
    const std::string direction = file.kind == DataKind::curve
                                      ? "rows"
                                      : std::string("points in direction ") + direction_names.at(v);
    const std::size_t needed = axis.closed ? fewest_closed[v] : fewest[v];
    if (axis.count < needed)
      fail(ErrorKind::data, "{}: expected at least {} {} for {}; found {}", input_name(path), needed, direction, scheme,
           axis.count);
    if (axis.closed && axis.count > 1 && repeats_first(file.data, v))
      fail(ErrorKind::data, "{}{}: expected each point of a closed {} once; found the first {} again", input_name(path),
           (file.kind == DataKind::curve ? ", line " + std::to_string(file.lines.at(axis.count - 1)) : ""),
           (axes == 1   ? "curve"
            : axes == 2 ? "surface"
                        : "volume"),
           (axes == 1 ? "row" : direction));
  }
}

std::vector<std::string> DataFile::names() const {
  if (kind == DataKind::curve) return table.header;
  std::vector<std::string> names;
  if (kind == DataKind::mesh)
    for (const data::VertexProperty& property : mesh.properties) names.push_back(property.name);
  if (kind == DataKind::volume)
    for (const data::VolumeArray& array : volume.arrays)
      for (std::size_t c = 0; c < array.components; ++c)
        names.push_back(array.name + (array.components == 1 ? "" : "_" + std::to_string(c)));
  return names;
}

namespace {

void write_grid(std::ostream& stream, const data::MeshFile& mesh, const std::vector<data::Axis>& axes,
                const PointSource& source) {
  write_grid_begin(stream, mesh, axes);
  source([&](const double* values, std::size_t points) { write_vertices(stream, mesh, values, points); });
  write_grid_end(stream, mesh, axes);
}

void write_volume(std::ostream& stream, const data::Volume& volume, const std::vector<data::Axis>& axes,
                  const PointSource& source) {
  std::size_t points = 1;
  for (const data::Axis& axis : axes) points *= axis.count;
  write_volume_begin(stream, volume, axes);
  for (std::size_t k = 0; k < volume.arrays.size(); ++k) {
    write_array_begin(stream, volume, k, points);
    source([&](const double* values, std::size_t count) { write_array(stream, volume, k, values, count); });
    write_array_end(stream, volume);
  }
}

}  // namespace

void write_data(std::ostream& stream, const DataFile& file, const std::vector<data::Axis>& axes,
                const PointSource& source, int threads) {
  if (file.kind == DataKind::mesh) return write_grid(stream, file.mesh, axes, source);
  if (file.kind == DataKind::volume) return write_volume(stream, file.volume, axes, source);
  const std::size_t dimension = file.data.dimension, width = file.kind == DataKind::matrix ? axes[0].count : dimension;
  stream << data::header_text(file.table.header, file.table.separator);
  source([&](const double* values, std::size_t points) {
    std::vector<data::TableColumn> columns;
    for (std::size_t c = 0; c < width; ++c) columns.push_back({values + c, width});
    data::write_rows(stream, columns, points * dimension / width, file.table.separator, threads);
  });
}

}  // namespace subcert::cli
