#include "laurent_polynomial.hpp"

#include <subcert/analysis/symbol/numbers/flint.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include "expression.hpp"
#include "term_text.hpp"

#include <utility>

namespace subcert {

/// A FLINT polynomial (integers over one reduced denominator) and the exponent of its constant term.
struct LaurentPolynomial::Impl {
  fmpq_poly_t poly;
  long shift = 0;

  Impl() { fmpq_poly_init(poly); }
  Impl(const Impl& other) : shift(other.shift) {
    fmpq_poly_init(poly);
    fmpq_poly_set(poly, other.poly);
  }
  Impl& operator=(const Impl&) = delete;
  ~Impl() { fmpq_poly_clear(poly); }

  long length() const { return fmpq_poly_length(poly); }

  /// Moves low zeros of the polynomial into the shift.
  void canonicalise() {
    const long n = length();
    long zeros = 0;
    while (zeros < n && fmpz_is_zero(poly->coeffs + zeros)) ++zeros;
    if (zeros == n) {
      shift = 0;
    } else if (zeros > 0) {
      fmpq_poly_shift_right(poly, poly, zeros);
      shift += zeros;
    }
  }
};

namespace {

constexpr long max_length = 100'000'000;

void require_nonzero(bool zero, const char* what) {
  if (zero) fail(ErrorKind::domain, "{}: need a non-zero polynomial, got 0", what);
}

}  // namespace

LaurentPolynomial::LaurentPolynomial() : impl_(std::make_unique<Impl>()) {}
LaurentPolynomial::LaurentPolynomial(const LaurentPolynomial& other) : impl_(std::make_unique<Impl>(*other.impl_)) {}
LaurentPolynomial::LaurentPolynomial(LaurentPolynomial&& other) noexcept = default;
LaurentPolynomial& LaurentPolynomial::operator=(const LaurentPolynomial& other) {
  if (this != &other) impl_ = std::make_unique<Impl>(*other.impl_);
  return *this;
}
LaurentPolynomial& LaurentPolynomial::operator=(LaurentPolynomial&& other) noexcept = default;
LaurentPolynomial::~LaurentPolynomial() = default;

LaurentPolynomial::LaurentPolynomial(const Rational& constant) : LaurentPolynomial() {
  fmpq_poly_set_fmpq(impl_->poly, flint::Quotient(constant).get());
}

LaurentPolynomial::LaurentPolynomial(const std::vector<Rational>& coefficients, long lowest) : LaurentPolynomial() {
  Integer common = 1;
  for (const Rational& c : coefficients) common = lcm(common, subcert::denominator(c));
  fmpz_poly_t numerators;
  fmpz_poly_init2(numerators, static_cast<slong>(coefficients.size()));
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    const Integer scaled = numerator(coefficients[i]) * (common / subcert::denominator(coefficients[i]));
    fmpz_poly_set_coeff_fmpz(numerators, static_cast<slong>(i), flint::Whole(scaled).get());
  }
  fmpq_poly_set_fmpz_poly(impl_->poly, numerators);
  fmpz_poly_clear(numerators);
  fmpq_poly_scalar_div_fmpz(impl_->poly, impl_->poly, flint::Whole(common).get());
  impl_->shift = lowest;
  impl_->canonicalise();
}

LaurentPolynomial LaurentPolynomial::monomial(const Rational& coefficient, long exponent) {
  return LaurentPolynomial(std::vector<Rational>{coefficient}, exponent);
}

LaurentPolynomial LaurentPolynomial::all_ones(int count) {
  require(count >= 1, "all_ones: need count >= 1, got {}", count);
  return LaurentPolynomial(std::vector<Rational>(static_cast<std::size_t>(count), 1), 0);
}

LaurentPolynomial LaurentPolynomial::parse(std::string_view text) {
  return in_one_letter(MultivariatePolynomial::parse(text, 1));
}

LaurentPolynomial LaurentPolynomial::parse_mask(std::string_view text) {
  const text::MaskText parts = text::parse_mask_text(text, 1);
  return LaurentPolynomial(parts.coefficients, parts.first ? parts.first->front() : 0);
}

bool LaurentPolynomial::is_zero() const { return impl_->length() == 0; }

bool LaurentPolynomial::is_canonical() const {
  if (!fmpq_poly_is_canonical(impl_->poly)) return false;
  return is_zero() ? impl_->shift == 0 : !fmpz_is_zero(impl_->poly->coeffs);
}

long LaurentPolynomial::lowest() const {
  require_nonzero(is_zero(), "lowest");
  return impl_->shift;
}

long LaurentPolynomial::highest() const {
  require_nonzero(is_zero(), "highest");
  return impl_->shift + impl_->length() - 1;
}

