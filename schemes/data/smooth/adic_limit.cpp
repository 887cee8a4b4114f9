#include "adic_limit.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <type_traits>

namespace subcert::data {
namespace {

constexpr long most_points = 1L << 53;

std::vector<double> rounded(const std::vector<Rational>& exact) {
  std::vector<double> result;
  for (const Rational& value : exact) result.push_back(static_cast<double>(value));
  return result;
}

}  // namespace

AdicLimit::AdicLimit(const Mask& mask, int order) : arity_(mask.arity()) {
  for (; points_ <= most_points / arity_; ++digits_) points_ *= arity_;
  const Mask differences = divided_difference_scheme(mask, order);
  const LaurentPolynomial& symbol = differences.symbol();
  first_index_ = symbol.lowest();
  exact_.coefficients = symbol.coefficients();
  const Interval support = limit_support(differences);
  first_ = floor_index(support.lower);
  const LimitValues psi = limit_values(differences, 0);
  for (long k = first_; Rational(k) <= support.upper; ++k) exact_.at_integers.push_back(psi.at(k));
  exact_.differences.assign(1, 1);
  for (int k = 0; k < order; ++k) {
    exact_.differences.emplace_back(0);
    for (std::size_t j = exact_.differences.size() - 1; j > 0; --j) exact_.differences[j] -= exact_.differences[j - 1];
  }
  rounded_ = {rounded(exact_.coefficients), rounded(exact_.at_integers), rounded(exact_.differences)};
}

template <class Number>
const AdicLimit::Parts<Number>& AdicLimit::parts() const {
  if constexpr (std::is_same_v<Number, double>)
    return rounded_;
  else
    return exact_;
}

template <class Number>
std::vector<Number> AdicLimit::values(long index) const {
  require(index >= 0 && index < points_, "AdicLimit: need 0 <= index < {}, got {}", points_, index);
  const Parts<Number>& known = parts<Number>();
  const auto width = static_cast<long>(known.at_integers.size()), length = static_cast<long>(known.coefficients.size());
  std::vector<Number> psi = known.at_integers, next(psi.size());
  int left = digits_;
  while (left > 0 && index % arity_ == 0) {  // T_0 v(0) = v(0)
    index /= arity_;
    --left;
  }
  for (; left > 0; --left, index /= arity_) {
    const long digit = index % arity_;
    for (long k = 0; k < width; ++k) {
      Number sum = 0;
      // The coefficient with index digit + a (first + k) - (first + m) belongs to phi(x' + first + m).
      const long zero = digit + arity_ * (first_ + k) - first_ - first_index_;
      for (long m = std::max(0L, zero - length + 1); m < std::min(width, zero + 1); ++m)
        sum += known.coefficients[static_cast<std::size_t>(zero - m)] * psi[static_cast<std::size_t>(m)];
      next[static_cast<std::size_t>(k)] = std::move(sum);
    }
    std::swap(psi, next);
  }
  std::vector<Number> result(psi.size() + known.differences.size() - 1, Number(0));
  for (std::size_t j = 0; j < known.differences.size(); ++j)
    for (std::size_t k = 0; k < psi.size(); ++k) result[k + j] += known.differences[j] * psi[k];
  return result;
}

template std::vector<double> AdicLimit::values<double>(long) const;
template std::vector<Rational> AdicLimit::values<Rational>(long) const;

}  // namespace subcert::data
