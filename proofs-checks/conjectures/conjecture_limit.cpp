#include "conjecture_limit.hpp"

#include <subcert/proofs-checks/theorems/limit_constant.hpp>

namespace subcert::conjectures {
namespace {

constexpr int largest_degree = 99;
constexpr int constant_digits = 25;

Enclosure deviation_of(const CertifiedMaximum& maximum, const Enclosure& constant) {
  Enclosure result;
  if (maximum.value.lower) result.lower = maximum.n * *maximum.value.lower / *constant.upper - 1;
  if (maximum.value.upper) result.upper = maximum.n * *maximum.value.upper / *constant.lower - 1;
  return result;
}

}  // namespace

std::optional<LimitComparison> limit_comparison(int degree, const std::vector<CertifiedMaximum>& maxima) {
  if (degree > largest_degree) return std::nullopt;
  LimitComparison result;
  result.degree = degree;
  result.constant = theorems::limit_constant(degree, constant_digits);
  for (const CertifiedMaximum& maximum : maxima)
    result.deviation.push_back({maximum.n, deviation_of(maximum, result.constant)});
  if (maxima.size() < 2) return result;
  const CertifiedMaximum& half = result.deviation[rate_start(maxima)];
  result.rate_from = half.n;
  result.exponent = decay_exponent(half.n, half.value, result.deviation.back().n, result.deviation.back().value);
  return result;
}

std::string LimitComparison::sentence() const {
  std::string text = "the proved limit of n max psi for n to infinity is C_" + std::to_string(degree) + " = " +
                     to_decimal(*constant.lower, 22, Rounding::down) + "...; n max psi / C_" + std::to_string(degree) +
                     " - 1 is " + shown(deviation.back().value) + " at n = " + std::to_string(deviation.back().n);
  if (exponent && exponent->is_bounded())
    text += " and falls like n^-r with r = " + shown(*exponent) + " from n = " + std::to_string(rate_from) + " on";
  return text + ".";
}

}  // namespace subcert::conjectures
