#pragma once
/// From candidates to rational proofs. Inner header.

#include "antinorm_proof.hpp"
#include "antinorm_search.hpp"

#include <subcert/analysis/symbol/support/budget.hpp>

namespace subcert::subradius {

/// A proved product, and what polytopes of the family and of its transposed matrices begin with.
struct LeadingVector {
  SlowProduct product;
  Enclosure radius;            ///< of the averaged spectral radius; exact where that is rational
  Rational rate;               ///< at least product.radius^(1/length), by less than 2^-bits, relatively
  std::vector<Integer> right;  ///< near a leading eigenvector of the product, >= 0 and not 0; empty for nilpotent ones
  std::vector<Integer> left;   ///< the same of the transposed product; empty also where none is found
};

/// Bounds the spectral radius of a product from above; of a product that is nilpotent, its power that is 0. Nothing
/// where the deadline passes. Domain: no entry negative. Error: radius is at most 1 + 2^-bits times too large, and
/// exact where it is a rational number with a positive eigenvector. Cost: a characteristic polynomial and two linear
/// systems.
std::optional<LeadingVector> leading_vector(const MatrixFamily& family, const std::vector<int>& word, int bits,
                                            const Deadline& deadline);

/// The kept vertices once more, exactly, from the first one on, and all images below which combinations of them are
/// found. Nothing of the candidate is trusted. Nothing where the deadline passes, or where an image has a zero that no
/// vertex has. Domain: `rate` > 0 is what the matrices of the search were divided by, nearly; `first` is the first
/// vertex; no entry of the family, which is the one that was searched, is negative. Cost: a program for each
/// image, and an exact linear system where it is no multiple of a vertex and its antinorm is 1, nearly.
std::optional<AntinormProof> certify_antinorm(const MatrixFamily& family, const AntinormCandidate& candidate,
                                              const std::vector<int>& cycle, const std::vector<Integer>& first,
                                              const Rational& rate, int bits, const Deadline& deadline);

inline Rational two_to(long exponent) { return power(Rational(2), exponent); }

/// Whether the subradius is the averaged spectral radius of the product of the cycle of a proof: yes, or unknown with
/// the step that is missing. The true vertices are the images of the eigenvector, within a factor near 1 of those of
/// the proof. Domain: `proof` belongs to this family, which is transposed where it says so; `radius` encloses that
/// averaged spectral radius. Cost: an eigenpair in balls, an image of each vertex. Source: SPEC.md, Theorem 32.
Decision product_attains_subradius(const MatrixFamily& family, AntinormProof& proof, const Enclosure& radius,
                                   const Deadline& deadline);

/// Positive integers x with matrix x <= shift x, 2^bits times as large as needed, near a leading eigenvector if the
/// shift is just above its eigenvalue. Empty where there are none. Domain: no entry negative; shift > 0. Cost: a linear
/// system.
std::vector<Integer> subinvariant_vector(const RationalMatrix& matrix, const Rational& shift, int bits = 0);

/// The only eigenvector of an eigenvalue, if it has no negative coordinate; else empty.
std::vector<Integer> eigenvector_of(const RationalMatrix& matrix, const Rational& eigenvalue);

/// The product of the cycle, the first letter applied first.
RationalMatrix product_of_cycle(const MatrixFamily& family, const std::vector<std::size_t>& cycle);

/// The rows and columns in which a vector is zero, or is not.
RationalMatrix restricted(const RationalMatrix& matrix, const std::vector<Integer>& vector, bool to_zeros);

}  // namespace subcert::subradius