long LaurentPolynomial::length() const { return impl_->length(); }

Rational LaurentPolynomial::coefficient(long exponent) const {
  if (exponent < impl_->shift || exponent >= impl_->shift + length()) return 0;
  flint::Quotient value;
  fmpq_poly_get_coeff_fmpq(value.get(), impl_->poly, exponent - impl_->shift);
  return flint::to_rational(value.get());
}

std::vector<Rational> LaurentPolynomial::coefficients() const {
  std::vector<Rational> result;
  result.reserve(static_cast<std::size_t>(length()));
  for (long i = 0; i < length(); ++i) result.push_back(coefficient(impl_->shift + i));
  return result;
}

std::vector<Integer> LaurentPolynomial::numerators() const {
  std::vector<Integer> result;
  result.reserve(static_cast<std::size_t>(length()));
  for (long i = 0; i < length(); ++i) result.push_back(flint::to_integer(impl_->poly->coeffs + i));
  return result;
}

Integer LaurentPolynomial::denominator() const { return flint::to_integer(fmpq_poly_denref(impl_->poly)); }

Rational LaurentPolynomial::operator()(const Rational& z) const {
  if (is_zero()) return 0;
  if (z == 0) {
    if (impl_->shift < 0) fail(ErrorKind::domain, "value of a Laurent polynomial: need z != 0, got 0");
    return coefficient(0);
  }
  flint::Quotient value;
  fmpq_poly_evaluate_fmpq(value.get(), impl_->poly, flint::Quotient(z).get());
  return flint::to_rational(value.get()) * power(z, impl_->shift);
}

LaurentPolynomial LaurentPolynomial::operator-() const {
  LaurentPolynomial result(*this);
  fmpq_poly_neg(result.impl_->poly, result.impl_->poly);
  return result;
}

LaurentPolynomial& LaurentPolynomial::operator+=(const LaurentPolynomial& other) {
  if (other.is_zero()) return *this;
  if (is_zero()) return *this = other;
  const long low = std::min(impl_->shift, other.impl_->shift);
  if (std::max(impl_->shift, other.impl_->shift) - low > max_length)
    fail(ErrorKind::size, "sum of Laurent polynomials: exponents more than 10^8 apart");
  fmpq_poly_shift_left(impl_->poly, impl_->poly, impl_->shift - low);
  impl_->shift = low;
  if (other.impl_->shift == low) {
    fmpq_poly_add(impl_->poly, impl_->poly, other.impl_->poly);
  } else {
    Impl moved(*other.impl_);
    fmpq_poly_shift_left(moved.poly, moved.poly, moved.shift - low);
    fmpq_poly_add(impl_->poly, impl_->poly, moved.poly);
  }
  impl_->canonicalise();
  return *this;
}

LaurentPolynomial& LaurentPolynomial::operator-=(const LaurentPolynomial& other) { return *this += -other; }

LaurentPolynomial& LaurentPolynomial::operator*=(const LaurentPolynomial& other) {
  const long shift = impl_->shift + other.impl_->shift;
  fmpq_poly_mul(impl_->poly, impl_->poly, other.impl_->poly);
  impl_->shift = is_zero() ? 0 : shift;
  return *this;
}

bool LaurentPolynomial::operator==(const LaurentPolynomial& other) const {
  return impl_->shift == other.impl_->shift && fmpq_poly_equal(impl_->poly, other.impl_->poly);
}

LaurentPolynomial LaurentPolynomial::pow(long exponent) const {
  require(exponent >= 0, "pow: need exponent >= 0, got {}", exponent);
  if (exponent > max_length / std::max(1L, length()))
    fail(ErrorKind::size, "pow: need length * exponent <= 10^8, got exponent {}", exponent);
  LaurentPolynomial result;
  fmpq_poly_pow(result.impl_->poly, impl_->poly, static_cast<ulong>(exponent));
  result.impl_->shift = result.is_zero() ? 0 : impl_->shift * exponent;
  return result;
}

LaurentPolynomial LaurentPolynomial::shifted(long exponent) const {
  LaurentPolynomial result(*this);
  if (!is_zero()) result.impl_->shift += exponent;
  return result;
}

