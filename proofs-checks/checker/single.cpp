#include "single.hpp"

#include <algorithm>
#include <optional>

namespace subcert_check {
namespace {

constexpr std::size_t most_coefficients = 1000;

Vector parse_polynomial(const Fields& fields) {
  Vector result;
  std::transform(fields.begin(), fields.end(), std::back_inserter(result), parse_integer);
  return result;
}

mpz_class times(const mpz_class& x, const mpz_class& y, Arithmetic& arithmetic) {
  mpz_class product;
  arithmetic.add_product(product, x, y);
  return product;
}

mpq_class value_at(const Vector& p, const mpq_class& x, Arithmetic& arithmetic) {
  mpz_class value, scale = 1;
  for (std::size_t k = p.size(); k-- > 0; scale = times(scale, x.get_den(), arithmetic)) {
    value = times(value, x.get_num(), arithmetic);
    arithmetic.add_product(value, p[k], scale);
  }
  return ratio(times(value, x.get_den(), arithmetic), scale);
}

/// The coefficients b_-c, ..., b_c times the denominator of the family.
Vector central_symbol(const Family& family) {
  Vector b;
  for (std::size_t i = 0; i < family.count() * family.size; ++i)
    b.push_back(family.matrix(i % family.count())[i / family.count()]);
  while (b.back() == 0) b.pop_back();
  require(b.size() % 2 == 1 && std::equal(b.begin(), b.end(), b.rbegin()),
          "one spectral radius needs a symmetric mask with an odd number of coefficients");
  return b;
}

/// The coefficients of z^0, z^1, ... of p(z) p(1/z).
Vector autocorrelation(const Vector& p, Arithmetic& arithmetic) {
  Vector result(p.size());
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t k = i; k < p.size(); ++k) arithmetic.add_product(result[k - i], p[i], p[k]);
  return result;
}

/// a / p, if that has integer coefficients.
std::optional<Vector> quotient(Vector a, const Vector& p, Arithmetic& arithmetic) {
  if (a.size() < p.size()) return std::nullopt;
  Vector result(a.size() - p.size() + 1);
  for (std::size_t k = result.size(); k-- > 0;) {
    const mpz_class& top = a[k + p.size() - 1];
    if (top % p.back() != 0) return std::nullopt;
    result[k] = top / p.back();
    const mpz_class factor = -result[k];
    for (std::size_t i = 0; i < p.size(); ++i) arithmetic.add_product(a[k + i], factor, p[i]);
  }
  if (std::any_of(a.begin(), a.end(), [](const mpz_class& x) { return x != 0; })) return std::nullopt;
  return result;
}

/// Divides by p as often as that goes.
std::size_t divide_out(Vector& a, const Vector& p, Arithmetic& arithmetic) {
  std::size_t times = 0;
  for (auto next = quotient(a, p, arithmetic); next; next = quotient(a, p, arithmetic), ++times) a = std::move(*next);
  return times;
}

/// At least as many as p has zeros that are `from` or more, each counted as often as it occurs; `above`: only more.
std::size_t count_zeros(const Vector& p, const mpq_class& from, bool above, Arithmetic& arithmetic) {
  Vector shifted = p;  // the coefficients of p(x + from), times positive numbers
  mpz_class scale = 1;
  for (std::size_t k = shifted.size(); k-- > 0; scale = times(scale, from.get_den(), arithmetic))
    shifted[k] = times(shifted[k], scale, arithmetic);
  for (std::size_t i = 0; i < shifted.size(); ++i)
    for (std::size_t k = shifted.size() - 1; k-- > i;)
      arithmetic.add_product(shifted[k], from.get_num(), shifted[k + 1]);
  const auto first = std::find_if(shifted.begin(), shifted.end(), [](const mpz_class& x) { return x != 0; });
  std::size_t count = above ? 0 : static_cast<std::size_t>(first - shifted.begin());
  int sign = sgn(*first);
  for (auto x = first; x != shifted.end(); ++x)
    if (sgn(*x) * sign < 0) ++count, sign = -sign;
  return count;
}

/// P and r of theorem 27.
class RadiusRecurrence {
 public:
  RadiusRecurrence(const Family& family, Reader& reader, Arithmetic& arithmetic) : arithmetic_(arithmetic) {
    const Vector b = central_symbol(family);
    polynomial_ = parse_polynomial(reader.take("recurrence", 2, most_coefficients));
    require(polynomial_.back() != 0, "the last coefficient of a recurrence is 0");
    // C times the denominator of the family.
    const std::size_t centre = b.size() / 2, size = centre / (family.count() - 1) + 1, degree = polynomial_.size() - 1;
    const auto coefficient = [&](std::size_t i) { return i <= centre ? b[centre + i] : mpz_class(0); };
    Vector matrix;
    for (std::size_t k = 0; k < size; ++k)
      for (std::size_t at = 0; at < family.count() * size; at += family.count()) {
        matrix.push_back(coefficient(at + k));
        if (k > 0) matrix.back() += coefficient(at > k ? at - k : k - at);
      }
    Vector scales{1};  // powers of the denominator
    for (std::size_t k = 0; k < degree; ++k) scales.push_back(times(scales.back(), family.denominator, arithmetic));
    Vector sum(size), power(size);
    power[0] = 1;
    numerator_.resize(degree);
    for (std::size_t k = 0;; ++k) {
      const mpz_class factor = times(polynomial_[k], scales[degree - k], arithmetic);
      for (std::size_t i = 0; i < size; ++i) arithmetic.add_product(sum[i], factor, power[i]);
      if (k == degree) break;
      const mpz_class moment = times(power[0], scales[degree - 1 - k], arithmetic);
      for (std::size_t j = 0; j < degree - k; ++j)
        arithmetic.add_product(numerator_[j], polynomial_[j + 1 + k], moment);
      power = arithmetic.multiply(matrix, power, size);
    }
    require(std::all_of(sum.begin(), sum.end(), [](const mpz_class& x) { return x == 0; }), "the recurrence is wrong");
  }

