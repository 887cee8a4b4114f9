#include "uniform_curve.hpp"

#include <map>
#include <mutex>
#include <utility>

namespace subcert::theorems {
namespace {

constexpr slong bits = 160;
constexpr int octaves = 13;  ///< of s; beyond 2^13 a geometric series

/// The largest multiple of 1/8 that is not above any point of the ball.
Rational rounded_down(const Ball& x) {
  const Rational eighths = *x.enclosure().lower * 8;
  Integer floor = numerator(eighths) / denominator(eighths);
  return Rational(floor, 8);
}

Ball decays_from(const UniformSymbol& symbol, const Ball& M, int j) {
  return symbol.decay(rounded_down(M * Ball::pi(bits).scaled(-j - 2)));
}

/// Suprema over cells of s, R <= s <= R 2^octaves, of M and L, and the integrals that the mean needs.
class MeanIntegrals {
 public:
  MeanIntegrals(const UniformSymbol& symbol, int degree, const Ball& N)
      : symbol_(symbol), degree_(degree), N_(N), near_(symbol.disc_difference()) {
    for (int octave = 0; octave + 1 < octaves; ++octave)
      for (int part = 0; part < UniformSymbol::parts; ++part) cells_.push_back(symbol.cell(octave, part));
  }

  /// Products of the suprema of max(1, factor) over the octaves, those below R included, squared: a shell meets two.
  Ball products() const {
    Ball result = near_product();
    for (int octave = 0; octave + 1 < octaves; ++octave) {
      Ball largest(1, bits);
      for (int part = 0; part < UniformSymbol::parts; ++part) largest = max(largest, cell(octave, part).factor);
      result = result * largest;
    }
    return result * result;
  }

  /// (2/pi) times the integral of M L plus (1/pi) times that of (s/pi)^2 M^2 over s >= pi N_1.
  Ball mean() const {
    const Ball pi = Ball::pi(bits), first = near_product();
    const Ball near = first * near_ / (Ball(1, bits).scaled(degree_ + 1) - 1);  // L <= near s^(d+1) for s <= 2R
    Ball integral = first * near / (degree_ + 2), far(bits);
    std::vector<Ball> M, L;
    Ball last_product(bits), last_square(bits), last_far(bits);
    for (int octave = 0; octave < octaves; ++octave) {
      last_product = last_square = last_far = Ball(bits);
      for (int part = 0; part < UniformSymbol::parts; ++part) {
        const Rational width = power(Rational(2), octave) / UniformSymbol::parts;
        const Ball end(Rational(width * (UniformSymbol::parts + part + 1)), bits), step(width, bits);
        const auto i = static_cast<std::size_t>(part);
        if (octave == 0) {
          M.push_back(first);
          L.push_back(near * end.pow(degree_ + 1));
        } else {
          const UniformSymbol::Cell& half = cell(octave - 1, part);
          L[i] = half.difference * M[i] + half.factor * L[i];
          M[i] = half.factor * M[i];
        }
        last_product += M[i] * L[i] * step;
        last_square += M[i].pow(2) * step;
        if (!end.is_less(pi * N_)) last_far += (M[i] * end / pi).pow(2) * step;
      }
      integral += last_product;
      far += last_far;
    }
    // Beyond: beta(v) <= a for v >= 2^12 R, and v beta(v) H(v)/v <= c.
    const Rational from = power(Rational(2), octaves - 1);
    const Ball a = symbol_.cell(octaves - 1, 0).factor, v(from, bits);
    const UniformSymbol::Growth growth = symbol_.growth(from);
    const Ball c = a * v * (growth.first + growth.zeroth / v), ratio = (a * a).scaled(1);
    integral += ((c * last_square).scaled(1) / (1 - ratio) + ratio * last_product) / (1 - ratio);
    far += last_far * ratio.scaled(2) / (1 - ratio.scaled(2));
    return (integral.scaled(1) + far) / pi;
  }

 private:
  const UniformSymbol::Cell& cell(int octave, int part) const {
    return cells_[static_cast<std::size_t>(octave * UniformSymbol::parts + part)];
  }
  /// The product of max(|m|, |khat|) over the octaves below R.
  Ball near_product() const { return exp(near_ / N_.pow(2) / (1 - Ball(1, bits).scaled(-degree_ - 1))); }

  const UniformSymbol& symbol_;
  int degree_;
  Ball N_, near_;
  std::vector<UniformSymbol::Cell> cells_;
};

UniformNumbers compute_numbers(int degree, int first_n) {
  const UniformSymbol symbol(degree, first_n, bits);
  const Ball M(2 * first_n - 1, bits), N(Rational(4 * first_n - 1, 2), bits);
  const MeanIntegrals integrals(symbol, degree, N);
  UniformNumbers result{symbol.disc_difference().upper_end(), symbol.disc_slope().upper_end(),
                        symbol.slope().upper_end(),           {},
                        integrals.products().upper_end(),     integrals.mean().upper_end()};
  for (int j = 0; j < kept_factors; ++j) result.decays.push_back(decays_from(symbol, M, j).upper_end());
  return result;
}

}  // namespace

const UniformNumbers& uniform_numbers(int degree, int first_n) {
  static std::mutex mutex;
  static std::map<std::pair<int, int>, UniformNumbers> known;
  const std::lock_guard lock(mutex);
  const std::pair key(degree, first_n);
  const auto found = known.find(key);
  return found != known.end() ? found->second : known.emplace(key, compute_numbers(degree, first_n)).first->second;
}

}  // namespace subcert::theorems
