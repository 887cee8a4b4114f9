#pragma once
/// The lines of certificates about joint spectral radii. Format: SPEC.md beside this. Inner header.

#include "certificate.hpp"

#include <subcert/analysis/family/parametric_family.hpp>
#include <subcert/analysis/regularity/scheme_convergence.hpp>

#include <string>
#include <vector>

namespace subcert::certificate_text {

/// A decimal of 15 places as a fraction in lowest terms; of 15 more than the zeros after the point for tiny numbers.
std::string outward(const Rational& value, Rounding rounding);

/// As to_mask_text(), with numbers 1/2-3/4*sqrt(7).
std::string mask_text(const QuadraticMask& mask);

/// Each after a blank.
std::string numbers_text(const std::vector<Integer>& numbers);

Integer common_denominator(const std::vector<LatticeSequence>& sequences);

/// POINT:INTEGER after blanks, of a sequence of vectors POINT.COMPONENT:INTEGER, of the sequence times a factor, and an
/// end of line; the point `first` leads, if it is one of them.
std::string terms_text(const LatticeSequence& sequence, const Rational& factor, std::size_t variables,
                       const LatticePoint& first = {});

/// The lines `space` and `vector`, times their common denominator.
std::string vectors_text(const std::vector<LatticeSequence>& basis, const std::vector<LatticePoint>& pivots,
                         std::size_t variables);

/// Of a mask of matrices of one variable, the lines up to the vectors of the space of what annihilates the polynomials
/// that it keeps. Domain: with `hermite` these are values and derivatives.
std::string space_of_vectors_text(const AnnihilatingSpace& space, int arity, bool hermite);

/// The lines `digits` and `fixed` of a scheme on vectors of any number of variables, and its space, absent where it
/// keeps nothing. `space`: the vectors and their pivots that are to be printed.
std::string space_of_constants_text(const Dilation& dilation, const SchemeDifferences& differences,
                                    const std::vector<LatticeSequence>& basis, const std::vector<LatticePoint>& pivots);
/// Convergence, or that there is none. Errors: throws Error where neither is proved.
ClaimedEnds ends_of_differences(const SchemeDifferences& differences);

/// Throws Error unless the mask may be one of a certificate of a scheme on vectors.
void require_vector_scheme(const LatticeMask& mask, bool hermite);
/// Throws Error unless so much is kept.
void require_kept(const PolynomialData& kept, bool hermite);

/// What is claimed of a scheme that keeps these data: the largest HC^k that the radius of arity^(m+1) T_t proves, or
/// convergence; or, as an upper end, that it has not even HC^(r-1), or that it diverges. Errors: throws Error where
/// neither is proved.
ClaimedEnds ends_of_scheme(const PolynomialData& kept, bool hermite, int arity, const JointSpectralRadius& radius);

/// The largest integer k from `least` on with radius < arity^(order - k), of which k is below; nothing where there is
/// none.
std::optional<long> proved_derivatives(const Rational& radius, long arity, long order, long least);

/// The head, and the coefficients from that of z^0 on.
std::string polynomial_text(const std::string& head, const LaurentPolynomial& p);

/// A line for each row, after the head.
std::string rows_text(const std::string& head, const RationalMatrix& matrix);

/// What tells the integral of a solution from the sums of its values: a line for each of a basis of the functionals l
/// with l (B - 1)^r = 0, B the mean matrix.
std::string functionals_text(const LatticeMask& mask);

/// What tells the exponent of the one function that was asked for; null where all are meant. Errors: throws Error where
/// there are several solutions, or no proof.
const ComponentProof* proof_of_component(const FunctionVector& vector);

/// How many of the blocks, the first ones, are of what the component does not show.
std::size_t unobservable_blocks(const ComponentProof& proof);

/// The line `product`.
std::string product_text(std::size_t block, const RationalComplex& eigenvalue, const std::vector<int>& word);

/// That and the lines of an inverse: large products are proved by one, which is checked by d^3 operations; eigenvalues
/// that are rational numbers by polynomials, exactly. Domain: `family` has the radius.
std::string product_text(const MatrixFamily& family, const JointSpectralRadius& radius);

/// What the line `product` proves at least.
Rational proved_lower(const ProductEvidence& product);

/// The same as a claim, if it is positive.
std::optional<std::string> claimed_lower(const ProductEvidence& product);

/// The upper end of an exponent of differences of this order, where the product proves a radius above 1, rounded up.
std::optional<std::string> upper_end_by(const ProductEvidence& product, int order, int arity);

/// The lines from `blocks` to `inverse`, if there are blocks.
std::string blocks_text(const JointSpectralRadius& radius);

/// On the line of the sum rules: there are no more of them.
inline const char* full_text(bool full) { return full ? " full" : ""; }

/// That the levels of the claim are those which follow from each other, and how their values come into its range.
/// `more`: lines that stand after those. Domain: the levels come there.
void add_recurrence(Certificate& certificate, char letter, const FollowedLevels& followed,
                    const std::string& more = "");

/// What is claimed and proved of the exponent of a mask: of that of the subject, of its reduced one, as `reduced` says,
/// or of that in the limit of the levels of the subject, where an upper end needs a product and there is no logarithm.
/// Domain: `regularity` is that of the mask, with norms of short words alone.
void add_exponent(Certificate& certificate, const Mask& mask, const HolderRegularity& regularity,
                  const std::optional<MaskRounding>& rounding = {}, const std::string& reduced = "",
                  bool in_limit = false);

/// With norms of words so short that checkers go through all of them: a mask tells the norms of longer ones at once.
HolderRegularity checkable(const Mask& mask, HolderRegularity regularity);

/// What says that the product attains the radius.
struct ExactRadius {
  std::string number = {}, root = {};  // empty where nothing says so; the letters of the product, of rounded families,
  std::string missing = {};            // and why
  std::vector<bool> blocks = {};       // those with products that attain the radius
  bool grows_like_powers = false;      // products of length n have norms between multiples of radius^n
  bool is_product = false;             // the number is given by letters
};

/// `first`: the first of the diagonal blocks whose radius is meant.
ExactRadius exact_radius(const JointSpectralRadius& radius, std::size_t first = 0);

/// The upper end of the radius that is proved; where letters of a graph are kept, by its product.
Rational upper_end(const JointSpectralRadius& radius, const ExactRadius& exact, std::size_t first = 0);

/// What the number is: `before` the logarithm of the radius, or the radius. Domain: the first section.
void claim_exact(Certificate& certificate, const ExactRadius& exact, const std::string& before = "");

/// The sections of a proof, block by block; for the blocks that are `exact` with what says that products attain the
/// radius. Errors: throws Error for what no checker reads.
void add_sections(Certificate& certificate, const RadiusProof& proof, std::size_t matrix_count,
                  const std::vector<bool>& exact = {});

}  // namespace subcert::certificate_text