  bool has_zeros_above(const mpq_class& bound) const { return count_zeros(polynomial_, bound, true, arithmetic_) > 0; }

  /// The order of the pole that is the joint spectral radius, less 1.
  std::size_t power_of(const ExactRadius& exact) const {
    require(exact.length == 1 && exact.im == 0 && exact.near_im == 0 && exact.near_re > 0,
            "one spectral radius is a positive zero");
    Vector denominator = polynomial_, numerator = numerator_;
    const std::size_t zeros = divide_out(denominator, exact.polynomial, arithmetic_),
                      lost = divide_out(numerator, exact.polynomial, arithmetic_);
    require(zeros > lost && count_zeros(polynomial_, exact.low, false, arithmetic_) == zeros,
            "the exact radius may not be the largest zero of the recurrence");
    Vector slopes;
    for (std::size_t k = 1; k < numerator.size(); ++k) slopes.push_back(abs(mpz_class(numerator[k] * k)));
    require(abs(value_at(numerator, exact.near_re, arithmetic_)) >
                exact.error * value_at(slopes, exact.near_re + exact.error, arithmetic_),
            "the exact radius may be no pole");
    return zeros - lost - 1;
  }

 private:
  Arithmetic& arithmetic_;
  Vector polynomial_, numerator_;
};

}  // namespace

SingleRadius read_single(const Family& family, const Fields& fields, const ExactRadius* exact, Reader& reader,
                         Arithmetic& arithmetic) {
  require(fields.size() == 3, "expected 'single', a bound and the digits of a factor");
  const mpq_class bound = parse_rational(fields[1]);
  require(bound >= 0, "the bound of a radius is negative");
  const std::size_t digits = parse_size(fields[2], 0, 4096);
  Vector b = central_symbol(family);
  mpz_class common = family.denominator;
  for (const mpz_class& x : b) common = gcd(common, x);
  for (mpz_class& x : b) x /= common;

  const Vector half = autocorrelation(parse_polynomial(reader.take("square", 1, most_coefficients)), arithmetic);
  Vector square(half.rbegin(), half.rend());
  square.insert(square.end(), half.begin() + 1, half.end());
  require(square.back() != 0, "a polynomial of squares begins or ends with 0");
  const auto rest = quotient(b, square, arithmetic);
  require(rest.has_value(), "the square does not divide the mask");

  const Vector factor = autocorrelation(parse_polynomial(reader.take("factor", 1, most_coefficients)), arithmetic);
  const std::size_t middle = rest->size() / 2;
  mpz_class margin = 0;
  for (std::size_t i = 0; i <= std::max(middle, factor.size() - 1); ++i) {
    mpz_class error = i <= middle ? mpz_class((*rest)[middle + i] << 2 * digits) : mpz_class(0);
    if (i < factor.size()) error -= factor[i];
    margin += i == 0 ? error : mpz_class(-2 * abs(error));
  }
  require(margin >= 0, "the cosine polynomial is not shown to be a sum of squares");

  const RadiusRecurrence recurrence(family, reader, arithmetic);
  require(!recurrence.has_zeros_above(bound), "the recurrence may have a zero above the bound");
  return {bound, exact ? recurrence.power_of(*exact) : 0};
}

std::size_t read_power(const Family& family, const ExactRadius& exact, Reader& reader, Arithmetic& arithmetic) {
  return RadiusRecurrence(family, reader, arithmetic).power_of(exact);
}

}  // namespace subcert_check
