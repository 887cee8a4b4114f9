#include "quadratic_proof.hpp"

#include "graph_prover.hpp"

#include <subcert/analysis/radii/polytope_search/decompositions.hpp>
#include <subcert/analysis/radii/schedule.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace subcert {
namespace {

using quadratic::EllipsoidalCoordinates;
using quadratic::ProductTree;

constexpr double useful = 0.98;          // what longer contexts leave of the excess of their bound over the radius
constexpr int most_useless = 2;          // contexts one after the other
constexpr double most_work = 2e10;       // of a proof; a checker takes a few seconds for it, the verified one a minute
constexpr double most_fine_work = 1e8;   // with long numbers
constexpr double work_per_second = 8e9;  // of all cores, and some to spare
constexpr double kept_excess = 1e-7;     // that the radius is above the bound of its words, relatively
constexpr double kept_slacks[] = {4, 32};  // times what proofs lose: that its words are below their bound
constexpr double full_trees = 8;           // that the search for the least bound and the proof cost, about
constexpr double fine_factor = 60;         // that work with long numbers costs more
// Of bounds above the goal, relatively. A proof loses 1e-11.
constexpr double least_excess = 2e-11, goal_below = 1.5e-11, excess_step = 8;
constexpr int bisections = 3;
constexpr int most_moves = 8;               // of the exact matrices to other coordinates
constexpr std::size_t most_isometric = 10;  // the size of matrices

/// A family in coordinates in which its orbits are round, and those that make its norms small, counted from there.
struct Shape {
  radius::RoundFamily round;
  EllipsoidalCoordinates coordinates;
};

/// Where a form is too flat for doubles its coordinates are applied to the exact matrices, and the search goes on
/// there.
Shape shape_of(const MatrixFamily& family, double target, const Deadline& deadline) {
  Shape shape{radius::round_family(family, deadline), {}};
  shape.coordinates = quadratic::ellipsoidal_coordinates(shape.round.family, target, deadline);
  const bool movable = family.group().size() <= 1 || family.is_flip_symmetric();
  for (int k = 0; k < most_moves && movable && shape.coordinates.ended_flat && shape.coordinates.bound > target; ++k) {
    radius::RoundFamily moved = shape.round;
    if (deadline.expired() || !radius::change_coordinates(moved, family, shape.coordinates.to)) break;
    Shape next{std::move(moved), {}};
    next.coordinates = quadratic::ellipsoidal_coordinates(next.round.family, target, deadline);
    if (!(next.coordinates.bound < shape.coordinates.bound) ||
        !quadratic::triangular_coordinates({next.coordinates.to}, next.round))
      break;
    shape = std::move(next);
  }
  return shape;
}

/// The rational number of which the modulus of each determinant is the power of the size, if there is one.
std::optional<Rational> common_ratio(const MatrixFamily& family) {
  const Rational first = abs(determinant(family[0]));
  for (const RationalMatrix& m : family)
    if (first == 0 || abs(determinant(m)) != first) return std::nullopt;
  return exact_root(first, family.size());
}

/// The symmetric P with A^T P A = ratio^2 P for all matrices, as vectors of the entries on and above the diagonal.
std::vector<std::vector<Rational>> invariant_forms(const MatrixFamily& family, const Rational& ratio) {
  const std::size_t n = family.size(), entries = n * (n + 1) / 2;
  const auto place = [n](std::size_t i, std::size_t j) {
    const std::size_t low = std::min(i, j), high = std::max(i, j);
    return low * n - low * (low + 1) / 2 + high;
  };
  RationalMatrix equations(family.count() * entries, entries);
  for (std::size_t t = 0; t < family.count(); ++t)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i; j < n; ++j) {
        const std::size_t row = t * entries + place(i, j);
        for (std::size_t k = 0; k < n; ++k)
          for (std::size_t l = 0; l < n; ++l) equations(row, place(k, l)) += family[t](k, i) * family[t](l, j);
        equations(row, place(i, j)) -= ratio * ratio;
      }
  return kernel(equations);
}

