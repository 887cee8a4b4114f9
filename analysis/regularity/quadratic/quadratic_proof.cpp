#include "quadratic_proof.hpp"

#include <subcert/analysis/regularity/polytope_proof/round_family.hpp>
#include <subcert/analysis/symbol/parallel.hpp>
#include "product_tree.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace subcert {
namespace {

using quadratic::EllipsoidalCoordinates;
using quadratic::ProductTree;

constexpr double shape_share = 0.4, words_share = 0.25, tree_share = 0.5;  // of the time that is left
constexpr std::size_t words_of_form = 64;                                  // that the form is made small for
constexpr double most_work = 4e9;                                          // of 10^10 that a checker may spend
constexpr double work_per_second = 5e8;                                    // of one core, and some to spare
constexpr int most_moves = 8;                                              // of the exact matrices to other coordinates
constexpr int form_bits = 48;  // of the coordinates; the form has twice as many
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

/// The sum over the group of g^T P g, P the form of the rounded coordinates.
Integers integer_form(const Shape& shape, const MatrixFamily& family) {
  const std::size_t n = family.size();
  RationalMatrix to = radius::to_rational(shape.coordinates.to), result(n, n);
  long bits = form_bits;
  if (const auto& [before, back] = shape.round.coordinates; shape.round.coordinates.differ()) {
    to = to * before;
    // Of what is flat as many digits are left.
    bits += std::max(0L, binary_exponent(before).value_or(0) + binary_exponent(back).value_or(0));
  }
  const Rational unit = power(Rational(2), bits - binary_exponent(to).value_or(0));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) to(i, j) = to_integer(unit * to(i, j), Rounding::nearest);
  for (const FamilySymmetry& element : family.group()) {
    const RationalMatrix moved = to * element.map.matrix(), image = transposed(moved) * moved;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) result(i, j) += image(i, j);
  }
  return integer_multiple(result, 1);
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
    if (!(next.coordinates.bound < shape.coordinates.bound) || !is_positive(integer_form(next, family), family.size()))
      break;
    shape = std::move(next);
  }
  return shape;
}

/// Proves the leaves of a tree for bounds that grow until all hold.
class LeafProver {
 public:
  LeafProver(const MatrixFamily& family, const Integers& form, double bound)
      : size_(family.size()), form_(form), denominator_(common_denominator(family)) {
    for (const RationalMatrix& m : family) integral_.push_back(integer_multiple(m, denominator_));
    for (const double slack : slacks)
      bounds_.push_back(Rational(Integer(std::ceil(std::ldexp(bound * (1 + slack), bound_bits)))) *
                        power(Rational(2), -bound_bits));
  }

  /// The least of the bounds that holds for all words.
  std::optional<Rational> prove(const std::vector<std::vector<int>>& words, const Deadline& deadline) {
    parallel_ranges(words.size(), ranges, all_cores(), [&](std::size_t begin, std::size_t end) {
      // The products of the beginnings of a word; the next word shares some of them.
      std::vector<Integers> products;
      for (std::size_t k = begin; k < end && !failed_; ++k) {
        const std::vector<int>& word = words[k];
        std::size_t common = 0;
        if (k > begin)
          common = static_cast<std::size_t>(
              std::mismatch(word.begin(), word.end(), words[k - 1].begin(), words[k - 1].end()).first - word.begin());
        products.erase(products.begin() + static_cast<std::ptrdiff_t>(common), products.end());
        for (std::size_t i = common; i < word.size(); ++i) {
          const Integers& letter = integral_[static_cast<std::size_t>(word[i])];
          products.push_back(i == 0 ? letter : product(products.back(), letter, size_));
        }
        if (deadline.expired() || !holds(image_of_form(products.back(), form_, size_), word.size())) failed_ = true;
      }
    });
    if (failed_) return std::nullopt;
    return bounds_[slack_];
  }

 private:
  static constexpr std::size_t ranges = 16;

  /// Raises the bound until it holds for a product with this image of the form.
  bool holds(const Integers& image, std::size_t length) {
    for (std::size_t slack = slack_; slack < bounds_.size(); ++slack) {
      const Rational power_of_bound = power(bounds_[slack] * Rational(denominator_), 2 * static_cast<long>(length));
      const Integer factor = (numerator(power_of_bound) << guard_bits) / denominator(power_of_bound);
      Integers difference;
      for (std::size_t i = 0; i < image.size(); ++i) difference.push_back(factor * form_[i] - (image[i] << guard_bits));
      if (!is_positive(std::move(difference), size_)) continue;
      for (std::size_t known = slack_; known < slack && !slack_.compare_exchange_weak(known, slack);) {
      }
      return true;
    }
    return false;
  }

  std::size_t size_;
  const Integers& form_;
  Integer denominator_;
  std::vector<Integers> integral_;  // the matrices times the denominator
  std::vector<Rational> bounds_;
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

}  // namespace

QuadraticProof scaled(QuadraticProof proof, long exponent) {
  proof.bound *= power(Rational(2), exponent);
  return proof;
}

std::optional<QuadraticProof> prove_by_quadratic_form(const MatrixFamily& family, const Rational& target,
                                                      const Budget& budget) {
  if (std::all_of(family.begin(), family.end(), [](const RationalMatrix& m) { return one_norm(m) == 0; }))
    return std::nullopt;
  const double enough = (1 - 2 * slacks[0]) * target.convert_to<double>();
  Shape shape = shape_of(family, enough, budget.deadline.after(shape_share));
  const double work = std::min(most_work, work_per_second * (1 - tree_share) * budget.deadline.remaining());
  const auto tree_of = [&](std::size_t leaves, double share) {
    return quadratic::product_tree(
        shape.coordinates, shape.round.family.symmetry,
        {enough, limbs_of(family), work, leaves, {budget.deadline.after(share), budget.memory / 2}});
  };
  ProductTree tree = tree_of(words_of_form, words_share);
  if (tree.bound > enough) {
    // A form for letters is not the best for words.
    EllipsoidalCoordinates for_letters = shape.coordinates;
    ProductTree small = std::move(tree);
    shape.coordinates = quadratic::coordinates_for_words(for_letters, shape.round.family, small.words, enough,
                                                         budget.deadline.after(words_share));
    tree = tree_of(std::numeric_limits<std::size_t>::max(), tree_share);
    if (small.bound <= tree.bound) {
      shape.coordinates = std::move(for_letters);
      tree = std::move(small);
    }
  }
  QuadraticProof result;
  const Integers form = integer_form(shape, family);
  if (!is_positive(form, family.size())) return std::nullopt;
  const auto bound = LeafProver(family, form, tree.bound).prove(tree.words, budget.deadline);
  if (!bound) return std::nullopt;
  result.form = lower_rows(form, family.size());
  result.group = family.group();
  result.words = tree.words;
  result.bound = *bound;
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
  QuadraticProof result{lower_rows(integral, n), {family.group().front()}, {}, *ratio};
  for (std::size_t t = 0; t < family.count(); ++t) result.words.push_back({static_cast<int>(t)});
  return result;
}

}  // namespace subcert
