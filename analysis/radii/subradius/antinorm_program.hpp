#pragma once
/// How far a point lies above a set of vertices, by a primal simplex method. Inner header.

#include <subcert/analysis/radii/polytope_search/dense.hpp>

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

}  // namespace subcert::subradius
