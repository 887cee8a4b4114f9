#pragma once
/// That a product attains the joint spectral subradius. Inner header.

#include "antinorm_proof.hpp"

#include <subcert/analysis/symbol/budget.hpp>

namespace subcert::subradius {

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
