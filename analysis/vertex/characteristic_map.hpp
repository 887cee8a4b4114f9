#pragma once
/// The characteristic map of a scheme at a vertex: is it regular, is it injective? For sources.

#include <subcert/analysis/symbol/numbers/balls.hpp>
#include "cosine_field.hpp"
#include "regular_cells.hpp"
#include "sector_block.hpp"

#include <optional>
#include <vector>

namespace subcert::vertex {

/// What is asked of the regular part of a scheme, once for all vertices.
struct CellForms {
  explicit CellForms(const LatticeMask& mask);

  LatticeMask mask;
  std::vector<LatticePoint> window;
  /// Windows of the derivatives along x and y, of differences in hulls; empty where these are not positive.
  std::vector<std::vector<LatticePoint>> derivative_windows;
  /// Of affine fits: of the sums of |phi(x - k)| and of its derivatives. Nothing where the hulls do, or where none was
  /// found.
  std::optional<Rational> value_bound;
  std::vector<Rational> derivative_bounds;
  std::vector<Rational> shift;

  bool by_hulls() const { return derivative_windows.size() == 2; }
};

/// What was proved of F on the ring of squares that all others come from by F(mx) = F(x)/lambda.
struct MapProof {
  Decision regular;     ///< no where the Jacobian has both signs
  Decision half_plane;  ///< each sector is in an open half plane
  int levels = 0;       ///< how often squares were cut, at most
  long squares = 0;     ///< in how many the proof is
};

/// F and its data: z(P) turned by w^t in sector t, z(new P) = lambda z(P) by the rules, and its own mirror image.
class CharacteristicMap {
 public:
  /// Data of the frequency with the eigenvalue lambda, simple among these. Domain: 0 < frequency < n/2, and lambda real
  /// and positive; `forms` of the mask of the rules. Nothing where no eigenvector is found in balls of so many bits.
  static std::optional<CharacteristicMap> find(const SectorRules& rules, const ClosedSet& set, const CellForms& forms,
                                               long frequency, const Ball& lambda, const BallField& field);

  /// z at a point of the plane of sector 0, or in the sectors beside it.
  Turning<Ball> data_at(const LatticePoint& point) const;
  /// Cuts squares up to `most_levels` times. Domain: frequency 1.
  MapProof prove(int most_levels) const;
  /// Whether F has no zero on some closed curve around the vertex: then it winds around 0 as often as k modulo n.
  bool winds(int most_levels) const;

 private:
  struct Cell {
    long x, y;
    int level;
  };
  CharacteristicMap(const SectorRules& rules, const CellForms& forms, long frequency, Ball lambda,
                    const BallField& field)
      : rules_(rules), forms_(forms), field_(field), block_(rules, {}, frequency, field), inverse_(1 / lambda) {}

  long radius() const;
  std::vector<Cell> ring() const;
  std::vector<Cell> children(const Cell& cell) const;
  Truth sign_of_jacobian(const Cell& cell) const;
  Truth jacobian_by_hulls(const Cell& cell) const;
  /// The values of a linear form a x + b y of F on the cell.
  Ball values_on(const Cell& cell, const Rational& a, const Rational& b) const;
  struct Fit;
  Fit fit_on(const Cell& cell) const;

  SectorRules rules_;
  const CellForms& forms_;
  BallField field_;
  SectorBlock<BallField> block_;
  Ball inverse_;
  mutable std::map<LatticePoint, Turning<Ball>> known_;
};

}  // namespace subcert::vertex
