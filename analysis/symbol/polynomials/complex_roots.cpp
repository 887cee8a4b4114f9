#include "complex_roots.hpp"

#include "flint_polynomial.hpp"

#if __has_include(<flint/acb_poly.h>)
#include <flint/acb_poly.h>
#else
#include <acb_poly.h>
#endif

#include <algorithm>
#include <cstdlib>

namespace subcert {

ComplexBall value_at(const LaurentPolynomial& p, const ComplexBall& z) {
  ComplexBall result(z.bits());
  arb_fmpz_poly_evaluate_acb(result.get(), flint::IntegerPolynomial(p).get(), z.get(), z.bits());
  for (long k = 0; k < p.lowest(); ++k) result *= z;
  acb_div_fmpz(result.get(), result.get(), flint::Whole(p.denominator()).get(), z.bits());
  return result;
}

namespace {

/// p(2^exponent z) up to a power of z and a factor.
LaurentPolynomial stretched(const LaurentPolynomial& p, long exponent) {
  std::vector<Rational> coefficients;
  for (long k = p.lowest(); k <= p.highest(); ++k)
    coefficients.push_back(p.coefficient(k) * power(Rational(2), exponent * (k - p.lowest())));
  return {coefficients, 0};
}

/// The binary exponent of the size of zeros, or 0 where that is about 1: such zeros are found fast. Domain: some zero.
long size_of_zeros(const LaurentPolynomial& p) {
  constexpr long near_enough = 32;
  const long size = (binary_exponent(p.coefficient(p.lowest())) - binary_exponent(p.coefficient(p.highest()))) /
                    (p.length() - 1);
  return std::abs(size) > near_enough ? size : 0;
}

/// Simultaneous iteration with ever more bits. Ref: [Joh17].
class Isolation {
 public:
  explicit Isolation(const LaurentPolynomial& p)
      : polynomial_(p), count_(p.length() - 1), roots_(_acb_vec_init(count_)) {
    acb_poly_init(rounded_);
  }
  Isolation(const Isolation&) = delete;
  Isolation& operator=(const Isolation&) = delete;
  ~Isolation() {
    acb_poly_clear(rounded_);
    _acb_vec_clear(roots_, count_);
  }

  bool run(slong bits, const Deadline& deadline) {
    constexpr slong first = 32;
    constexpr double growth = 4;  // of the time, where the bits are twice as many
    double needed = 0;
    for (slong precision = first; needed < deadline.remaining(); precision *= 2) {
      const Stopwatch watch;
      acb_poly_set_fmpz_poly(rounded_, polynomial_.get(), precision);
      const slong found = acb_poly_find_roots(roots_, rounded_, precision == first ? nullptr : roots_,
                                              std::min(4 * count_ + 64, precision), precision);
      if (found == count_ && std::all_of(roots_, roots_ + count_, [bits](const acb_struct& root) {
            return acb_rel_accuracy_bits(&root) >= bits;
          }))
        return true;
      needed = growth * watch.seconds();
    }
    return false;
  }

  std::vector<ComplexBall> zeros(slong bits) const {
    std::vector<ComplexBall> result;
    for (slong i = 0; i < count_; ++i) result.emplace_back(roots_ + i, bits);
    return result;
  }

 private:
  flint::IntegerPolynomial polynomial_;
  slong count_;
  acb_ptr roots_;
  acb_poly_t rounded_;
};

std::vector<ComplexBall> scaled(std::vector<ComplexBall> zeros, long exponent) {
  for (ComplexBall& zero : zeros) zero = zero.scaled(exponent);
  return zeros;
}

}  // namespace

std::optional<std::vector<ComplexBall>> complex_roots(const LaurentPolynomial& p, slong bits,
                                                      const Deadline& deadline) {
  if (p.length() == 1) return std::vector<ComplexBall>{};
  const long size = size_of_zeros(p);
  Isolation isolation(stretched(p, size));
  if (!isolation.run(bits, deadline)) return std::nullopt;
  return scaled(isolation.zeros(bits), size);
}

std::vector<ComplexBall> complex_roots(const LaurentPolynomial& p, slong bits) {
  const slong count = p.length() - 1;
  if (count == 0) return {};
  if (const long size = size_of_zeros(p); size != 0) return scaled(complex_roots(stretched(p, size), bits), size);
  std::vector<ComplexBall> result;
  const flint::IntegerPolynomial polynomial(p);
  acb_ptr roots = _acb_vec_init(count);
  arb_fmpz_poly_complex_roots(roots, polynomial.get(), 0, bits);
  for (slong i = 0; i < count; ++i) result.emplace_back(roots + i, bits);
  _acb_vec_clear(roots, count);
  return result;
}

std::optional<std::vector<ComplexBall>> complex_roots(const std::vector<Ball>& coefficients) {
  const slong degree = static_cast<slong>(coefficients.size()) - 1, bits = coefficients.front().bits();
  acb_poly_t p;
  acb_poly_init(p);
  for (slong k = 0; k <= degree; ++k) {
    const ComplexBall entry(coefficients[static_cast<std::size_t>(k)]);
    acb_poly_set_coeff_acb(p, k, entry.get());
  }
  acb_ptr roots = _acb_vec_init(degree);
  const bool isolated = acb_poly_find_roots(roots, p, nullptr, 0, bits) == degree;
  std::optional<std::vector<ComplexBall>> result;
  if (isolated) {
    result.emplace();
    for (slong k = 0; k < degree; ++k) result->emplace_back(roots + k, bits);
  }
  _acb_vec_clear(roots, degree);
  acb_poly_clear(p);
  return result;
}

}  // namespace subcert