/// The lower triangle, row by row.
std::vector<std::vector<Integer>> lower_rows(const quadratic::Integers& form, std::size_t n) {
  std::vector<std::vector<Integer>> rows(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= i; ++j) rows[i].push_back(form[j * n + i]);
  return rows;
}

/// Forms and a tree whose bound they may prove.
struct FormedTree {
  quadratic::StateForms forms;
  ProductTree tree;
  int bits;      ///< of the proof
  double bound;  ///< that the proof will have, about
};

/// A tree of the goal, or at least of a bound that is hardly above it.
std::optional<ProductTree> tree_at_goal(const quadratic::StateForms& forms, double goal,
                                        const quadratic::TreeLimits& limits) {
  auto near = quadratic::product_tree(forms, goal * (1 + least_excess), limits);
  if (!near) return std::nullopt;
  auto tree = quadratic::product_tree(forms, goal, {std::min(limits.work, 4 * near->work), limits.deadline});
  return tree ? tree : near;
}

/// A tree of nearly the least bound that is within the limits.
std::optional<ProductTree> least_tree(const quadratic::StateForms& forms, double goal,
                                      const quadratic::TreeLimits& limits) {
  double excess = std::max(forms.bound / goal - 1, least_excess);
  auto best = quadratic::product_tree(forms, goal * (1 + 2 * excess), limits);
  const auto hold = [&](double smaller) {
    auto tree = quadratic::product_tree(forms, goal * (1 + smaller), limits);
    if (!tree) return false;
    best = std::move(tree);
    excess = smaller;
    return true;
  };
  while (best && excess >= least_excess && hold(excess / excess_step)) {
  }
  if (excess < least_excess) {
    auto tree = tree_at_goal(forms, goal, limits);
    return tree ? tree : best;
  }
  for (int k = 1; k <= bisections; ++k) hold(excess * std::pow(excess_step, -std::ldexp(1.0, -k)));
  return best;
}

/// The search for forms and trees of one family, and their proofs.
class Search {
 public:
  /// `radius`: that of the product, or a bound that is small enough.
  Search(const MatrixFamily& family, Shape shape, double radius, const LeadingProduct& product, const Budget& budget)
      : family_(family), shape_(std::move(shape)), radius_(radius), product_(product), budget_(budget) {}

  /// Of one form and forms of contexts, ever longer, the first ones that prove the product to attain the radius, or
  /// whose tree has the goal for its bound; or, of the last ones and the one form, those whose proof has the least
  /// bound.
  std::optional<GraphProof> run(const quadratic::StateForms& one, quadratic::ContextForms contexts) {
    const Deadline contexts_end = budget_.deadline.after(schedule::forms::contexts);
    quadratic::StateForms states;
    double seconds = schedule::forms::first_look;
    for (int useless = 0; useless < most_useless;) {
      // A long product costs time of its own, and so do the ends of words on it.
      const Deadline looking = for_trees().at_most(seconds);
      states = with_product(contexts, looking);
      const double work = std::min(most_work, work_per_second * seconds);
      const auto kept = kept_tree(states, kept_slacks[0], work, looking);
      if (kept)
        if (auto proof = attained(states, *kept)) return proof;
      if (kept || states.product.empty())
        if (auto tree = tree_at_goal(states, goal(), {work, looking})) return proved(states, *tree, bits_of(*tree));
      const Stopwatch stopwatch;
      const double excess = contexts.forms().bound - radius_;
      if (!contexts.grow({contexts_end, budget_.memory / 2})) break;
      seconds = std::max(schedule::forms::first_look, schedule::forms::look * stopwatch.seconds());
      useless = contexts.forms().bound - radius_ < useful * excess ? 0 : useless + 1;
    }
    const Deadline trees_end = for_trees();
    if (states.product.empty()) states = with_product(contexts, trees_end);
    if (const auto kept = kept_tree(states, kept_slacks[0], most_work, trees_end.after(schedule::forms::kept_tree)))
      if (auto proof = attained(states, *kept)) return proof;
    std::optional<FormedTree> best;
    const auto try_out = [&](const quadratic::StateForms& found, int bits, double work) {
      auto tree = least_tree(found, goal(), {work, trees_end});
      if (!tree) return;
      const double bound = tree->bound * (1 + quadratic::slack_of(bits, family_.size()));
      if (!best || bound < best->bound) best = FormedTree{found, std::move(*tree), bits, bound};
    };
    const double most = std::min(most_work, work_per_second / full_trees * remaining());
    // Words that leave a long product are many; other bounds may do without.
    for (const quadratic::StateForms* found : {&contexts.forms(), &std::as_const(states), &one}) {
      if (found == &states && states.product.empty()) continue;
      // Contexts that there was little time for may be worse than the one form.
      if (found == &one && best && best->bound <= one.bound) break;
      try_out(*found, quadratic::most_bits, std::min(most, fine_work()));
      try_out(*found, quadratic::double_bits, most);
    }
    return best ? proved(best->forms, best->tree, best->bits) : std::nullopt;
  }

