#pragma once
/// From forms and a tree in floating point to a proof. Inner header.

#include "integer_forms.hpp"
#include "product_tree.hpp"
#include "quadratic_proof.hpp"

#include <subcert/analysis/symbol/matrices/matrix_family.hpp>
#include <subcert/analysis/symbol/numbers/rational_complex.hpp>

namespace subcert::quadratic {

/// With matrices of steps over 2^bits and the least of some bounds above that of the tree that all words prove.
/// Nothing where none does. Domain: coordinates of the states, lower triangular; bits at most 60. Cost: a few exact
/// products for each step, and two products of matrices for each word, of doubles if bits is at most `double_bits`.
std::optional<GraphProof> prove_graph(const MatrixFamily& family, const std::vector<Integers>& coordinates,
                                      const StateForms& forms, const ProductTree& tree, int bits,
                                      const Deadline& deadline);

/// That the product round which forms are attains the joint spectral radius: the same for one bound, near this one,
/// below its radius. Domain: as above; a tree with kept letters; the leading eigenvalue of the product, nearly.
std::optional<AttainedGraph> prove_attained(const MatrixFamily& family, const std::vector<Integers>& coordinates,
                                            const StateForms& forms, const ProductTree& tree, int bits,
                                            const RationalComplex& eigenvalue, double bound, const Deadline& deadline);

/// By how much more than the bound of the tree a proof tries to prove first, relatively.
double slack_of(int bits, std::size_t size);

/// Products of matrices and of their norms, up to 8 times 4^bits, are exact in double.
constexpr int double_bits = 24;
constexpr int most_bits = 60;

/// With the left eigenvectors u_0 A = r u_1, ... of a product, scaled so that a coordinate of u_0 has modulus 1, each
/// letter of the product leads max(|L x|, scale |u x|) over into r times that of the next state, `kept` being the part
/// of |L x|^2 that does not come from u. The second part is at most low/bound times the first.
struct KeptCycle {
  std::size_t coordinate = 0;
  Rational kept, scale;
  Enclosure radius = Enclosure::at_least(0);  ///< of r, the root of the modulus of an eigenvalue of the product
};

/// Nothing where the inequalities of SPEC.md, 4.14, do not hold. Domain: a product from left to right, its leading
/// eigenvalue, nearly; lower triangular coordinates L before each letter; 0 < bound. Cost: an inverse of balls, and
/// some exact decompositions for each letter.
std::optional<KeptCycle> prove_kept_cycle(const MatrixFamily& family, const std::vector<int>& product,
                                          const RationalComplex& eigenvalue, std::span<const Integers> coordinates,
                                          const Rational& bound);

}  // namespace subcert::quadratic
