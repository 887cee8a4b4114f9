#pragma once
/// The eigenvalues of rules with a letter, by frequency. Inner header.

#include "letter_polynomials.hpp"
#include "sector_block.hpp"

#include <map>
#include <optional>
#include <vector>

namespace subcert::vertex {

/// A zero of the characteristic polynomial of one block.
struct LetterZero {
  long frequency;
  std::size_t block;
  Ball value;
};

/// At one valence, for values of the letters of the weights in balls.
class LetterSpectrum {
 public:
  using Polynomial = std::vector<CosineField::Number>;  ///< in the letter, lowest coefficient first; no last one is 0

  /// Domain: symmetric rules with so many letters that reproduce constants, and their closed set. Errors: throws Error
  /// where 1 is no factor of the constants' polynomials. Cost: characteristic polynomials in two letters more.
  LetterSpectrum(const SectorRules& rules, const ClosedSet& set, std::size_t letters);

  /// The largest zero of a frequency, real and simple for each value of the letter, larger in modulus than the zeros of
  /// all other blocks; nothing where that is not proved. Of frequency 0 it may be negative.
  std::optional<LetterZero> leader(long frequency, const Letters& weights) const;
  /// The largest zero of a frequency among its own, whatever those of others are.
  std::optional<LetterZero> largest(long frequency, const Letters& weights) const;
  /// Whether all zeros but this one are below the radius in modulus.
  bool others_below(const LetterZero& zero, const Ball& radius, const Letters& weights) const;
  /// Whether a real zero of some block is proved to have a larger modulus than the radius.
  bool some_beyond(const LetterZero& but, const Ball& radius, const Letters& weights) const;

  /// Whether some eigenvalue but the 1 of the constants is proved to have a modulus above 1.
  bool some_above_one(const Letters& weights) const;

  /// The zeros of other blocks that may have a modulus of the radius or more, one of each, real and simple; nothing
  /// where that is not proved.
  std::optional<std::vector<LetterZero>> rivals(const LetterZero& zero, const Ball& radius,
                                                const Letters& weights) const;
  /// A polynomial in the letter that is zero where the zero, or its square, and the rival have the same modulus.
  /// Domain: one letter.
  Polynomial crossing(const LetterZero& zero, const LetterZero& rival, bool squared) const;
  /// Whether that is so for all values of the letters.
  bool coincide(const LetterZero& zero, const LetterZero& rival, bool squared) const;
  const CosineField& field() const { return field_; }

 private:
  struct Block {
    long frequency;
    LetterPolynomial polynomial;
  };
  Letters letters_at(long frequency, const Letters& weights) const;
  std::vector<Ball> values(const Block& block, const Letters& weights, bool mirrored) const;
  /// By products of powers of the letters; none with a coefficient 0.
  std::map<std::vector<long>, CosineField::Number> resultant(const LetterZero& zero, const LetterZero& rival,
                                                             bool squared) const;
  LetterRing ring_of(long frequency) const;

  long valence_;
  std::size_t letters_;
  CosineField field_;
  std::vector<Block> blocks_;
};

}  // namespace subcert::vertex
