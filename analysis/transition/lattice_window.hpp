#pragma once
/// The transition operators of a mask on a lattice, (T_d v)_j = sum over k of a_{Mj + d - k} v_k for the digits d, and
/// the finite sets of lattice points on which they act. Coefficients meet sequences in transitions() alone: windows,
/// spaces and families of matrices only ask for it and for the support. One variable has kernels in transition.hpp.

#include <subcert/analysis/symbol/masks/mask.hpp>
#include <subcert/analysis/symbol/matrices/matrix_family.hpp>

#include <map>
#include <vector>

namespace subcert {

/// A sequence of finite support. Canonical: no value is 0. Where a mask has r > 1 components its sequences have vectors
/// of r numbers: the component, from 0, is a last coordinate of the point.
using LatticeSequence = std::map<LatticePoint, Rational>;

/// The indices that matter for a mask: every T_d v is supported there where v is.
class LatticeWindow {
 public:
  /// The points that words of `steps()` letters or more reach from `start`: those that shorter words alone reach are
  /// left out. With `digit` for words of that digit alone. Domain: start not empty. Errors: throws Error where that
  /// takes more than `most_points` points. Cost: points * coefficients.
  LatticeWindow(const LatticeMask& mask, const std::vector<LatticePoint>& start, std::size_t most_points,
                std::optional<std::size_t> digit = std::nullopt);
  /// All points that words reach from `start`, those of `start` among them.
  static LatticeWindow closure(const LatticeMask& mask, const std::vector<LatticePoint>& start,
                               std::size_t most_points);

  const std::vector<LatticePoint>& points() const { return points_; }
  std::size_t size() const { return points_.size(); }
  int steps() const { return steps_; }
  /// The place of a point among points(), or size().
  std::size_t place(const LatticePoint& point) const;

 private:
  LatticeWindow() = default;

  std::vector<LatticePoint> points_;  // in the order of std::map
  int steps_ = 0;
};

/// sum over k of a_k x_{i - k}, for the terms of a mask with so many components; sums that are 0 stay.
LatticeSequence convolution(const std::vector<LatticeMask::Term>& terms, std::size_t components,
                            const LatticeSequence& x);

/// T_d v for every digit d. Cost: the length of v times the number of coefficients.
std::vector<LatticeSequence> transitions(const LatticeMask& mask, const LatticeSequence& v);

/// T_d on all sequences on a window; what they lead out of it is dropped.
MatrixFamily transition_family(const LatticeMask& mask, const LatticeWindow& window);

/// T_d on the span of sequences, of which number c is 1 at pivots[c], where all others are 0. Domain: invariant.
MatrixFamily transition_family(const LatticeMask& mask, const std::vector<LatticeSequence>& basis,
                               const std::vector<LatticePoint>& pivots);

/// The differences nabla^mu delta of total order |mu| = order along these directions, in the order of
/// exponents_of_degree; along the axes.
std::vector<LatticeSequence> differences_of_delta(const std::vector<LatticePoint>& directions, int order);
std::vector<LatticeSequence> differences_of_delta(std::size_t variables, int order);

/// sum over i of a_i x_{k - i}, for numbers a_i and a sequence of numbers or vectors.
LatticeSequence convolution(const LatticeSequence& a, const LatticeSequence& x);

}  // namespace subcert
