#pragma once
/// A limit function at any a-adic points, one at a time.

#include <subcert/analysis/symbol/masks/mask.hpp>

#include <vector>

namespace subcert::data {

/// phi^(order) at a point and at all its translates by integers, from the digits of the point: v(x) = (phi(x + k))_k
/// has v(x) = T_e v(a x - e) for 0 <= x < 1 with the first digit e, and v(0) is known. For derivatives the same with
/// the scheme of divided differences and their limit psi, phi^(order)(x) = sum over j of (-1)^j binomial(order, j)
/// psi(x - j), so that no factor grows with the digits.
class AdicLimit {
 public:
  /// Domain: the divided difference scheme of this order converges. Errors: as limit_values().
  AdicLimit(const Mask& mask, int order);

  /// The finest points: multiples of arity^-digits(). 2^53 of them, or nearly so, lie between two integers.
  int digits() const { return digits_; }
  /// arity^digits().
  long points() const { return points_; }

  /// values[i] = phi^(order)(index / points() + first() + i), exact in rational numbers. Domain: 0 <= index < points().
  /// Cost: a product of vector and matrix for each digit up to the last that is not 0.
  template <class Number>
  std::vector<Number> values(long index) const;
  long first() const { return first_; }

 private:
  template <class Number>
  struct Parts {
    std::vector<Number> coefficients;  // of the scheme of divided differences
    std::vector<Number> at_integers;   // of its limit
    std::vector<Number> differences;
  };
  template <class Number>
  const Parts<Number>& parts() const;

  int arity_;
  int digits_ = 0;
  long points_ = 1;
  long first_;        // of the translates
  long first_index_;  // of the coefficients
  Parts<Rational> exact_;
  Parts<double> rounded_;
};

}  // namespace subcert::data
