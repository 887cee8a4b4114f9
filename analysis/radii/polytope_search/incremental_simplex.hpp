#pragma once
/// Membership in a polytope that grows vertex by vertex, by a warm started simplex method. Its parts: the pivot loop
/// (incremental_simplex.cpp), bases and their factorisation (simplex_basis.cpp), pricing (simplex_pricing.cpp), and
/// where a program starts (simplex_starts.cpp).

#include "symmetry.hpp"

#include <subcert/analysis/symbol/support/budget.hpp>

#include <cstdint>

namespace subcert::polytope {

/// One term `coefficient * g(vertex)` of a combination, g an element of the symmetry, with or without conjugation.
struct CombinationTerm {
  int vertex = 0;
  int element = 0;          ///< of the symmetry; 0: the vertex itself, 1: its mirror image under the flip
  bool conjugated = false;  ///< the complex conjugate is meant (complex kind only)
  std::complex<double> coefficient;
};

/// What a membership question came to. `lower <= norm <= upper` up to rounding in every case.
struct Membership {
  enum class Answer { inside, outside, undecided };
  Answer answer = Answer::undecided;
  double lower = 0;
  double upper = 0;
  bool combined = false;  ///< combination() is the point, with moduli that sum to `upper`
};

/// A column of a basis: an image of a vertex times a phase, or a unit vector or slack.
struct BasisColumn {
  int vertex = -1;  // -1: unit vector or slack `axis`
  int axis = 0;
  int element = 0;
  bool conjugated = false;
  bool slack = false;
  double phase = 0;
  double cost = 1;
};

/// What a question answered `outside` leaves behind, for asking it again after vertices were added: multipliers y with
/// y.x = value and |y.v| <= largest for the first `seen` vertices, and the last basis. Empty multipliers: nothing yet.
struct WarmStart {
  Vector multipliers;
  double value = 0, largest = 0, upper = 0;
  std::size_t seen = 0;
  std::vector<BasisColumn> basis;
};

/// The norm ||x||_P = min { sum |l_j| : sum l_j v_j = x } of a polytope that grows vertex by vertex, by a primal
/// simplex method with an explicit basis inverse.
///
/// Every basis is primal feasible after sign (complex: phase) changes, so that each one gives an upper bound, and the
/// multipliers y of each one give the lower bound y.x / max_j |y.v_j|; a question ends as soon as either bound answers
/// it. The ratio test passes through zeros of basic variables while the objective still falls (long steps, as in L1
/// regression [BR73]). Complex vertices are priced over all phases, so that columns e^{it} v_j are generated as needed.
/// Vertices are stored once for each orbit of the symmetry; under the flip both of a pair are priced for the price of
/// one.
///
/// Unit vectors of prohibitive cost complete the basis while the vertices do not span; a point that needs them is
/// never inside.
///
/// Error: a combination is vouched for only if its residual, after refinement, is below 1e-12 times the scale of the
/// point; a failed or unfinished program is `undecided`, but may have such a combination. No claim is rigorous: this is
/// a search tool.
/// Cost: O(dim^2) per pivot and O(dim * vertices) per full pricing, most pivots being priced on a short list.
class IncrementalSimplex {
 public:
  /// `action`: of the symmetry on vertices; reversal for the non-negative kind, a change of signs for the others.
  /// Programs end undecided past the deadline of the budget; its memory is what cached bases may take.
  /// Domain: dimension >= 1.
  IncrementalSimplex(PolytopeKind kind, const GroupAction& action, const Budget& budget);

  /// Adds a vertex, given by `dimension` numbers (complex kind: real parts, then imaginary parts). Returns its index.
  int add(std::span<const double> vertex);

  /// Is ||x||_P <= accept? `outside` is answered when the norm exceeds `reject` (or optimum > accept).
  /// Domain: accept <= reject; `x` shaped like a vertex.
  /// What the same question left in `warm` spares most of the work; it is updated when the answer is `outside`.
  Membership solve(std::span<const double> x, double accept, double reject, WarmStart* warm = nullptr);

  /// The combination behind the upper bound of the last `solve`; at most `dimension` terms (complex: twice that).
  /// Terms of the unit vectors that stand in for missing vertices are left out.
  std::vector<CombinationTerm> combination() const;