LaurentPolynomial LaurentPolynomial::dilated(long factor) const {
  require(factor >= 1, "dilated: need factor >= 1, got {}", factor);
  if (is_zero()) return {};
  if (length() - 1 > max_length / factor)
    fail(ErrorKind::size, "dilated: need at most 10^8 coefficients, got factor {}", factor);
  LaurentPolynomial result;
  fmpq_poly_t& target = result.impl_->poly;
  fmpz_poly_t numerators;
  fmpz_poly_init(numerators);
  fmpq_poly_get_numerator(numerators, impl_->poly);
  fmpz_poly_inflate(numerators, numerators, static_cast<ulong>(factor));
  fmpq_poly_set_fmpz_poly(target, numerators);
  fmpz_poly_clear(numerators);
  fmpq_poly_scalar_div_fmpz(target, target, fmpq_poly_denref(impl_->poly));
  result.impl_->shift = impl_->shift * factor;
  return result;
}

LaurentPolynomial LaurentPolynomial::reversed() const {
  if (is_zero()) return {};
  LaurentPolynomial result(*this);
  fmpq_poly_reverse(result.impl_->poly, result.impl_->poly, length());
  result.impl_->shift = -highest();
  return result;
}

LaurentPolynomial LaurentPolynomial::derivative() const {
  std::vector<Rational> values = coefficients();
  for (std::size_t i = 0; i < values.size(); ++i) values[i] *= impl_->shift + static_cast<long>(i);
  return LaurentPolynomial(values, impl_->shift - 1);
}

LaurentPolynomial LaurentPolynomial::coset(int arity, long residue) const {
  require(arity >= 1, "coset: need arity >= 1, got {}", arity);
  if (is_zero()) return {};
  // First exponent of the form arity*j + residue that is not below lowest().
  long j = (lowest() - residue) / arity;
  while (arity * j + residue < lowest()) ++j;
  while (arity * (j - 1) + residue >= lowest()) --j;
  const long first = j;
  std::vector<Rational> values;
  for (; arity * j + residue <= highest(); ++j) values.push_back(coefficient(arity * j + residue));
  return LaurentPolynomial(values, first);
}

LaurentPolynomial::Division LaurentPolynomial::divided_by(const LaurentPolynomial& divisor) const {
  require_nonzero(divisor.is_zero(), "divisor");
  Division result;
  fmpq_poly_divrem(result.quotient.impl_->poly, result.remainder.impl_->poly, impl_->poly, divisor.impl_->poly);
  result.quotient.impl_->shift = impl_->shift - divisor.impl_->shift;
  result.remainder.impl_->shift = impl_->shift;
  result.quotient.impl_->canonicalise();
  result.remainder.impl_->canonicalise();
  return result;
}

std::optional<LaurentPolynomial> LaurentPolynomial::exact_quotient(const LaurentPolynomial& divisor) const {
  Division division = divided_by(divisor);
  if (!division.remainder.is_zero()) return std::nullopt;
  return std::move(division.quotient);
}

int LaurentPolynomial::multiplicity(const LaurentPolynomial& factor) const {
  require_nonzero(is_zero(), "multiplicity");
  if (factor.length() < 2) fail(ErrorKind::domain, "multiplicity: need a factor with at least two terms");
  int count = 0;
  for (auto rest = exact_quotient(factor); rest; rest = rest->exact_quotient(factor)) ++count;
  return count;
}

LaurentPolynomial gcd(const LaurentPolynomial& a, const LaurentPolynomial& b) {
  LaurentPolynomial result;
  fmpq_poly_gcd(result.impl_->poly, a.impl_->poly, b.impl_->poly);
  return result;
}

namespace {

std::vector<Monomial> terms_of(const LaurentPolynomial& p) {
  std::vector<Monomial> terms;
  long exponent = p.is_zero() ? 0 : p.lowest();
  for (const Rational& c : p.coefficients()) {
    if (c != 0) terms.push_back({c, {exponent}});
    ++exponent;
  }
  return terms;
}

}  // namespace

std::string LaurentPolynomial::to_text() const { return text::print_terms(terms_of(*this), text::Style::plain); }

std::string LaurentPolynomial::to_latex() const { return text::print_terms(terms_of(*this), text::Style::latex); }

std::string LaurentPolynomial::to_mask_text() const {
  if (is_zero()) return "[0]@0";
  return text::print_mask_text({coefficients(), {static_cast<std::size_t>(length())}, {{lowest()}}});
}

LaurentPolynomial interpolation(const std::vector<Rational>& nodes, std::vector<Rational> values) {
  // Newton's divided differences.
  for (std::size_t order = 1; order < nodes.size(); ++order)
    for (std::size_t i = nodes.size(); i-- > order;)
      values[i] = (values[i] - values[i - 1]) / (nodes[i] - nodes[i - order]);
  LaurentPolynomial result;
  for (std::size_t i = nodes.size(); i-- > 0;)
    result = result.shifted(1) - LaurentPolynomial(nodes[i]) * result + LaurentPolynomial(values[i]);
  return result;
}

}  // namespace subcert
