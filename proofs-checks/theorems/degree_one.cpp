#include "degree_one.hpp"

#include "kernel/kernel.hpp"
#include "limit_constant.hpp"
#include "proofs.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <stdexcept>
#include <string>

namespace subcert::theorems {
namespace {

constexpr slong precision = 192;

void check_size(const char* function, int n) {
  if (n < 2 || n > 1'000'000) fail(ErrorKind::domain, "{}: need 2 <= n <= 10^6, got {}", function, n);
}

Ball interval(const Rational& low, const Rational& high, slong bits) { return Ball::containing({low, high}, bits); }

/// The largest |sin(x)/x - cos(x)| on [low, high], low > 0, by branch and bound with the mean value form.
class Supremum {
 public:
  explicit Supremum(slong bits) : bits_(bits) {}

  void search(const Rational& low, const Rational& high, int depth) {
    const Rational middle = (low + high) / 2;
    const Ball x(middle, bits_), whole = interval(low, high, bits_);
    const Ball value = sinc(x) - cos(x);
    const Ball slope = (cos(whole) - sinc(whole)) / whole + sin(whole);
    const Ball bound = abs(value + slope * (whole - x));
    const Rational attained = *abs(value).enclosure().lower;
    if (attained > best_) best_ = attained;
    const Rational above = *bound.enclosure().upper;
    if (above <= best_) return;
    if (depth == 0) {
      if (above > ceiling_) ceiling_ = above;
      return;
    }
    search(low, middle, depth - 1);
    search(middle, high, depth - 1);
  }

  Enclosure enclosure() const { return {best_, ceiling_ > best_ ? ceiling_ : best_}; }

