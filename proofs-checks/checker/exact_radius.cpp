
#include "exact_radius.hpp"

#include <algorithm>
#include <utility>

namespace subcert_check {
namespace {

constexpr std::size_t most_degree = 256;
constexpr std::size_t error_bits = 512;  // bounds are rounded up to so many binary digits after the point

mpz_class square(const mpz_class& x) { return x * x; }
mpz_class squared_modulus(const Complex& z) { return square(z.re) + square(z.im); }

/// point / scale
struct ComplexRatio {
  Complex point;
  mpz_class scale;

  ComplexRatio(const mpq_class& re, const mpq_class& im) : scale(lcm(re.get_den(), im.get_den())) {
    point = {re.get_num() * (scale / re.get_den()), im.get_num() * (scale / im.get_den())};
  }
};

/// The sum of c_k point^k scale^(n - k), k = 0, ..., n.
Complex form_value(const Vector& c, const ComplexRatio& at, Arithmetic& arithmetic) {
  Complex value{0, 0};
  mpz_class scale = 1;
  for (std::size_t k = c.size(); k-- > 0; scale *= at.scale) {
    value = times(value, at.point, arithmetic);
    arithmetic.add_product(value.re, c[k], scale);
  }
  return value;
}

Vector derivative(const Vector& p) {
  Vector result;
  for (std::size_t k = 1; k < p.size(); ++k) result.push_back(p[k] * k);
  return result;
}

}  // namespace

bool lies_between(const mpq_class& re, const mpq_class& im, const mpq_class& error, const mpq_class& low,
                  const mpq_class& high) {
  const mpq_class modulus = re * re + im * im, least = low + error, most = high - error;
  return least * least <= modulus && most >= 0 && modulus <= most * most;
}

mpz_class norm(const Complex& z) { return abs(z.re) + abs(z.im); }

Complex times(const Complex& a, const Complex& b, Arithmetic& arithmetic) {
  Complex product;
  arithmetic.add_product(product.re, a.re, b.re);
  arithmetic.add_product(product.re, a.im, -b.im);
  arithmetic.add_product(product.im, a.re, b.im);
  arithmetic.add_product(product.im, a.im, b.re);
  return product;
}

mpz_class norm(const Vector& x) {
  mpz_class sum = 0;
  for (const mpz_class& c : x) sum += abs(c);
  return sum;
}

mpq_class rounded_up(const mpq_class& x) {
  const mpz_class one = mpz_class(1) << error_bits;
  return ratio(ceiling(x * one), one);
}

std::vector<Vector> read_seed(const ExactRadius& radius, std::size_t n, const mpz_class& scale,
                              const std::function<Vector(const Vector&)>& around, Reader& reader,
                              Arithmetic& arithmetic) {
  const Vector& p = radius.polynomial;
  const std::size_t degree = p.size() - 1;
  Vector seed;
  for (const std::string_view field : reader.take("seed", n, n)) seed.push_back(parse_integer(field));
  // The matrix of the cycle is N / scale, and the zeros of sum p_k scale^(degree - k) x^k are those of p times scale.
  power(scale, degree);  // not too large
  std::vector<Vector> basis(degree, Vector(n));
  for (std::size_t i = 0; i < n; ++i) basis[degree - 1][i] = p[degree] * seed[i];
  mpz_class factor = scale;
  for (std::size_t k = degree; k-- > 0; factor *= scale) {
    Vector next = around(basis[k]);
    const mpz_class coefficient = p[k] * factor;
    for (std::size_t i = 0; i < n; ++i) arithmetic.add_product(next[i], coefficient, seed[i]);
    if (k > 0)
      basis[k - 1] = std::move(next);
    else
      require(norm(next) == 0, "the polynomial of the cycle does not vanish on the seed");
  }
  return basis;
}

Eigenvector eigenvector_of(const ExactRadius& radius, const std::vector<Vector>& basis, const mpz_class& scale,
                           Arithmetic& arithmetic) {
  const std::size_t degree = basis.size(), n = basis[0].size();
  Eigenvector result{std::vector<Complex>(n), 0};
  const ComplexRatio at(radius.near_re * scale, radius.near_im * scale);
  const mpq_class away = radius.error * scale,
                  size = (abs(radius.near_re) + abs(radius.near_im) + radius.error) * scale;
  mpz_class whole = 1;  // at.scale^(degree - 1) in the end
  for (std::size_t k = degree; k-- > 0; whole *= k > 0 ? at.scale : mpz_class(1))
    for (std::size_t i = 0; i < n; ++i) {
      result.point[i] = times(result.point[i], at.point, arithmetic);
      arithmetic.add_product(result.point[i].re, basis[k][i], whole);
    }
  mpq_class slope = 0, powers = 1;
  for (std::size_t k = 1; k < degree; ++k, powers = rounded_up(powers * size))
    slope += mpz_class(k * norm(basis[k])) * powers;
  result.error = 2 * away * slope * whole;
  return result;
}

Eigenvector over_field(const Eigenvector& parts, const mpz_class& root) {
  const std::size_t n = parts.point.size() / 2;
  const mpz_class near = scaled_root(root);
  Eigenvector result{{}, mpz_class(root << root_bits) * parts.error};  // of the p once, of the q sqrt(root) times
  for (std::size_t i = 0; i < n; ++i) {
    const Complex &p = parts.point[i], &q = parts.point[n + i];
    result.point.push_back({(p.re << root_bits) + q.re * near, (p.im << root_bits) + q.im * near});
    result.error += norm(q);
  }
  return result;
}

ExactRadius parse_exact_radius(std::string_view text) {
  constexpr const char* expected = "an exact radius is |[p0,p1,...]@RE,IM,EPS|^1/L";
  const std::size_t end = text.find("]@"), power = text.rfind("|^1/");
  require(text.starts_with("|[") && end < power && power < text.size(), expected);
  const Fields point = split(text.substr(end + 2, power - end - 2), ",");
  require(point.size() == 3, expected);
  ExactRadius radius;
  for (const std::string_view c : split(text.substr(2, end - 2), ",")) radius.polynomial.push_back(parse_integer(c));
  const std::size_t degree = radius.polynomial.size() - 1;
  require(degree >= 1 && degree <= most_degree && radius.polynomial.back() != 0,
          "a polynomial has the degree 1 to 256 and a leading coefficient that is not zero");
  radius.re = parse_rational(point[0]);
  radius.im = parse_rational(point[1]);
  radius.within = parse_rational(point[2]);
  require(radius.within > 0, "the distance of a zero must be positive");
  radius.length = parse_size(text.substr(power + 4), 1, most_letters);
  return radius;
}

ExactRadius parse_attained(const Fields& fields) {
  ExactRadius result;
  result.letters = parse_letters(fields[0]);
  result.low = parse_rational(fields[1]);
  result.high = parse_rational(fields[2]);
  require(result.low > 0 && result.high > 0, "the bounds of the radius are not positive");
  return result;
}

std::vector<std::size_t> parse_letters(std::string_view text) {
  std::vector<std::size_t> letters;
  for (const std::string_view letter : split(text, ",")) letters.push_back(parse_size(letter, 0, 15));
  require(letters.size() <= most_letters, "a product of more than 1000 letters");
  return letters;
}

void read_root(ExactRadius& radius, Reader& reader, Arithmetic& arithmetic) {
  const Fields fields = reader.take("root", 5, 5);
  mpq_class* const numbers[] = {&radius.near_re, &radius.near_im, &radius.error, &radius.low, &radius.high};
  for (std::size_t k = 0; k < 5; ++k) *numbers[k] = parse_rational(fields[k]);
  const auto squared = [](const mpq_class& x) { return mpq_class(x * x); };
  const mpq_class &error = radius.error, low = power(radius.low, radius.length),
                  high = power(radius.high, radius.length);
  require(error >= 0 && radius.low > 0 && radius.high > 0,
          "the error of a root is negative, or its modulus not positive");
  const mpq_class away = squared(radius.near_re - radius.re) + squared(radius.near_im - radius.im);
  require(error <= radius.within && away <= squared(radius.within - error), "the root is not the one of the claim");
  require(lies_between(radius.near_re, radius.near_im, error, low, high), wrong_bounds);
  // A zero within n |p/p'| of the point.
  const Vector &p = radius.polynomial, slope = derivative(p);
  const ComplexRatio near(radius.near_re, radius.near_im), centre(radius.re, radius.im);
  const mpz_class value = squared_modulus(form_value(p, near, arithmetic)),
                  steep = squared_modulus(form_value(slope, near, arithmetic));
  require(steep > 0 && square(mpz_class(slope.size())) * value <= squared(error * near.scale) * steep,
          "no zero is proved so near");
  // Only one: |p'(x) - p'(centre)| < |p'(centre)| for all x of the disc.
  const mpq_class size = abs(radius.re) + abs(radius.im) + radius.within;
  mpq_class change = 0;
  for (std::size_t k = p.size(); k-- > 2;) change = rounded_up(change * size) + abs(mpz_class(p[k] * k * (k - 1)));
  const mpq_class steepness = ratio(squared_modulus(form_value(slope, centre, arithmetic)),
                                    power(centre.scale, 2 * (slope.size() - 1)).get_num());
  require(squared(change * radius.within) < steepness, "more than one zero may be so near");
}

}  // namespace subcert_check
