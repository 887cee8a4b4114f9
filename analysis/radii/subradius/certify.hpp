#pragma once
/// From candidates to rational proofs. Inner header.

#include "antinorm_proof.hpp"
#include "antinorm_search.hpp"

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

}  // namespace subcert::subradius
