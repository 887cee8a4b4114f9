#pragma once
/// The lines of a certificate that prove that a product attains the joint spectral radius. Inner header.

#include "group_words.hpp"

#include <subcert/analysis/radii/joint/single_radius.hpp>
#include <subcert/analysis/radii/polytope_proof/polytope_proof.hpp>
#include <subcert/analysis/radii/quadratic/graph_proof.hpp>
#include <subcert/analysis/radii/subradius/antinorm_proof.hpp>

#include <optional>
#include <string>

namespace subcert {

/// The words of the group of a polytope. `exact`: of its cycles, too, which may need the negation; then no letter
/// stands for the flip, as none may beside a group. Domain: exact = false, or the polytope has cycles.
GroupWords words_of(const PolytopeProof& polytope, bool exact);

/// A dyadic number within 2^-bits of the value, relatively.
Rational rounded(const Rational& value, int bits, Rounding rounding);

/// The number |z|^(1/L) in the words of a claim and of a certificate.
struct NumberLines {
  std::string number;  ///< |[p0,p1,...]@RE,IM,EPS|^1/L
  std::string root;    ///< the line `root`
  Rational low;        ///< a lower bound
};

/// Nothing where a hundred decimals do not tell the zero from others. Cost: Newton's method for the zero.
std::optional<NumberLines> number_lines(const AttainedNumber& number);

/// The lines from `cycle` on. Source: SPEC.md beside this, section 4.10.
std::string cycle_text(const AttainedProof& proof, const GroupWords& words);
/// The same of a graph, section 4.14.
std::string cycle_text(const AttainedGraph& graph);

/// The largest real zero of a recurrence: section 4.11.
std::optional<AttainedNumber> number_of(const CoefficientGrowth& growth);

/// That the product of the cycle attains a subradius: section 4.15.
struct SubradiusLines {
  NumberLines number;
  std::string cycles;
};
std::optional<SubradiusLines> exact_subradius_lines(const MatrixFamily& family, const AntinormProof& proof);

}  // namespace subcert
