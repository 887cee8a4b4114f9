#pragma once
/// Polytopes that matrices map above themselves, found in floating point. Inner header; nothing here is to be trusted.

#include "antinorm_program.hpp"

#include <subcert/analysis/symbol/budget.hpp>

namespace subcert::subradius {

/// A set of vertices that grows by images of its own until no image falls below it.
struct AntinormCandidate {
  struct Vertex {
    polytope::Vector value;
    int parent = -1, letter = -1;  ///< the image of that vertex; -1: one of the first
  };
  std::vector<Vertex> vertices;
  std::size_t kept = 0;  ///< the first so many are best
  double least = 0;      ///< antinorm of their images
  bool closed = false;   ///< no image falls below, up to rounding
  /// The letters of a product whose averaged spectral radius is below 1, the one applied first in front; where that
  /// was met the search ends.
  std::vector<int> smaller;
};

/// Grows the vertices of a cycle, each the image of the one before under the letters; the last letter leads back to the
/// first vertex. Without letters the first vertex is any. Ref: [GP13, Alg. 2].
class AntinormSearch {
 public:
  /// Domain: matrices without negative entries, divided by the averaged spectral radius of the product; a vertex >= 0
  /// that is not 0. `memory`: bytes that vertices may take.
  AntinormSearch(std::vector<polytope::Matrix> matrices, polytope::Vector first, std::vector<int> cycle,
                 std::size_t memory);

  /// Goes on until a set closes, a smaller product is met or no more is allowed, or the deadline passes. Cost: a
  /// program per vertex and matrix, and one more for each image that falls below.
  const AntinormCandidate& advance(const Deadline& deadline);

  const std::vector<int>& cycle() const { return cycle_; }
  /// Whether going on may change anything.
  bool is_over() const { return result_.closed || !result_.smaller.empty() || is_full(); }

 private:
  struct Image {
    polytope::Vector value;
    int parent, letter;
    double antinorm;
  };

  bool is_full() const;
  void add(AntinormCandidate::Vertex vertex);
  void look_at_images(std::size_t vertex);
  void end_generation();
  void find_smaller(const Image& image);

  std::vector<polytope::Matrix> matrices_;
  std::vector<int> cycle_;
  std::size_t memory_;
  AntinormProgram program_;
  AntinormCandidate result_;
  // Of the generation that is looked at: its vertices, the next one of them, and the images that fall below. These are
  // added one by one as the next generation.
  std::size_t end_ = 0, next_ = 0, added_ = 0;
  std::vector<Image> below_;
};

/// Images that are so near to a multiple of their antinorm count as vertices, or as inside.
inline constexpr double rounding = 1e-12;

}  // namespace subcert::subradius
