#pragma once
/// Rational proofs of upper bounds for joint spectral radii by a positive definite quadratic form and a tree of
/// products.

#include <subcert/analysis/symbol/budget.hpp>
#include <subcert/analysis/symbol/matrix_family.hpp>

namespace subcert {

/// With A_w = A_{w_1} ... A_{w_k} and P = P_from, Q = P_to, bound^(2 k) g^T Q g - A_w^T P A_w is positive semidefinite
/// for all words w, g their elements of the group. Every infinite sequence of letters begins with a word from any given
/// form or, where there is one form only, with the image of a word under an element of the group
/// (proofs-checks/certificates/SPEC.md). Of equal matrices the words name the first.
struct QuadraticProof {
  struct Word {
    std::size_t from = 0, to = 0;  ///< forms
    std::size_t element = 0;       ///< of the group
    std::vector<int> letters;
  };
  std::vector<std::vector<std::vector<Integer>>> forms;  ///< each row by row up to the diagonal
  std::vector<FamilySymmetry> group;                     ///< of the family; a single form P has g^T P g = P
  std::vector<Word> words;
  Rational bound;  ///< proved: joint spectral radius <= bound
};

/// The proof for 2^exponent times the matrices.
QuadraticProof scaled(QuadraticProof proof, long exponent);

/// Searches a form and a tree in floating point and confirms both in exact arithmetic. Nothing is returned where that
/// fails. Domain: entries whose doubles are finite and not far from 1 in size; different matrices. `target`: a bound
/// that is small enough; `product`: from left to right, one that may attain the radius. Error: none, the bound is
/// proved. Cost: a few hundred decompositions of each matrix, then three exact matrix products for each word; the
/// checker's work is limited likewise.
std::optional<QuadraticProof> prove_by_quadratic_form(const MatrixFamily& family, const Rational& target,
                                                      const Budget& budget, const std::vector<int>& product = {});

/// The proof for matrices that are a rational number times isometries of one positive definite form: the bound is that
/// number, and the joint spectral radius. Nothing where they are not, or where the form was not found. Domain: size up
/// to 10; others are left out. Cost: the kernel of a system with an unknown for each entry of the form.
std::optional<QuadraticProof> prove_isometries(const MatrixFamily& family, const Deadline& deadline);

}  // namespace subcert