 private:
  double goal() const { return radius_ * (1 - goal_below); }
  Deadline for_trees() const { return budget_.deadline.after(schedule::forms::tree); }
  double remaining() const { return budget_.deadline.remaining(); }
  double fine_work() const { return std::min(most_fine_work, work_per_second / 2 / fine_factor * remaining()); }
  int bits_of(const ProductTree& tree) const {
    return tree.work <= fine_work() ? quadratic::most_bits : quadratic::double_bits;
  }

  quadratic::StateForms with_product(const quadratic::ContextForms& contexts, const Deadline& deadline) const {
    if (!product_.word.empty())
      if (auto forms = contexts.with_cycle(product_.word, {deadline, budget_.memory / 2})) return std::move(*forms);
    return contexts.forms();
  }

  /// Of two numbers of digits, the larger first if that may be in time.
  template <class Prove>
  auto with_bits(int bits, const Prove& prove) const {
    const Deadline end = budget_.deadline.later(schedule::forms::grace);
    auto proof = bits > quadratic::double_bits ? prove(bits, end.after(schedule::forms::fine_proof))
                                               : decltype(prove(bits, end))();
    return proof ? std::move(proof) : prove(quadratic::double_bits, end);
  }

  using Coordinates = std::vector<quadratic::Integers>;

  std::optional<GraphProof> proved(const quadratic::StateForms& forms, const ProductTree& tree, int bits) const {
    const auto coordinates = quadratic::triangular_coordinates(forms.to, shape_.round);
    return coordinates ? proved(forms, tree, bits, *coordinates) : std::nullopt;
  }
  std::optional<GraphProof> proved(const quadratic::StateForms& forms, const ProductTree& tree, int bits,
                                   const Coordinates& coordinates) const {
    return with_bits(bits, [&](int digits, const Deadline& deadline) {
      return quadratic::prove_graph(family_, coordinates, forms, tree, digits, deadline);
    });
  }

  /// A bound for words where letters of the product are kept.
  double below() const { return radius_ * (1 - kept_excess); }

  /// A tree for less than that bound that keeps the letters of the product. Nothing where there is none.
  std::optional<ProductTree> kept_tree(const quadratic::StateForms& forms, double slack, double work,
                                       const Deadline& deadline) const {
    if (forms.product.empty()) return std::nullopt;
    const double lost = slack * quadratic::slack_of(quadratic::double_bits, family_.size());
    return quadratic::product_tree(forms, below() / (1 + lost), {work, deadline, true});
  }

