#pragma once
/// Rational proofs of upper bounds for joint spectral radii by quadratic forms.

#include "graph_proof.hpp"

namespace subcert {
/// A_t^T P A_t = bound^2 P for the letters t, of equal matrices the first one's, so that bound is the radius
/// (proofs-checks/certificates/SPEC.md, 4.8).
struct QuadraticProof {
  std::vector<std::vector<Integer>> form;  ///< P row by row up to the diagonal
  std::vector<int> letters;
  Rational bound;  ///< proved: joint spectral radius <= bound
};

/// The proof for factor times the matrices. Domain: factor > 0.
QuadraticProof scaled(QuadraticProof proof, const Rational& factor);

/// A product that may attain the joint spectral radius, from left to right.
struct LeadingProduct {
  std::vector<int> word;
  RationalComplex eigenvalue;  ///< the leading one, nearly
};

/// Searches forms and trees in floating point and confirms them in exact arithmetic. Nothing is returned where that
/// fails. Domain: entries whose doubles are finite and not far from 1 in size; different matrices. `target`: a bound
/// that is small enough; `product`: one that may attain the radius, which is proved too if possible. Error: none, the
/// bound is proved. Cost: a few hundred decompositions of each matrix, then two products of matrices for each word; the
/// checker's work is limited likewise.
std::optional<GraphProof> prove_by_quadratic_forms(const MatrixFamily& family, const Rational& target,
                                                   const Budget& budget, const LeadingProduct& product = {});

/// The proof for matrices that are a rational number times isometries of one positive definite form: the bound is that
/// number, and the joint spectral radius. Nothing where they are not, or where the form was not found. Domain: size up
/// to 10; others are left out. Cost: the kernel of a system with an unknown for each entry of the form.
std::optional<QuadraticProof> prove_isometries(const MatrixFamily& family, const Deadline& deadline);

}  // namespace subcert