 private:
  slong bits_;
  Rational best_ = 0;
  Rational ceiling_ = 0;
};

/// Everything of DegreeOneBounds in balls, with the shells 0, ..., shells - 1 and bounds for the rest.
struct Shells {
  std::vector<Ball> x, e, big_x, big_y, big_z, energy;  ///< the capitals have one entry more, for all shells beyond
};

Ball zero_to(const Ball& bound) { return bound.scaled(-1).widened(bound.scaled(-1)); }

Shells make_shells(int n) {
  const slong bits = precision;
  const Ball pi = Ball::pi(bits), kappa = Ball::containing(cosine_minus_sinc_supremum(), bits);
  const Ball g(Rational(4 * static_cast<long>(n) - 1, 4 * static_cast<long>(n) * (2 * static_cast<long>(n) - 1)), bits);
  const Ball one(1, bits);
  const long four = 4 * static_cast<long>(n) - 1;
  int shells = 70;
  for (long size = n; size > 0; size /= 2) shells += 2;
  Shells result;
  for (int j = 0; j < shells; ++j) {
    const Ball u = pi.scaled(-j - 1), away = g / sin(pi.scaled(-j - 2));
    const Ball near = u / sin(u) * min(u * u * four / 12, kappa / (2 * (2 * static_cast<long>(n) - 1)));
    result.x.push_back(min(one, away));
    result.e.push_back(min(near, away));
  }
  // Beyond the last shell x_j = 1, e_j <= (pi/2) (4n-1)/12 pi^2 4^(-j-1).
  if (!one.is_less(g / sin(pi.scaled(-shells - 2)))) throw std::logic_error("degree_one_bounds: too few shells");
  const Ball rest = pi * pi * pi * four / 24;
  const auto size = static_cast<std::size_t>(shells) + 1;
  result.big_x.assign(size, one);
  result.big_y.assign(size, zero_to(rest.scaled(-2 * shells) / 3));
  result.big_z.assign(size, zero_to(rest.scaled(-shells)));
  result.energy.assign(size, zero_to((rest * rest).scaled(-4 * shells) / 15));
  for (std::size_t j = size - 1; j-- > 0;) {
    const Ball &x = result.x[j], &e = result.e[j];
    result.big_x[j] = x * result.big_x[j + 1];
    result.big_y[j] = e + x * result.big_y[j + 1];
    result.big_z[j] = e.scaled(static_cast<slong>(j) + 1) + x * result.big_z[j + 1];
    result.energy[j] = e * e + x * x * result.energy[j + 1];
  }
  return result;
}

std::vector<Enclosure> enclosures(const std::vector<Ball>& balls) {
  std::vector<Enclosure> result;
  for (const Ball& ball : balls) result.push_back(ball.enclosure());
  return result;
}

}  // namespace

Enclosure cosine_minus_sinc_supremum() {
  static const Enclosure value = [] {
    // For x <= 1 the function is at most x^2/3, for x >= 16 at most 1 + 1/16; both are below its value at 11/4.
    Supremum supremum(precision);
    supremum.search(Rational(11, 4), 3, 40);
    supremum.search(1, 16, 44);
    Enclosure result = supremum.enclosure();
    if (*result.lower <= Rational(17, 16))
      throw std::logic_error("cosine_minus_sinc_supremum: the ends are not excluded");
    return result;
  }();
  return value;
}

DegreeOneBounds degree_one_bounds(int n) {
  check_size("degree_one_bounds", n);
  const slong bits = precision;
  const Shells shells = make_shells(n);
  const Ball pi = Ball::pi(bits), one(1, bits);
  const std::size_t count = shells.x.size();
  DegreeOneBounds result{n,
                         enclosures(shells.x),
                         enclosures(shells.e),
                         enclosures(shells.big_x),
                         enclosures(shells.big_y),
                         enclosures(shells.big_z),
                         Enclosure::at_least(0),
                         Enclosure::at_least(0),
                         Enclosure::at_least(0),
                         Enclosure::at_least(0),
                         Enclosure::at_least(0)};
  for (auto* list : {&result.big_x, &result.big_y, &result.big_z}) list->pop_back();

  if (shells.energy[0].is_less(one)) {
    // On shell 0 the sum of all squares is at most X_0^2 / (1 - E_0).
    const Ball squares = shells.big_x[0].pow(2) / (1 - shells.energy[0]);
    Ball sum = shells.energy[count].scaled(-static_cast<slong>(count));
    for (std::size_t j = 0; j < count; ++j) sum += shells.energy[j].scaled(-static_cast<slong>(j) - 1);
    result.energy = (squares * sum).enclosure();
  }
  if (!shells.big_y[0].is_less(one)) return result;
  const Ball u0 = shells.big_x[0] / (1 - shells.big_y[0]);
  result.u0 = u0.enclosure();
  // Half the measure of shell j is pi 2^(-j-1), of all shells from j on pi 2^-j.
  Ball ripple(bits);
  for (std::size_t j = 0; j <= count; ++j) {
    const Ball aliases = u0 * shells.big_y[j];
    const slong halvings = static_cast<slong>(j) + (j < count ? 1 : 0);
    ripple += ((shells.big_x[j] * aliases).scaled(1) + aliases * aliases).scaled(-halvings);
  }
  result.ripple = ripple.enclosure();
  if (!shells.big_z[0].is_less(one)) return result;
  const Ball v0 = shells.big_x[0] / (1 - shells.big_z[0]);
  result.v0 = v0.enclosure();
  Ball slope(bits);
  for (std::size_t j = 0; j <= count; ++j) {
    const slong halvings = static_cast<slong>(j) + (j < count ? 1 : 0);
    const Ball aliases = u0 * shells.big_y[j], weighted = v0 * shells.big_z[j];
    slope += (pi * (shells.big_x[j] * aliases + weighted * shells.big_x[j] + weighted * aliases))
                 .scaled(-halvings - static_cast<slong>(j));
  }
  result.slope = slope.scaled(1).enclosure();
  return result;
}

Rational degree_one_second_coefficient() {
  // (1/9) |s Phi|^2 / |Phi|^2 + (1/4) (1 - |s Phi|^2 / (3 |Phi|^2)) with |s Phi|^2 = 4 |Phi|^2.
  const Rational energy = 4;
  return energy / 9 + (1 - energy / 3) / 4;
}

Ball degree_one_moment() {
  const slong bits = precision;
  // On 2^j <= s <= 2^(j+1) M(s) = 2^(j(j+1)/2) s^-j, and M = 1 on [0, 2].
  const int octaves = 24;
  Rational half = Rational(32, 5);
  for (int j = 1; j < octaves; ++j)
    half += power(Rational(2), j * (j + 1)) *
            (power(Rational(2), (j + 1) * (5 - 2 * j)) - power(Rational(2), j * (5 - 2 * j))) / (5 - 2 * j);
  // An octave j >= 24 contributes at most 2^(6j - j^2), so all of them at most twice the first.
  return (Ball(half, bits) + zero_to(Ball(2, bits).scaled(6 * octaves - octaves * octaves))) / Ball::pi(bits);
}

Ball degree_one_fourth_order() {
  const Ball pi = Ball::pi(precision), phi = Kernel(1, precision).product(pi);
  return (1 / (phi * phi) - 1 - pi * pi / 9) / pi.pow(4);
}

DegreeOneMean degree_one_mean(int n) {
  check_size("degree_one_mean", n);
  const slong bits = precision;
  const Ball N(Rational(4 * static_cast<long>(n) - 1, 2), bits);
  static const Enclosure constant = limit_constant(1, 40);
  const Ball c = Ball::containing(constant, bits);

  const Ball factor = (Ball(Rational(8, 9), bits) + degree_one_fourth_order()) * degree_one_moment() /
                      (1 - 1 / N.scaled(1)).pow(5);

  DegreeOneMean result;
  result.n = n;
  const Ball leading = c.scaled(1) / N;
  const Ball next = leading * Ball(degree_one_second_coefficient(), bits) / N.pow(2);
  const Ball remainder = factor / N.pow(5);
  result.leading = leading.enclosure();
  result.next = next.enclosure();
  result.remainder = remainder.enclosure();
  result.aliases = degree_one_bounds(n).energy;
  result.mean = (leading + next).widened(remainder).enclosure();
  if (result.aliases.upper)
    *result.mean.upper += *result.aliases.upper;
  else
    result.mean.upper.reset();
  return result;
}

Enclosure degree_one_maximum(int n) {
  Enclosure result = degree_one_mean(n).mean;
  const Enclosure ripple = degree_one_bounds(n).ripple;
  if (result.upper && ripple.upper)
    *result.upper += *ripple.upper;
  else
    result.upper.reset();
  return result;
}

}  // namespace subcert::theorems
