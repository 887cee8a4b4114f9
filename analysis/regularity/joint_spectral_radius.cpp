#include "joint_spectral_radius.hpp"

#include "exact_radius.hpp"

#include <subcert/analysis/symbol/flint.hpp>

#include <Eigen/Eigenvalues>
#include <boost/multiprecision/mpfr.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

namespace subcert {
namespace {

using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<80>, boost::multiprecision::et_off>;

const Rational rounding = power(Rational(10), -15);

Eigen::MatrixXd to_double(const RationalMatrix& m) {
  Eigen::MatrixXd result(static_cast<Eigen::Index>(m.rows()), static_cast<Eigen::Index>(m.columns()));
  for (std::size_t i = 0; i < m.rows(); ++i)
    for (std::size_t j = 0; j < m.columns(); ++j)
      result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = m(i, j).convert_to<double>();
  return result;
}

/// J M_t J = M_{count-1-t} for the reversal J of the coordinates.
bool is_flip_symmetric(const std::vector<RationalMatrix>& matrices) {
  const std::size_t n = matrices.front().rows(), count = matrices.size();
  for (std::size_t t = 0; t < count; ++t)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        if (matrices[t](i, j) != matrices[count - 1 - t](n - 1 - i, n - 1 - j)) return false;
  return true;
}

RationalMatrix product_of(const std::vector<RationalMatrix>& matrices, const std::vector<int>& word) {
  RationalMatrix product = matrices[static_cast<std::size_t>(word.front())];
  for (std::size_t k = 1; k < word.size(); ++k) product = product * matrices[static_cast<std::size_t>(word[k])];
  return product;
}

template <class Number>
struct Gaussian {
  Number re, im;
};

/// p and p' at a Gaussian number, by Horner.
template <class Number, class Coefficients>
std::pair<Gaussian<Number>, Gaussian<Number>> evaluate(const Coefficients& coefficients, const Gaussian<Number>& z) {
  Gaussian<Number> value{0, 0}, slope{0, 0};
  const auto times_z = [&z](const Gaussian<Number>& x) -> Gaussian<Number> {
    return {Number(x.re * z.re - x.im * z.im), Number(x.re * z.im + x.im * z.re)};
  };
  for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) {
    slope = times_z(slope);
    slope.re += value.re;
    slope.im += value.im;
    value = times_z(value);
    value.re += *c;
  }
  return {value, slope};
}

Rational to_dyadic(const Real& value) {
  constexpr int bits = 200;
  return Rational(Integer(round(ldexp(value, bits))), Integer(1) << bits);
}

Rational squared_modulus(const Gaussian<Rational>& z) { return z.re * z.re + z.im * z.im; }

std::vector<Rational> coefficients_of(const LaurentPolynomial& p) {
  std::vector<Rational> result(static_cast<std::size_t>(p.highest()) + 1);
  for (std::size_t k = 0; k < result.size(); ++k) result[k] = p.coefficient(static_cast<long>(k));
  return result;
}

/// A fraction with a small denominator next to the number, by its continued fraction; nothing to trust.
std::optional<Rational> near_fraction(Real value) {
  static const Real tiny("1e-55"), large("1e20");
  Integer num = 1, den = 0, last_num = 0, last_den = 1;
  const Real target = value;
  for (int k = 0; k < 60; ++k) {
    const Real whole = floor(value);
    if (abs(whole) > large) return std::nullopt;
    const Integer a(whole);
    std::tie(num, last_num) = std::pair(Integer(a * num + last_num), num);
    std::tie(den, last_den) = std::pair(Integer(a * den + last_den), den);
    if (Real(den) > large) return std::nullopt;
    if (abs(target - Real(num) / Real(den)) < tiny * (1 + abs(target))) return Rational(num, den);
    value = 1 / (value - whole);
  }
  return std::nullopt;
}

/// Whether all zeros of p but root and -root are smaller in modulus.
bool is_largest_root(const LaurentPolynomial& p, const Rational& root) {
  LaurentPolynomial rest = p;
  for (const Rational& r : {root, Rational(-root)})
    while (rest.length() > 1 && rest(r) == 0) rest = *rest.exact_quotient(LaurentPolynomial({-r, 1}, 0));
  return *largest_root_modulus(rest).largest.upper < abs(root);
}

Rational one_norm(const RationalMatrix& m) {
  Rational most = 0;
  for (std::size_t j = 0; j < m.columns(); ++j) {
    Rational sum = 0;
    for (std::size_t i = 0; i < m.rows(); ++i) sum += abs(m(i, j));
    most = std::max(most, sum);
  }
  return most;
}

/// The best root of a largest norm over all products of one length, for short lengths.
KnownNorm norm_of_products(const std::vector<RationalMatrix>& matrices) {
  std::vector<RationalMatrix> products = matrices;
  KnownNorm best{1, 0};
  Rational best_bound = 0;
  for (int level = 1;; ++level) {
    Rational most = 0;
    for (const RationalMatrix& product : products) most = std::max(most, one_norm(product));
    const Rational bound = *root_enclosure(most, level).upper;
    if (level == 1 || bound < best_bound) {
      best = {level, most};
      best_bound = bound;
    }
    if (most == 0 || products.size() * matrices.size() > 512 || level >= 24) return best;
    std::vector<RationalMatrix> longer;
    for (const RationalMatrix& product : products)
      for (const RationalMatrix& m : matrices) longer.push_back(product * m);
    products = std::move(longer);
  }
}

void check(const std::vector<RationalMatrix>& matrices, double seconds) {
  const auto fail = [](const std::string& what) { throw std::invalid_argument("joint_spectral_radius: need " + what); };
  if (matrices.empty() || matrices.size() > 64) fail("1 to 64 matrices, got " + std::to_string(matrices.size()));
  const std::size_t n = matrices.front().rows();
  if (n < 1 || n > 256) fail("matrices of size 1 to 256, got " + std::to_string(n));
  for (const RationalMatrix& m : matrices)
    if (m.rows() != n || m.columns() != n) fail("square matrices of one size");
  if (!(seconds > 0)) fail("seconds > 0");
}

}  // namespace

