#pragma once
// Random exact inputs for tests, biased to corners. SUBCERT_TEST_EFFORT scales the number of rounds, SUBCERT_TEST_SEED
// changes the inputs; both default to 1. A failure names the round and the seed.

#include <subcert/analysis/symbol/polynomials/laurent_polynomial.hpp>
#include <subcert/cmake/catch.hpp>

#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace subcert::testing {

inline unsigned long from_environment(const char* name) {
  const char* text = std::getenv(name);
  return text ? std::strtoul(text, nullptr, 10) : 1;
}

/// The number of a round. While it lives, failures name it.
class Round {
 public:
  explicit Round(int number)
      : number_(number),
        message_(Catch::MessageBuilder("INFO", CATCH_INTERNAL_LINEINFO, Catch::ResultWas::Info)
                 << "round " << number << " with SUBCERT_TEST_SEED=" << from_environment("SUBCERT_TEST_SEED")) {}
  operator int() const { return number_; }  // NOLINT: it is its number

 private:
  int number_;
  Catch::ScopedMessage message_;
};

/// `for (const auto round : rounds(20))`: 0, ..., 19, more with SUBCERT_TEST_EFFORT.
class Rounds {
 public:
  struct Iterator {
    int number;
    Round operator*() const { return Round(number); }
    void operator++() { ++number; }
    bool operator!=(const Iterator& other) const { return number != other.number; }
  };
  explicit Rounds(int count) : count_(count) {}
  static Iterator begin() { return {0}; }
  Iterator end() const { return {count_}; }

 private:
  int count_;
};

inline Rounds rounds(int base) { return Rounds(base * static_cast<int>(from_environment("SUBCERT_TEST_EFFORT"))); }

class Random {
 public:
  Random() : engine_(from_environment("SUBCERT_TEST_SEED")) {}

  long integer(long low, long high) { return std::uniform_int_distribution<long>(low, high)(engine_); }
  bool chance(int percent) { return integer(1, 100) <= percent; }

  Rational rational() {
    if (chance(15)) return 0;
    if (chance(15)) return chance(50) ? 1 : -1;
    if (chance(10)) return power(Rational(integer(2, 9), integer(10, 19)), integer(-60, 60));
    return Rational(integer(-30, 30), integer(1, 12));
  }
  Rational nonzero() {
    for (;;)
      if (const Rational value = rational(); value != 0) return value;
  }

  LaurentPolynomial polynomial(long most = 8) {
    if (chance(8)) return {};
    std::vector<Rational> coefficients;
    const long count = chance(15) ? 1 : integer(1, most);
    for (long i = 0; i < count; ++i) coefficients.push_back(rational());
    return LaurentPolynomial(coefficients, integer(-6, 6));
  }
  LaurentPolynomial nonzero_polynomial(long most = 8) {
    for (;;)
      if (LaurentPolynomial p = polynomial(most); !p.is_zero()) return p;
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace subcert::testing
