#pragma once
/// The lines of a certificate that prove that a product attains the joint spectral radius. Inner header.

#include <subcert/analysis/radii/joint/single_radius.hpp>
#include <subcert/analysis/radii/polytope_proof/polytope_proof.hpp>
#include <subcert/analysis/radii/quadratic/quadratic_proof.hpp>
#include <subcert/analysis/radii/subradius/antinorm_proof.hpp>
#include <subcert/analysis/symbol/matrices/matrix_family.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace subcert {

/// The elements of a group as words of a few of them, with the sign that the product lacks.
class GroupWords {
 public:
  /// `flip`: the group is the flip of PolytopeProof::is_flip_symmetric(), and its reversal is written as `f`.
  /// `negation`: whether one more generator, after the others, takes the negative of a vector. Errors: throws Error for
  /// maps that are no group.
  GroupWords(const std::vector<FamilySymmetry>& group, bool flip, bool negation = false);

  const std::vector<std::size_t>& generators() const { return generators_; }
  /// The word of the negation, empty where there is none.
  const std::string& negation() const { return negation_; }
  /// The element that undoes a generator.
  std::size_t inverse(std::size_t generator) const { return inverses_[generator]; }
  const std::string& word(std::size_t element) const { return words_[element]->first; }
  int sign(std::size_t element) const { return words_[element]->second; }

 private:
  void extend(const std::vector<RationalMatrix>& maps);

  std::vector<std::size_t> generators_, inverses_;
  std::string negation_;
  std::vector<std::optional<std::pair<std::string, int>>> words_;  // the word gives sign * element
};

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

/// The lines `inverse` and `column`.
std::string inverse_text(int bits, const std::vector<std::vector<Integer>>& columns);

/// The lines from `cycle` on. Source: SPEC.md beside this, sections 4.10 and 7.1.
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
