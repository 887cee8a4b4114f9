#pragma once
/// Rational proofs of upper bounds for joint spectral radii by a positive definite quadratic form and a tree of
/// products.

#include <subcert/analysis/symbol/budget.hpp>
#include <subcert/analysis/symbol/matrix_family.hpp>

namespace subcert {

/// With A_w = A_{w_1} ... A_{w_k}, bound^(2 k) P - A_w^T P A_w is positive semidefinite for all words w, and every
/// infinite sequence of letters begins with one of them or with its image under an element of the group
/// (proofs-checks/certificates/SPEC.md). Of equal matrices the words name the first.
struct QuadraticProof {
  std::vector<std::vector<Integer>> form;  ///< P, row by row up to the diagonal
  std::vector<FamilySymmetry> group;       ///< of the family; g^T P g = P up to signs of g
  std::vector<std::vector<int>> words;
  Rational bound;  ///< proved: joint spectral radius <= bound
};

/// The proof for 2^exponent times the matrices.
QuadraticProof scaled(QuadraticProof proof, long exponent);

/// Searches a form and a tree in floating point and confirms both in exact arithmetic. Nothing is returned where that
/// fails. Domain: entries whose doubles are finite and not far from 1 in size; different matrices. `target`: a bound
/// that is small enough. Error: none, the bound is proved. Cost: a few hundred decompositions of each matrix, then
/// three exact matrix products for each word; the checker's work is limited likewise.
std::optional<QuadraticProof> prove_by_quadratic_form(const MatrixFamily& family, const Rational& target,
                                                      const Budget& budget);

/// The proof for matrices that are a rational number times isometries of one positive definite form: the bound is that
/// number, and the joint spectral radius. Nothing where they are not, or where the form was not found. Domain: size up
/// to 10; others are left out. Cost: the kernel of a system with an unknown for each entry of the form.
std::optional<QuadraticProof> prove_isometries(const MatrixFamily& family, const Deadline& deadline);

}  // namespace subcert
