
#include "similarity.hpp"

#include "modular_meataxe.hpp"

#include <subcert/analysis/radii/polytope_proof/round_family.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace subcert::radius {
namespace {

using Letters = std::vector<std::size_t>;

constexpr std::size_t most_permutations = 200, most_elements = 48;

Letters in_order(std::size_t count) {
  Letters result(count);
  std::iota(result.begin(), result.end(), std::size_t{0});
  return result;
}

/// tr(A_s A_t) for all s and t.
std::vector<ModVector> traces(const ModFamily& family) {
  const nmod_t mod = family.front().modulus();
  const std::size_t n = family.front().rows();
  std::vector<ModVector> result(family.size(), ModVector(family.size(), 0));
  for (std::size_t s = 0; s < family.size(); ++s)
    for (std::size_t t = 0; t < family.size(); ++t)
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          if (family[s](i, j) != 0)
            result[s][t] = nmod_add(result[s][t], nmod_mul(family[s](i, j), family[t](j, i), mod), mod);
  return result;
}

/// The permutations p with traces first[s][t] == second[p(s)][p(t)].
std::vector<Letters> candidate_permutations(const std::vector<ModVector>& first, const std::vector<ModVector>& second) {
  std::vector<Letters> result;
  Letters chosen;
  const auto extend = [&](const auto& self) -> void {
    const std::size_t s = chosen.size();
    if (s == first.size()) {
      result.push_back(chosen);
      return;
    }
    for (std::size_t image = 0; image < first.size() && result.size() < most_permutations; ++image) {
      if (std::find(chosen.begin(), chosen.end(), image) != chosen.end()) continue;
      bool fits = first[s][s] == second[image][image];
      for (std::size_t t = 0; t < s && fits; ++t) fits = first[s][t] == second[image][chosen[t]];
      if (!fits) continue;
      chosen.push_back(image);
      self(self);
      chosen.pop_back();
    }
  };
  extend(extend);
  return result;
}

/// All the similarities of one family to others.
class SimilaritySearch {
 public:
  /// Finds a vector that is determined up to a factor by an element of the algebra and one of its eigenvalues. Is not
  /// ready once the deadline passes.
  SimilaritySearch(const MatrixFamily& family, const Deadline& deadline)
      : family_(family), reduced_(modulo_prime(family)) {
    if (!reduced_) return;
    std::mt19937_64 random(1);
    for (int attempt = 0; attempt < 4 * meataxe_attempts; ++attempt) {
      element_ = algebra_element(family.count(), attempt, random);
      if (deadline.expired()) return;
      for (const ulong eigenvalue : simple_eigenvalues(*reduced_, element_)) {
        if (deadline.expired()) return;
        const auto start = eigenvector(*reduced_, element_, eigenvalue);
        if (!start) continue;
        steps_ = spin(*reduced_, *start);
        if (steps_.size() < family.size()) continue;
        eigenvalue_ = eigenvalue;
        inverse_basis_ = inverse(words_applied(*reduced_, *start, in_order(family.count())));
        return;
      }
    }
  }

  bool is_ready() const { return inverse_basis_.has_value(); }

  /// The permutations that traces allow.
  std::vector<Letters> permutations(const ModFamily& other) const {
    return candidate_permutations(traces(*reduced_), traces(other));
  }

  /// J with J A_t = B_letters[t] J, exactly; determined up to a factor.
  std::optional<RationalMatrix> map_to(const MatrixFamily& other, const ModFamily& reduced,
                                       const Letters& letters) const {
    AlgebraElement element = element_;
    for (AlgebraElement::Summand& summand : element.summands)
      for (std::size_t& letter : summand.word) letter = letters[letter];
    const auto start = eigenvector(reduced, element, eigenvalue_);
    if (!start) return std::nullopt;
    const ModMatrix j = words_applied(reduced, *start, letters) * *inverse_basis_;
    auto map = recognised(j);
    if (!map) return std::nullopt;
    for (std::size_t t = 0; t < family_.count(); ++t)
      if (!(*map * family_[t] == other[letters[t]] * *map)) return std::nullopt;
    return map;
  }

  const std::optional<ModFamily>& reduced() const { return reduced_; }

 private:
  /// The columns A_w start for the words of the steps, letters replaced.
  ModMatrix words_applied(const ModFamily& family, const ModVector& start, const Letters& letters) const {
    const std::size_t n = start.size();
    std::vector<ModVector> vectors{start};
    for (std::size_t k = 1; k < steps_.size(); ++k)
      vectors.push_back(family[letters[steps_[k].letter]] * vectors[steps_[k].parent]);
    ModMatrix result(n, n);
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i) result(i, j) = vectors[j][i];
    return result;
  }

