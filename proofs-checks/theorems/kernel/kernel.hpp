#pragma once
/// The Legendre kernel k_d, its transform khat and the product Phi in ball arithmetic, for the sources of this floor.
/// [LC] is docs/limit-constants.md.

#include <subcert/analysis/symbol/numbers/balls.hpp>

#include <cmath>
#include <vector>

namespace subcert::theorems {

/// P_{2q}(0) without its sign: binomial(2q, q) / 4^q.
inline Rational central(int q) {
  Rational result = 1;
  for (int i = 1; i <= q; ++i) result *= Rational(2 * i - 1, 2 * i);
  return result;
}

/// gamma = d |P_{d-1}(0)|. Domain: odd degree.
inline Rational gamma_of(int degree) { return degree * central((degree - 1) / 2); }

inline Rational absolute(const Rational& x) { return x < 0 ? Rational(-x) : x; }

inline double to_double(const Rational& x) { return x.convert_to<double>(); }

/// The transform of the kernel of odd degree d at one precision.
///   khat(s) = sum over q of (4q+1) |P_{2q}(0)| j_{2q}(s) = 1 - sum over i of series[i] s^(d+1+2i).
class Kernel {
 public:
  Kernel(int degree, slong bits) : degree_(degree % 2 == 0 ? degree + 1 : degree), bits_(bits) {
    for (int q = 0; q <= (degree_ - 1) / 2; ++q) bessel_.push_back((4 * q + 1) * central(q));
    for (const Rational& c : bessel_) bessel_balls_.emplace_back(c, bits);
    make_series();
    make_closed_form();
  }

  int degree() const { return degree_; }
  slong bits() const { return bits_; }

  /// T with |1 - khat(s)| <= 2 T |s|^(d+1) for complex |s|^2 <= d + 2. Ref: [LC, Lemma 2 (a)].
  const Rational& flatness() const { return exact_series_.front(); }

  /// A with |khat(s)| <= A / s for real s >= from. Ref: [LC, Lemma 2 (b)].
  Rational decay(const Rational& from) const {
    Rational sum = 0, factor = 1;
    for (const Rational& c : closed_form_) {
      sum += c * factor;
      factor /= from;
    }
    return sum;
  }

  /// 2 k_d(0), the square of a bound for the integral of |k_d| and so for |khat| on the real line. [LC, Lemma 2 (c)].
  Rational squared_bound() const {
    Rational sum = 0;
    for (std::size_t q = 0; q < bessel_.size(); ++q) sum += bessel_[q] * central(static_cast<int>(q));
    return sum;
  }

  template <class Number>
  Number transform(const Number& s) const {
    const double size = s.magnitude();
    return size <= series_radius() ? by_series(s, size) : by_recurrence(s);
  }

  /// Phi(s): factors until the proved tail bound falls below the precision. Ref: [LC, Lemma 3].
  template <class Number>
  Number product(const Number& s) const {
    Number result = one(s);
    double size = s.magnitude();
    if (!std::isfinite(size)) return Number::indeterminate(s.bits());
    Number scaled = s;
    for (;;) {
      // The sum over the factors to come of |1 - khat| is at most 2 T |s|^(d+1) / (2^(d+1) - 1).
      if (size * size <= 4 * (degree_ + 2) &&
          std::log2(size) * (degree_ + 1) + std::log2(to_double(flatness())) - degree_ < static_cast<double>(-bits_))
        break;
      scaled = scaled.scaled(-1);
      size /= 2;
      result *= transform(scaled);
      if (!result.is_finite()) return result;
    }
    const Ball tail = abs(scaled).pow(degree_ + 1) * Ball(2 * flatness(), bits_) /
                      (Ball(1, bits_).scaled(degree_ + 1) - 1);
    return result * (one(s).widened(tail.scaled(1)));
  }

 private:
  double series_radius() const { return degree_ + 2; }

  static Ball one(const Ball& like) { return Ball(1, like.bits()); }
  static ComplexBall one(const ComplexBall& like) { return ComplexBall(Ball(1, like.bits())); }

