#include "near_eigenvector.hpp"

#include <algorithm>

namespace subcert_check {
namespace {

/// Complex matrices, column by column, with as many columns as they have; `im` is empty where all is real.
struct Columns {
  Vector re, im;
};

/// a x, a square.
Columns times(const Columns& a, const Columns& x, std::size_t size, Arithmetic& arithmetic) {
  Columns product{arithmetic.multiply(a.re, x.re, size), {}};
  if (a.im.empty()) return product;
  const Vector square = arithmetic.multiply(a.im, x.im, size), other = arithmetic.multiply(a.im, x.re, size);
  product.im = arithmetic.multiply(a.re, x.im, size);
  for (std::size_t i = 0; i < square.size(); ++i) product.re[i] -= square[i], product.im[i] += other[i];
  return product;
}

/// The largest sum over a column of |re| + |im|.
mpz_class largest_column(const Columns& a, std::size_t size) {
  mpz_class largest = 0;
  for (std::size_t begin = 0; begin < a.re.size(); begin += size) {
    mpz_class sum = 0;
    for (std::size_t i = begin; i < begin + size; ++i)
      sum += abs(a.re[i]) + (a.im.empty() ? mpz_class(0) : abs(a.im[i]));
    largest = std::max(largest, sum);
  }
  return largest;
}

/// Of the system for an eigenvalue and an eigenvector: the derivative at the given ones, and what is left there.
struct System {
  Columns derivative, rest;  // over `one`; the rest is one column
  mpz_class one;
};

System system_of(const NearProduct& p, Arithmetic& arithmetic) {
  const std::size_t n = p.size, m = n + 1;
  const mpz_class q = lcm(p.re.get_den(), p.im.get_den()), whole = p.scale * q;
  const Vector c{mpq_class(p.re * whole).get_num(), mpq_class(p.im * whole).get_num()};
  Columns less{p.matrix, Vector(p.parts == 2 ? n * n : 0)};  // the product less the eigenvalue, over `whole`
  for (mpz_class& x : less.re) x *= q;
  Columns vector{{p.vector.begin(), p.vector.begin() + static_cast<std::ptrdiff_t>(n)},
                 {p.vector.begin() + static_cast<std::ptrdiff_t>(n), p.vector.end()}};
  for (std::size_t i = 0; i < n; ++i) {
    less.re[i * n + i] -= c[0];
    if (p.parts == 2) less.im[i * n + i] -= c[1];
  }
  System system{
      {Vector(m * m), Vector(p.parts == 2 ? m * m : 0)}, times(less, vector, n, arithmetic), whole * p.vertex_one};
  system.rest.re.emplace_back(0);
  if (p.parts == 2) system.rest.im.emplace_back(0);
  system.derivative.re[p.kept * m + n] = system.one;
  for (std::size_t part = 0; part < p.parts; ++part) {
    const Vector &from = part == 0 ? less.re : less.im, &x = part == 0 ? vector.re : vector.im;
    Vector& to = part == 0 ? system.derivative.re : system.derivative.im;
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = 0; i < n; ++i) to[k * m + i] = from[k * n + i] * p.vertex_one;
    for (std::size_t i = 0; i < n; ++i) to[n * m + i] = -x[i] * whole;
  }
  return system;
}

}  // namespace

mpq_class distance_to_eigenvector(const NearProduct& p, Reader& reader, Arithmetic& arithmetic) {
  const std::size_t m = p.size + 1;
  const mpz_class unit = mpz_class(1) << parse_size(reader.take("inverse", 1, 1)[0], 0, 4096);
  Columns inverse;
  for (std::size_t k = 0; k < m; ++k) {
    const Fields fields = reader.take("column " + std::to_string(k), p.parts * m, p.parts * m);
    for (std::size_t i = 0; i < fields.size(); ++i)
      (i < m ? inverse.re : inverse.im).push_back(parse_integer(fields[i]));
  }
  const System system = system_of(p, arithmetic);
  Columns unity = times(inverse, system.derivative, m, arithmetic);
  const mpz_class one = system.one * unit;
  for (std::size_t i = 0; i < m; ++i) unity.re[i * m + i] -= one;
  const mpq_class size = ratio(largest_column(inverse, m), unit), moved = size * p.error;
  mpz_class length = 0;
  for (const mpz_class& x : p.vector) length += abs(x);
  const mpq_class contraction = few_digits_up(ratio(largest_column(unity, m), one) + moved),
                  step = few_digits_up(ratio(largest_column(times(inverse, system.rest, m, arithmetic), m), one) +
                                       moved * ratio(length, p.vertex_one)),
                  rest = 1 - contraction;
  require(rest > 0 && 6 * size * step < rest * rest, "no eigenvector is proved near the first vertex of the cycle");
  return 2 * step / rest;
}

}  // namespace subcert_check