  /// The multiple of a matrix modulo the prime whose first entry that is not 0 is 1, if all are small fractions then.
  static std::optional<RationalMatrix> recognised(const ModMatrix& matrix) {
    const nmod_t mod = matrix.modulus();
    ulong factor = 0;
    RationalMatrix result(matrix.rows(), matrix.columns());
    for (std::size_t i = 0; i < matrix.rows(); ++i)
      for (std::size_t j = 0; j < matrix.columns(); ++j) {
        if (matrix(i, j) == 0) continue;
        if (factor == 0) factor = nmod_inv(matrix(i, j), mod);
        const auto value = small_fraction(nmod_mul(matrix(i, j), factor, mod));
        if (!value) return std::nullopt;
        result(i, j) = *value;
      }
    return result;
  }

  const MatrixFamily& family_;
  std::optional<ModFamily> reduced_;
  AlgebraElement element_;
  ulong eigenvalue_ = 0;
  std::vector<SpinStep> steps_;
  std::optional<ModMatrix> inverse_basis_;
};

/// The multiple of J, unique up to its sign, of which a power is the identity or its negative. Domain: a power of J is
/// a multiple of the identity, below this order.
std::optional<RationalMatrix> of_finite_order(const RationalMatrix& j, std::size_t order) {
  const RationalMatrix power_of_j = power(j, static_cast<long>(order));
  const Rational& factor = power_of_j(0, 0);
  if (factor == 0 || !(power_of_j == factor * RationalMatrix::identity(j.rows()))) return std::nullopt;
  const auto size = exact_root(abs(factor), static_cast<unsigned long>(order));
  if (!size) return std::nullopt;
  return 1 / *size * j;
}

std::size_t order_of(const Letters& letters) {
  Letters power = letters;
  std::size_t order = 1;
  for (; power != in_order(letters.size()); ++order)
    for (std::size_t& letter : power) letter = letters[letter];
  return order;
}

struct Element {
  RationalMatrix map;
  Letters letters;
};

/// With each element its products with all others. Those of equal letters differ by their sign only, as the family is
/// irreducible over the complex numbers wherever a simple eigenvalue spins to the whole space.
void close(std::vector<Element>& group) {
  std::set<Letters> known;
  for (const Element& element : group) known.insert(element.letters);
  for (std::size_t i = 0; i < group.size() && group.size() <= most_elements; ++i)
    for (std::size_t k = 0; k < group.size(); ++k) {
      Letters letters = group[k].letters;
      for (std::size_t& letter : letters) letter = group[i].letters[letter];
      if (known.insert(letters).second) group.push_back({group[i].map * group[k].map, std::move(letters)});
    }
}

std::vector<Element> symmetry_group(const MatrixFamily& family, const Deadline& deadline) {
  std::vector<Element> group{{RationalMatrix::identity(family.size()), in_order(family.count())}};
  const SimilaritySearch search(family, deadline);
  if (!search.is_ready()) return group;
  for (const Letters& letters : search.permutations(*search.reduced())) {
    if (deadline.expired()) break;
    if (std::any_of(group.begin(), group.end(), [&](const Element& e) { return e.letters == letters; })) continue;
    const auto map = search.map_to(family, *search.reduced(), letters);
    auto finite = map ? of_finite_order(*map, order_of(letters)) : std::nullopt;
    if (!finite) continue;
    group.push_back({std::move(*finite), letters});
    close(group);
    if (group.size() > most_elements) return {group.front()};
  }
  return group;
}

/// Columns: a basis of the lattice that the images of the unit vectors span.
RationalMatrix invariant_lattice(const std::vector<Element>& group) {
  const std::size_t n = group.front().map.rows();
  Integer common = 1;
  for (const Element& element : group) common = lcm(common, common_denominator(element.map));
  std::vector<std::vector<Integer>> rows;
  for (const Element& element : group)
    for (std::size_t j = 0; j < n; ++j) {
      rows.emplace_back();
      for (std::size_t i = 0; i < n; ++i) rows.back().push_back(numerator(Rational(element.map(i, j) * common)));
    }
  const std::vector<std::vector<Integer>> basis = reduced_lattice(lattice_basis(rows));
  RationalMatrix result(n, n);
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) result(i, j) = Rational(basis[j][i], common);
  return result;
}

}  // namespace

