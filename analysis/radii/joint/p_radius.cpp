#include "p_radius.hpp"

#include "block_triangular.hpp"
#include "cost.hpp"

#include <subcert/analysis/radii/schedule.hpp>
#include <subcert/analysis/symbol/polynomials/root_modulus.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <map>

namespace subcert {
namespace {

constexpr std::size_t most_forms = 256;
constexpr int largest_power = 64;

using Exponents = std::vector<int>;
using Form = std::map<Exponents, Rational>;

/// The number of monomials of degree p in n variables, or more than most_forms.
std::size_t count_of_forms(std::size_t n, int p) {
  std::size_t count = 1;
  for (std::size_t k = 1; k < n && count <= most_forms; ++k) count = count * (static_cast<std::size_t>(p) + k) / k;
  return count;
}

Form times_linear(const Form& form, const RationalMatrix& matrix, std::size_t row) {
  Form result;
  for (const auto& [exponents, coefficient] : form)
    for (std::size_t j = 0; j < matrix.columns(); ++j) {
      if (matrix(row, j) == 0) continue;
      Exponents next = exponents;
      ++next[j];
      result[std::move(next)] += coefficient * matrix(row, j);
    }
  return result;
}

void add_monomials(Exponents& exponents, std::size_t variable, int rest, std::map<Exponents, std::size_t>& places) {
  if (variable + 1 == exponents.size()) {
    exponents[variable] = rest;
    places.emplace(exponents, places.size());
    return;
  }
  for (int e = 0; e <= rest; ++e) {
    exponents[variable] = e;
    add_monomials(exponents, variable + 1, rest - e, places);
  }
}

/// The matrix of f -> sum of f(A x) over the family, on forms of degree p.
std::optional<RationalMatrix> operator_on_forms(const MatrixFamily& family, int p, const Deadline& deadline) {
  std::map<Exponents, std::size_t> places;
  Exponents exponents(family.size());
  add_monomials(exponents, 0, p, places);
  RationalMatrix result(places.size(), places.size());
  for (const RationalMatrix& matrix : family)
    for (const auto& [monomial, column] : places) {
      if (deadline.expired()) return std::nullopt;
      Form image{{Exponents(family.size()), 1}};
      for (std::size_t i = 0; i < monomial.size(); ++i)
        for (int k = 0; k < monomial[i]; ++k) image = times_linear(image, matrix, i);
      for (const auto& [at, coefficient] : image) result(places.at(at), column) += coefficient;
    }
  return result;
}

/// The p-th power of the p-radius, times the number of matrices, of a family that is not split.
std::optional<Enclosure> sum_of_powers(const MatrixFamily& family, int p, int bits, const Deadline& deadline) {
  if (family.size() == 1) {
    Rational sum = 0;
    for (const RationalMatrix& number : family) sum += power(abs(number(0, 0)), p);
    return Enclosure::exactly(sum);
  }
  if (count_of_forms(family.size(), p) > most_forms)
    fail(ErrorKind::size, "p_radius: need at most {} forms of degree p, got matrices of size {} and p = {}", most_forms,
         family.size(), p);
  const auto forms = operator_on_forms(family, p, deadline);
  if (!forms) return std::nullopt;
  const auto characteristic = characteristic_polynomial(*forms, deadline);
  if (!characteristic || !radius::has_time_for_roots(*characteristic, deadline)) return std::nullopt;
  return largest_root_modulus(*characteristic, bits).largest;
}

bool is_triangular(const MatrixFamily& family) {
  for (const RationalMatrix& matrix : family)
    for (std::size_t i = 0; i < matrix.rows(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (matrix(i, j) != 0) return false;
  return true;
}

/// Diagonal blocks, each of which has a formula; otherwise the family itself.
std::vector<MatrixFamily> parts_of(const MatrixFamily& family, int p, const Deadline& deadline) {
  BlockTriangular triangular{std::vector<std::size_t>(family.size(), 1), RationalMatrix(0, 0), family.matrices(), {}};
  if (!is_triangular(family)) triangular = block_triangularise(family, deadline);
  std::vector<MatrixFamily> parts;
  for (std::size_t k = 0; k < triangular.sizes.size(); ++k) parts.push_back(triangular.block(k));
  const bool known = std::ranges::all_of(
      parts, [=](const MatrixFamily& part) { return part.size() == 1 || p % 2 == 0 || is_nonnegative(part); });
  return known ? parts : std::vector{family};
}

}  // namespace

bool has_p_radius(const MatrixFamily& family, int p) {
  return p % 2 == 0 || is_nonnegative(family) || is_triangular(family);
}

std::optional<PRadius> p_radius(const MatrixFamily& family, int p, int bits, const Deadline& deadline) {
  require(p >= 1 && p <= largest_power, "p_radius: need 1 <= p <= {}, got {}", largest_power, p);
  require(has_p_radius(family, p), "p_radius: need an even p, or matrices without negative entries, got p = {}", p);
  Enclosure most = Enclosure::exactly(0);
  std::size_t size = 1;
  for (const MatrixFamily& part : parts_of(family, p, deadline.after(schedule::p_radius::splitting))) {
    const auto sum = sum_of_powers(part, p, bits, deadline);
    if (!sum) return std::nullopt;
    most = {std::max(*most.lower, *sum->lower), std::max(*most.upper, *sum->upper)};
    size = std::max(size, part.size() == 1 ? 1 : count_of_forms(part.size(), p));
  }
  const Rational count(static_cast<long>(family.count()));
  return PRadius{
      {root_enclosure(*most.lower / count, p, bits).lower, root_enclosure(*most.upper / count, p, bits).upper}, size};
}

}  // namespace subcert
