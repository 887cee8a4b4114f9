#include "turning.hpp"

#include "../circle.hpp"

#include <algorithm>
#include <limits>

namespace subcert_check {
namespace {

mpz_class floor_shift(const mpz_class& x, std::size_t by) {
  mpz_class result;
  mpz_fdiv_q_2exp(result.get_mpz_t(), x.get_mpz_t(), by);
  return result;
}

mpz_class floor_quotient(const mpz_class& x, const mpz_class& y) {
  mpz_class result;
  mpz_fdiv_q(result.get_mpz_t(), x.get_mpz_t(), y.get_mpz_t());
  return result;
}

}  // namespace

Interval operator+(const Interval& a, const Interval& b) { return {a.low + b.low, a.high + b.high}; }
Interval operator-(const Interval& a, const Interval& b) { return {a.low - b.high, a.high - b.low}; }
Interval operator-(const Interval& a) { return {-a.high, -a.low}; }
mpz_class largest(const Interval& a) { return std::max(mpz_class(-a.low), a.high); }

Interval Intervals::number(const mpq_class& x) const {
  const mpz_class top = x.get_num() << bits_;
  return {floor_quotient(top, x.get_den()), -floor_quotient(-top, x.get_den())};
}

Interval Intervals::times(const Interval& a, const Interval& b) const {
  mpz_class products[4];
  arithmetic_.add_product(products[0], a.low, b.low);
  arithmetic_.add_product(products[1], a.low, b.high);
  arithmetic_.add_product(products[2], a.high, b.low);
  arithmetic_.add_product(products[3], a.high, b.high);
  const auto [low, high] = std::minmax_element(products, products + 4);
  return {floor_shift(*low, bits_), -floor_shift(-*high, bits_)};
}

Interval Intervals::over(const Interval& a, const Interval& b) const {
  const mpz_class low = a.low << bits_, high = -a.high << bits_;
  arithmetic_.spend(4 * (40 + bits_ / 64 * bits_ / 64));
  return {std::min(floor_quotient(low, b.low), floor_quotient(low, b.high)),
          -std::min(floor_quotient(high, b.low), floor_quotient(high, b.high))};
}

Interval Intervals::cosine(std::size_t k, std::size_t n) const {
  if (k == 0) return {one(), one()};
  if (2 * k == n) return {-one(), -one()};
  return cosine(ratio(k, n));
}

Interval Intervals::cosine(const mpq_class& x) const {
  const mpz_class near = Circle(bits_).powers(2 * x, 2, arithmetic_)[1].re, off = mpz_class(1) << 19;
  return {near - off, near + off};
}

Turning operator+(const Turning& x, const Turning& y) { return {x.a + y.a, x.b + y.b}; }
Turning operator-(const Turning& x, const Turning& y) { return {x.a - y.a, x.b - y.b}; }
mpz_class largest(const Turning& x) { return largest(x.a) + largest(x.b); }

Frequency::Frequency(std::size_t k, std::size_t n, const Intervals& intervals)
    : k_(static_cast<long>(k)), n_(static_cast<long>(n)), intervals_(intervals) {
  const Interval cosine = intervals.cosine(k, n);
  twice_cosine_ = cosine + cosine;
}

Frequency::Frequency(const Interval& cosine, const Intervals& intervals)
    : k_(1), n_(std::numeric_limits<long>::max()), intervals_(intervals), twice_cosine_(cosine + cosine) {}

Turning Frequency::times(const Turning& x, const Turning& y) const {
  const Interval bb = intervals_.times(x.b, y.b);
  return {intervals_.times(x.a, y.a) - bb,
          intervals_.times(x.a, y.b) + intervals_.times(x.b, y.a) + intervals_.times(twice_cosine_, bb)};
}

Interval Frequency::inner(const Turning& x, const Turning& y) const {
  const Interval parts = intervals_.times(x.a, y.a) + intervals_.times(x.b, y.b);
  return parts + parts + intervals_.times(twice_cosine_, intervals_.times(x.a, y.b) + intervals_.times(x.b, y.a));
}

Turning Frequency::scaled(const Interval& factor, const Turning& x) const {
  return {intervals_.times(factor, x.a), intervals_.times(factor, x.b)};
}

Turning Frequency::inverse(const Turning& x) const {
  // The conjugate of a + b w is a + 2 cos b - b w.
  const Turning conjugate{x.a + intervals_.times(twice_cosine_, x.b), -x.b};
  const Interval square = times(x, conjugate).a;
  require(square.low > 0, "a number that is divided by may be 0");
  return {intervals_.over(conjugate.a, square), intervals_.over(conjugate.b, square)};
}

Turning Frequency::turned(Turning x, long turns) const {
  if (k_ == 0) return x;
  if (2 * k_ == n_) return turns % 2 == 0 ? x : Turning{-x.a, -x.b};
  if (2 * turns > n_) turns -= n_;
  for (; turns > 0; --turns) x = {-x.b, x.a + intervals_.times(twice_cosine_, x.b)};
  for (; turns < 0; ++turns) x = {x.b + intervals_.times(twice_cosine_, x.a), -x.a};
  return x;
}

Turning Frequency::turned_near_one(Turning x, long turns, const Interval& delta) const {
  const Interval one{intervals_.one(), intervals_.one()};
  for (; turns > 0; --turns) {
    x.a = x.a - x.b;
    x.b = x.b + one + intervals_.times(delta, x.a);
  }
  for (; turns < 0; ++turns) {
    x.b = x.b - one - intervals_.times(delta, x.a);
    x.a = x.a + x.b;
  }
  return x;
}

mpz_class row_norm(const TurningMatrix& matrix) {
  mpz_class norm = 0;
  for (const std::vector<Turning>& row : matrix) {
    mpz_class sum = 0;
    for (const Turning& x : row) sum += largest(x);
    norm = std::max(norm, sum);
  }
  return norm;
}

TurningMatrix product(const TurningMatrix& x, const TurningMatrix& y, const Frequency& frequency) {
  TurningMatrix result(x.size(), std::vector<Turning>(y.front().size()));
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t k = 0; k < y.size(); ++k)
      for (std::size_t j = 0; j < y[k].size(); ++j) result[i][j] = result[i][j] + frequency.times(x[i][k], y[k][j]);
  return result;
}

}  // namespace subcert_check
