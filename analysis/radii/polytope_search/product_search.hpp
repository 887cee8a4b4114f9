#pragma once
/// Products of the matrices of a family whose averaged spectral radius is large, or small: the candidates for spectrum
/// maximizing, or minimizing, products that the search for a polytope starts from.

#include "symmetry.hpp"

#include <subcert/analysis/symbol/support/budget.hpp>

#include <array>
#include <vector>

namespace subcert::polytope {

/// A finite set of real square matrices of one size, and a group that permutes them.
struct SearchFamily {
  std::vector<Matrix> matrices;
  SymmetryGroup symmetry;
};

bool is_finite(const SearchFamily& family);
/// Whether g A_i g^-1 = A_g(i) for all elements g of its group, up to rounding. Domain: finite entries.
bool has_symmetry(const SearchFamily& family);

/// The same letters from the other end: a product is written from left to right, and its last matrix is applied first.
inline std::vector<int> turned(const std::vector<int>& word) { return {word.rbegin(), word.rend()}; }

/// A product A_{w_k} ... A_{w_1}, written as the word w_1 ... w_k (the letter applied first comes first). Canonical:
/// the word is primitive and the least of its cyclic shifts and of those of its images under the symmetry.
struct Candidate {
  std::vector<int> word;  ///< letters in the order in which the matrices are applied
  double radius = 0;      ///< rho(product)^(1/k)

  /// The letters as the product is written, from left to right.
  std::vector<int> written() const { return turned(word); }
  /// The product of the transposed matrices that is transposed to this one.
  Candidate transposed() const { return {written(), radius}; }
};

/// How wide and how far the product search looks.
struct ProductSearchOptions {
  int max_length = 40;
  int width = 32;      ///< products kept per length; fewer where the memory does not hold so many
  double near = 5e-3;  ///< candidates within this relative distance of the best are reported
  Budget budget;
  bool least = false;  ///< products of small radius are meant instead
};

/// Looks of rising cost: with each one better products may be found.
struct ProductLook {
  int length, width;
};
inline constexpr std::array<ProductLook, 3> product_looks{{{12, 12}, {40, 32}, {200, 100}}};

/// The shortest word of which this one is a power. Cost: O(length) for each divisor of the length.
std::vector<int> without_repetitions(std::vector<int> word);

/// The canonical form of a word, see Candidate. Domain: 0 <= letters < letter_count. Cost: O(length^2) per element of
/// the symmetry.
std::vector<int> canonical_word(std::vector<int> word, std::size_t letter_count, const SymmetryGroup& symmetry);

/// Best first, those of largest radius or with `least` of smallest; among those that equal the best to a relative 1e-11
/// the shorter words first. Returns how many do.
std::size_t sort_candidates(std::vector<Candidate>& candidates, bool least = false);

/// Adds the products, if any is clearly larger than the first of these, the best, of a part of its word, read in a
/// circle, as what runs through several cycles is no better than the best of them; or of its word, turned, and that of
/// one of the next few, turned; and so on from there. Cost: a multiplication of matrices for each of them, nothing
/// where they are more than some 10^6 products of numbers.
void add_better_neighbours(std::vector<Candidate>& candidates, const SearchFamily& family);

/// |tr P^2|^(1/2), the spectral radius of P up to the weight of the other eigenvalues.
double estimated_radius(const Matrix& product);

/// rho(A_{w_k} ... A_{w_1})^(1/k), from the eigenvalues of the product in double precision.
/// Domain: non-empty word over the family.
double product_radius(const std::vector<Matrix>& matrices, const std::vector<int>& word);

/// A symmetric positive definite G with G = sum_i A_i G A_i^T / s + a little of the identity: the averaged shape of all
/// orbits, and the square root of s, which is an upper bound of the joint spectral radius (s / count bounds it below).
/// s = 0 exactly when all long products vanish. Commutes with the symmetry of the family. Past the deadline, or where
/// rounding has made G indefinite, G is what it was last, and the bound a cruder one. Cost: up to 60 sums of 2 count
/// cubic products. Ref: [BN05], the ellipsoidal norm of the lifted sum.
struct OrbitShape {
  Matrix shape;
  double radius_bound = 0;
  bool lost = false;  ///< to rounding
};
/// Of the largest eigenvalue of such a shape: below it they are rounding, of either sign.
inline constexpr double resolved_share = 1e-9;
OrbitShape orbit_shape(const std::vector<Matrix>& matrices, const Deadline& deadline = {});

/// Coordinates x' = to x in which a symmetric positive definite shape becomes the identity; eigenvalues below
/// `least` times the largest are raised to it.
struct Whitening {
  Matrix to, from;
};
Whitening whitening(const Matrix& shape, double least);

/// Products of large averaged spectral radius, best first, shortest first among equals (relative 1e-11), at most 64 of
/// them, at least one. A width limited branch and bound: per length it keeps the products of largest norm and those of
/// largest estimated radius, and drops those whose norm shows that no power of them can beat the best.
/// Within the budget it never misses a product of length k with count^k <= width. The result is a lower bound of the
/// joint spectral radius, not more. With `least` it keeps products of small norm and radius, and drops none for its
/// norm. Domain: at least one matrix; of numbers that are not finite it says that the first matrix has the radius 0.
/// Error: radii as exact as double precision eigenvalues.
/// Cost: 2 width * max_length matrix products and a few hundred eigenvalue problems. Ref: [Gri96], [Mej20, sec. 3].
std::vector<Candidate> search_products(const SearchFamily& family, const ProductSearchOptions& options);

}  // namespace subcert::polytope