  /// d |P_{d-1}(0)| / (2^i i! (2d+2i+1)!! (d+1+2i)) for i = 0, 1, ...
  void make_series() {
    Rational head = degree_ * central((degree_ - 1) / 2);
    for (int odd = 3; odd <= 2 * degree_ + 1; odd += 2) head /= odd;
    for (int i = 0;; ++i) {
      if (i > 0) head /= Rational(2 * i) * (2 * degree_ + 2 * i + 1);
      exact_series_.push_back(head / (degree_ + 1 + 2 * i));
      series_.emplace_back(i % 2 == 0 ? exact_series_.back() : Rational(-exact_series_.back()), bits_);
      Integer top = numerator(exact_series_.back()), bottom = denominator(exact_series_.back());
      const double log = static_cast<double>(msb(top)) + 1 - static_cast<double>(msb(bottom));
      logs_.push_back(log);
      if (has_small_ratios(i, series_radius()) &&
          log + (degree_ + 1 + 2 * i) * std::log2(series_radius()) < static_cast<double>(-bits_))
        break;
    }
  }

  /// From index i on each term is at most half of the one before it, if |s| <= size.
  bool has_small_ratios(int i, double size) const {
    return 1.01 * size * size <= (i + 1.0) * (2.0 * degree_ + 2 * i + 3);
  }

  template <class Number>
  Number by_series(const Number& s, double size) const {
    std::size_t count = 0;
    while (count + 1 < series_.size() &&
           !(has_small_ratios(static_cast<int>(count), size) &&
             logs_[count] + (degree_ + 1 + 2.0 * static_cast<double>(count)) * std::log2(size) <
                 static_cast<double>(-bits_)))
      ++count;
    const Number square = s * s;
    Number sum(s.bits());
    for (std::size_t i = count; i-- > 0;) sum = sum * square + series_[i];
    Number power = square;
    for (int i = 1; i < (degree_ + 1) / 2; ++i) power *= square;
    // The terms left out are at most twice the first of them.
    const Ball first = Ball(exact_series_[count], bits_) * abs(s).pow(degree_ + 1 + 2 * static_cast<long>(count));
    return (one(s) - power * sum).widened(first.scaled(1));
  }

  /// Spherical Bessel functions by the recurrence j_{l+1} = (2l+1)/s j_l - j_{l-1}.
  template <class Number>
  Number by_recurrence(const Number& s) const {
    const Number inverse = one(s) / s;
    Number before = sin(s) * inverse;
    Number now = (before - cos(s)) * inverse;
    Number sum = before;
    for (int l = 1; l < degree_ - 1; ++l) {
      Number next = inverse * Ball(2 * l + 1, bits_) * now - before;
      before = now;
      now = next;
      if (l % 2 == 1) sum += now * bessel_balls_[static_cast<std::size_t>(l + 1) / 2];
    }
    return sum;
  }

  /// closed_form_[i]: the absolute coefficients of sin(s)/s^(i+1) and cos(s)/s^(i+1) in khat(s), added.
  void make_closed_form() {
    const auto size = static_cast<std::size_t>(degree_) + 1;
    using Coefficients = std::vector<Rational>;  // index 2i: sin(s)/s^(i+1), index 2i+1: cos(s)/s^(i+1)
    Coefficients before(2 * size, 0), now(2 * size, 0), sum(2 * size, 0);
    before[0] = 1;
    now[2] = 1;
    now[1] = -1;
    sum = before;
    for (int l = 1; l < degree_ - 1; ++l) {
      Coefficients next(2 * size, 0);
      for (std::size_t i = 0; i < 2 * size; ++i)
        next[i] = (i >= 2 ? (2 * l + 1) * now[i - 2] : Rational(0)) - before[i];
      before = now;
      now = next;
      if (l % 2 == 1)
        for (std::size_t i = 0; i < 2 * size; ++i) sum[i] += bessel_[static_cast<std::size_t>(l + 1) / 2] * now[i];
    }
    for (std::size_t i = 0; i < size; ++i) closed_form_.push_back(absolute(sum[2 * i]) + absolute(sum[2 * i + 1]));
  }

  int degree_;
  slong bits_;
  std::vector<Rational> bessel_;
  std::vector<Ball> bessel_balls_;
  std::vector<Rational> exact_series_;
  std::vector<Ball> series_;
  std::vector<double> logs_;  ///< upper bounds of log2 of exact_series_
  std::vector<Rational> closed_form_;
};

}  // namespace subcert::theorems
