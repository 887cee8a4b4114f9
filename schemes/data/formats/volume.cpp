#include "volume.hpp"

#include "text_lines.hpp"

#include <subcert/schemes/data/refine/axis_refinement.hpp>

#include <algorithm>
#include <ostream>
#include <sstream>
#include <utility>

namespace subcert::data {
namespace {

constexpr std::size_t most_values = 100'000'000;
constexpr NumberType byte{1, true, false};

struct VtkType {
  const char* name;
  NumberType type;
};

/// Of 64-bit machines. Identifiers are written as 32-bit numbers.
constexpr VtkType vtk_types[] = {{"UNSIGNED_CHAR", byte},
                                 {"CHAR", {1, true, true}},
                                 {"UNSIGNED_SHORT", {2, true, false}},
                                 {"SHORT", {2, true, true}},
                                 {"UNSIGNED_INT", {4, true, false}},
                                 {"INT", {4, true, true}},
                                 {"UNSIGNED_LONG", {8, true, false}},
                                 {"LONG", {8, true, true}},
                                 {"VTKTYPEINT64", {8, true, true}},
                                 {"VTKTYPEUINT64", {8, true, false}},
                                 {"FLOAT", {4, false, true}},
                                 {"DOUBLE", {8, false, true}},
                                 {"VTKIDTYPE", {4, true, true}}};

NumberType vtk_type(const TextLines& lines, std::size_t word) {
  for (const VtkType& one : vtk_types)
    if (lines.is_keyword(word, one.name)) return one.type;
  lines.fail(word, "a type of numbers, as unsigned_char, int, float or double");
}

/// An array as it was read.
struct ReadArray {
  VolumeArray what;
  std::vector<double> values;
};

/// Reads the parts of a file after DATASET.
class VtkReader {
 public:
  VtkReader(TextLines& lines, Volume& volume, bool gaps) : lines_(lines), volume_(volume), gaps_(gaps) {}

  void read() {
    read_geometry();
    do {
      const bool cells = lines_.is_keyword(0, "CELL_DATA");
      lines_.need(cells || lines_.is_keyword(0, "POINT_DATA"), 0, "POINT_DATA or CELL_DATA");
      const std::size_t expected = cells ? cell_count() : points_;
      lines_.need(lines_.count(1, 1, most_values, "a number of points") == expected, 1,
                  std::to_string(expected) + " as DIMENSIONS say");
      read_arrays(expected, cells ? cells_ : arrays_);
    } while (!ended_);
    set_arrays();
  }

 private:
  bool next() {
    ended_ = !lines_.next(false);
    return !ended_;
  }

  void leave_out(const std::string& what) {
    if (std::ranges::count(left_out_, what) == 0) left_out_.push_back(what);
  }

  void read_geometry() {
    for (bool ended = false; !ended;) {
      if (!next()) lines_.fail_file("DIMENSIONS and POINT_DATA");
      if (lines_.is_keyword(0, "DIMENSIONS")) {
        lines_.need(points_ == 0, 0, "DIMENSIONS once");
        read_dimensions();
      } else if (lines_.is_keyword(0, "ORIGIN") || lines_.is_keyword(0, "SPACING") ||
                 lines_.is_keyword(0, "ASPECT_RATIO")) {
        for (std::size_t v = 0; v < 3; ++v)
          (lines_.is_keyword(0, "ORIGIN") ? volume_.origin : volume_.spacing)[v] = lines_.number(v + 1);
      } else if (lines_.is_keyword(0, "FIELD")) {
        read_field(0, nullptr);
        leave_out("fields of the data set");
      } else if (lines_.is_keyword(0, "METADATA")) {
        lines_.pass_paragraph();
      } else {
        ended = lines_.is_keyword(0, "POINT_DATA") || lines_.is_keyword(0, "CELL_DATA");
        lines_.need(ended, 0, "DIMENSIONS, ORIGIN, SPACING, FIELD, POINT_DATA or CELL_DATA");
        lines_.need(points_ > 0, 0, "DIMENSIONS before the data");
      }
    }
  }

