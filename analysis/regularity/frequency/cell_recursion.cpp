
#include "cell_recursion.hpp"

#include <subcert/analysis/radii/frequency/positive_fixed_point.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

namespace subcert::frequency {
namespace {

/// The cell of shell 0 that holds xi/2 + pi, modulo 2 pi, for xi in the cell (j, i).
std::size_t image(std::size_t j, std::size_t i, std::size_t cells) {
  // floor of cells - (cells + i + 1)/2^(j+1)
  const std::size_t unit = std::size_t{1} << (j + 1);
  return cells - (cells + i + unit) / unit;
}

}  // namespace

CellBounds bounds_on_cells(const HalfSymbol& symbol, std::size_t cells) {
  const Ball pi = Ball::pi(cell_bits);
  // So many shells that the sum of 2^j b over the shells beyond is about 2^-14.
  const double least = std::log2(static_cast<double>(cells)) + 1;  // so that the shells beyond refer to the last cell
  const double count = std::max(least, std::log2(symbol.flatness().middle()) + 18);
  CellBounds result{static_cast<std::size_t>(count), cells, {}, {}, Ball(cell_bits)};
  for (std::size_t j = 0; j < result.count; ++j) {
    const Ball low = pi.scaled(-static_cast<slong>(j) - 2), high = low.scaled(1);
    std::vector<Ball> x, e;
    for (const HalfSymbol::Suprema& one : symbol.suprema(low, high, static_cast<int>(cells))) {
      x.push_back(one.plain);
      e.push_back(one.alias);
    }
    result.x.push_back(std::move(x));
    result.e.push_back(std::move(e));
  }
  result.beyond = symbol.flatness() * pi * pi.scaled(-2 * static_cast<slong>(result.count)) / 3;
  return result;
}

Cells products(const CellBounds& shells, bool squared) {
  Cells result(shells.count + 1, std::vector<Ball>(shells.cells, exp(shells.beyond.scaled(squared ? 1 : 0))));
  for (std::size_t j = shells.count; j-- > 0;)
    for (std::size_t i = 0; i < shells.cells; ++i) {
      const Ball& x = shells.x[j][i];
      result[j][i] = (squared ? x * x : x) * result[j + 1][i];
    }
  return result;
}

Recursion::Recursion(const CellBounds& shells, const Terms& terms)
    : shells_(shells), terms_(terms), x_(shells.x), e_(shells.e) {
  const auto cells = static_cast<long>(shells.cells);
  for (std::size_t j = 0; j < shells.count; ++j)
    for (std::size_t i = 0; i < shells.cells; ++i) {
      Ball &x = x_[j][i], &e = e_[j][i];
      if (terms.squared) {
        x = x * x;
        e = e * e;
      }
      if (!terms.frequencies) continue;
      // 2^(j+1) times the ratio of the ends of the cells.
      const Rational ratio(cells + static_cast<long>(image(j, i, shells.cells)) + 1, cells + static_cast<long>(i) + 1);
      e = (e * Ball(ratio, cell_bits)).scaled(static_cast<slong>(j) + 1);
    }
}

Cells Recursion::operator()(const std::vector<Ball>& w) const {
  Cells result(shells_.count + 1, std::vector<Ball>(shells_.cells, beyond() * w.back()));
  for (std::size_t j = shells_.count; j-- > 0;)
    for (std::size_t i = 0; i < shells_.cells; ++i)
      result[j][i] = e_[j][i] * w[image(j, i, shells_.cells)] + x_[j][i] * result[j + 1][i];
  return result;
}

Ball Recursion::beyond() const {
  const Ball& b = shells_.beyond;
  if (terms_.squared) return b * b * exp(b.scaled(1));
  if (!terms_.frequencies) return b * exp(b);
  return (b * exp(b)).scaled(static_cast<slong>(shells_.count) + 3);
}

polytope::Matrix Recursion::matrix() const {
  polytope::Matrix result(shells_.cells, shells_.cells);
  const double last = beyond().middle();
  for (std::size_t i = 0; i < shells_.cells; ++i) {
    double product = 1;
    for (std::size_t j = 0; j < shells_.count; ++j) {
      result(i, image(j, i, shells_.cells)) += product * e_[j][i].middle();
      product *= x_[j][i].middle();
    }
    result(i, shells_.cells - 1) += product * last;
  }
  return result;
}

std::optional<std::vector<Ball>> supersolution(const std::vector<Ball>& first, const Recursion& recursion) {
  constexpr double slack = 1.0001;
  std::vector<double> start;
  for (const Ball& one : first) start.push_back(slack * one.middle());
  const std::optional<std::vector<double>> w = positive_fixed_point(recursion.matrix(), start);
  if (!w) return std::nullopt;
  std::vector<Ball> result;
  for (const double one : *w) result.emplace_back(Rational(one), cell_bits);
  const Cells value = recursion(result);
  for (std::size_t i = 0; i < result.size(); ++i)
    if (!(first[i] + value.front()[i]).is_at_most(result[i])) return std::nullopt;
  return result;
}

namespace {

void raise_to(Ball& largest, const Ball& value) { largest = max(largest, value.upper_end()); }

/// Value and first derivative of a polynomial at t.
std::pair<Ball, Ball> value_and_slope(const std::vector<Ball>& p, const Ball& t) {
  Ball value(t.bits()), slope(t.bits());
  for (std::size_t l = p.size(); l-- > 0;) {
    slope = slope * t + value;
    value = value * t + p[l];
  }
  return {value, slope};
}

/// A bound of the second derivative on |t| <= radius.
Ball curvature(const std::vector<Ball>& p, const Ball& radius) {
  Ball sum(radius.bits());
  for (std::size_t l = p.size(); l-- > 2;) {
    const auto factor = static_cast<long>(l * (l - 1));
    sum = sum * radius + abs(p[l]) * factor;
  }
  return sum;
}

}  // namespace

HalfSymbol::HalfSymbol(const Mask& mask, slong bits)
    : bits_(bits),
      half_(false),
      reach_(0),
      flatness_(bits),
      second_(bits),
      fourth_(bits),
      remainder_(bits),
      moments_(moments, Ball(bits)),
      moment_remainder_(bits) {
  const LaurentPolynomial& symbol = mask.symbol();
  const long first = symbol.lowest(), last = symbol.highest();
  half_ = (first + last) % 2 != 0;
  Rational alternating = 0, first_moment = 0, sum = 0;
  for (long i = first; i <= last; ++i) {
    const Rational a = symbol.coefficient(i);
    require(a == symbol.coefficient(first + last - i), "HalfSymbol: need a symmetric mask");
    sum += a;
    alternating += i % 2 == 0 ? a : Rational(-a);
    first_moment += i % 2 == 0 ? Rational(i * a) : Rational(-i * a);
  }
  require(mask.arity() == 2 && sum == 2 && alternating == 0 && first_moment == 0,
          "HalfSymbol: need a binary mask with two sum rules");

  const long centre = (first + last + (half_ ? 1 : 0)) / 2;  // the first index on the right of the middle
  std::vector<Rational> right;
  for (long i = centre; i <= last; ++i)
    right.push_back(i == centre && !half_ ? symbol.coefficient(i) / 2 : symbol.coefficient(i));
  const auto size = right.size();
  reach_ = static_cast<double>(size) - (half_ ? 0.5 : 1);
  for (int l = 0; l < order; ++l) {
    plain_.emplace_back(size);
    alias_.emplace_back(size);
  }
  Rational factorial = 1;
  for (int l = 2; l <= order; ++l) factorial *= l;
  for (std::size_t i = 0; i < size; ++i) {
    const Rational place = half_ ? Rational(2 * static_cast<long>(i) + 1, 2) : Rational(static_cast<long>(i));
    Rational term = right[i];
    coefficients_.emplace_back(term, bits);
    for (int l = 0; l < order; ++l) {
      if (l > 0) term *= place / l;
      plain_[static_cast<std::size_t>(l)].set(i, Ball(term, bits));
      alias_[static_cast<std::size_t>(l)].set(i, Ball(i % 2 == 0 ? term : Rational(-term), bits));
    }
    const Ball size_of = abs(coefficients_.back());
    second_ = second_ - Ball(Rational(right[i] * place * place), bits);
    fourth_ += size_of * Ball(Rational(power(place, 4)), bits);
    flatness_ += size_of * Ball(Rational(place * place / 2), bits);
    remainder_ += size_of * Ball(Rational(power(place, order) / factorial), bits);
    Ball moment = coefficients_.back();
    const Ball square(Rational(place * place), bits);
    for (std::size_t l = 0; l < moments; ++l) {
      moments_[l] += moment;
      const auto next = static_cast<long>((2 * l + 1) * (2 * l + 2));
      moment = -moment * square / next;
    }
    moment_remainder_ += abs(moment);
  }
  flatness_ = flatness_.upper_end();
  fourth_ = fourth_.upper_end();
  remainder_ = remainder_.upper_end();
  moment_remainder_ = moment_remainder_.upper_end();
}

HalfSymbol::Waves HalfSymbol::waves(const Ball& w) const {
  const std::size_t size = coefficients_.size();
  const auto on_circle = [&](const Ball& angle) {
    ComplexBall z(bits_);
    arb_sin_cos(acb_imagref(z.get()), acb_realref(z.get()), angle.get(), bits_);
    return z;
  };
  std::vector<ComplexBall> powers{ComplexBall(Ball(1, bits_))};
  powers.reserve(size);
  if (size > 1) powers.push_back(on_circle(w));
  // Short chains of products, so that the radii stay small.
  for (std::size_t i = 2; i < size; ++i) powers.push_back(powers[i / 2] * powers[i - i / 2]);
  Waves result{BallVector(size), BallVector(size)};
  const ComplexBall shift = on_circle(w.scaled(-1));
  for (std::size_t i = 0; i < size; ++i) {
    const ComplexBall wave = half_ ? powers[i] * shift : powers[i];
    arb_set(result.cosine[i], acb_realref(wave.get()));
    arb_set(result.sine[i], acb_imagref(wave.get()));
  }
  return result;
}

/// By cos (a + b) = 2 cos a cos b - cos (a - b), in short chains, where a - b is the first or the second angle.
BallVector HalfSymbol::cosines(const Ball& w) const {
  const std::size_t size = coefficients_.size(), whole = half_ ? size / 2 + 1 : size;
  const auto cosine = [&](BallVector& result, std::size_t i, const Ball& angle) {
    if (i < result.size()) arb_cos(result[i], angle.get(), bits_);
  };
  const auto sum = [&](arb_ptr result, arb_srcptr first, arb_srcptr second, arb_srcptr difference) {
    arb_mul(result, first, second, bits_);
    arb_mul_2exp_si(result, result, 1);
    arb_sub(result, result, difference, bits_);
  };
  BallVector of_whole(whole);
  arb_one(of_whole[0]);
  cosine(of_whole, 1, w);
  for (std::size_t i = 2; i < whole; ++i) sum(of_whole[i], of_whole[i / 2], of_whole[i - i / 2], of_whole[i % 2]);
  if (!half_) return of_whole;
  BallVector of_halves(size);
  cosine(of_halves, 0, w.scaled(-1));
  // i + 1/2 = ceil(i/2) + (floor(i/2) + 1/2), whose difference is 1/2.
  for (std::size_t i = 1; i < size; ++i) sum(of_halves[i], of_whole[i - i / 2], of_halves[i / 2], of_halves[0]);
  return of_halves;
}

Ball HalfSymbol::value(const Ball& w) const {
  // The remainder holds for any w, and is small here.
  if (std::abs(w.middle()) * reach_ > moment_reach) return dot(plain_.front(), cosines(w), bits_);
  const Ball square = w * w;
  Ball sum(bits_);
  for (std::size_t l = moments; l-- > 0;) sum = sum * square + moments_[l];
  return sum.widened(moment_remainder_ * square.pow(moments));
}

Ball HalfSymbol::product_near_zero(const Ball& xi) const {
  // log m(w) is half the second derivative times w^2, up to (sup of the fourth/24 + mu^2) w^4: |log(1 + a) - a| <= a^2.
  const Ball square = xi * xi;
  const Ball error = (fourth_ / 24 + flatness_ * flatness_) * square * square / 15;
  return exp((second_ * square / 6).widened(error));
}

/// Taylor coefficients of m(w) and m(w + pi) around one point, the latter up to its sign.
void HalfSymbol::expand(const Ball& centre, std::vector<Ball>& plain, std::vector<Ball>& alias) const {
  const Waves at = waves(centre);
  plain.clear();
  alias.clear();
  for (int l = 0; l < order; ++l) {
    const auto k = static_cast<std::size_t>(l);
    const Ball even = dot(plain_[k], l % 2 == 0 ? at.cosine : at.sine, bits_);
    plain.push_back(l % 4 == 1 || l % 4 == 2 ? -even : even);
    // Where the centre lies between two indices, the cosines become sines.
    const Ball odd = dot(alias_[k], (l % 2 == 0) != half_ ? at.cosine : at.sine, bits_);
    const bool negative = half_ ? l % 4 >= 2 : l % 4 == 1 || l % 4 == 2;
    alias.push_back(negative ? -odd : odd);
  }
}

std::vector<HalfSymbol::Suprema> HalfSymbol::suprema(const Ball& low, const Ball& high, int count) const {
  const Ball width = high - low;
  // Expansions reach at most 1/reach; 16 steps for each, and at least one for each interval.
  const double needed = std::max(1.0, width.middle() * reach_ / 2);
  const auto expansions = static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::ceil(needed))));
  const int steps = std::max(count, 16 * expansions);
  const Ball radius = (width / (2 * expansions)).upper_end(), step = (width / (2 * steps)).upper_end();
  const Ball rest = remainder_ * radius.pow(order);
  std::vector<Suprema> result(static_cast<std::size_t>(count), {Ball(bits_), Ball(bits_)});
  std::vector<Ball> plain, alias;
  Ball plain_bend(bits_), alias_bend(bits_);
  for (int s = 0; s < steps; ++s) {
    const int expansion = s / (steps / expansions);
    const Ball centre = low + width * (2 * expansion + 1) / (2 * expansions);
    if (s % (steps / expansions) == 0) {
      expand(centre, plain, alias);
      plain_bend = curvature(plain, radius) * step * step / 2 + rest;
      alias_bend = curvature(alias, radius) * step * step / 2 + rest;
    }
    const Ball t = low + width * (2 * s + 1) / (2 * steps) - centre;
    Suprema& one = result[static_cast<std::size_t>(s / (steps / count))];
    const auto [value, slope] = value_and_slope(plain, t);
    raise_to(one.plain, abs(value) + abs(slope) * step + plain_bend);
    const auto [other, other_slope] = value_and_slope(alias, t);
    raise_to(one.alias, abs(other) + abs(other_slope) * step + alias_bend);
  }
  return result;
}

}  // namespace subcert::frequency
