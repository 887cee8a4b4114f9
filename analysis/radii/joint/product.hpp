#pragma once
/// Products of a family, their leading eigenvalues with proof, and exact comparisons between them.

#include <subcert/analysis/symbol/matrices/matrix_family.hpp>

namespace subcert {

/// A product of a family with a proved lower bound of its spectral radius: some eigenvalue of the product lies within
/// size * |p(c) / p'(c)| of the point c = `eigenvalue`, p the characteristic polynomial; where that polynomial would be
/// long, a simple eigenvalue is enclosed with its eigenvector.
struct ProductEvidence {
  std::vector<int> word;  ///< the product M_{word[0]} M_{word[1]} ..., from left to right
  RationalComplex eigenvalue;
  /// Of rho(product)^(1/length): the lower end is proved, the upper end is that of the nearby eigenvalue.
  Enclosure radius = Enclosure::at_least(0);
  std::optional<Rational> exact;  ///< rho(product)^(1/length), where that is proved to be a rational number
};

/// The letters of a product in a row, with commas before letters above 9.
std::string word_text(const std::vector<int>& word);

/// Encloses the leading eigenvalue of a product. `distance`: for all families whose entries differ from these by at
/// most that. Domain: a word of at least one letter; distance >= 0. Error: about 2^-190, relatively; the lower end is 0
/// where no eigenvalue is isolated or the deadline passes. Cost: one characteristic polynomial, or an enclosure by
/// balls where that is quicker. Ref: SPEC.md, 4.5 and section 7.
ProductEvidence prove_product(const MatrixFamily& family, const std::vector<int>& word, const Deadline& deadline = {},
                              const Rational& distance = 0);

/// An inverse of c - P, P a product and c a number near its leading eigenvalue, good to about 2^-60. Ref: SPEC.md, 4.5.
struct ApproximateInverse {
  RationalComplex point;  ///< c, about 2^-72 away from the eigenvalue, relatively
  int bits;
  std::vector<std::vector<Integer>> columns;  ///< over 2^bits; real parts, then, if c is not real, imaginary parts
};

/// Domain: evidence of a product of this family. Nothing where its numbers would be too long for a certificate. Cost:
/// the product and one inverse of balls.
std::optional<ApproximateInverse> approximate_inverse(const MatrixFamily& family, const ProductEvidence& evidence);

namespace radius {

/// The same by balls alone, for products whose polynomials take long. Nothing for others, and where the leading
/// eigenvalue is multiple or rational, as far as doubles tell, or is not isolated. Cost: some hundredths of a second
/// for a size of 100.
std::optional<ProductEvidence> prove_long_product(const MatrixFamily& family, const std::vector<int>& word,
                                                  const Deadline& deadline);

/// The evidence for factor times the matrices. Domain: factor > 0.
ProductEvidence scaled(ProductEvidence evidence, const Rational& factor);

/// Whether rho(below)^(1/length) <= rho(above)^(1/length'), exactly, for products over two families: all leading
/// eigenvalues of the one are eigenvalues of the other, or smaller. False where that takes too long. Cost:
/// characteristic polynomials of powers of equal length.
bool is_dominated(const MatrixFamily& first, const ProductEvidence& above, const MatrixFamily& second,
                  const ProductEvidence& below, const Deadline& deadline);

/// The size of the largest Jordan block of the leading eigenvalue of a product, less 1; 0 where that is not decided.
int jordan_power(const MatrixFamily& family, const std::vector<int>& word, const Deadline& deadline);

}  // namespace radius
}  // namespace subcert
