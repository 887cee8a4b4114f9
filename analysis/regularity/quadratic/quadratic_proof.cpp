#include "quadratic_proof.hpp"

#include <subcert/analysis/regularity/polytope_proof/round_family.hpp>
#include <subcert/analysis/symbol/parallel.hpp>
#include "context_forms.hpp"
#include "product_tree.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>

namespace subcert {
namespace {

using quadratic::EllipsoidalCoordinates;
using quadratic::ProductTree;
using quadratic::TreeWord;

// Of the time: until the first form is found; of the rest until the last contexts are, and their tree.
constexpr double shape_share = 0.3, contexts_share = 0.65, tree_share = 0.75;
constexpr double trees_worth = 5;         // the time for contexts and trees, by that for trees, before the next tree
constexpr std::size_t first_leaves = 64;  // before there are contexts
constexpr double most_work = 4e9;         // of 10^10 that a checker may spend
constexpr double work_per_second = 8e8;   // of one core, and some to spare
constexpr int most_moves = 8;             // of the exact matrices to other coordinates
constexpr int form_bits = 48;             // of the coordinates; the form has twice as many
constexpr int bound_bits = 50;
constexpr std::size_t guard_bits = 64, pivot_bits = 128;
constexpr std::size_t most_isometric = 10;  // the size of matrices
constexpr double isometry_seconds = 0.5;
constexpr double slacks[] = {1e-11, 1e-9, 1e-7, 1e-5, 1e-3};  // of the bound, relatively

/// A square matrix of integers, row by row.
using Integers = std::vector<Integer>;

Integers product(const Integers& a, const Integers& b, std::size_t n) {
  Integers result(n * n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k)
      if (!a[i * n + k].is_zero())
        for (std::size_t j = 0; j < n; ++j) add_product(result[i * n + j], a[i * n + k], b[k * n + j]);
  return result;
}

/// m^T P m on and above the diagonal.
Integers image_of_form(const Integers& m, const Integers& form, std::size_t n) {
  const Integers right = product(form, m, n);
  Integers result(n * n);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i; j < n; ++j) add_product(result[i * n + j], m[k * n + i], right[k * n + j]);
  return result;
}

/// A family in coordinates in which its orbits are round, and those that make its norms small, counted from there.
struct Shape {
  radius::RoundFamily round;
  EllipsoidalCoordinates coordinates;
};

/// The forms of coordinates x' = to x of the round family, rounded; of a single one the sum over the group of g^T P g.
std::vector<Integers> integer_forms(const std::vector<polytope::Matrix>& coordinates, const radius::RoundFamily& round,
                                    const MatrixFamily& family) {
  const std::size_t n = family.size();
  std::vector<RationalMatrix> maps;
  for (const polytope::Matrix& to : coordinates) maps.push_back(radius::to_rational(to));
  long bits = form_bits;
  if (const auto& [before, back] = round.coordinates; round.coordinates.differ()) {
    for (RationalMatrix& to : maps) to = to * before;
    // Of what is flat as many digits are left.
    bits += std::max(0L, binary_exponent(before).value_or(0) + binary_exponent(back).value_or(0));
  }
  long exponent = binary_exponent(maps.front()).value_or(0);
  for (const RationalMatrix& to : maps) exponent = std::max(exponent, binary_exponent(to).value_or(exponent));
  const Rational unit = power(Rational(2), bits - exponent);
  std::vector<Integers> forms;
  for (RationalMatrix& to : maps) {
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) to(i, j) = to_integer(unit * to(i, j), Rounding::nearest);
    RationalMatrix sum(n, n);
    for (const FamilySymmetry& element : family.group()) {
      const RationalMatrix moved = to * element.map.matrix(), image = transposed(moved) * moved;
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) sum(i, j) += image(i, j);
      if (maps.size() > 1) break;
    }
    forms.push_back(integer_multiple(sum, 1));
  }
  return forms;
}

/// Whether a symmetric matrix, given on and above the diagonal, is positive semidefinite, by a Cholesky decomposition
/// in integers that makes up for its rounding (proofs-checks/certificates/SPEC.md, 4.8).
bool is_positive(Integers s, std::size_t n) {
  Integer largest = 0;
  for (const Integer& entry : s) largest = std::max(largest, abs(entry));
  if (largest == 0) return true;
  const std::size_t bits = msb(largest) + 1;
  for (Integer& entry : s) {
    if (bits <= 2 * pivot_bits)
      entry <<= 2 * pivot_bits - bits;
    else
      entry >>= bits - 2 * pivot_bits;
  }
  const Integer margin = (Integer(n) << pivot_bits) + Integer(n);
  for (std::size_t k = 0; k < n; ++k) {
    Integer* row = &s[k * n];
    row[k] -= margin;
    for (std::size_t l = 0; l < k; ++l) {
      const Integer factor = -s[l * n + k];
      for (std::size_t j = k; j < n; ++j) add_product(row[j], factor, s[l * n + j]);
    }
    if (row[k].sign() <= 0) return false;
    row[k] = sqrt(row[k]);
    for (std::size_t j = k + 1; j < n; ++j) mpz_fdiv_q(row[j].get(), row[j].get(), row[k].get());
  }
  return true;
}

