#include "product.hpp"

#include <algorithm>

namespace subcert_check {
namespace {

/// The integer matrix is within `error` of `scale` times the product, in the norm of the largest column sum,
/// |re| + |im|; c = x + i y is `scale` times the given eigenvalue.
struct ScaledProduct {
  Family product;
  mpz_class x, y;
  mpq_class scale, error;

  std::size_t size() const { return product.size; }
};

ScaledProduct scaled(const Family& family, const GivenProduct& given, const mpq_class& entry_error,
                     Arithmetic& arithmetic) {
  const std::size_t n = family.size, length = given.letters.size();
  const mpz_class q = lcm(given.re.get_den(), given.im.get_den());
  const mpq_class scale = power(family.denominator, length).get_num() * q;
  Vector product(n * n);
  for (std::size_t i = 0; i < n; ++i) product[i * n + i] = q;
  for (std::size_t i = length; i-- > 0;) product = arithmetic.multiply(family.matrix(given.letters[i]), product, n);
  return {{n, product, 1},
          mpq_class(given.re * scale).get_num(),
          mpq_class(given.im * scale).get_num(),
          scale,
          change_of(family, entry_error, length) * scale};
}

/// With fewer digits, which is one more error.
void shorten(ScaledProduct& p) {
  std::size_t most = 0;
  for (const mpz_class& entry : p.product.entries) most = std::max(most, bits(entry));
  const std::size_t cut = most - std::min(most, 256 + 40 * p.size());
  for (mpz_class& entry : p.product.entries) entry >>= cut;
  p.x >>= cut, p.y >>= cut;
  p.scale /= mpz_class(1) << cut;
  if (cut > 0) p.error = p.error / (mpz_class(1) << cut) + mpz_class(p.size());
}

mpz_class square(const mpz_class& a, const mpz_class& b) { return a * a + b * b; }

mpq_class bound_by_polynomial(const ScaledProduct& p, Arithmetic& arithmetic) {
  const std::size_t n = p.size();
  // The characteristic polynomial, highest coefficient first; by Horner's scheme its value and derivative at c.
  mpz_class coefficient = 1;
  const Vector times_c{p.x, p.y, -p.y, p.x};
  Vector m(n * n), state{1, 0, 0, 0};  // real and imaginary part of the value, then of the derivative
  for (std::size_t k = 1; k <= n; ++k) {
    mpz_class trace = 0;
    for (std::size_t i = 0; i < n; ++i) m[i * n + i] += coefficient;
    m = arithmetic.multiply(p.product.entries, m, n);
    for (std::size_t i = 0; i < n; ++i) trace += m[i * n + i];
    coefficient = -trace / k;
    Vector next = arithmetic.multiply(times_c, state, 2);
    next[0] += coefficient;
    for (std::size_t part = 0; part < 2; ++part) next[2 + part] += state[part];
    state = next;
  }
  const mpz_class values = square(state[0], state[1]) * n * n, slopes = square(state[2], state[3]);
  require(slopes != 0, "the characteristic polynomial has derivative 0 at the given eigenvalue");
  const mpz_class modulus = sqrt(mpz_class(square(p.x, p.y) << 640));
  mpz_class distance = sqrt(mpz_class((values << 640) / slopes)) + (values == 0 ? 0 : 1);
  if (p.error > 0) {
    // The changes of the characteristic polynomial and of its derivative.
    const mpq_class column = largest_column_sum(p.product) + sqrt(square(p.x, p.y)) + 1, factor(mpz_class(n) << 320);
    const mpz_class steep = sqrt(mpz_class((slopes << 640))) -
                            ceiling(change_of_product(column, p.error, n - 1) * factor),
                    value = sqrt(mpz_class(values << 640)) + 1 +
                            ceiling(change_of_product(column, p.error, n) * factor);
    require(steep > 0, "the product proves nothing of rounded masks");
    distance = (value << 320) / steep + 1;
  }
  return (modulus - distance) / (p.scale * (mpz_class(1) << 320));
}

/// By an approximate inverse X of c - P, P the product. The eigenvalue is real if `parts` is 1.
mpq_class bound_by_inverse(const ScaledProduct& p, std::size_t parts, Reader& reader, Arithmetic& arithmetic) {
  const std::size_t n = p.size();
  const mpz_class unit = mpz_class(1) << parse_size(reader.take("inverse", 1, 1)[0], 0, 4096);
  // (c - P) X is a part of 1/(scale * unit) of the integers below.
  const mpq_class whole = p.scale * unit;
  mpz_class largest = 0, farthest = 0, traces[2];
  for (std::size_t k = 0; k < n; ++k) {
    const Fields fields = reader.take("column " + std::to_string(k), parts * n, parts * n);
    Vector re(n), im(n);
    for (std::size_t i = 0; i < n; ++i) re[i] = parse_integer(fields[i]);
    for (std::size_t i = 0; parts == 2 && i < n; ++i) im[i] = parse_integer(fields[n + i]);
    const Vector moved_re = arithmetic.multiply(p.product.entries, re, n),
                 moved_im = arithmetic.multiply(p.product.entries, im, n);
    mpz_class size = 0, away = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const mpz_class real = p.x * re[i] - p.y * im[i] - moved_re[i],
                      imaginary = p.x * im[i] + p.y * re[i] - moved_im[i];
      away += abs(mpz_class((i == k ? whole.get_num() : mpz_class(0)) - whole.get_den() * real)) +
              abs(mpz_class(whole.get_den() * imaginary));
      size += abs(re[i]) + abs(im[i]);
    }
    traces[0] += re[k], traces[1] += im[k];
    largest = std::max(largest, size), farthest = std::max(farthest, away);
  }
  const mpq_class size = ratio(largest, unit), off = ratio(farthest, whole.get_num()) + p.error / p.scale * size;
  require(off < 1, "the inverse is none of the product less the given eigenvalue");
  const auto modulus = [](const mpz_class& a, const mpz_class& b) {
    return ratio(sqrt(mpz_class(square(a, b) << 640)), mpz_class(1) << 320);
  };
  const mpq_class steep = modulus(traces[0], traces[1]) / unit - mpz_class(n) * size * off / (1 - off);
  require(steep > 0, "the inverse proves no eigenvalue near the given one");
  return modulus(p.x, p.y) / p.scale - mpz_class(n) / steep;
}

/// The largest 1-norm of product * x over all products of this many matrices.
mpz_class largest_norm(const Family& family, const Vector& x, std::size_t level, Arithmetic& arithmetic) {
  mpz_class largest = 0;
  for (std::size_t t = 0; level > 0 && t < family.count(); ++t)
    largest = std::max(
        largest, largest_norm(family, arithmetic.multiply(family.matrix(t), x, family.size), level - 1, arithmetic));
  for (std::size_t i = 0; level == 0 && i < x.size(); ++i) largest += abs(x[i]);
  return largest;
}

}  // namespace

mpq_class spectral_radius_bound(const Family& family, const GivenProduct& given, const mpq_class& entry_error,
                                Reader& reader, Arithmetic& arithmetic) {
  ScaledProduct product = scaled(family, given, entry_error, arithmetic);
  const bool by_inverse = reader.at("inverse");
  if (entry_error > 0 || by_inverse) shorten(product);
  const mpq_class bound = by_inverse ? bound_by_inverse(product, given.im == 0 ? 1 : 2, reader, arithmetic)
                                     : bound_by_polynomial(product, arithmetic);
  require(bound > 0, "the product proves no positive spectral radius");
  return bound;
}

mpq_class norm_of_products(const Family& family, std::size_t level, std::size_t columns, Arithmetic& arithmetic) {
  const std::size_t n = family.size;
  require(power(family.count(), level) * columns * n * n * 20 <= max_work, too_much_work);
  mpz_class largest = 0;
  for (std::size_t k = 0; k < columns; ++k) {
    Vector unit(n);
    unit[k] = 1;
    largest = std::max(largest, largest_norm(family, unit, level, arithmetic));
  }
  return ratio(largest, power(family.denominator, level).get_num());
}

}  // namespace subcert_check
