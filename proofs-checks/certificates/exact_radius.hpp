#pragma once
/// The lines of a certificate that prove that a product attains the joint spectral radius. Inner header.

#include "group_words.hpp"

#include <subcert/analysis/regularity/polytope_proof/polytope_proof.hpp>
#include <subcert/analysis/regularity/quadratic/graph_proof.hpp>
#include <subcert/analysis/regularity/radius/single_radius.hpp>
#include <subcert/analysis/regularity/subradius/antinorm_proof.hpp>

#include <optional>
#include <string>

namespace subcert {

/// The words of the group of a polytope. With `negation` no letter stands for the flip, as none may beside a group.
GroupWords words_of(const PolytopeProof& polytope, bool negation);

/// A dyadic number within 2^-bits of the value, relatively.
Rational rounded(const Rational& value, int bits, Rounding rounding);

/// The lines from `cycle` on.
struct CycleLines {
  std::string text;
  bool negation = false;  ///< whether words are those of words_of(polytope, true)
};

/// The joint spectral radius of a family as |z|^(1/L), z a zero of a polynomial with integer coefficients.
struct ExactRadiusLines {
  std::string number;  ///< |[p0,p1,...]@RE,IM,EPS|^1/L
  std::string root;    ///< the line `root`
  CycleLines cycles;
  Rational low;  ///< a lower bound
};

/// Nothing where the polytope has no cycle, or where leading eigenvalues of cycles differ by more than their signs.
/// What it writes is for the checker to accept or not: the images that have to lie inside are not looked at. Domain:
/// `polytope` belongs to this family. Cost: at most three characteristic polynomials and their factorisations for each
/// cycle. Source: SPEC.md beside this, section 4.10.
std::optional<ExactRadiusLines> exact_radius_lines(const MatrixFamily& family, const PolytopeProof& polytope);

/// The same for the product of a graph. Source: SPEC.md, section 4.14.
std::optional<ExactRadiusLines> exact_radius_lines(const MatrixFamily& family, const AttainedGraph& graph);

/// The same for the largest real zero of a recurrence; without cycles. Source: SPEC.md, section 4.11.
std::optional<ExactRadiusLines> exact_radius_lines(const CoefficientGrowth& growth);

/// The same for a subradius that the product of the cycle attains. Source: SPEC.md, section 4.15.
std::optional<ExactRadiusLines> exact_subradius_lines(const MatrixFamily& family, const AntinormProof& proof);

}  // namespace subcert