BlockTriangular with_symmetries(BlockTriangular triangular, const Deadline& deadline) {
  const std::size_t n = triangular.basis.rows();
  std::vector<std::vector<FamilySymmetry>> groups;
  RationalMatrix change = RationalMatrix::identity(n);
  bool changed = false;
  std::size_t start = 0;
  for (std::size_t k = 0; k < triangular.sizes.size(); start += triangular.sizes[k++]) {
    const MatrixFamily family = triangular.block(k);
    groups.push_back(family.group());
    const std::size_t size = family.size();
    if (size == 1 || family.count() == 1 || (family.count() <= 3 && family.group().size() > 1) || deadline.expired())
      continue;
    if (is_nonnegative(family)) continue;  // the cone of non-negative vectors serves better than a group
    const std::vector<Element> group = symmetry_group(family, deadline);
    if (group.size() <= family.group().size()) continue;
    const RationalMatrix basis = invariant_lattice(group);
    groups.back().clear();
    for (const Element& element : group)
      groups.back().push_back({SparseMap(solve(basis, element.map * basis)), element.letters});
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < size; ++j) change(start + i, start + j) = basis(i, j);
    changed = true;
  }
  triangular.groups = std::move(groups);
  if (!changed) return triangular;
  return in_basis(std::move(triangular), change);
}

bool are_similar(const MatrixFamily& first, const MatrixFamily& second, const Deadline& deadline) {
  if (first.size() != second.size() || first.count() != second.count()) return false;
  const SimilaritySearch search(first, deadline);
  const auto reduced = modulo_prime(second);
  if (!search.is_ready() || !reduced) return false;
  for (const Letters& letters : search.permutations(*reduced)) {
    if (deadline.expired()) return false;
    const auto map = search.map_to(second, *reduced, letters);
    if (map && kernel(*map).empty()) return true;
  }
  return false;
}

namespace {

constexpr long near_enough = 16;        // bits: families of ordinary numbers are left alone
constexpr long short_denominator = 64;  // bits: those of ordinary decimals and masks
constexpr double ordinary_span = 60;    // bits between the largest and the smallest entry that doubles stand
constexpr int sweeps = 200;
constexpr long lattice_bits = 400;  // of the longest vector of a lattice before it is reduced

constexpr double none = -std::numeric_limits<double>::infinity();

/// The logarithms to base 2 of the largest entries at each place, over all matrices; -infinity for zeros.
std::vector<std::vector<double>> entry_sizes(const MatrixFamily& family) {
  const std::size_t n = family.size();
  std::vector<std::vector<double>> result(n, std::vector<double>(n, none));
  for (const RationalMatrix& m : family)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        if (m(i, j) != 0) result[i][j] = std::max(result[i][j], static_cast<double>(binary_exponent(m(i, j))));
  return result;
}

double span_of(const std::vector<std::vector<double>>& sizes) {
  double low = -none, high = none;
  for (const auto& row : sizes)
    for (const double size : row)
      if (size > none) {
        low = std::min(low, size);
        high = std::max(high, size);
      }
  return high > none ? high - low : 0;
}

/// D = diag(2^e_i) for which D^-1 A D has rows and columns of equal size, the diagonal apart: one coordinate after the
/// other, until nothing changes. Nothing where the entries differ little. Ref: [Osb60].
std::optional<RationalMatrix> equal_lengths(const MatrixFamily& family) {
  const auto sizes = entry_sizes(family);
  if (span_of(sizes) <= ordinary_span) return std::nullopt;
  const std::size_t n = family.size();
  std::vector<double> e(n, 0);
  bool changed = true;
  for (int sweep = 0; changed && sweep < sweeps; ++sweep) {
    changed = false;
    for (std::size_t i = 0; i < n; ++i) {
      double row = none, column = none;
      for (std::size_t j = 0; j < n; ++j) {
        if (j == i) continue;
        row = std::max(row, sizes[i][j] + e[j] - e[i]);
        column = std::max(column, sizes[j][i] + e[i] - e[j]);
      }
      const double step = row > none && column > none ? (row - column) / 2 : 0;
      e[i] += step;
      changed = changed || std::abs(step) > 0.5;
    }
  }
  RationalMatrix result(n, n);
  for (std::size_t i = 0; i < n; ++i) {
    // The flip has to stay a symmetry; the mean of two balanced scalings is one.
    const double mean = family.is_flip_symmetric() ? (e[i] + e[n - 1 - i]) / 2 : e[i];
    result(i, i) = power(Rational(2), std::lround(mean - e[0]));
  }
  return result;
}

MatrixFamily in_basis(const MatrixFamily& family, const RationalMatrix& basis) {
  std::vector<RationalMatrix> matrices;
  for (const RationalMatrix& m : family) matrices.push_back(solve(basis, m * basis));
  return matrices;
}

/// The size of the largest entry, in bits; nothing where all are 0.
std::optional<long> largest_exponent(const MatrixFamily& family) {
  std::optional<long> largest;
  for (const RationalMatrix& m : family)
    if (const auto e = binary_exponent(m)) largest = std::max(largest.value_or(*e), *e);
  return largest;
}

/// A reduced basis of the integer vectors, where lengths are measured in coordinates in which orbits are round, with
/// the lengths made equal by powers of two: in it matrices are hardly larger than their products. Nothing where they
/// are not much larger anyway, or the basis does not make them smaller.
std::optional<RationalMatrix> short_basis(const MatrixFamily& family, const Deadline& deadline) {
  if (family.is_flip_symmetric() || !has_hidden_products(family, deadline)) return std::nullopt;
  const auto round = long_rounding(family, deadline);
  if (!round) return std::nullopt;
  const std::size_t n = family.size();
  std::vector<std::vector<Integer>> images(n);  // of the unit vectors
  RationalMatrix given(n, n), reduced(n, n);    // columns
  const Rational unit = power(Rational(2), lattice_bits - binary_exponent(*round).value_or(0));
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) {
      images[j].push_back(to_integer((*round)(i, j) * unit, Rounding::nearest));
      given(i, j) = images[j].back();
    }
  if (!kernel(given).empty()) return std::nullopt;
  const auto shortest = reduced_lattice(images);
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) reduced(i, j) = shortest[j][i];
  RationalMatrix basis = solve(given, reduced);
  for (std::size_t j = 0; j < n; ++j) {
    Integer length = 0;
    for (const Integer& c : shortest[j]) length = std::max(length, abs(c));
    const Rational factor = power(Rational(2), lattice_bits - static_cast<long>(msb(length)));
    for (std::size_t i = 0; i < n; ++i) basis(i, j) *= factor;
  }
  const bool shorter = largest_exponent(in_basis(family, basis)) < largest_exponent(family);
  return shorter ? std::optional(std::move(basis)) : std::nullopt;
}

