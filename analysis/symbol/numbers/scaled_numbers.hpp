#pragma once
/// Fractions as integers over one denominator, so that sums of their products are reduced once. Inner header.

#include "numbers.hpp"

#include <vector>

namespace subcert {

/// Numbers times their least common denominator.
struct ScaledNumbers {
  std::vector<Integer> numerators;
  Integer denominator = 1;

  explicit ScaledNumbers(const std::vector<Rational>& numbers) {
    for (const Rational& x : numbers)
      if (!mpz_divisible_p(denominator.get(), mpq_denref(x.get())))
        denominator = lcm(denominator, subcert::denominator(x));
    for (const Rational& x : numbers) {
      Integer& numerator = numerators.emplace_back(denominator);
      mpz_divexact(numerator.get(), numerator.get(), mpq_denref(x.get()));
      mpz_mul(numerator.get(), numerator.get(), mpq_numref(x.get()));
    }
  }
};

}  // namespace subcert
