#pragma once

#include <Eigen/Dense>

#include <complex>
#include <cstdint>
#include <vector>

namespace subcert {

/// The hull a polytope norm is taken over.
enum class PolytopeKind {
  real,         ///< symmetric hull: { sum l_j v_j : sum |l_j| <= 1 }, l_j real
  nonnegative,  ///< cone hull: { x >= 0 : x <= sum l_j v_j, l_j >= 0, sum l_j <= 1 }, vertices and points non-negative
  complex       ///< balanced complex hull of the vertices and their conjugates, l_j complex
};

/// One term `coefficient * g(vertex)` of a combination; g conjugates and/or flips the vertex as told.
struct Term {
  int vertex = 0;
  bool flipped = false;     ///< the mirror image J v is meant
  bool conjugated = false;  ///< the complex conjugate is meant (complex kind only)
  std::complex<double> coefficient;
};

/// What a membership question came to. `lower <= norm <= upper` up to rounding in every case.
struct Membership {
  enum class Answer { inside, outside, undecided };
  Answer answer = Answer::undecided;
  double lower = 0;
  double upper = 0;
};

/// A column of a basis: a guise of a vertex, or a unit vector or slack.
struct BasisColumn {
  int vertex = -1;  // -1: unit vector or slack `axis`
  int axis = 0;
  bool flipped = false;
  bool conjugated = false;
  bool slack = false;
  double phase = 0;
  double cost = 1;
};

/// What a question answered `outside` leaves behind, for asking it again after vertices were added: multipliers y with
/// y.x = value and |y.v| <= largest for the first `seen` vertices, and the last basis. Empty multipliers: nothing yet.
struct Hint {
  Eigen::VectorXd multipliers;
  double value = 0, largest = 0, upper = 0;
  int seen = 0;
  std::vector<BasisColumn> basis;
};

/// The norm ||x||_P = min { sum |l_j| : sum l_j v_j = x } of a polytope that grows vertex by vertex, by a primal
/// simplex method with an explicit basis inverse.
///
/// Every basis is primal feasible after sign (complex: phase) changes, so that each one gives an upper bound, and the
/// multipliers y of each one give the lower bound y.x / max_j |y.v_j|; a question ends as soon as either bound answers
/// it. The ratio test passes through zeros of basic variables while the objective still falls (long steps, as in L1
/// regression [BR73]). Complex vertices are priced over all phases, so that columns e^{it} v_j are generated as needed.
/// Vertices may come in mirror pairs v, Jv: they are stored once, in coordinates where J negates the trailing `odd`
/// coordinates (real and complex kind) or reverses the order (non-negative kind), and both are priced for the price of
/// one.
///
/// Unit vectors of prohibitive cost complete the basis while the vertices do not span; a point that needs them is
/// never inside.
///
/// Error: `inside` is answered only if the residual of the combination, after refinement, is below 1e-12 times the
/// scale of the point, and a failed or unfinished program is `undecided`. No claim is rigorous: this is a search tool.
/// Cost: O(dim^2) per pivot and O(dim * vertices) per full pricing, most pivots being priced on a short list.
class IncrementalSimplex {
 public:
  /// Domain: dimension >= 1; 0 <= odd <= dimension; `flip` tells whether mirror images belong to the polytope.
  IncrementalSimplex(PolytopeKind kind, int dimension, bool flip, int odd);

  /// Adds a vertex, given by `dimension` numbers (complex kind: real parts, then imaginary parts). Returns its index.
  int add(const Eigen::VectorXd& vertex);

  /// Is ||x||_P <= accept? `outside` is answered when the norm exceeds `reject` (or optimum > accept).
  /// Domain: accept <= reject; `x` shaped like a vertex.
  /// A hint left by the same question spares most of the work; it is updated when the answer is `outside`.
  Membership solve(const Eigen::VectorXd& x, double accept, double reject, Hint* hint = nullptr);

  /// The combination behind the upper bound of the last `solve`; at most `dimension` terms (complex: twice that).
  /// Terms of the unit vectors that stand in for missing vertices are left out.
  std::vector<Term> combination() const;

  int vertex_count() const { return count_; }
  std::int64_t programs() const { return programs_; }
  std::int64_t pivots() const { return pivots_; }
  std::int64_t cold_starts() const { return cold_starts_; }

 private:
  static constexpr int kLane = 16;  // vertices per block of the single precision copy

  struct Basis {
    std::vector<double> inverse;  // column major, leading dimension stride_
    std::vector<double> matrix;   // the columns themselves
    std::vector<BasisColumn> columns;
    std::vector<double> y;  // multipliers of the last point it was optimal or outside for
    double largest = 0;     // max |y.v| over all vertices; 0: y is worth nothing
    int age = 0;            // pivots since the last factorisation
    std::int64_t used = 0;
  };

  struct Offer {  // a column that may enter
    double profit = 0;
    BasisColumn column;
  };

  struct Step {
    double length = 0;
    int leaving = 0;
  };

  void fill_column(const BasisColumn& column, double* out) const;
  void cold_basis(const Eigen::VectorXd& x, Basis& basis) const;
  bool refactor(Basis& basis) const;
  double choose_start(const Eigen::VectorXd& x);
  bool start_from(const std::vector<BasisColumn>& columns, const Eigen::VectorXd& x);
  bool still_outside(Hint& hint, double reject);
  void know(double largest);
  void keep(Hint* hint, const Membership& result, double largest) const;
  void remember();
  void multipliers();
  double price_all();
  Offer price_one(int vertex, const double* y) const;
  double score(const Basis& basis, const Eigen::VectorXd& x, bool& flipped) const;
  double evaluate();
  double artificial_part() const;
  bool refine(const Eigen::VectorXd& x);
  double ratio_test(const Offer& offer, Step& result);
  bool pivot(const std::vector<Offer>& offers);
  bool collect_offers();

  PolytopeKind kind_;
  int half_;    // dimension as given
  int size_;    // real dimension of the programs
  int stride_;  // size_ rounded up
  bool flip_;
  int odd_;
  int count_ = 0;

  std::vector<double> vertices_;  // double precision, one column of length stride_ each
  std::vector<float> lanes_;      // single precision, blocks of kLane vertices, coordinate major
  std::vector<float> prices_, peaks_;
  std::vector<int> list_;

  std::vector<Basis> cache_;
  std::vector<std::size_t> order_;
  Basis work_;
  std::vector<double> lambda_, y_, direction_, column_, row_, scratch_, best_direction_, best_column_;
  std::vector<Offer> offers_;
  std::vector<float> single_;
  std::vector<std::pair<double, int>> breaks_;
  Eigen::VectorXd turned_;
  int patience_ = 0;
  bool changed_ = false;

  std::int64_t programs_ = 0, pivots_ = 0, cold_starts_ = 0, clock_ = 0;
};

}  // namespace subcert