/// The basis in which the entries of a block are of like sizes, and not much larger than those of products; nothing
/// where it is the given one.
std::optional<RationalMatrix> balancing(const MatrixFamily& family, const Deadline& deadline) {
  const auto lengths = equal_lengths(family);
  const auto shorter = short_basis(lengths ? in_basis(family, *lengths) : family, deadline);
  return lengths && shorter ? *lengths * *shorter : shorter ? shorter : lengths;
}

}  // namespace

long scaling_exponent(const MatrixFamily& family) {
  const auto largest = largest_exponent(family);
  return largest && std::abs(*largest) > near_enough ? *largest : 0;
}

Rational unit_of(const MatrixFamily& family) {
  Integer numerators = 0, denominators = 1;
  for (const RationalMatrix& m : family)
    for (std::size_t i = 0; i < m.rows(); ++i)
      for (std::size_t j = 0; j < m.columns(); ++j) {
        numerators = gcd(numerators, numerator(m(i, j)));
        denominators = lcm(denominators, denominator(m(i, j)));
      }
  if (numerators == 0) return 1;
  const Rational content(numerators, denominators);
  const auto bits = [](const Integer& x) { return static_cast<long>(msb(x)); };
  const bool is_short = bits(numerators) <= near_enough && bits(denominators) <= short_denominator;
  const long exponent = scaling_exponent(family);
  if (is_short && exponent == 0) return 1;
  long largest = 0, longest = 0;  // of the integers that are left; of the numbers as they are
  for (const RationalMatrix& m : family) {
    if (const auto e = binary_exponent(m)) largest = std::max(largest, *e - binary_exponent(content));
    for (std::size_t i = 0; i < m.rows(); ++i)
      for (std::size_t j = 0; j < m.columns(); ++j)
        if (m(i, j) != 0) longest = std::max(longest, bits(abs(numerator(m(i, j)))) + bits(denominator(m(i, j))));
  }
  if (is_short || 2 * largest > longest) return power(Rational(2), exponent);
  return content * power(Rational(2), largest);
}

BlockTriangular in_basis(BlockTriangular triangular, const RationalMatrix& change) {
  triangular.basis = triangular.basis * change;
  for (RationalMatrix& matrix : triangular.triangular) matrix = solve(change, matrix * change);
  return triangular;
}

BlockTriangular balanced(BlockTriangular triangular, const Deadline& deadline) {
  RationalMatrix change(0, 0);
  std::size_t start = 0;
  for (std::size_t k = 0; k < triangular.sizes.size(); start += triangular.sizes[k++]) {
    const auto own = triangular.sizes[k] == 1 ? std::nullopt : balancing(triangular.block(k), deadline);
    if (!own) continue;
    if (change.rows() == 0) change = RationalMatrix::identity(triangular.basis.rows());
    for (std::size_t i = 0; i < own->rows(); ++i)
      for (std::size_t j = 0; j < own->rows(); ++j) change(start + i, start + j) = (*own)(i, j);
  }
  return change.rows() == 0 ? triangular : in_basis(std::move(triangular), change);
}

}  // namespace subcert::radius
