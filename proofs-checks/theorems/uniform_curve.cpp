#include "uniform_curve.hpp"

#include "kept_by_scheme.hpp"
#include "patience.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>

#include <tuple>

namespace subcert::theorems {
namespace {

constexpr slong uniform_bits = 192;
constexpr int octaves = 13;  ///< of s; beyond 2^13 a geometric series

/// The largest multiple of 1/8 that is not above any point of the ball.
Rational rounded_down(const Ball& x) {
  const Rational eighths = *x.enclosure().lower * 8;
  Integer floor = numerator(eighths) / denominator(eighths);
  return Rational(floor, 8);
}

}  // namespace

UniformNumbers::UniformNumbers(Evaluation evaluation, int degree, const Rational& first_N)
    : slope(uniform_bits), any_decay(uniform_bits), far(uniform_bits), degree_(degree), N_(first_N, uniform_bits) {
  const UniformSymbol symbol(evaluation, degree, first_N, uniform_bits);
  const Rational M = evaluation == Evaluation::dual ? first_N : Rational(first_N - Rational(1, 2));
  difference_disc = symbol.disc_difference();
  slope_disc = symbol.disc_slope(degree + 1);
  alias_disc = symbol.disc_slope(alias_order(evaluation, degree));
  for (UniformSymbol::Disc* disc : {&difference_disc, &slope_disc, &alias_disc}) disc->bound = disc->bound.upper_end();
  slope = symbol.slope().upper_end();
  for (int j = 0; j < kept_factors; ++j)
    decays.push_back(
        symbol.decay(rounded_down(Ball(M, uniform_bits) * Ball::pi(uniform_bits).scaled(-j - 2))).upper_end());
  any_decay = symbol.decay(1).upper_end();
  for (int octave = 0; octave + 1 < octaves; ++octave)
    for (int part = 0; part < UniformSymbol::parts; ++part) cells_.push_back(symbol.cell(octave, part));
  far = symbol.cell(octaves - 1, 0).factor.upper_end();
  growth_ = symbol.growth(power(Rational(2), octaves - 1));
}

/// With N^2 |m(v/N) - khat(v)| <= H v^(d+1) where that holds, and the bound of both |m| and |khat|.
UniformSymbol::Cell UniformNumbers::cell(int octave, int part, const Ball& H) const {
  UniformSymbol::Cell result = cells_[static_cast<std::size_t>(octave * UniformSymbol::parts + part)];
  const Rational end = power(Rational(2), octave) * Rational(UniformSymbol::parts + part + 1, UniformSymbol::parts);
  if (end <= difference_disc.radius)
    result.difference = min(result.difference, H * Ball(end, uniform_bits).pow(degree_ + 1));
  result.factor = max(result.factor, result.transform + result.difference / N_.pow(2));
  return result;
}

/// Pi_0: the product of max(|m|, |khat|) over v, v/2, v/4, ... <= 1.
Ball UniformNumbers::near_product(const Ball& H) const {
  return exp(H / N_.pow(2) / (1 - Ball(1, uniform_bits).scaled(-degree_ - 1)));
}

/// A shell meets at most two octaves.
Ball UniformNumbers::products(const Ball& H) const {
  Ball result = near_product(H);
  for (int octave = 0; octave + 1 < octaves; ++octave) {
    Ball largest(1, uniform_bits);
    for (int part = 0; part < UniformSymbol::parts; ++part) largest = max(largest, cell(octave, part, H).factor);
    result = result * largest;
  }
  return result * result;
}

/// (2/pi) times the integral of M L plus (1/pi) times that of (s/pi)^2 M^2 over s >= pi N_1.
Ball UniformNumbers::mean(const Ball& H) const {
  const Ball pi = Ball::pi(uniform_bits), first = near_product(H);
  const Ball near = first * H / (Ball(1, uniform_bits).scaled(degree_ + 1) - 1);  // L <= near s^(d+1) for s <= 2
  Ball integral = first * near / (degree_ + 2), beyond(uniform_bits);
  std::vector<Ball> M, L;
  Ball last_product(uniform_bits), last_square(uniform_bits), last_far(uniform_bits);
  for (int octave = 0; octave < octaves; ++octave) {
    last_product = last_square = last_far = Ball(uniform_bits);
    for (int part = 0; part < UniformSymbol::parts; ++part) {
      const Rational width = power(Rational(2), octave) / UniformSymbol::parts;
      const Ball end(Rational(width * (UniformSymbol::parts + part + 1)), uniform_bits), step(width, uniform_bits);
      const auto i = static_cast<std::size_t>(part);
      if (octave == 0) {
        M.push_back(first);
        L.push_back(near * end.pow(degree_ + 1));
      } else {
        const UniformSymbol::Cell half = cell(octave - 1, part, H);
        L[i] = half.difference * M[i] + half.factor * L[i];
        M[i] = half.factor * M[i];
      }
      last_product += M[i] * L[i] * step;
      last_square += M[i].pow(2) * step;
      if (!end.is_less(pi * N_)) last_far += (M[i] * end / pi).pow(2) * step;
    }
    integral += last_product;
    beyond += last_far;
  }
  // Beyond: alpha(v) <= a for v >= 2^12, and v alpha(v) H(v)/v <= c.
  const Ball& a = far;
  const Ball v(power(Rational(2), octaves - 1), uniform_bits), ratio = (a * a).scaled(1);
  const Ball c = a * v * (growth_.first + growth_.zeroth / v);
  integral += ((c * last_square).scaled(1) / (1 - ratio) + ratio * last_product) / (1 - ratio);
  beyond += last_far * ratio.scaled(2) / (1 - ratio.scaled(2));
  return (integral.scaled(1) + beyond) / pi;
}

const UniformNumbers& uniform_numbers(Evaluation evaluation, int degree, const Rational& first_N) {
  static Kept<std::tuple<Evaluation, int, Rational>, UniformNumbers> known;
  return known({evaluation, degree, first_N}, [&] {
    next_step("degree " + std::to_string(degree) + " from N = " + to_decimal(first_N, 6, Rounding::nearest) + " on");
    return UniformNumbers(evaluation, degree, first_N);
  });
}

}  // namespace subcert::theorems
