// Vertices of a polytope that stem from images of others: sections 4.10 and 4.15 of ../certificates/SPEC.md.
#pragma once

#include "polytope.hpp"

#include <functional>
#include <optional>

namespace subcert_check {

/// Of a vertex under a matrix.
struct Image {
  std::size_t vertex, letter;

  auto operator<=>(const Image&) const = default;
};

/// What the lines `origin` say.
class Origins {
 public:
  Origins(const Polytope& body, Arithmetic& arithmetic)
      : body_(body), arithmetic_(arithmetic), parents_(body.vertices.size()) {}

  /// Reads the line of a vertex, which is not the first one of all. Returns the image from which it stems.
  Image read(std::size_t j, Reader& reader);

  /// Whether a vertex stems from this image.
  bool contains(const Image& image) const { return children_.contains(image); }

  /// The last image of a cycle from this vertex on.
  Image last_image(std::size_t vertex, const std::vector<std::size_t>& letters) const;

  /// The first vertex that a vertex stems from, and the letters in between, the last one first.
  struct Way {
    std::size_t first;
    std::vector<std::size_t> letters;
  };
  Way way_to(std::size_t j);

  /// What so many turns and then the letters of a way make of x.
  Vector led(Vector x, const std::function<Vector(Vector)>& around, std::size_t turns, const Way& way);

 private:
  const Polytope& body_;
  Arithmetic& arithmetic_;
  std::vector<std::optional<Image>> parents_;
  std::map<Image, std::size_t> children_;  // of several with one origin the last one
};

}  // namespace subcert_check
