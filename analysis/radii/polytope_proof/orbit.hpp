#pragma once
/// The orbit that makes a polytope, once more in high precision. Inner header.

#include "candidate.hpp"

#include <boost/multiprecision/mpfr.hpp>

namespace subcert::radius {

using Real =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<60>, boost::multiprecision::et_off>;
using RealVector = std::vector<Real>;

/// x + i y; y is empty for real vectors.
struct OrbitPoint {
  RealVector x, y;
  bool is_complex() const { return !y.empty(); }
};

struct Orbit {
  std::vector<OrbitPoint> vertices;
  Real scale;  ///< what images are divided by: the radius of the first product where the search used it
};

/// Roots are refined by inverse iteration, the others follow them. Nothing is proved. Nothing once the deadline passes,
/// or where a number is not finite. Domain: `candidate` belongs to this family.
std::optional<Orbit> recomputed_orbit(const MatrixFamily& family, const PolytopeCandidate& candidate,
                                      const Deadline& deadline);

}  // namespace subcert::radius