ProductEvidence prove_product(const std::vector<RationalMatrix>& matrices, const std::vector<int>& word) {
  ProductEvidence evidence{word, 0, 0, Enclosure::at_least(0), std::nullopt};
  const RationalMatrix product = product_of(matrices, word);
  const LaurentPolynomial p = characteristic_polynomial(product);
  const std::vector<Rational> coefficients = coefficients_of(p);

  const Eigen::VectorXcd eigenvalues = to_double(product).eigenvalues();
  Eigen::Index leading = 0;
  for (Eigen::Index k = 0; k < eigenvalues.size(); ++k)
    if (std::abs(eigenvalues[k]) > std::abs(eigenvalues[leading]) * (1 + 1e-12)) leading = k;
  if (std::abs(eigenvalues[leading]) == 0) return evidence;

  // Multiple eigenvalues are found as simple zeros of the squarefree part.
  const LaurentPolynomial nonzero = p.shifted(-p.lowest());
  const LaurentPolynomial squarefree = *nonzero.exact_quotient(gcd(nonzero, nonzero.derivative()));
  if (squarefree.length() == 1) return evidence;
  std::vector<Real> real_coefficients;
  for (const Rational& c : coefficients_of(squarefree)) real_coefficients.push_back(Real(numerator(c)) / Real(denominator(c)));
  // A multiple real eigenvalue may come out as a pair that is off by the root of the rounding.
  const double imaginary = std::abs(eigenvalues[leading].imag());
  const bool multiple = squarefree.length() < nonzero.length();
  const bool real = imaginary <= (multiple ? 1e-6 : 1e-12) * std::abs(eigenvalues[leading]);
  Gaussian<Real> z{eigenvalues[leading].real(), real ? 0 : imaginary};
  for (int k = 0; k < 16; ++k) {  // Newton
    const auto [value, slope] = evaluate(real_coefficients, z);
    const Real square = slope.re * slope.re + slope.im * slope.im;
    if (square == 0) break;
    z.re -= (value.re * slope.re + value.im * slope.im) / square;
    z.im -= (value.im * slope.re - value.re * slope.im) / square;
  }
  Gaussian<Rational> c{to_dyadic(z.re), to_dyadic(z.im)};
  const auto fraction = real ? near_fraction(z.re) : std::nullopt;
  const bool rational = fraction && *fraction != 0 && p(*fraction) == 0;
  if (rational) c = {*fraction, 0};
  auto [value, slope] = evaluate(coefficients, c);
  if (squarefree.length() < nonzero.length() && squared_modulus(slope) == 0) {
    c.re += power(Rational(2), -200);
    std::tie(value, slope) = evaluate(coefficients, c);
  }
  evidence.re = c.re;
  evidence.im = c.im;
  if (squared_modulus(slope) == 0) return evidence;
  const Rational distance =
      static_cast<long>(matrices.front().rows()) * *root_enclosure(squared_modulus(value) / squared_modulus(slope), 2).upper;
  const Enclosure modulus = root_enclosure(squared_modulus(c), 2);
  const int length = static_cast<int>(word.size());
  const Rational low = *modulus.lower - distance;
  if (low > 0)
    evidence.radius = {root_enclosure(low, length).lower, root_enclosure(*modulus.upper + distance, length).upper};
  if (rational && is_largest_root(p, *fraction)) {
    const Enclosure exact = root_enclosure(abs(*fraction), length);
    if (exact.is_exact()) evidence.exact = exact.lower;
  }
  return evidence;
}

