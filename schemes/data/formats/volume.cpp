#include "volume.hpp"

#include "text_lines.hpp"

#include <subcert/schemes/data/refine/axis_refinement.hpp>

namespace subcert::data {
namespace {

constexpr std::size_t most_values = 100'000'000;

void read_geometry(TextLines& lines, Volume& volume) {
  std::size_t points = 1;
  for (bool dimensions = false, ended = false; !ended;) {
    if (!lines.next()) lines.fail_file("DIMENSIONS and POINT_DATA");
    if (lines.is(0, "DIMENSIONS")) {
      lines.need(!dimensions, 0, "DIMENSIONS once");
      dimensions = true;
      for (std::size_t v = 0; v < 3; ++v) {
        const std::size_t count = lines.count(v + 1, 1, most_values, "a number of points");
        if (points > most_values / count) lines.fail(v + 1, "at most " + std::to_string(most_values) + " points");
        points *= count;
        if (v < 2 || count > 1) volume.data.axes.push_back(Axis::of(count));
      }
    } else if (lines.is(0, "ORIGIN") || lines.is(0, "SPACING") || lines.is(0, "ASPECT_RATIO")) {
      for (std::size_t v = 0; v < 3; ++v)
        (lines.is(0, "ORIGIN") ? volume.origin : volume.spacing)[v] = lines.number(v + 1);
    } else if (lines.is(0, "POINT_DATA")) {
      lines.need(dimensions, 0, "DIMENSIONS before POINT_DATA");
      lines.need(lines.count(1, 1, most_values, "a number of points") == points, 1,
                 std::to_string(points) + " as DIMENSIONS say");
      ended = true;
    } else {
      lines.fail(0, "DIMENSIONS, ORIGIN, SPACING or POINT_DATA");
    }
  }
}

void read_array_header(TextLines& lines, Volume& volume) {
  if (!lines.next()) lines.fail_file("SCALARS or VECTORS");
  lines.need(lines.is(0, "SCALARS") || lines.is(0, "VECTORS"), 0, "SCALARS or VECTORS");
  lines.need(lines.words().size() >= 3, lines.words().size(), "the name and the type of the array");
  volume.name = lines.word(1);
  volume.data.dimension = lines.is(0, "VECTORS")     ? 3
                          : lines.words().size() > 3 ? lines.count(3, 1, 4, "a number of components")
                                                     : 1;
}

}  // namespace

Volume parse_vtk(std::string_view text, const std::string& file) {
  TextLines lines(text, file);
  constexpr std::string_view beginning = "# vtk DataFile Version ";
  if (text.substr(0, beginning.size()) != beginning)
    lines.fail_file("a legacy VTK file, which begins with '" + std::string(beginning) + "'");
  Volume volume{{{}, 1, {}}, "", "", {0, 0, 0}, {1, 1, 1}};
  lines.next(false);
  if (!lines.next(false)) lines.fail_file("a title, ASCII, DATASET");
  if (lines.line() == 2) {  // else the title is empty
    for (const std::string_view word : lines.words())
      volume.title += (volume.title.empty() ? "" : " ") + std::string(word);
    if (!lines.next(false)) lines.fail_file("ASCII, DATASET");
  }
  lines.need(lines.is(0, "ASCII"), 0, "ASCII (binary files are not read)");
  if (!lines.next(false)) lines.fail_file("DATASET STRUCTURED_POINTS");
  lines.need(lines.is(0, "DATASET") && lines.is(1, "STRUCTURED_POINTS"), lines.is(0, "DATASET") ? 1 : 0,
             lines.is(0, "DATASET") ? "STRUCTURED_POINTS" : "DATASET");
  read_geometry(lines, volume);
  read_array_header(lines, volume);
  const std::size_t values = volume.data.points() * volume.data.dimension;
  bool table_allowed = true;
  while (volume.data.values.size() < values) {
    if (!lines.next(false))
      lines.fail_file(std::to_string(values) + " values; found " + std::to_string(volume.data.values.size()));
    if (table_allowed && volume.data.values.empty() && lines.is(0, "LOOKUP_TABLE")) {
      table_allowed = false;
      continue;
    }
    for (std::size_t i = 0; i < lines.words().size(); ++i) {
      lines.need(volume.data.values.size() < values, i,
                 "the end of the file after " + std::to_string(values) + " values");
      volume.data.values.push_back(lines.number(i));
    }
  }
  if (lines.next(false)) lines.fail(0, "the end of the file after one array");
  return volume;
}

std::string to_vtk(const Volume& volume) {
  const GridData<double>& data = volume.data;
  std::string dimensions = "DIMENSIONS", origin = "ORIGIN", spacing = "SPACING";
  for (std::size_t v = 0; v < 3; ++v) {
    const bool there = v < data.axes.size();
    dimensions += " " + std::to_string(there ? data.axes[v].count : 1);
    origin += " " +
              shortest_text(volume.origin[v] + (there ? nearest_double(data.axes[v].first) * volume.spacing[v] : 0));
    spacing += " " + shortest_text(volume.spacing[v] * (there ? nearest_double(data.axes[v].step) : 1));
  }
  std::string text = "# vtk DataFile Version 3.0\n" + (volume.title.empty() ? "data" : volume.title) +
                     "\nASCII\nDATASET STRUCTURED_POINTS\n" + dimensions + "\n" + origin + "\n" + spacing +
                     "\nPOINT_DATA " + std::to_string(data.points()) + "\nSCALARS " + volume.name + " double " +
                     std::to_string(data.dimension) + "\nLOOKUP_TABLE default\n";
  for (std::size_t i = 0; i < data.values.size(); ++i)
    text += shortest_text(data.values[i]) + ((i + 1) % data.dimension == 0 ? '\n' : ' ');
  return text;
}

}  // namespace subcert::data
