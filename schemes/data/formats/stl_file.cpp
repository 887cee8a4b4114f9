#include "mesh_parts.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <cmath>

namespace subcert::data {
namespace {

constexpr std::size_t header_bytes = 80, facet_bytes = 50;
constexpr NumberType facet_number{4, false, true}, facet_count{4, true, false}, facet_attribute{2, true, false};

/// The facets of a file in bytes, three vertices each; whether they have attributes.
bool read_facets(TextLines& lines, MeshFile& mesh) {
  lines.take_bytes(header_bytes, "the header");
  const auto read = [&](const char* bytes, const NumberType& type) {
    return read_number(bytes, type, Encoding::little_endian);
  };
  const auto count = static_cast<std::size_t>(read(lines.take_bytes(4, "the number of facets"), facet_count));
  bool attributes = false;
  for (std::size_t f = 0; f < count; ++f) {
    const char* const bytes = lines.take_bytes(facet_bytes, "facet " + std::to_string(f));
    for (std::size_t k = 3; k < 12; ++k) {
      const double value = read(bytes + 4 * k, facet_number);
      if (!std::isfinite(value))
        lines.fail_file("finite numbers in facet " + std::to_string(f) + "; found " + shortest_text(value));
      mesh.mesh.values.push_back(value);
    }
    attributes = attributes || read(bytes + 48, facet_attribute) != 0;
  }
  return attributes;
}

void need_line(TextLines& lines, std::initializer_list<const char*> words) {
  if (!lines.next(false)) lines.fail_file(std::string("the line ") + *words.begin() + " of a facet");
  std::size_t i = 0;
  for (const char* word : words) lines.need(lines.is_keyword(i, word), i, word), ++i;
}

/// The facets between `solid` and `endsolid`, of which there may be several.
void read_facet_lines(TextLines& lines, MeshFile& mesh) {
  bool open = false;
  while (lines.next(false)) {
    if (lines.is_keyword(0, open ? "ENDSOLID" : "SOLID")) {
      open = !open;
      continue;
    }
    lines.need(open, 0, "solid");
    lines.need(lines.is_keyword(0, "FACET"), 0, "facet or endsolid");
    const std::size_t line = lines.line();
    need_line(lines, {"OUTER", "LOOP"});
    for (int v = 0; v < 3; ++v) {
      need_line(lines, {"VERTEX"});
      for (std::size_t c = 1; c <= 3; ++c) mesh.mesh.values.push_back(lines.number(c));
    }
    need_line(lines, {"ENDLOOP"});
    need_line(lines, {"ENDFACET"});
    mesh.lines.add(line);
  }
  if (open) lines.fail_file("the line endsolid");
}

}  // namespace

MeshFile parse_stl(std::string_view text, const std::string& file) {
  TextLines lines(text, file);
  MeshFile mesh{.properties = {{"x"}, {"y"}, {"z"}}, .format = MeshFormat::stl, .file = file};
  std::vector<std::string> left_out;
  // Files in bytes may begin with `solid`, too; these have the length that they say.
  const bool complete = text.size() >= header_bytes + 4 &&
                        static_cast<double>(text.size() - header_bytes - 4) ==
                            static_cast<double>(facet_bytes) *
                                read_number(text.data() + header_bytes, facet_count, Encoding::little_endian);
  if (complete || !text.substr(0, std::min<std::size_t>(text.size(), 1024)).starts_with("solid")) {
    if (text.size() < header_bytes + 4) lines.fail_file("an STL file: the line solid, or a header of 80 bytes");
    mesh.encoding = Encoding::little_endian;
    if (read_facets(lines, mesh)) left_out.emplace_back("attributes of the facets");
    if (!complete) lines.fail_file("the end of the file after the facets");
  } else {
    read_facet_lines(lines, mesh);
  }
  for (std::size_t v = 0; v < mesh.mesh.vertices(); ++v) {
    mesh.mesh.corners.push_back(static_cast<std::uint32_t>(v));
    if (v % 3 == 2) mesh.mesh.end_face();
  }
  join_equal_vertices(mesh);
  return finished(std::move(mesh), std::move(left_out), lines);
}

}  // namespace subcert::data