Enclosure root_enclosure(const Rational& value, int degree) {
  if (value < 0 || degree < 1) throw std::invalid_argument("root_enclosure: need value >= 0 and degree >= 1");
  if (degree == 1 || value == 0) return Enclosure::exactly(value);
  // An exact root where there is one.
  Integer num, den;
  if (mpz_root(num.backend().data(), numerator(value).backend().data(), static_cast<unsigned long>(degree)) != 0 &&
      mpz_root(den.backend().data(), denominator(value).backend().data(), static_cast<unsigned long>(degree)) != 0)
    return Enclosure::exactly(Rational(num, den));
  flint::Ball ball;
  arb_set_fmpq(ball.get(), flint::Quotient(value).get(), 256);
  arb_root_ui(ball.get(), ball.get(), static_cast<ulong>(degree), 256);
  return ball.enclosure();
}

JointSpectralRadius joint_spectral_radius(const std::vector<RationalMatrix>& matrices, double seconds,
                                          const std::optional<KnownNorm>& known) {
  check(matrices, seconds);
  const bool symmetric = is_flip_symmetric(matrices);
  SearchFamily family;
  for (const RationalMatrix& m : matrices) family.matrices.push_back(to_double(m));
  family.flip_symmetric = symmetric;
  SearchOptions options;
  options.seconds = seconds;
  const SearchResult search = search_polytope(family, options);

  JointSpectralRadius result;
  // The word of the search lists the matrix applied first; its transposed words are the other way round already.
  std::vector<int> word = search.products.front().word;
  if (!search.transposed) std::reverse(word.begin(), word.end());
  result.product = prove_product(matrices, word);
  result.radius.lower = result.product.radius.lower;
  result.polytope = certify_polytope(matrices, symmetric, search);

  const KnownNorm norm = known ? *known : norm_of_products(matrices);
  const Rational norm_bound = *root_enclosure(norm.norm, norm.level).upper;
  // Of two bounds that differ by rounding only, the polytope is the shorter proof.
  if (result.polytope && result.polytope->bound < norm_bound * (1 + rounding)) {
    result.method = JsrMethod::invariant_polytope;
    result.certified_upper = result.polytope->bound;
    result.vertices = result.polytope->vertices.size();
  } else {
    result.method = JsrMethod::norm_of_products;
    result.certified_upper = norm_bound;
    result.norm_level = norm.level;
    result.polytope.reset();
  }
  result.radius.upper = result.certified_upper;
  if (*result.radius.upper == *result.radius.lower)
    result.exact = {Truth::yes, "both ends of the enclosure are the same number"};
  else if (result.method == JsrMethod::invariant_polytope && *result.radius.lower > 0)
    result.exact = product_attains_radius(matrices, search, *result.polytope, *result.radius.lower);
  else
    result.exact = {Truth::unknown, "no polytope closed"};
  if (result.exact.is_yes()) {
    if (result.product.exact) result.radius = Enclosure::exactly(*result.product.exact);
    // A norm that no matrix expands by more than the radius.
    result.growth.at_most = 0;
  }
  result.closed = *result.radius.upper <= *result.radius.lower * (1 + 1000 * rounding);
  return result;
}

}  // namespace subcert
