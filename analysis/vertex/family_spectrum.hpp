#pragma once
/// The eigenvalues of a scheme at the vertices of all valences at once. Inner header.

#include "letter_polynomials.hpp"
#include "sector_block.hpp"

#include <optional>
#include <vector>

namespace subcert::vertex {

/// An eigenvalue on an interval of 1/n.
struct FamilyLeader {
  Ball value;
  /// Where it tends to 1 for n -> infinity, which is in the interval: (1 - value) / (2 - 2c).
  std::optional<Ball> decay;
};

class FamilySpectrum {
 public:
  /// Domain: symmetric rules that reproduce constants, from `least` sectors on; their closed set. Errors: throws Error
  /// where 1 is no simple eigenvalue of the constants. Cost: characteristic polynomials in three letters.
  FamilySpectrum(const SectorRuleFamily& family, const ClosedSet& set);

  /// An eigenvalue of frequency 1, for each 1/n > 0 in the interval: real, positive, below 1, simple, and larger than
  /// the modulus of all others but 1. Nothing where that is not proved. Domain: the intervals are asked for in order,
  /// from 0 on, each beginning where the last one ended; one that gave nothing may be asked for again in parts.
  std::optional<FamilyLeader> leader_on(const Rational& low, const Rational& high, slong bits);

 private:
  /// What is known of the leader on one interval.
  struct Leader {
    std::size_t block;
    Ball value, slope;  // by 1/n
    std::optional<Ball> decay;
  };
  /// A polynomial of a frequency that rules name, 0 among them, without w. It may meet the leader for n -> infinity.
  struct Named {
    LetterPolynomial polynomial;
    bool meets = true;  // while on all intervals from 0 on the leader grew away from its largest zero
  };

  static std::vector<LetterPolynomial> polynomials(const SectorRuleFamily& family, const ClosedSet& set, long frequency,
                                                   long general);
  std::optional<Leader> find_leader(const Letters& at, const Letters& middle) const;
  bool is_behind(const LetterPolynomial& p, const Leader& leader, const Letters& at, const Letters& middle,
                 bool from_zero) const;
  bool general_is_behind(const LetterPolynomial& p, const Leader& leader, const Letters& at,
                         const Letters& middle) const;

  std::vector<LetterPolynomial> first_;
  std::vector<Named> named_;
  std::vector<LetterPolynomial> general_;
};

}  // namespace subcert::vertex
