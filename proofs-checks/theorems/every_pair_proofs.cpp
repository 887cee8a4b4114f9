// Conjecture 8 in d for neighbouring odd degrees: for every degree from 5 on and all large n by bounds of mean and
// ripple, for every n by the bound of single curves. The numbers of the checks are those of
// docs/theorems/every-pair.tex.

#include "every_pair.hpp"
#include "proofs.hpp"

#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>
#include "curve_bounds.hpp"
#include "kernel/kernel.hpp"

#include <algorithm>
#include <vector>

namespace subcert::theorems {
namespace {

constexpr int least_large_n = 50;
constexpr int last_linear = 191;  ///< the degree up to which n_0 = max(50, 4d + 4)

const Rational stretch(8, 5);

/// t_{2q}(0)^2/h_{2q} on M points. Domain: M > 2q.
Rational squared_value(int q, int M) {
  Rational result = (4 * q + 1) * power(central(q), 2) / M;
  for (int i = 1; i <= q; ++i) result *= Rational(M * M - (2 * i - 1) * (2 * i - 1)) / (M * M - 4 * i * i);
  return result;
}

/// The coefficients of cos(2kw) in D_{2n-1}^2 - D_{2n}^2.
std::vector<Rational> difference_of_squares(const Mask& mask, int n) {
  std::vector<Rational> result(static_cast<std::size_t>(2 * n));
  for (int x = 1 - 2 * n; x < 2 * n; ++x)
    for (int y = x; y < 2 * n; y += 2) {
      Rational term = mask.symbol().coefficient(x) * mask.symbol().coefficient(y);
      if (x != y) term *= 2;
      if (x % 2 != 0) term = -term;
      result[static_cast<std::size_t>(y - x) / 2] += term;
    }
  return result;
}

/// An upper bound of the mean over a period of |the sum of coefficients[k] cos(k t)|.
Ball mean_modulus(const std::vector<Rational>& coefficients, int cells) {
  constexpr slong bits = 64;
  const std::size_t size = coefficients.size(), period = 4 * static_cast<std::size_t>(cells);
  const Ball pi = Ball::pi(bits);
  std::vector<Ball> cosines, values, slopes;  // cos(2 pi i/period), 0 <= i < period
  for (std::size_t i = 0; i < period; ++i)
    cosines.push_back(cos(pi * static_cast<long>(i) / static_cast<long>(period / 2)));
  Ball curvature(bits);
  for (std::size_t k = 0; k < size; ++k) {
    values.emplace_back(coefficients[k], bits);
    slopes.push_back(values.back() * static_cast<long>(k));
    curvature += abs(slopes.back()) * static_cast<long>(k);
  }
  const Ball half = pi / static_cast<long>(period / 2);  // of the width of a cell
  const Ball tiny = Ball(1, bits).scaled(-bits);
  Ball sum(bits);
  for (std::size_t i = 0; i < static_cast<std::size_t>(cells); ++i) {
    Ball value(bits), slope(bits);
    for (std::size_t k = 0; k < size; ++k) {
      const std::size_t place = k * (2 * i + 1) % period;
      value.add_product(values[k], cosines[place]);
      slope.add_product(slopes[k], cosines[(place + period - period / 4) % period]);  // the sine
    }
    value = abs(value).upper_end();
    const Ball rise = (abs(slope) * half + tiny).upper_end();
    // The mean of |value + slope s| over |s| <= half increases with both moduli; it is the first if the rise is
    // smaller, and the second, which is never less than the first, otherwise.
    sum += rise.is_at_most(value) ? value : (value * value / rise + rise).scaled(-1);
  }
  return sum / cells + curvature * half * half / 6;
}

/// s_0 = sin w_0.
Ball sine_at_stretch(int degree, int n) {
  return exactly(stretch / (2 * n - 1)) * sqrt(exactly(degree * (degree + 1)));
}

/// x_-.
Rational turning_exponent(int d, int n) {
  return stretch * stretch * d * (d + 1) / (8 * d + 12) * (1 - power(Rational(d + 1, 2 * n - 1), 2));
}

/// The numbers that the bounds round, (T.6) to (T.11).
std::vector<Check> rounded_checks(int degree, int n) {
  const Ball one(1, proof_bits), pi = Ball::pi(proof_bits), root = sqrt(exactly(2)), fourth = one.scaled(-2);
  const auto stated = [](const Rational& value) { return Enclosure::exactly(value); };
  std::vector<Check> checks{
      less("T.6", "1.7 < 1 + cos(pi/4)", stated(rounded::cosine), (one + one / root).enclosure()),
      less("T.7", "(1/4 - 1/(2 pi))/1.7^2 < 0.0315",
           ((fourth - one / pi.scaled(1)) / exactly(rounded::cosine).pow(2)).enclosure(), stated(rounded::spread)),
      less("T.8", "sqrt 2 (1 + (pi/2)/(sqrt 2 - 1)) < 6.8", (root * (pi.scaled(-1) / (root - 1) + 1)).enclosure(),
           stated(rounded::envelopes)),
      less("T.9", "(1/2)/(1 - 2^(-1/2)) < 1.71", (one.scaled(-1) / (one - one / root)).enclosure(),
           stated(rounded::constants)),
      // 2 cos x = sqrt(2 + 2 cos 2x), twice.
      less("T.10", "1.99 < 2 cos(arcsin(0.23)/4)", stated(rounded::halving),
           sqrt(sqrt(sqrt(one - exactly(rounded::sine).pow(2)).scaled(1) + 2) + 2).enclosure())};
  for (int d : {degree, degree + 2})
    checks.push_back(less("T.11", "s_0 < 0.23 at d = " + text(d) + ", n = " + text(n),
                          sine_at_stretch(d, n).enclosure(), stated(rounded::sine)));
  return checks;
}

/// What makes (T.5) fall from the last degree that it is run for on, (T.12) to (T.15).
std::vector<Check> growth_checks(int d) {
  const Rational share(26, 100), grown(203, 100), step(63, 100);
  const Ball factor = exactly(stretch * stretch / 4 * share) * exp(exactly(grown - step / 2));
  const auto half_square = [](int degree) { return (degree * degree + 1) / 2; };
  return {
      less("T.12", "(beta^2/4) 0.26 e^2.03 e^-0.315 < 0.96", factor.enclosure(), Enclosure::exactly(decimal("0.96"))),
      less("T.13", "(d + 2)(d + 3)/((2d + 3)(2d + 5)) < 0.26 at d = " + text(d),
           Enclosure::exactly(Rational((d + 2) * (d + 3), (2 * d + 3) * (2 * d + 5))), Enclosure::exactly(share)),
      less("T.14", "2 + 3/d < 2.03 at d = " + text(d), Enclosure::exactly(2 + Rational(3, d)),
           Enclosure::exactly(grown)),
      less("T.15", "0.63 < the step of x_- at d = " + text(d), Enclosure::exactly(step),
           Enclosure::exactly(turning_exponent(d + 2, half_square(d + 2)) - turning_exponent(d, half_square(d))))};
}

}  // namespace

Rational central_weight(int degree, int M) {
  if (M <= degree) return 1;
  Rational sum = 0;
  for (int q = 0; 2 * q < degree; ++q) sum += squared_value(q, M);
  return sum;
}

LargeBounds large_bounds(int degree, int n) {
  const int d = degree, odd = 2 * n - 1, nu = d * (d + 1);
  const Ball one(1, proof_bits), pi = Ball::pi(proof_bits), log_two = log(exactly(2));
  const Ball gamma = exactly(d * central((d - 1) / 2)), a = sqrt(exactly(nu)), L = exactly(odd * odd - nu);
  const Ball root_L = sqrt(L), b = exactly(stretch * stretch - 1), squared_beta = exactly(stretch * stretch);
  const Ball s0 = sine_at_stretch(degree, n), z0 = sqrt(one - s0 * s0), zh = sqrt((one + z0).scaled(-1));
  const Ball theta = one / (a * b * sqrt(b)), sigma = one + exactly(2 * n * rounded::rise) / L;
  const Ball constant = gamma / root_L * (one + exactly(2 * n) / L);
  const auto envelope = [&](const Ball& u) {  // without u/(u^2 - nu)
    const Ball square = u * u, X = square - nu, eta = (square + nu) / (X * sqrt(X));
    return sqrt(sigma) * (sqrt(one + eta * eta) + eta);
  };
  const Ball u = exactly(odd) / sqrt(exactly(2));
  const Ball delta = envelope(u) * gamma * u / (u * u - nu) + constant;

  const Ball scale = gamma * gamma * sigma / root_L / (one - theta), root_b = sqrt(b), cube = b * root_b;
  const Ball J = one / (cube * 3) + exactly(Rational(4, 5)) / (cube * b) + exactly(Rational(4, 7)) / (cube * b * b);
  const Ball mu1 = scale / (a * root_b).scaled(1) * (one + squared_beta * theta), mu2 = scale * J / a.pow(3);
  const Ball even_tail = (sqrt(mu1) + sqrt(mu2).scaled(1)).pow(2).scaled(1) / pi;
  const Ball far = (even_tail + (sqrt(even_tail) + constant).pow(2)).scaled(-1);

  Rational variation = 0;
  for (int q = 0; 2 * q < d; ++q) variation += q * (2 * q + 1) * squared_value(q, 2 * n);
  const Ball epsilon = exactly(central_weight(d, odd) - central_weight(d, 2 * n) + 2 * variation / (4 * n * n - d * d));
  const Ball omega = ((one - z0) * sqrt(s0) + sqrt(epsilon)).pow(2) / (z0 * z0).scaled(2);

  Rational double_factorial = 1;
  for (int i = 3; i <= 2 * d + 1; i += 2) double_factorial *= i;
  const Rational exponent = stretch * stretch * nu / (8 * d + 12);
  const Ball x_low = exactly(turning_exponent(d, n));
  const Ball lambda = one * (d + 1) - exactly(exponent * power(Rational(2 * n, odd), 2)) / (zh * zh);
  const Ball p = gamma / (zh * exactly(double_factorial)) * (exactly(stretch * Rational(n, odd)) * a / zh).pow(d + 1) *
                 exp(-x_low.scaled(-1)) / lambda;
  const Ball series = one / (one - exp(-(lambda * log(exactly(rounded::halving)))));
  const Ball iota = s0.scaled(2) / (pi * zh * zh) * p * series / (lambda + 1);

  const Ball near_turn = envelope(a * exactly(stretch)), first = near_turn * gamma * exactly(stretch) / (a * b);
  const Ball spread = exactly(rounded::spread) * (near_turn * gamma * squared_beta / b).pow(2) / exactly(odd * odd);
  const Ball quarter = (sqrt((one - z0).pow(2) * s0 + spread) + sqrt(epsilon)).pow(2).scaled(-1);
  const Ball p0 = p.scaled(-1) * series, mixed = sqrt(far * quarter);
  const Ball both = sqrt(exactly(central_weight(d, odd)) * omega) + mixed + (delta * delta).scaled(-2);
  const Ball aliased = iota.scaled(-2) + p0 * far +
                       mixed * (first * exactly(rounded::envelopes) +
                                constant * exactly(rounded::constants) * sqrt(pi / s0));
  const Ball Gamma = p0 + 1 + log(pi / s0.scaled(1)) / log_two;
  return {iota + omega + far,
          (delta * (both + aliased)).scaled(1) + (delta * delta * (omega + far + Gamma * aliased)).scaled(1)};
}

Rational curve_ceiling(int n, int degree) {
  const Enclosure modulus = mean_modulus(difference_of_squares(primal_mask(n, degree), n), 128 * n).enclosure();
  if (!modulus.upper) fail(ErrorKind::undecided, "the difference of the two rules is not bounded at n = {}", n);
  return (central_weight(degree, 2 * n - 1) + central_weight(degree, 2 * n) + *modulus.upper) / 2;
}

int large_n(int degree) {
  return degree <= last_linear ? std::max(least_large_n, 4 * degree + 4) : (degree * degree + 1) / 2;
}

std::vector<Check> every_n_checks(const Constants&, int degree, int threads) {
  const int first = (degree + 3) / 2, next = degree + 2;
  std::vector<Check> checks(static_cast<std::size_t>(large_n(degree) - first));
  parallel_for_each(checks.size(), threads, [&](std::size_t i) {
    const int n = large_n(degree) - 1 - static_cast<int>(i);  // those that cost most first
    const Enclosure mean = curve_bounds(primal_mask(n, next), 1).mean;
    const Enclosure twice = mean.lower ? Enclosure::at_least(2 * *mean.lower) : Enclosure{};
    checks[checks.size() - 1 - i] = less("T.16",
                                         "U + U of degree " + text(next) + " < 2 I of degree " + text(next) + at(n),
                                         Enclosure::exactly(curve_ceiling(n, degree) + curve_ceiling(n, next)), twice);
  });
  // These bounds do not refute: U is above the curve.
  for (Check& one : checks)
    if (one.decision.is_no()) one.decision = {Truth::unknown, "the bounds do not suffice"};
  const std::vector<Check> large = large_n_checks(Constants(), degree, threads);
  checks.insert(checks.end(), large.begin(), large.end());
  return checks;
}

Constants large_n_constants(int degree) {
  struct Stated {
    const char *T, *high, *low;
  };
  if (degree > 11) return Constants();
  const Stated s = degree == 5   ? Stated{"0.7946", "0.1374", "0.1145"}
                   : degree == 7 ? Stated{"0.7375", "0.1716", "0.1374"}
                   : degree == 9 ? Stated{"0.7105", "0.2181", "0.1716"}
                                 : Stated{"0.7055", "0.2790", "0.2181"};
  const std::string where = " at d = " + text(degree) + ", n = " + text(large_n(degree));
  return Constants({{"T", decimal(s.T), Side::above, "T.1", "2n T of degree d + 2" + where},
                    {"Z'", decimal(s.high), Side::above, "T.2", "2n Z of degree d + 2" + where},
                    {"Z", decimal(s.low), Side::above, "T.3", "2n Z of degree d" + where}});
}

std::vector<Check> large_n_checks(const Constants& c, int degree, int) {
  const auto gap = [](int d) { return Enclosure::exactly((2 * d + 3) * power(central((d + 1) / 2), 2)); };
  const std::string right = " < (2d + 3) (binom(d+1, (d+1)/2)/2^(d+1))^2";
  std::vector<Check> checks;
  if (c.all().empty()) {
    const int last = last_linear + 2;
    for (int d = 13; d <= last; d += 2) {
      const int n = large_n(d);
      const LargeBounds low = large_bounds(d, n), high = large_bounds(d + 2, n);
      checks.push_back(less("T.5", "2n (T' + Z' + Z)" + right + " at d = " + text(d) + ", n = " + text(n),
                            ((high.deficit + high.ripple + low.ripple) * (2 * n)).enclosure(), gap(d)));
    }
    // The sines s_0 are largest at d = 15.
    for (const std::vector<Check>& more :
         {rounded_checks(13, large_n(13)), rounded_checks(15, large_n(15)), growth_checks(last)})
      checks.insert(checks.end(), more.begin(), more.end());
    return checks;
  }
  const int n = large_n(degree);
  const LargeBounds low = large_bounds(degree, n), high = large_bounds(degree + 2, n);
  checks = {defining(c, "T", "2n T of degree d + 2", high.deficit * (2 * n)),
            defining(c, "Z'", "2n Z of degree d + 2", high.ripple * (2 * n)),
            defining(c, "Z", "2n Z of degree d", low.ripple * (2 * n)),
            less("T.4", "T + Z' + Z" + right, Enclosure::exactly(c["T"] + c["Z'"] + c["Z"]), gap(degree))};
  const std::vector<Check> more = rounded_checks(degree, n);
  checks.insert(checks.end(), more.begin(), more.end());
  return checks;
}

}  // namespace subcert::theorems
