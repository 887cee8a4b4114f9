#pragma once
/// The elements of a group in the words of certificates. Inner header.

#include <subcert/analysis/symbol/matrix_family.hpp>

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

}  // namespace subcert
