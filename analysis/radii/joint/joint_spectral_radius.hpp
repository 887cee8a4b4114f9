#pragma once
/// Joint spectral radii, enclosed with proof.

#include <subcert/analysis/radii/frequency/frequency_proof.hpp>
#include <subcert/analysis/radii/polytope_proof/polytope_proof.hpp>
#include <subcert/analysis/radii/quadratic/quadratic_proof.hpp>
#include "block_triangular.hpp"
#include "norm_of_products.hpp"
#include "product.hpp"
#include "single_radius.hpp"

#include <variant>

namespace subcert {

struct JointSpectralRadius;

/// The radius is the largest of those of the diagonal blocks.
struct BlockProof {
  BlockTriangular triangular;
  std::vector<JointSpectralRadius> blocks;
  std::size_t leading = 0;  ///< the block from which the product is formed: the one with the largest lower end

  /// Raises the lower ends of blocks whose products of this word have larger radii than those found. Cost: a
  /// characteristic polynomial for each block.
  void try_product(const std::vector<int>& word, const Deadline& deadline);
};

/// The radius is the spectral radius of one matrix: of the transition matrices of this symbol.
struct SingleRadiusProof {
  LaurentPolynomial symbol;
  CoefficientGrowth growth;
};

/// How the upper end is proved.
using RadiusProof =
    std::variant<NormProof, PolytopeProof, QuadraticProof, GraphProof, BlockProof, SingleRadiusProof, FrequencyProof>;

enum class JsrMethod { invariant_polytope, quadratic_form, norm_of_products, single_spectral_radius, frequencies };

/// `invariant polytope`, and so on.
std::string to_text(JsrMethod method);

/// The largest norm of a product of n matrices lies between positive multiples of n^at_least radius^n and n^at_most
/// radius^n; an absent end is not known.
struct GrowthPower {
  int at_least = 0;
  std::optional<int> at_most;
};

struct JointSpectralRadius {
  Enclosure radius;  ///< its upper end may be lower than what `proof` gives, where `exact` says so
  ProductEvidence product;
  /// Whether `product` attains the radius exactly, proved or unknown.
  Decision exact;
  GrowthPower growth;
  RadiusProof proof;

  /// The ends of `radius` are within 1e-12 of each other, relatively: in practice the search closed with `product` as
  /// spectrum maximizing product.
  bool is_closed() const;
  /// The upper bound that `proof` gives.
  Rational proved_upper() const;
  /// Of the leading block, where there are several.
  JsrMethod method() const;
  /// Of all polytopes.
  std::size_t vertices() const;
  /// Products of the trees of all quadratic forms.
  std::size_t words() const;
  /// The proof by diagonal blocks, or null.
  const BlockProof* by_blocks() const { return std::get_if<BlockProof>(&proof); }
};

/// The largest families that are looked at. Together 64 matrices of the largest size have so many entries.
struct FamilyLimits {
  static constexpr std::size_t matrices = 4096, size = 256, entries = std::size_t{1} << 22;
  /// Whether so many matrices of a size are within them.
  static constexpr bool hold(std::size_t count, std::size_t size_of_one) {
    return count >= 1 && count <= matrices && size_of_one >= 1 && size_of_one <= size &&
           count * size_of_one * size_of_one <= entries;
  }
};

/// Encloses the joint spectral radius, block by block where the family is reducible over the rationals. Domain: a
/// family within FamilyLimits, numbers of any size. `known`: an upper bound that is known beforehand; `target`: one
/// that is low enough, where the work ends. Errors: throws Error. Error: none, both ends are proved in exact
/// arithmetic; where the search for an invariant polytope ends within the budget the width is about 1e-15, otherwise as
/// narrow as the budget allowed, and without a target not wider than with a third of it (rounds.hpp). Cost: one linear
/// program per vertex and matrix. Ref: [GP13, Alg. 1], [Mej20].
JointSpectralRadius joint_spectral_radius(const MatrixFamily& family, const Budget& budget,
                                          const std::optional<NormProof>& known = std::nullopt,
                                          const std::optional<Rational>& target = std::nullopt);

/// A product whose averaged spectral radius is at least that, with proof; where none is found in time, the best that
/// was. Domain: as above. Cost: searches among more and more products.
ProductEvidence find_product_above(const MatrixFamily& family, const Rational& least, const Budget& budget);

/// Of radii that a product attains, and of exponents from them.
constexpr int default_bits = 160;
/// With which they are at most so wide, radii up to 2^32, and not wider than by default. Domain: 10^-1000 <= width
/// <= 1. Errors: throws Error.
int bits_for_width(const Rational& width);

/// Narrows the enclosure of a radius that a product attains to a relative width below 2^-bits. Domain: `radius` is of
/// this family; bits >= 1. Leaves it as it is where that is not proved (`exact`), or where the deadline comes first.
/// Cost: one characteristic polynomial and the balls of its zeros.
void sharpen(JointSpectralRadius& radius, const MatrixFamily& family, int bits, const Deadline& deadline);

}  // namespace subcert