  void read_dimensions() {
    points_ = 1;
    for (std::size_t v = 0; v < 3; ++v) {
      counts_[v] = lines_.count(v + 1, 1, most_values, "a number of points");
      if (points_ > most_values / counts_[v]) lines_.fail(v + 1, "at most " + std::to_string(most_values) + " points");
      points_ *= counts_[v];
    }
  }

  std::size_t cell_count() const {
    std::size_t cells = 1;
    for (const std::size_t count : counts_) cells *= std::max<std::size_t>(count, 2) - 1;
    return cells;
  }

  /// The arrays of a section, up to the next one or the end.
  void read_arrays(std::size_t points, std::vector<ReadArray>& arrays) {
    while (next() && !lines_.is_keyword(0, "POINT_DATA") && !lines_.is_keyword(0, "CELL_DATA")) {
      if (lines_.is_keyword(0, "METADATA"))
        lines_.pass_paragraph();
      else if (lines_.is_keyword(0, "FIELD"))
        read_field(points, &arrays);
      else if (lines_.is_keyword(0, "LOOKUP_TABLE"))
        read_lookup_table();
      else
        read_attribute(points, arrays);
    }
  }

  /// LOOKUP_TABLE NAME alone belongs to the array before or after it.
  void read_lookup_table() {
    if (lines_.words().size() < 3) return;
    const std::size_t size = lines_.count(2, 0, most_values, "a number of colours");
    lines_.take_numbers(4 * size, byte, volume_.encoding);
    leave_out("lookup tables");
  }

  void read_attribute(std::size_t points, std::vector<ReadArray>& arrays) {
    static constexpr std::pair<const char*, std::size_t> keywords[] = {
        {"SCALARS", 1}, {"COLOR_SCALARS", 0}, {"VECTORS", 3},      {"TENSORS", 9},   {"TEXTURE_COORDINATES", 0},
        {"NORMALS", 3}, {"GLOBAL_IDS", 1},    {"PEDIGREE_IDS", 1}, {"EDGE_FLAGS", 1}};
    const auto found = std::ranges::find_if(keywords, [&](const auto& one) { return lines_.is_keyword(0, one.first); });
    lines_.need(
        found != std::end(keywords), 0,
        arrays.empty() ? "SCALARS, VECTORS, FIELD or another kind of array" : "the end of the file, or another array");
    VolumeArray array{std::string(lines_.word(1)), found->first, found->second};
    const bool colours = array.keyword == "COLOR_SCALARS", textures = array.keyword == "TEXTURE_COORDINATES";
    if (colours || textures || (array.keyword == "SCALARS" && lines_.words().size() > 3))
      array.components = lines_.count(array.keyword == "SCALARS" ? 3 : 2, 1, 9, "a number of components");
    const NumberType type = colours ? byte : vtk_type(lines_, textures ? 3 : 2);
    if (array.keyword == "SCALARS") pass_table_name_ = true;
    std::vector<double> values = take(points, array.components, type);
    if (found - std::begin(keywords) < 5)
      arrays.push_back({std::move(array), std::move(values)});
    else
      leave_out(array.keyword);
  }

  /// The numbers of an array; behind SCALARS the name of a lookup table may come first.
  std::vector<double> take(std::size_t points, std::size_t components, const NumberType& type) {
    if (std::exchange(pass_table_name_, false)) lines_.pass_line("LOOKUP_TABLE");
    if (points > 0 && components > most_values / points)
      lines_.fail(0, "at most " + std::to_string(most_values) + " numbers in an array");
    return lines_.take_numbers(points * components, type, volume_.encoding, gaps_);
  }