bool are_positive(const std::vector<Integers>& forms, std::size_t n) {
  return std::ranges::all_of(forms, [n](const Integers& form) { return is_positive(form, n); });
}

/// Where a form is too flat for doubles its coordinates are applied to the exact matrices, and the search goes on
/// there.
Shape shape_of(const MatrixFamily& family, double target, const Deadline& deadline) {
  Shape shape{radius::round_family(family, deadline), {}};
  shape.coordinates = quadratic::ellipsoidal_coordinates(shape.round.family, target, deadline);
  const bool movable = family.group().size() <= 1 || family.is_flip_symmetric();
  for (int k = 0; k < most_moves && movable && shape.coordinates.ended_flat && shape.coordinates.bound > target; ++k) {
    radius::RoundFamily moved = shape.round;
    if (deadline.expired() || !radius::change_coordinates(moved, family, radius::to_rational(shape.coordinates.to)))
      break;
    Shape next{std::move(moved), {}};
    next.coordinates = quadratic::ellipsoidal_coordinates(next.round.family, target, deadline);
    if (!(next.coordinates.bound < shape.coordinates.bound) ||
        !are_positive(integer_forms({next.coordinates.to}, next.round, family), family.size()))
      break;
    shape = std::move(next);
  }
  return shape;
}

/// Proves the leaves of a tree for bounds that grow until all hold.
class LeafProver {
 public:
  LeafProver(const MatrixFamily& family, const std::vector<Integers>& forms, double bound)
      : size_(family.size()), forms_(forms), denominator_(common_denominator(family)) {
    for (const RationalMatrix& m : family) integral_.push_back(integer_multiple(m, denominator_));
    moved_.push_back(forms);
    for (std::size_t g = 1; g < family.group().size() && forms.size() > 1 && family.is_flip_symmetric(); ++g) {
      const Integers map = integer_multiple(family.group()[g].map.matrix(), 1);
      moved_.emplace_back();
      for (const Integers& form : forms) moved_.back().push_back(image_of_form(map, form, size_));
    }
    for (const double slack : slacks)
      bounds_.push_back(Rational(Integer(std::ceil(std::ldexp(bound * (1 + slack), bound_bits)))) *
                        power(Rational(2), -bound_bits));
  }

  /// The least of the bounds that holds for all words.
  std::optional<Rational> prove(const std::vector<TreeWord>& words, const Deadline& deadline) {
    for (const TreeWord& word : words) {
      std::vector<Integer>& factors = factors_[word.letters.size()];
      if (!factors.empty()) continue;
      for (const Rational& bound : bounds_) {
        const Rational power_of_bound = power(bound * Rational(denominator_),
                                              2 * static_cast<long>(word.letters.size()));
        factors.push_back((numerator(power_of_bound) << guard_bits) / denominator(power_of_bound));
      }
    }
    parallel_ranges(words.size(), ranges, all_cores(), [&](std::size_t begin, std::size_t end) {
      // The products of the beginnings of a word; the next word shares some of them.
      std::vector<Integers> products;
      for (std::size_t k = begin; k < end && !failed_; ++k) {
        const std::vector<int>& word = words[k].letters;
        std::size_t common = 0;
        if (k > begin)
          common = static_cast<std::size_t>(std::ranges::mismatch(word, words[k - 1].letters).in1 - word.begin());
        products.erase(products.begin() + static_cast<std::ptrdiff_t>(common), products.end());
        for (std::size_t i = common; i < word.size(); ++i) {
          const Integers& letter = integral_[static_cast<std::size_t>(word[i])];
          products.push_back(i == 0 ? letter : product(products.back(), letter, size_));
        }
        const Integers image = image_of_form(products.back(), forms_[words[k].from], size_);
        const Integers& last = moved_[static_cast<std::size_t>(words[k].element)][words[k].to];
        if (deadline.expired() || !holds(image, last, word.size())) failed_ = true;
      }
    });
    if (failed_) return std::nullopt;
    return bounds_[slack_];
  }

 private:
  static constexpr std::size_t ranges = 16;

  /// Raises the bound until it holds for a product with this image of its first form and this last form.
  bool holds(const Integers& image, const Integers& last, std::size_t length) {
    for (std::size_t slack = slack_; slack < bounds_.size(); ++slack) {
      const Integer& factor = factors_.at(length)[slack];
      Integers difference;
      for (std::size_t i = 0; i < image.size(); ++i) difference.push_back(factor * last[i] - (image[i] << guard_bits));
      if (!is_positive(std::move(difference), size_)) continue;
      for (std::size_t known = slack_; known < slack && !slack_.compare_exchange_weak(known, slack);) {
      }
      return true;
    }
    return false;
  }