  /// Bytes held, and those that one more vertex takes, a larger array for all of them included.
  std::size_t bytes() const;
  std::size_t bytes_of_next_vertex() const;
  /// At most that many are held by a warm start.
  std::size_t bytes_of_warm_start() const { return size_ * (sizeof(double) + sizeof(BasisColumn)) + 32; }

  /// Of the programs: numbers of a vertex.
  std::size_t dimension() const { return size_; }
  std::int64_t pivots() const { return pivots_; }

 private:
  static constexpr std::size_t block_size = 16;   // vertices per block of the single precision copy
  static constexpr double price_margin = 1e-6;    // prices in single precision are off by less
  static constexpr double artificial_cost = 1e6;  // of the unit vectors: far above the norm of any point asked about

  struct Basis {
    std::vector<double> inverse;  // column major, leading dimension stride_
    std::vector<double> matrix;   // the columns themselves
    std::vector<BasisColumn> columns;
    std::vector<double> y;  // multipliers of the last point it was optimal or outside for
    double largest = 0;     // max |y.v| over all vertices; 0: y is worth nothing
    int age = 0;            // pivots since the last factorisation
    std::int64_t used = 0;
  };

  struct EnteringColumn {
    double price = 0;  // |y.v|; more than its cost lowers the objective
    BasisColumn column;
  };

  struct Step {
    double length = 0;
    std::size_t leaving = 0;
  };

  struct Question {
    std::span<const double> x;
    double accept, reject;
    WarmStart* warm;
  };

  // The pivot loop.
  bool start(const Question& question, Membership& result);
  void iterate(const Question& question, Membership& result);
  bool is_inside(const Question& question, Membership& result);
  void conclude(const Question& question, bool optimal, Membership& result);

  // Bases.
  void fill_column(const BasisColumn& column, double* out) const;
  bool refactor(Basis& basis) const;
  void set_coefficients(std::span<const double> x);
  double objective() const;
  double artificial_part() const;
  bool refine(std::span<const double> x);
  double length_of(const BasisColumn& column) const {
    return column.vertex < 0 ? 1 : lengths_[static_cast<std::size_t>(column.vertex)];
  }
  bool ratio_test(Step& result);
  bool pivot();

  // Pricing.
  void update_multipliers();
  EnteringColumn price_one(std::size_t vertex, const double* y) const;
  EnteringColumn price_complex(std::size_t vertex, const double* y) const;
  double price_all();
  void fill_short_list(float largest);
  bool choose_slack();
  bool choose_vertex();
  bool choose_among_all();

  // Starts.
  void start_cold(std::span<const double> x);
  bool start_from(const std::vector<BasisColumn>& columns, std::span<const double> x);
  double choose_start(std::span<const double> x);
  double lower_bound(const Basis& basis, std::span<const double> x, int& element) const;
  void turn_basis(int element);
  bool still_outside(WarmStart& warm, double reject);
  void keep_multipliers(double largest);
  void store(WarmStart* warm, const Membership& result, double largest) const;
  void cache_basis();
  std::size_t bytes_of_basis() const;

  PolytopeKind kind_;
  GroupAction action_;
  std::size_t half_;    // dimension as given
  std::size_t size_;    // real dimension of the programs
  std::size_t stride_;  // size_ rounded up to whole registers
  std::size_t count_ = 0;
  Deadline deadline_;

  std::vector<double> vertices_;  // double precision, one column of length stride_ each
  std::vector<double> lengths_;   // their Euclidean norms
  std::vector<float> blocks_;     // single precision, blocks of block_size vertices, coordinate major
  std::vector<float> prices_, peaks_;
  std::vector<std::size_t> short_list_;
  std::size_t short_list_pivots_ = 0;  // that one short list serves

  std::vector<Basis> cache_;
  std::size_t cache_size_;
  Basis work_;
  std::vector<double> lambda_, y_, direction_, column_, row_, scratch_;
  EnteringColumn entering_;
  std::vector<float> single_;
  std::vector<std::pair<double, std::size_t>> breaks_;
  bool changed_ = false;

  std::int64_t pivots_ = 0, clock_ = 0;
};

}  // namespace subcert::polytope