  /// Without `arrays` what is read is left out, and may be of any length.
  void read_field(std::size_t points, std::vector<ReadArray>* arrays) {
    const std::size_t count = lines_.count(2, 0, 100'000, "a number of arrays");
    for (std::size_t i = 0; i < count; ++i) {
      do {
        if (!next()) lines_.fail_file(std::to_string(count) + " arrays in FIELD; found " + std::to_string(i));
        if (lines_.is_keyword(0, "METADATA")) lines_.pass_paragraph();
      } while (lines_.is_keyword(0, "METADATA"));
      VolumeArray array{std::string(lines_.word(0)), "FIELD",
                        lines_.count(1, arrays ? 1 : 0, 100'000, "a number of components")};
      const std::size_t tuples = lines_.count(2, 0, most_values, "a number of points");
      lines_.need(!arrays || tuples == points, 2, std::to_string(points) + ", one for each point");
      std::vector<double> values = take(tuples, array.components, vtk_type(lines_, 3));
      if (arrays) arrays->push_back({std::move(array), std::move(values)});
    }
  }

  /// Puts the arrays of the points, or those of the cells where there are none, into the volume.
  void set_arrays() {
    const bool cells = arrays_.empty();
    if (!cells && !cells_.empty()) leave_out("CELL_DATA");
    if (cells) {
      if (cells_.empty()) lines_.fail_file("an array of POINT_DATA or CELL_DATA; found none");
      volume_.remarks.emplace_back("CELL_DATA are taken as data at the middles of the cells");
      arrays_ = std::move(cells_);
    }
    for (std::size_t v = 0; v < 3; ++v) {
      if (cells && counts_[v] > 1) {
        volume_.origin[v] += volume_.spacing[v] / 2;
        --counts_[v];
      }
      if (v < 2 || counts_[v] > 1) volume_.data.axes.push_back(Axis::of(counts_[v]));
    }
    std::stable_partition(arrays_.begin(), arrays_.end(),
                          [](const ReadArray& one) { return one.what.keyword != "FIELD"; });
    join_numbers();
    if (left_out_.empty()) return;
    std::string text = "left out: ";
    for (const std::string& what : left_out_) text += (text.ends_with(": ") ? "" : ", ") + what;
    volume_.remarks.push_back(text);
  }

  void join_numbers() {
    GridData<double>& data = volume_.data;
    data.dimension = 0;
    for (const ReadArray& one : arrays_) {
      volume_.arrays.push_back(one.what);
      data.dimension += one.what.components;
    }
    if (arrays_.size() == 1) {
      data.values = std::move(arrays_.front().values);
      return;
    }
    if (data.dimension > most_values / data.points())
      lines_.fail_file("at most " + std::to_string(most_values) + " numbers in all arrays");
    data.values.resize(data.points() * data.dimension);
    std::size_t first = 0;
    for (ReadArray& one : arrays_) {
      const std::size_t size = one.what.components;
      for (std::size_t i = 0; i < one.values.size(); ++i)
        data.values[i / size * data.dimension + first + i % size] = one.values[i];
      first += size;
      one.values = {};
    }
  }

  TextLines& lines_;
  Volume& volume_;
  bool gaps_;
  std::array<std::size_t, 3> counts_{};
  std::size_t points_ = 0;
  bool ended_ = false;
  bool pass_table_name_ = false;
  std::vector<ReadArray> arrays_;
  std::vector<ReadArray> cells_;
  std::vector<std::string> left_out_;
};

/// Of VTK's colours: bytes, or text from 0 to 1.
bool is_colour(const VolumeArray& array) { return array.keyword == "COLOR_SCALARS"; }

}  // namespace

Volume parse_vtk(std::string_view text, const std::string& file, bool gaps) {
  TextLines lines(text, file);
  constexpr std::string_view beginning = "# vtk DataFile Version ";
  if (!lines.next(false) || !text.substr(text.find('#') == 3 ? 3 : 0).starts_with(beginning))
    lines.fail_file("a legacy VTK file, which begins with '" + std::string(beginning) + "'");
  Volume volume{{{}, 1, {}}, "", {}, {0, 0, 0}, {1, 1, 1}};
  if (!lines.next(false)) lines.fail_file("a title, ASCII, DATASET");
  if (lines.line() == 2) {  // else the title is empty
    for (const std::string_view word : lines.words())
      volume.title += (volume.title.empty() ? "" : " ") + std::string(word);
    if (!lines.next(false)) lines.fail_file("ASCII, DATASET");
  }
  lines.need(lines.is_keyword(0, "ASCII") || lines.is_keyword(0, "BINARY"), 0, "ASCII or BINARY");
  if (lines.is_keyword(0, "BINARY")) volume.encoding = Encoding::big_endian;
  if (!lines.next(false)) lines.fail_file("DATASET STRUCTURED_POINTS");
  const bool data_set = lines.is_keyword(0, "DATASET");
  lines.need(data_set && lines.is_keyword(1, "STRUCTURED_POINTS"), data_set ? 1 : 0,
             data_set ? "STRUCTURED_POINTS" : "DATASET");
  VtkReader(lines, volume, gaps).read();
  return volume;
}

void write_volume_begin(std::ostream& stream, const Volume& form, const std::vector<Axis>& axes) {
  std::string dimensions = "DIMENSIONS", origin = "ORIGIN", spacing = "SPACING";
  std::size_t points = 1;
  for (std::size_t v = 0; v < 3; ++v) {
    const bool there = v < axes.size();
    const std::size_t count = there ? axes[v].count : 1;
    points *= count;
    dimensions += " " + std::to_string(count);
    origin += " " + shortest_text(form.origin[v] + (there ? nearest_double(axes[v].first) * form.spacing[v] : 0));
    spacing += " " + shortest_text(form.spacing[v] * (there ? nearest_double(axes[v].step) : 1));
  }
  stream << "# vtk DataFile Version 3.0\n"
         << (form.title.empty() ? "data" : form.title) << (form.encoding == Encoding::text ? "\nASCII" : "\nBINARY")
         << "\nDATASET STRUCTURED_POINTS\n"
         << dimensions << "\n"
         << origin << "\n"
         << spacing << "\nPOINT_DATA " << points << "\n";
}

void write_array_begin(std::ostream& stream, const Volume& form, std::size_t array, std::size_t points) {
  const VolumeArray& what = form.arrays[array];
  if (what.keyword == "FIELD") {
    if (array == 0 || form.arrays[array - 1].keyword != "FIELD")
      stream << "FIELD FieldData " << form.arrays.size() - array << "\n";
    stream << what.name << " " << what.components << " " << points << " double\n";
    return;
  }
  const bool counted = is_colour(what) || what.keyword == "TEXTURE_COORDINATES";
  stream << what.keyword << " " << what.name << (counted ? " " + std::to_string(what.components) : "")
         << (is_colour(what) ? "" : " double");
  if (what.keyword == "SCALARS") stream << " " << what.components << "\nLOOKUP_TABLE default";
  stream << "\n";
}

void write_array(std::ostream& stream, const Volume& form, std::size_t array, const double* values,
                 std::size_t points) {
  const VolumeArray& what = form.arrays[array];
  std::size_t first = 0;
  for (std::size_t k = 0; k < array; ++k) first += form.arrays[k].components;
  std::size_t dimension = 0;
  for (const VolumeArray& one : form.arrays) dimension += one.components;
  std::string text;
  for (std::size_t i = 0; i < points; ++i) {
    text.clear();
    for (std::size_t c = 0; c < what.components; ++c) {
      const double value = values[i * dimension + first + c];
      if (form.encoding != Encoding::text)
        append_number(value, is_colour(what) ? byte : NumberType{}, form.encoding, text);
      else
        text += shortest_text(is_colour(what) ? std::clamp(value, 0.0, 1.0) : value) +
                (c + 1 == what.components ? '\n' : ' ');
    }
    stream << text;
  }
}

void write_array_end(std::ostream& stream, const Volume& form) {
  if (form.encoding != Encoding::text) stream << '\n';
}

std::string to_text(const Volume& volume) {
  std::ostringstream stream;
  write_volume_begin(stream, volume, volume.data.axes);
  for (std::size_t k = 0; k < volume.arrays.size(); ++k) {
    write_array_begin(stream, volume, k, volume.data.points());
    write_array(stream, volume, k, volume.data.values.data(), volume.data.points());
    write_array_end(stream, volume);
  }
  return stream.str();
}

}  // namespace subcert::data
