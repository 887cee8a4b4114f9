#pragma once
/// Rational proofs of upper bounds for joint spectral radii by quadratic forms.

#include <subcert/analysis/radii/polytope_proof/attained_number.hpp>
#include <subcert/analysis/symbol/matrices/matrix_family.hpp>
#include <subcert/analysis/symbol/support/budget.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace subcert {

struct AttainedGraph;

/// States with norms |x| = |L x|, L lower triangular, and steps L A_t = bound (B + E) L_to g / 2^bits, g an element of
/// the group, E an error of norm at most the size of the matrices. Words of steps lead away from each state whose
/// products are contractions, errors included; every infinite sequence of letters begins with one
/// (proofs-checks/certificates/SPEC.md, 4.13).
struct GraphProof {
  struct Step {
    std::size_t letter = 0, to = 0;
    std::size_t element = 0;           ///< of the group
    std::int64_t norm = 0;             ///< of B, at least
    std::vector<std::int64_t> matrix;  ///< B row by row
  };
  struct State {
    std::vector<std::vector<Integer>> coordinates;  ///< L row by row up to the diagonal
    std::vector<Step> steps;                        ///< by letter; words go on by the first one of a letter
    std::string ends;                               ///< words, as in ProductTree
  };
  std::vector<State> states;
  int bits = 0;                       ///< at most 60
  std::vector<FamilySymmetry> group;  ///< of the family
  Rational bound;                     ///< proved: joint spectral radius <= bound
  /// That a product attains the joint spectral radius, where it is proved.
  std::shared_ptr<const AttainedGraph> attained = {};

  std::size_t words() const;
};

/// Words of steps for a bound below the radius of a product, and letters that go round the product instead of words:
/// these keep a norm that knows the left eigenvector of the product (SPEC.md, 4.14).
struct AttainedGraph {
  GraphProof graph;                           ///< with kept letters; its bound proves nothing by itself
  std::size_t first;                          ///< the state before the first letter of the product
  std::vector<int> product;                   ///< from left to right
  std::size_t coordinate;                     ///< of the eigenvector, whose modulus is 1
  Rational kept, scale;                       ///< of the line `cycle`
  Enclosure radius;                           ///< the joint spectral radius
  std::optional<AttainedNumber> number = {};  ///< that is it, once it is named,
  std::vector<Integer> seed = {};  ///< and a vector whose images under the transposed product sum to the eigenvector
};

/// The proof for factor times the matrices. Domain: factor > 0.
GraphProof scaled(GraphProof proof, const Rational& factor);

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
