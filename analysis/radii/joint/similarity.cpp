#include "similarity.hpp"

#include "modular_meataxe.hpp"
#include "scaling.hpp"

#include <algorithm>
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

}  // namespace subcert::radius
