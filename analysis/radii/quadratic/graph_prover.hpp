#pragma once
/// From forms and a tree in floating point to a proof. Inner header.

#include "graph_proof.hpp"
#include "integer_forms.hpp"
#include "product_tree.hpp"

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

}  // namespace subcert::quadratic
