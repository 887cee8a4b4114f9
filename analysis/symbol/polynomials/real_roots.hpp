#pragma once
/// Exact questions about the zeros of a Laurent polynomial on the real line and on the unit circle.

#include <subcert/analysis/symbol/support/budget.hpp>
#include "laurent_polynomial.hpp"

namespace subcert {

/// The number of distinct real zeros. Domain: p not zero. Cost: one Sturm sequence. Ref: [BPR06].
int count_real_roots(const LaurentPolynomial& p);

/// The number of distinct zeros x with low < x < high. Domain: p not zero, no negative exponents, low < high. Decided
/// by the sign variations of Bernstein coefficients, on halves of the interval where they leave it open. Cost: a few
/// Taylor shifts for each half that is looked at, and a gcd where the first look leaves it open. Ref: [BPR06, ch. 10].
int count_real_roots(const LaurentPolynomial& p, const Rational& low, const Rational& high);
/// The same, or nothing past the deadline.
std::optional<int> count_real_roots(const LaurentPolynomial& p, const Rational& low, const Rational& high,
                                    const Deadline& deadline);

/// Whether p is not zero and has no zero x with low <= x <= high. Domain: no negative exponents, low < high. Cost: as
/// count_real_roots.
bool has_no_real_root(const LaurentPolynomial& p, const Rational& low, const Rational& high);
/// Whether that is proved before the deadline.
bool has_no_real_root(const LaurentPolynomial& p, const Rational& low, const Rational& high, const Deadline& deadline);
/// Whether p is not zero and has no zero x >= low. Domain: no negative exponents, low > 0. Cost: the same.
bool has_no_real_root_from(const LaurentPolynomial& p, const Rational& low);

/// The zero of a polynomial of degree 1; nothing for another degree. Domain: lowest exponent 0 or more.
std::optional<Rational> zero_of_linear(const LaurentPolynomial& p);

/// Canonical: irreducible over the rationals, with integer coefficients and lowest exponent 0, or z itself.
struct PolynomialFactor {
  LaurentPolynomial polynomial;
  int multiplicity;
};

/// The irreducible factors, without constants and powers of 1/z. Domain: p not zero. Cost: polynomial, by lattices.
std::vector<PolynomialFactor> irreducible_factors(const LaurentPolynomial& p);

/// The zeros in (low, high), in order, each enclosed with at most this width; rational ones are one number. Those of
/// one irreducible factor have disjoint enclosures. Domain: p not zero, lowest exponent 0 or more, low < high, width >
/// 0. Cost: a factorisation and the balls of the zeros. Ref: [Joh17].
std::vector<Enclosure> real_roots(const LaurentPolynomial& p, const Rational& low, const Rational& high,
                                  const Rational& width);

/// The largest real zero, enclosed, with its multiplicity. Canonical: `value` is one number exactly where the zero is
/// rational, and only there.
struct RealRoot {
  Enclosure value;
  int multiplicity;
};

/// Nothing where p has no real zero. Domain: p not zero. Error: relative width below 2^-bits, or none for a rational
/// zero. Cost: one squarefree factorisation and the balls of the zeros of its factors.
std::optional<RealRoot> largest_real_root(const LaurentPolynomial& p, int bits = 64);

/// Whether p has a zero of modulus 1. Domain: p not zero. Decided exactly: such zeros are zeros of the gcd of p with
/// its reversal, which is a polynomial in x = z + 1/z whose zeros in (-2, 2) Sturm's theorem counts.
bool has_root_on_unit_circle(const LaurentPolynomial& p);

/// Whether p(e^{i t}) >= 0 for all real t. Domain: p is its own reversal, so that the values are real. Errors: throws
/// Error otherwise. Decided exactly: p changes sign only at zeros of odd multiplicity in x = z + 1/z.
bool is_nonnegative_on_unit_circle(const LaurentPolynomial& p);

/// The cyclotomic polynomial of this order. Domain: 1 <= order <= 10^6.
LaurentPolynomial cyclotomic(long order);

/// Euler's totient, the degree of cyclotomic(order). Domain: order >= 1.
long totient(long order);

}  // namespace subcert
