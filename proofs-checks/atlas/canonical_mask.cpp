#include "canonical_mask.hpp"

#include "canonical_surface.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/proofs-checks/certificates/identity.hpp>
#include <subcert/schemes/specification.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace subcert::atlas {
namespace {

constexpr std::size_t digits_of_id = 12;

/// The k with base^k = number; 0 where there is none.
int exponent_of(int number, int base) {
  int k = 0;
  for (; number % base == 0; number /= base) ++k;
  return number == 1 ? k : 0;
}

/// Symbol of several steps.
LaurentPolynomial iterated(const LaurentPolynomial& symbol, int arity, int steps) {
  LaurentPolynomial product(1);
  for (long n = 0, power = 1; n < steps; ++n, power *= arity) product *= symbol.dilated(power);
  return product;
}

/// The b with b_0 = 1 and length n of which `steps` give a sequence that begins as the coefficients divided by the
/// first one. With P_1 = b, P_l(z) = b(z) P_(l-1)(z^m) the coefficient a_j is b_j and products of earlier ones.
std::vector<Rational> formal_root(const std::vector<Rational>& coefficients, int arity, int steps, std::size_t length) {
  const auto m = static_cast<std::size_t>(arity);
  std::vector<std::vector<Rational>> products(static_cast<std::size_t>(steps) - 1);  // P_1, ..., P_(steps-1)
  std::vector<Rational>& b = products.front();
  const auto sum = [&](const std::vector<Rational>& inner, std::size_t j, std::size_t first) {
    Rational total = 0;
    for (std::size_t u = first; u * m <= j; ++u) total += b[j - u * m] * inner[u];
    return total;
  };
  for (std::size_t j = 0; j < length; ++j) {
    Rational next = coefficients[j] / coefficients.front();
    if (j > 0) next -= sum(products.back(), j, 1);
    b.push_back(next);
    for (std::size_t l = 1; l < products.size(); ++l) products[l].push_back(sum(products[l - 1], j, 0));
  }
  return b;
}

}  // namespace

std::optional<Mask> root_of(const Mask& mask, int arity) {
  require(arity >= 2, "root_of: need arity >= 2, got {}", arity);
  const int steps = exponent_of(mask.arity(), arity);
  const LaurentPolynomial& symbol = mask.symbol();
  const long span = symbol.length() - 1, parts = (mask.arity() - 1) / (arity - 1);
  if (steps < 2 || span % parts != 0 || symbol(1) != mask.arity()) return std::nullopt;
  const std::vector<Rational> root = formal_root(symbol.coefficients(), arity, steps,
                                                 static_cast<std::size_t>(span / parts) + 1);
  Rational sum = 0;
  for (const Rational& one : root) sum += one;
  if (sum == 0) return std::nullopt;
  const LaurentPolynomial b = LaurentPolynomial(root, 0) * LaurentPolynomial(Rational(arity) / sum);
  if (b.is_zero() || iterated(b, arity, steps) != symbol.shifted(-symbol.lowest())) return std::nullopt;
  return Mask(b, arity);
}

Mask canonical_mask(const Mask& mask) {
  const Mask root = [&] {
    for (int arity = 2; arity * arity <= mask.arity(); ++arity)
      if (exponent_of(mask.arity(), arity) >= 2)
        if (auto found = root_of(mask, arity)) return *found;
    return mask;
  }();
  const LaurentPolynomial forward = root.symbol().shifted(-root.symbol().lowest()), mirrored = forward.reversed();
  const LaurentPolynomial backward = mirrored.shifted(-mirrored.lowest());
  return {forward.coefficients() <= backward.coefficients() ? forward : backward, root.arity()};
}

LatticeMask canonical_mask(const LatticeMask& mask) {
  return mask.dimension() == 1 ? LatticeMask(canonical_mask(mask.curve())) : canonical_surface(mask);
}

std::string mask_text(const LatticeMask& canonical) {
  const Dilation& dilation = canonical.dilation();
  const int factor = dilation.factor().value_or(0);
  return (canonical.dimension() == 1 ? "mask:" + canonical.curve().symbol().to_mask_text()
                                     : "mask2:" + to_mask_text(canonical)) +
         (factor == 2  ? ""
          : factor > 2 ? fmt::format(",arity={}", factor)
                       : ",dilation=" + dilation.to_text());
}

std::string entry_id(const LatticeMask& canonical) { return content_id(mask_text(canonical)).substr(0, digits_of_id); }

bool is_entry_id(const std::string& text) {
  return text.size() == digits_of_id && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

}  // namespace subcert::atlas
