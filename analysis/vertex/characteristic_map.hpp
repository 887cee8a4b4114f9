#pragma once
/// The characteristic map of a scheme at a vertex: is it regular, is it injective? For sources.

#include <subcert/analysis/symbol/numbers/balls.hpp>
#include "cosine_field.hpp"
#include "regular_cells.hpp"
#include "sector_block.hpp"
#include "vertex_spectrum.hpp"

#include <array>
#include <deque>
#include <optional>
#include <vector>

namespace subcert::vertex {

/// A function sum over k of d_k psi(x - k) of data d on the unit squares: psi sums to 1, and its affine sums are x +
/// shift.
struct CellForm {
  CellForm(const LatticeMask& mask, std::vector<LatticePoint> points);

  std::vector<LatticePoint> window;
  std::vector<Rational> shift;
  bool affine;                    ///< whether affine data give affine functions
  bool positive;                  ///< whether psi >= 0
  std::optional<Rational> bound;  ///< of the sum of |psi(x - k)|
  /// Of the least squares slopes of data on the window: [k][axis] is the factor of d_k.
  std::vector<std::array<Rational, 2>> slopes;
};

/// What is asked of the regular part of a scheme, once for all vertices.
struct CellForms {
  explicit CellForms(const LatticeMask& of);

  LatticeMask mask;
  CellForm values;
  /// Of the derivatives along x and y as functions of differences; empty where the mask has no such factors.
  std::vector<CellForm> derivatives;
  /// Else, of the sums of the |D phi(x - k)|.
  std::vector<Rational> derivative_bounds;

  /// Whether derivatives lie in the hulls of differences.
  bool are_hulls() const { return derivatives.size() == 2 && derivatives[0].positive && derivatives[1].positive; }
  bool are_known() const { return values.bound && (derivatives.size() == 2 || derivative_bounds.size() == 2); }
};

/// What was proved of F on the ring of squares that all others come from by F(mx) = F(x)/lambda.
struct MapProof {
  Decision regular;     ///< no where the Jacobian has both signs
  Decision half_plane;  ///< each sector is in an open half plane
  int levels = 0;       ///< how often squares were cut, at most
  long squares = 0;     ///< in how many the proof is
  /// Where the Jacobian has both signs: the corners of small squares on which it is above 0, and below.
  std::vector<LatticePoint> folds = {};
};

/// Where F has no zero: on the unit squares with corners (x, y), max(x, y) = place, or x + y = place.
struct ClosedCurve {
  long place;
  bool is_diagonal;
};

/// F and its data: z(P) turned by w^t in sector t, z(new P) = lambda z(P) by the rules, and its own mirror image.
class CharacteristicMap {
 public:
  /// Data of the frequency with the eigenvalue lambda, one vector among these. Domain: 0 <= frequency < n/2, and lambda
  /// real and positive; `forms` of the mask of the rules. Nothing where no eigenvector is found in balls of so many
  /// bits.
  static std::optional<CharacteristicMap> find(const SectorRules& rules, const ClosedSet& set, const CellForms& forms,
                                               long frequency, const Ball& lambda, const BallField& field);

  /// The same of a share of what leads, by its eigenvector where that is one of several. Nothing also where the
  /// frequency is n/2.
  static std::optional<CharacteristicMap> find(const SectorRules& rules, const ClosedSet& set, const CellForms& forms,
                                               const Leader::Share& share, const Ball& lambda, const BallField& field);

  /// The same for a frequency 1 and 1/n in an interval from 0 on, where lambda = 1 - decay delta, delta = 2 - 2 cos(2
  /// pi/n), so that for n -> infinity z is constant: the data are x = rho and y = s of z = 1 + delta rho + s (w - 1).
  /// Domain: a dual lattice.
  static std::optional<CharacteristicMap> find_near_one(const SectorRules& rules, const ClosedSet& set,
                                                        const CellForms& forms, const Ball& lambda, const Ball& decay,
                                                        const BallField& field);

  /// z at a point of the plane of sector 0, or in the sectors beside it.
  Turning<Ball> data_at(const LatticePoint& point) const;
  /// Cuts squares up to `most_levels` times. Domain: frequency 1.
  MapProof prove(int most_levels) const;
  /// A closed curve around the vertex where F has no zero, if one is found: then it winds around 0 as often as k modulo
  /// n. Domain: also frequency 0, with a real eigenvalue other than 0.
  std::optional<ClosedCurve> winds(int most_levels) const;
  /// The same curve by small squares, on each of which F is seen to have no zero. Domain: not diagonal.
  std::optional<long> winds_by_small_squares(const ClosedCurve& curve) const;
  /// Whether F is proved not to vanish on some square. Domain: as `winds`.
  bool has_values() const;

 private:
  struct Cell {
    long x, y;
    int level;
  };
  CharacteristicMap(const SectorRules& rules, const CellForms& forms, long frequency, const Ball& lambda,
                    const BallField& field)
      : rules_(rules), forms_(forms), field_(field), block_(rules, {}, frequency, field), inverse_(1 / lambda) {}
  /// From an eigenvector, in the unknowns of the frequency.
  static CharacteristicMap of_vector(const SectorRules& rules, const ClosedSet& set, const CellForms& forms,
                                     long frequency, const Ball& lambda, const std::vector<Ball>& vector,
                                     const BallField& field);

  struct NearOne {
    Ball delta, decay;
  };
  Turning<Ball> datum_turned(Turning<Ball> value, long times) const;
  /// By a rule, divided by lambda.
  Turning<Ball> new_value(const SectorRule& rule) const;
  /// Where positive on a cell, F is in the half plane of its sector.
  Ball half_plane_form_on(const Cell& cell) const;
  long radius() const;
  /// Whether in the windows of the ring the rules are those of the mask in the plane: beyond the ring they are then.
  bool is_plane_on_ring() const;
  std::vector<Cell> ring() const;
  /// Those with x = place and y <= x.
  static std::deque<Cell> side(long place);
  /// From which coordinate on certificates name squares: small ones, and beyond their ring.
  long far() const { return 12 * radius(); }
  std::vector<Cell> children(const Cell& cell) const;
  bool has_no_zero(std::deque<Cell> open, int most_levels) const;
  Truth sign_of_jacobian(const Cell& cell) const;
  /// Whether two squares show it: large ones first, as a proof goes to the last level of the first that it does not
  /// decide.
  /// Their corners.
  std::optional<std::array<Cell, 2>> both_signs(int most_levels) const;
  LatticePoint small_part_of(const Cell& cell) const;
  Truth jacobian_by_hulls(const Cell& cell) const;
  /// The data of a form, or the differences along an axis that its derivative is a function of.
  std::vector<Turning<Ball>> data_on(const Cell& cell, const CellForm& form, const LatticePoint& step) const;
  struct Fit;
  Fit fitted(const CellForm& form, const std::vector<Turning<Ball>>& data) const;
  /// Encloses the function on the cell of the data.
  Turning<Ball> enclosed(const CellForm& form, const std::vector<Turning<Ball>>& data) const;
  /// The values of a linear form a x + b y of F on the cell.
  Ball values_on(const Cell& cell, const Rational& a, const Rational& b) const;

  SectorRules rules_;
  const CellForms& forms_;
  BallField field_;
  SectorBlock<BallField> block_;
  Ball inverse_;
  std::optional<NearOne> near_one_ = std::nullopt;
  mutable std::map<LatticePoint, Turning<Ball>> known_;
};

}  // namespace subcert::vertex
