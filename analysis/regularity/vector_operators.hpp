#pragma once
/// The transition operators of vectors of functions on rational spaces, also over a quadratic field. Inner header.

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/radii/joint/joint_spectral_radius.hpp>
#include <subcert/analysis/symbol/masks/matrix_masks.hpp>

namespace subcert::vectors {

constexpr std::size_t largest_space = 256;

/// A vector of functions by the mask of its rational parts: where these are more than one each, the multiples of 1 and
/// of the square root of a number (QuadraticMask).
struct Parts {
  const LatticeMask& mask;
  long root = 0;  ///< that number, or 0
  std::size_t components() const { return mask.components() / (root > 0 ? 2 : 1); }
  /// Of a component, from 0.
  std::vector<std::size_t> parts_of(std::size_t component) const {
    return root > 0 ? std::vector{component, component + components()} : std::vector{component};
  }
};

/// The transition operators on a rational space, digit by digit, and the product with the square root where there is
/// one.
struct Operators {
  MatrixFamily family;
  std::optional<RationalMatrix> root = std::nullopt;

  /// All of them, the root last.
  std::vector<RationalMatrix> matrices() const {
    std::vector<RationalMatrix> result = family.matrices();
    if (root) result.push_back(*root);
    return result;
  }
};

/// The root last, where there is one.
Operators operators_of(std::vector<RationalMatrix> matrices, const Parts& parts);
Operators operators_of(const DifferenceSpace& space, const Parts& parts);
/// Those of a family on a space of sequences with these basis and pivots.
Operators operators_of(const std::vector<LatticeSequence>& basis, const std::vector<LatticePoint>& pivots,
                       const MatrixFamily& family, const Parts& parts);

/// A basis of the span of the rows over the field of the root, or with 0 over the rationals: each is 1 at a column
/// where the others are 0. The columns hold all x_c and then all y_c of x + sqrt(root) y; of a row and its multiple by
/// the root that with 1 in a column of x_c is kept. Domain: rows; the rational span holds all multiples by the root.
std::vector<std::vector<Rational>> basis_over_field(const std::vector<std::vector<Rational>>& rows, long root);

/// The columns, one after the other, that are no combinations over the field of the root of those before them, each
/// with its image under the root behind it. Domain: the root times itself is a number that is no square.
RationalMatrix basis_of_pairs(const RationalMatrix& columns, const RationalMatrix& root);

/// The even columns, each with its image under the root behind it in place of the next one.
RationalMatrix with_root_columns(RationalMatrix basis, const RationalMatrix& root);

/// Domain: with a root; a regular basis.
Operators in_basis(const Operators& operators, const RationalMatrix& basis);

/// A basis e_1, J e_1, e_2, J e_2, ..., J the product with the root, such that the reversal of e_1, e_2, ... maps the
/// operators to those of the digits in reverse order: matrices of rounded entries keep this symmetry. Nothing where
/// none is found; what is found is verified exactly. Domain: with a root. Cost: kernels and products of rational
/// matrices of this size, about one for each of its rows.
std::optional<RationalMatrix> mirror_symmetric_basis(const Operators& given, const Deadline& deadline);

/// Whether a regular map over the field of the root takes the operators of one to those of the other, digit by digit in
/// the same order or in the reverse one: their radii are equal. False where none is found. Domain and cost: as above.
bool are_similar(const Operators& first, const Operators& second, const Deadline& deadline);

/// Matrices, and how far the entries of those that are meant may be from theirs.
struct RealFamily {
  MatrixFamily matrices;
  Rational distance = 0;
};

/// On the functions themselves, for the square root of this number, or 0. In the basis e_1, J e_1, e_2, J e_2, ... of
/// the rational space, J the product with the root, e_1, e_2, ... are a basis over the field of the root, with the
/// entries X(2i, 2k) + sqrt(number) X(2i + 1, 2k).
RealFamily on_functions(const Operators& operators, long number, long root_bits = 512);

/// The 2-radius on the functions: the limit of (mean of |T_w|^2 over the words of k digits)^(1/(2k)). Error and cost:
/// as p_radius; over a field as radius_of_congruences of each block. Errors: as these. Nothing where the deadline comes
/// first. Proof: docs/vectors.md, section 8.
std::optional<Enclosure> mean_square_radius(const Operators& operators, long number, int bits,
                                            const Deadline& deadline);

NormProof norms_of(const RealFamily& family, const Budget& budget);

/// On the functions; over a field of the diagonal blocks, each by itself, whose basis in the proof is a rational one of
/// twice the size, e_1, J e_1, e_2, J e_2, ... as above. `target`: as joint_spectral_radius, of rational matrices
/// alone.
JointSpectralRadius radius_of(const Operators& operators, long number, const Budget& budget, const NormProof& norms,
                              const std::optional<Rational>& target = std::nullopt);

}  // namespace subcert::vectors
