#pragma once
/// The surface near a vertex, for pictures.

#include "vertex_smoothness.hpp"

#include <cstddef>

namespace subcert {

/// Refined data around a vertex: in the plane those of the characteristic map, above it the eigenvector of the largest
/// eigenvalue behind it, which is what curvature is made of. Sectors of squares, and of triangles the half of them next
/// to the vertex, follow one another: points[row * columns + i], with points that are no numbers between and around
/// them. In a unit of the largest distance from the vertex, heights up to 0.35.
struct VertexSurface {
  long valence;
  std::optional<long> frequency;  ///< of the heights; nothing where there are none: then they and curvature are 0
  std::size_t columns, rows;
  std::vector<std::array<double, 3>> points;
  /// The root of the modulus of Gauss's curvature, with its sign, by quadratic fits to a point and those around it.
  std::vector<double> curvature;
  double scale;  ///< twice the median modulus in the outer half
};

/// `size` points along each ray. Domain: what vertex_smoothness() says of these rules, size >= 4. Nothing where the
/// subdominant eigenvalue is not proved to be one of frequency 1; no heights where that behind it is not proved to be
/// one real number other than 0.
/// Error: none is proved; doubles of balls, for the eye. Cost: the spectrum, and size^2 values of a rule.
/// Ref: docs/vertices.md, section 7.
std::optional<VertexSurface> vertex_surface(const SectorRules& rules, const RegularPart& regular,
                                            const VertexSmoothness& smoothness, int size = 24);

}  // namespace subcert
