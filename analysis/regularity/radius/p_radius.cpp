#include "p_radius.hpp"

#include "cost.hpp"

#include <subcert/analysis/symbol/error.hpp>

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

}  // namespace

bool has_p_radius(const MatrixFamily& family, int p) { return p % 2 == 0 || is_nonnegative(family); }

std::optional<PRadius> p_radius(const MatrixFamily& family, int p, int bits, const Deadline& deadline) {
  require(p >= 1 && p <= largest_power, "p_radius: need 1 <= p <= {}, got {}", largest_power, p);
  require(has_p_radius(family, p), "p_radius: need an even p, or matrices without negative entries, got p = {}", p);
  if (count_of_forms(family.size(), p) > most_forms)
    fail(ErrorKind::size, "p_radius: need at most {} forms of degree p, got matrices of size {} and p = {}", most_forms,
         family.size(), p);
  const auto forms = operator_on_forms(family, p, deadline);
  if (!forms) return std::nullopt;
  const auto characteristic = characteristic_polynomial(*forms, deadline);
  if (!characteristic || !radius::has_time_for_roots(*characteristic, deadline)) return std::nullopt;
  const Enclosure sum = largest_root_modulus(*characteristic, bits).largest;
  const Rational count(static_cast<long>(family.count()));
  return PRadius{{root_enclosure(*sum.lower / count, p, bits).lower, root_enclosure(*sum.upper / count, p, bits).upper},
                 forms->rows()};
}

}  // namespace subcert
