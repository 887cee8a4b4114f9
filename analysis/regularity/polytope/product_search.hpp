#pragma once

#include <Eigen/Dense>

#include <cstdint>
#include <vector>

namespace subcert {

/// A finite set of real square matrices of one size.
struct SearchFamily {
  std::vector<Eigen::MatrixXd> matrices;
  /// J A_i J = A_{m-1-i}, J the reversal of the coordinates: mirror images of vertices come for free.
  bool flip_symmetric = false;
};

/// A product A_{w_k} ... A_{w_1}, written as the word w_1 ... w_k (the letter applied first comes first). Canonical:
/// the word is primitive and the least of its cyclic shifts (under flip symmetry: of those of its mirror image as
/// well).
struct Candidate {
  std::vector<int> word;
  double radius = 0;  ///< rho(product)^(1/k)
};

/// How wide and how far the product search looks.
struct ProductSearchOptions {
  int max_length = 40;
  int width = 32;         ///< products kept per length
  double seconds = 1e30;  ///< stops early when spent
  double near = 5e-3;     ///< candidates within this relative distance of the best are reported
};

/// The canonical form of a word, see Candidate. Domain: 0 <= letters < letter_count. Cost: O(length^2).
std::vector<int> canonical_word(std::vector<int> word, int letter_count, bool flip_symmetric);

/// rho(A_{w_k} ... A_{w_1})^(1/k), from the eigenvalues of the product in double precision.
/// Domain: non-empty word over the family.
double product_radius(const std::vector<Eigen::MatrixXd>& matrices, const std::vector<int>& word);

/// A symmetric positive definite G with G = sum_i A_i G A_i^T / s + a little of the identity: the averaged shape of all
/// orbits, and the square root of s, which is an upper bound of the joint spectral radius (s / count bounds it below).
/// s = 0 exactly when all long products vanish. Commutes with the flip if the family is flip symmetric.
/// Cost: up to 60 sums of 2 count cubic products. Ref: [BN05], the ellipsoidal norm of the lifted sum.
struct OrbitShape {
  Eigen::MatrixXd shape;
  double radius_bound = 0;
};
OrbitShape orbit_shape(const std::vector<Eigen::MatrixXd>& matrices);

/// Products of large averaged spectral radius, best first, shortest first among equals (relative 1e-11), at most 64 of
/// them. A width limited branch and bound: per length it keeps the products of largest norm and those of
/// largest estimated radius, and drops those whose norm shows that no power of them can beat the best.
/// It never misses a product of length k with count^k <= width. The result is a lower bound of the joint
/// spectral radius, not more. Error: radii as exact as double precision eigenvalues.
/// Cost: 2 width * max_length matrix products and a few hundred eigenvalue problems. Ref: [Gri96], [Mej20, sec. 3].
std::vector<Candidate> search_products(const SearchFamily& family, const ProductSearchOptions& options);

}  // namespace subcert