  /// That the product attains the radius, by such a tree or one with more to spare.
  std::optional<GraphProof> attained(const quadratic::StateForms& forms, ProductTree tree) const {
    const auto coordinates = quadratic::triangular_coordinates(forms.to, shape_.round);
    if (!coordinates) return std::nullopt;
    const auto prove = [&](int bits, const Deadline& deadline) {
      return quadratic::prove_attained(family_, *coordinates, forms, tree, bits, product_.eigenvalue, below(),
                                       deadline);
    };
    auto graph = with_bits(bits_of(tree), prove);
    if (!graph) {
      auto other = kept_tree(forms, kept_slacks[1], most_work, for_trees().after(schedule::forms::kept_tree));
      if (!other) return std::nullopt;
      tree = std::move(*other);
      graph = prove(quadratic::double_bits, budget_.deadline);
    }
    if (!graph) return std::nullopt;
    tree.bound = radius_;
    auto proof = proved(forms, tree, graph->graph.bits, *coordinates);
    if (proof) proof->attained = std::make_shared<AttainedGraph>(std::move(*graph));
    return proof;
  }

  const MatrixFamily& family_;
  Shape shape_;
  double radius_;
  const LeadingProduct& product_;
  Budget budget_;
};

}  // namespace

QuadraticProof scaled(QuadraticProof proof, const Rational& factor) {
  proof.bound *= factor;
  return proof;
}

std::optional<GraphProof> prove_by_quadratic_forms(const MatrixFamily& family, const Rational& target,
                                                   const Budget& budget, const LeadingProduct& product) {
  if (std::all_of(family.begin(), family.end(), [](const RationalMatrix& m) { return one_norm(m) == 0; }))
    return std::nullopt;
  double radius = target.convert_to<double>();
  const Shape shape = shape_of(family, radius, budget.deadline.after(schedule::forms::one_form));
  for (const polytope::Matrix& m : shape.round.family.matrices) radius = std::max(radius, polytope::spectral_radius(m));
  if (!(radius > 0)) return std::nullopt;
  const quadratic::ContextForms one(shape.round.family, shape.coordinates);
  return Search(family, shape, radius, product, budget).run(one.forms(), one);
}

std::optional<QuadraticProof> prove_isometries(const MatrixFamily& family, const Deadline& deadline) {
  const std::size_t n = family.size();
  if (n > most_isometric) return std::nullopt;
  const auto ratio = common_ratio(family);
  // The checker rounds powers of the bound times the denominator down: only integers lose nothing.
  if (!ratio || denominator(*ratio * Rational(common_denominator(family))) != 1) return std::nullopt;
  const std::vector<std::vector<Rational>> forms = invariant_forms(family, *ratio);
  if (forms.empty()) return std::nullopt;
  // That combination of them which is nearest to the form that floating point finds.
  const std::vector<std::size_t> free = free_columns(forms);
  const auto guess = quadratic::ellipsoidal_coordinates(radius::to_search_family(family), 0,
                                                        deadline.at_most(schedule::forms::isometry_seconds));
  const auto near = radius::to_rational(guess.to.transposed() * guess.to);
  if (!near) return std::nullopt;
  RationalMatrix form(n, n);
  for (std::size_t k = 0, column = 0; k < n; ++k)
    for (std::size_t l = k; l < n; ++l, ++column)
      for (std::size_t v = 0; v < forms.size(); ++v)
        if (free[v] == column)
          for (std::size_t i = 0, at = 0; i < n; ++i)
            for (std::size_t j = i; j < n; ++j, ++at) form(i, j) += (*near)(k, l) * forms[v][at];
  const quadratic::Integers integral = integer_multiple(form, common_denominator(form));
  if (!quadratic::is_positive(integral, n)) return std::nullopt;
  QuadraticProof result{lower_rows(integral, n), {}, *ratio};
  for (std::size_t t = 0; t < family.count(); ++t) result.letters.push_back(static_cast<int>(t));
  return result;
}

}  // namespace subcert
