#include "circle.hpp"

namespace subcert_check {
namespace {

/// pi W, up to 2 [Machin 1706].
mpz_class four_arctangents(std::size_t bits) {
  const auto arctangent = [&](unsigned n) {
    mpz_class sum = 0, power = (mpz_class(1) << (bits + 32)) / n;
    for (unsigned k = 1; power != 0; k += 2, power /= n * n) {
      if (k % 4 == 1)
        sum += power / k;
      else
        sum -= power / k;
    }
    return sum;
  };
  return (16 * arctangent(5) - 4 * arctangent(239)) >> 32;
}

}  // namespace

Circle::Circle(std::size_t bits) : one_(mpz_class(1) << bits), pi_(four_arctangents(bits)) {}

mpz_class Circle::half_angle(const mpq_class& x) const { return pi_ * x.get_num() / (2 * x.get_den()); }

/// Near exp(i pi y), within the circle: not further away than 2^18.
CirclePoint Circle::at(const mpq_class& y) const {
  const bool negative = y >= 1;
  const mpq_class rest = negative ? mpq_class(y - 1) : y;
  const mpz_class x = pi_ * rest.get_num() / rest.get_den();
  CirclePoint sum{one_, 0};
  mpz_class term = one_;
  for (unsigned k = 1; term != 0; ++k) {
    term = term * x / (one_ * k);
    mpz_class& part = k % 2 == 0 ? sum.re : sum.im;
    if (k % 4 < 2)
      part += term;
    else
      part -= term;
  }
  const mpz_class shrink = (one_ - (1 << 16)) * (negative ? -1 : 1);
  return {sum.re * shrink / one_, sum.im * shrink / one_};
}

std::vector<CirclePoint> Circle::powers(const mpq_class& y, std::size_t count, Arithmetic& arithmetic) const {
  const CirclePoint z = at(y);
  const std::size_t words = bits(one_) / 64 + 2;
  arithmetic.spend(4 * count * (40 + words * words));
  std::vector<CirclePoint> result{{one_, 0}};
  for (std::size_t k = 1; k < count; ++k) {
    const CirclePoint last = result.back();
    result.push_back({(last.re * z.re - last.im * z.im) / one_, (last.re * z.im + last.im * z.re) / one_});
  }
  return result;
}

CirclePoint combined(std::span<const mpz_class> factors, const std::vector<CirclePoint>& points,
                     Arithmetic& arithmetic) {
  CirclePoint sum;
  for (std::size_t k = 0; k < points.size(); ++k) {
    arithmetic.add_product(sum.re, factors[k], points[k].re);
    arithmetic.add_product(sum.im, factors[k], points[k].im);
  }
  return sum;
}

}  // namespace subcert_check