  std::size_t size_;
  const std::vector<Integers>& forms_;
  std::vector<std::vector<Integers>> moved_;  // by each element of the group, if there are several
  Integer denominator_;
  std::vector<Integers> integral_;  // the matrices times the denominator
  std::vector<Rational> bounds_;
  std::map<std::size_t, std::vector<Integer>> factors_;  // of the last form, by length and bound
  std::atomic<std::size_t> slack_ = 0;
  std::atomic<bool> failed_ = false;
};

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
std::vector<std::vector<Integer>> lower_rows(const Integers& form, std::size_t n) {
  std::vector<std::vector<Integer>> rows(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= i; ++j) rows[i].push_back(form[j * n + i]);
  return rows;
}

double limbs_of(const MatrixFamily& family) {
  long bits = 0;
  for (const RationalMatrix& m : family) {
    const Integer denominator = common_denominator(m);
    bits = std::max(bits, static_cast<long>(msb(denominator)) + binary_exponent(m).value_or(0));
  }
  return static_cast<double>(std::max(bits, 1L)) / 64;
}

/// Forms and a tree whose bound they may prove.
struct FormedTree {
  std::vector<Integers> forms;
  ProductTree tree;
};

/// Of one form and forms of contexts, ever longer, those whose tree has the least bound. Nothing where the one form is
/// too flat.
std::optional<FormedTree> best_tree(const Shape& shape, const MatrixFamily& family, double target,
                                    const std::vector<int>& product, const Budget& budget) {
  const double work = std::min(most_work, work_per_second * (1 - tree_share) * budget.deadline.remaining());
  const Deadline trees_end = budget.deadline.after(tree_share), contexts_end = budget.deadline.after(contexts_share);
  quadratic::ContextForms contexts(shape.round.family, shape.coordinates);
  std::optional<FormedTree> best;
  const auto try_out = [&](const quadratic::StateForms& states, std::size_t leaves) {
    const quadratic::TreeLimits limits{target, limbs_of(family), work, leaves, {trees_end, budget.memory / 2}};
    ProductTree tree = quadratic::product_tree(states, contexts.symmetry(), limits);
    if (best && tree.bound >= best->tree.bound) return;
    std::vector<Integers> forms = integer_forms(states.to, shape.round, family);
    if (are_positive(forms, family.size())) best = FormedTree{std::move(forms), std::move(tree)};
  };
  try_out(contexts.forms(), first_leaves);
  if (!best || best->tree.bound <= target) return best;
  const auto try_contexts = [&] {
    constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();
    try_out(contexts.forms(), no_limit);
    if (product.empty() || contexts.forms().states() == 1 || best->tree.bound <= target) return;
    if (const auto cycle = contexts.with_cycle(product, contexts_end)) try_out(*cycle, no_limit);
  };
  // Trees take a small part of the time.
  const Stopwatch stopwatch;
  double in_trees = 0;
  bool tried = false;
  while (best->tree.bound > target && contexts.grow({contexts_end, budget.memory / 2})) {
    tried = stopwatch.seconds() > trees_worth * in_trees;
    if (!tried) continue;
    const double before = stopwatch.seconds();
    try_contexts();
    in_trees += stopwatch.seconds() - before;
  }
  if (!tried) try_contexts();
  return best;
}

}  // namespace

QuadraticProof scaled(QuadraticProof proof, long exponent) {
  proof.bound *= power(Rational(2), exponent);
  return proof;
}

std::optional<QuadraticProof> prove_by_quadratic_form(const MatrixFamily& family, const Rational& target,
                                                      const Budget& budget, const std::vector<int>& product) {
  if (std::all_of(family.begin(), family.end(), [](const RationalMatrix& m) { return one_norm(m) == 0; }))
    return std::nullopt;
  const double enough = (1 - 2 * slacks[0]) * target.convert_to<double>();
  const auto best = best_tree(shape_of(family, enough, budget.deadline.after(shape_share)), family, enough, product,
                              budget);
  if (!best) return std::nullopt;
  const auto bound = LeafProver(family, best->forms, best->tree.bound).prove(best->tree.words, budget.deadline);
  if (!bound) return std::nullopt;
  QuadraticProof result{{}, family.group(), {}, *bound};
  for (const Integers& form : best->forms) result.forms.push_back(lower_rows(form, family.size()));
  for (const TreeWord& word : best->tree.words)
    result.words.push_back({word.from, word.to, static_cast<std::size_t>(word.element), word.letters});
  return result;
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
                                                        deadline.at_most(isometry_seconds));
  const polytope::Matrix near = guess.to.transposed() * guess.to;
  RationalMatrix form(n, n);
  for (std::size_t k = 0, column = 0; k < n; ++k)
    for (std::size_t l = k; l < n; ++l, ++column)
      for (std::size_t v = 0; v < forms.size(); ++v)
        if (free[v] == column)
          for (std::size_t i = 0, at = 0; i < n; ++i)
            for (std::size_t j = i; j < n; ++j, ++at) form(i, j) += Rational(near(k, l)) * forms[v][at];
  const Integers integral = integer_multiple(form, common_denominator(form));
  if (!is_positive(integral, n)) return std::nullopt;
  QuadraticProof result{{lower_rows(integral, n)}, {family.group().front()}, {}, *ratio};
  for (std::size_t t = 0; t < family.count(); ++t) result.words.push_back({0, 0, 0, {static_cast<int>(t)}});
  return result;
}

}  // namespace subcert
