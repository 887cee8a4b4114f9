#pragma once
/// Polytopes that matrices map above themselves, found in floating point. Inner header; nothing here is to be trusted.

#include "antinorm_proof.hpp"

#include <subcert/analysis/radii/polytope_search/dense.hpp>
#include <subcert/analysis/symbol/support/budget.hpp>

#include <optional>
#include <vector>

namespace subcert::subradius {

/// A combination of vertices with weights >= 0 that is at most a point in each coordinate, up to rounding.
struct Combination {
  struct Term {
    std::size_t vertex;
    double weight;
  };
  double value = 0;               ///< the sum of the weights
  std::vector<Term> terms;        ///< those of the last basis, zeros included
  std::vector<std::size_t> rows;  ///< coordinates in which the point is positive and the basis asks for equality
};

/// The antinorm of a polytope, max { sum w_j : sum w_j v_j <= x, w_j >= 0 } for non-negative vertices and points. It is
/// superadditive on the orthant; a matrix that takes all vertices to points of antinorm >= g has spectral radius >= g.
/// Ref: [GP13, sec. 4].
class AntinormProgram {
 public:
  explicit AntinormProgram(std::size_t dimension) : dimension_(dimension) {}

  /// Domain: `dimension` numbers >= 0, one of them positive.
  void add(const polytope::Vector& vertex) { entries_.insert(entries_.end(), vertex.begin(), vertex.end()); }
  std::size_t count() const { return entries_.size() / dimension_; }
  const double* vertex(std::size_t j) const { return &entries_[j * dimension_]; }
  std::size_t dimension() const { return dimension_; }

  /// The best combination below x, or the first one found whose value is at least `enough`. Domain: x >= 0. Error:
  /// whatever is returned is a combination below x, up to rounding; it may fall short of the best one where pivots are
  /// tiny. Cost: a pass over the vertices and dimension^2 operations per pivot.
  Combination below(const polytope::Vector& x, double enough) const;

 private:
  std::size_t dimension_;
  std::vector<double> entries_;  // vertex by vertex
};

/// A set of vertices that grows by images of its own until no image falls below it.
struct AntinormCandidate {
  struct Vertex {
    polytope::Vector value;
    int parent = -1, letter = -1;  ///< the image of that vertex; -1: the first one
    std::size_t steps = 0;         ///< letters that lead to it
    bool cut = false;              ///< it, or one that leads to it, has lost coordinates
  };
  std::vector<Vertex> vertices;
  std::vector<AntinormProof::Coincidence> coincidences;  ///< as words of equal effect lead to both
  std::size_t kept = 0;                                  ///< the first so many are best
  double least = 0;                                      ///< antinorm of their images
  bool closed = false;                                   ///< no image falls below, up to rounding
  /// The letters of a product whose averaged spectral radius is below 1, the one applied first in front; where that
  /// was met the search ends.
  std::vector<int> smaller;
};

/// Grows the vertices of a cycle, each the image of the one before under the letters; the last letter leads back to the
/// first vertex. Ref: [GP13, Alg. 2].
class AntinormSearch {
 public:
  /// Domain: matrices without negative entries, divided by the averaged spectral radius of the product; a vertex >= 0
  /// that is not 0. `memory`: bytes that vertices may take. `explained`: as below.
  AntinormSearch(std::vector<polytope::Matrix> matrices, polytope::Vector first, std::vector<int> cycle,
                 std::size_t memory, bool explained = false);

  /// Goes on until a set closes, a smaller product is met, there are so many vertices or no more memory, or the
  /// deadline passes. Cost: a program per vertex and matrix, and one more for each image that falls below.
  const AntinormCandidate& advance(std::size_t vertices, const Deadline& deadline);

  /// The same from the beginning, in which images on the boundary have to be coincidences, or become vertices.
  AntinormSearch explained() const { return {matrices_, result_.vertices.front().value, cycle_, memory_, true}; }

  const std::vector<int>& cycle() const { return cycle_; }
  std::size_t count() const { return result_.vertices.size(); }
  bool has_closed() const { return result_.closed; }
  /// Whether going on may change anything.
  bool is_over() const { return result_.closed || !result_.smaller.empty() || overflows_ || is_full(); }

 private:
  struct Image {
    polytope::Vector value;
    int parent, letter;
    double antinorm;
  };

  bool is_full() const;
  void add(AntinormCandidate::Vertex vertex);
  void add_image(const Image& image);
  void look_at_images(std::size_t vertex);
  bool is_inside(const Image& image);
  std::optional<std::size_t> coincident(const Image& image) const;
  void end_generation();
  void find_smaller(const Image& image);

  std::vector<polytope::Matrix> matrices_;
  std::vector<int> cycle_;
  std::size_t memory_;
  bool explained_;
  bool overflows_ = false;  // doubles do not hold an image
  AntinormProgram program_;
  AntinormCandidate result_;
  // Of the generation that is looked at: its vertices, the next one of them, and the images that fall below. These are
  // added one by one as the next generation.
  std::size_t end_ = 0, next_ = 0, added_ = 0;
  std::vector<Image> below_;
};

/// Images that are so near to a multiple of their antinorm count as vertices, or as inside.
inline constexpr double rounding = 1e-12;
/// An antinorm so far above 1 is inside for certain, and needs no exact weights.
inline constexpr double clearly_above = 1e-9;

}  // namespace subcert::subradius
