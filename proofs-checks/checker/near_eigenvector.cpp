#include "near_eigenvector.hpp"

#include <algorithm>

namespace subcert_check {
namespace {

/// |x|_1, or of a square matrix, column by column.
mpz_class norm_of(const Vector& columns, std::size_t size) {
  mpz_class largest = 0;
  for (std::size_t begin = 0; begin < columns.size(); begin += size) {
    mpz_class sum = 0;
    for (std::size_t i = begin; i < begin + size; ++i) sum += abs(columns[i]);
    largest = std::max(largest, sum);
  }
  return largest;
}

/// Of the equations for an eigenvalue and an eigenvector: the derivative at the given ones, and what is left there.
struct System {
  Vector derivative, rest;  // over `one`
  mpz_class one;
};

System system_of(const NearProduct& p, Arithmetic& arithmetic) {
  const std::size_t n = p.vector.size(), m = n + 1;
  const mpz_class q = p.eigenvalue.get_den(), whole = p.scale * q;
  System system{Vector(m * m), {}, whole * p.vertex_one};
  Vector less = p.matrix;  // the product less the eigenvalue, over `whole`
  for (mpz_class& x : less) x *= q;
  for (std::size_t i = 0; i < n; ++i) less[i * n + i] -= p.eigenvalue.get_num() * p.scale;
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < n; ++i) system.derivative[k * m + i] = less[k * n + i] * p.vertex_one;
  for (std::size_t i = 0; i < n; ++i) system.derivative[n * m + i] = p.vector[i] * -whole;
  system.derivative[p.kept * m + n] = system.one;
  system.rest = arithmetic.multiply(less, p.vector, n);
  system.rest.emplace_back(0);
  return system;
}

}  // namespace

mpq_class distance_to_eigenvector(const NearProduct& p, Reader& reader, Arithmetic& arithmetic) {
  const std::size_t m = p.vector.size() + 1;
  const mpz_class unit = mpz_class(1) << parse_size(reader.take("inverse", 1, 1)[0], 0, 4096);
  Vector inverse;
  for (std::size_t k = 0; k < m; ++k)
    for (const std::string_view field : reader.take("column " + std::to_string(k), m, m))
      inverse.push_back(parse_integer(field));
  const System system = system_of(p, arithmetic);
  const mpz_class one = system.one * unit;
  Vector unity = arithmetic.multiply(inverse, system.derivative, m);
  for (std::size_t i = 0; i < m; ++i) unity[i * m + i] -= one;
  const mpz_class length = norm_of(p.vector, p.vector.size());
  const mpq_class size = ratio(norm_of(inverse, m), unit), moved = size * p.error,
                  contraction = few_digits_up(ratio(norm_of(unity, m), one) + moved),
                  step = few_digits_up(ratio(norm_of(arithmetic.multiply(inverse, system.rest, m), m), one) +
                                       moved * ratio(length, p.vertex_one)),
                  rest = 1 - contraction;
  require(rest > 0 && 6 * size * step < rest * rest, "no eigenvector is proved near the first vertex of the cycle");
  return 2 * step / rest;
}

}  // namespace subcert_check
