#include "multivariate_polynomial.hpp"

#include <subcert/analysis/symbol/numbers/flint.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include "expression.hpp"
#include "term_text.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace subcert {
namespace {

constexpr int most_variables = 5;

void require_variables(int variables) {
  if (variables < 1 || variables > most_variables)
    fail(ErrorKind::domain, "multivariate polynomial: need 1 to {} variables, got {}", most_variables, variables);
}

/// FLINT contexts live as long as the program; one for each number of variables.
const fmpq_mpoly_ctx_struct* context(int variables) {
  struct Contexts {
    fmpq_mpoly_ctx_t ctx[most_variables];
    Contexts() {
      for (int i = 0; i < most_variables; ++i) fmpq_mpoly_ctx_init(ctx[i], i + 1, ORD_LEX);
    }
  };
  static const Contexts contexts;
  require_variables(variables);
  return contexts.ctx[variables - 1];
}

}  // namespace

/// x^shift times a FLINT polynomial that no variable divides.
struct MultivariatePolynomial::Impl {
  int variables;
  const fmpq_mpoly_ctx_struct* ctx;
  fmpq_mpoly_t poly;
  Exponents shift;

  explicit Impl(int count_of_variables)
      : variables(count_of_variables), ctx(context(variables)), shift(static_cast<std::size_t>(variables), 0) {
    fmpq_mpoly_init(poly, ctx);
  }
  Impl(const Impl& other) : Impl(other.variables) {
    shift = other.shift;
    fmpq_mpoly_set(poly, other.poly, ctx);
  }
  Impl& operator=(const Impl&) = delete;
  ~Impl() { fmpq_mpoly_clear(poly, ctx); }

  bool is_zero() const { return fmpq_mpoly_is_zero(poly, ctx) != 0; }
  slong count() const { return fmpq_mpoly_length(poly, ctx); }

  Exponents raw_exponents(slong term) const {
    std::vector<slong> raw(shift.size());
    fmpq_mpoly_get_term_exp_si(raw.data(), poly, term, ctx);
    return {raw.begin(), raw.end()};
  }

  Exponents extreme(bool largest) const {
    Exponents result = raw_exponents(0);
    for (slong t = 1; t < count(); ++t) {
      const Exponents e = raw_exponents(t);
      for (std::size_t v = 0; v < e.size(); ++v)
        result[v] = largest ? std::max(result[v], e[v]) : std::min(result[v], e[v]);
    }
    return result;
  }

  /// Multiplies the FLINT polynomial by x^e; the shift stays. Domain: the exponents stay non-negative.
  void move(const Exponents& e) {
    const bool up = std::all_of(e.begin(), e.end(), [](long x) { return x >= 0; });
    std::vector<ulong> magnitude;
    for (long x : e) magnitude.push_back(static_cast<ulong>(up ? x : -x));
    fmpq_mpoly_t monomial;
    fmpq_mpoly_init(monomial, ctx);
    fmpq_mpoly_set_coeff_fmpq_ui(monomial, flint::Quotient(Rational(1)).get(), magnitude.data(), ctx);
    if (up)
      fmpq_mpoly_mul(poly, poly, monomial, ctx);
    else
      fmpq_mpoly_divides(poly, poly, monomial, ctx);
    fmpq_mpoly_clear(monomial, ctx);
  }

  void canonicalise() {
    if (is_zero()) {
      std::fill(shift.begin(), shift.end(), 0);
      return;
    }
    Exponents low = extreme(false);
    if (std::all_of(low.begin(), low.end(), [](long x) { return x == 0; })) return;
    for (std::size_t v = 0; v < low.size(); ++v) {
      shift[v] += low[v];
      low[v] = -low[v];
    }
    move(low);
  }

  /// A copy whose shift is `target`. Domain: target <= shift in every variable.
  std::unique_ptr<Impl> with_shift(const Exponents& target) const {
    auto copy = std::make_unique<Impl>(*this);
    Exponents by(shift.size());
    for (std::size_t v = 0; v < by.size(); ++v) by[v] = shift[v] - target[v];
    copy->move(by);
    copy->shift = target;
    return copy;
  }
};

namespace {

void require_same(int a, int b) {
  if (a != b)
    fail(ErrorKind::domain, "multivariate polynomials: need as many variables on both sides, got {} and {}", a, b);
}

}  // namespace

MultivariatePolynomial::MultivariatePolynomial(int variables) : impl_(std::make_unique<Impl>(variables)) {}
MultivariatePolynomial::MultivariatePolynomial(int variables, const Rational& constant)
    : MultivariatePolynomial(variables, {{constant, Exponents(static_cast<std::size_t>(variables), 0)}}) {}
MultivariatePolynomial::MultivariatePolynomial(const MultivariatePolynomial& other)
    : impl_(std::make_unique<Impl>(*other.impl_)) {}
MultivariatePolynomial::MultivariatePolynomial(MultivariatePolynomial&& other) noexcept = default;
MultivariatePolynomial& MultivariatePolynomial::operator=(const MultivariatePolynomial& other) {
  if (this != &other) impl_ = std::make_unique<Impl>(*other.impl_);
  return *this;
}
MultivariatePolynomial& MultivariatePolynomial::operator=(MultivariatePolynomial&& other) noexcept = default;
MultivariatePolynomial::~MultivariatePolynomial() = default;

MultivariatePolynomial::MultivariatePolynomial(int variables, const std::vector<Monomial>& terms)
    : MultivariatePolynomial(variables) {
  if (terms.empty()) return;
  Impl& impl = *impl_;
  Exponents low = terms.front().exponents;
  for (const Monomial& term : terms) {
    if (term.exponents.size() != static_cast<std::size_t>(variables))
      fail(ErrorKind::domain, "multivariate polynomial: need {} exponents in each term, got {}", variables,
           term.exponents.size());
    for (std::size_t v = 0; v < low.size(); ++v) low[v] = std::min(low[v], term.exponents[v]);
  }
  for (const Monomial& term : terms) {
    std::vector<ulong> raw;
    for (std::size_t v = 0; v < low.size(); ++v) raw.push_back(static_cast<ulong>(term.exponents[v] - low[v]));
    fmpq_mpoly_push_term_fmpq_ui(impl.poly, flint::Quotient(term.coefficient).get(), raw.data(), impl.ctx);
  }
  fmpq_mpoly_sort_terms(impl.poly, impl.ctx);
  fmpq_mpoly_combine_like_terms(impl.poly, impl.ctx);
  impl.shift = low;
  impl.canonicalise();
}

MultivariatePolynomial MultivariatePolynomial::tensor_product(const std::vector<LaurentPolynomial>& factors) {
  const int variables = static_cast<int>(factors.size());
  require_variables(variables);
  MultivariatePolynomial result = in_variable(variables, 0, factors.front());
  for (int v = 1; v < variables; ++v) result *= in_variable(variables, v, factors[static_cast<std::size_t>(v)]);
  return result;
}

MultivariatePolynomial MultivariatePolynomial::in_variable(int variables, int index, const LaurentPolynomial& p) {
  require_variables(variables);
  if (index < 0 || index >= variables)
    fail(ErrorKind::domain, "in_variable: need 0 <= index < {}, got {}", variables, index);
  std::vector<Monomial> terms;
  long exponent = p.is_zero() ? 0 : p.lowest();
  for (const Rational& c : p.coefficients()) {
    Exponents e(static_cast<std::size_t>(variables), 0);
    e[static_cast<std::size_t>(index)] = exponent++;
    terms.push_back({c, std::move(e)});
  }
  return MultivariatePolynomial(variables, terms);
}

MultivariatePolynomial MultivariatePolynomial::parse(std::string_view text, int variables) {
  constexpr long max_exponent = 1'000'000;
  require_variables(variables);
  std::string names;
  for (const std::string& name : text::variable_names(variables)) names += name;
  return read_polynomial(text, names, max_exponent);
}

int MultivariatePolynomial::variables() const { return impl_->variables; }
bool MultivariatePolynomial::is_zero() const { return impl_->is_zero(); }
long MultivariatePolynomial::count() const { return impl_->count(); }

bool MultivariatePolynomial::is_canonical() const {
  if (!fmpq_mpoly_is_canonical(impl_->poly, impl_->ctx)) return false;
  const Exponents zero(impl_->shift.size(), 0);
  return is_zero() ? impl_->shift == zero : impl_->extreme(false) == zero;
}

std::vector<MultivariatePolynomial::Monomial> MultivariatePolynomial::terms() const {
  std::vector<Monomial> result;
  flint::Quotient value;
  for (slong t = 0; t < count(); ++t) {
    fmpq_mpoly_get_term_coeff_fmpq(value.get(), impl_->poly, t, impl_->ctx);
    Exponents e = impl_->raw_exponents(t);
    for (std::size_t v = 0; v < e.size(); ++v) e[v] += impl_->shift[v];
    result.push_back({flint::to_rational(value.get()), std::move(e)});
  }
  return result;
}

Rational MultivariatePolynomial::coefficient(const Exponents& exponents) const {
  require_same(variables(), static_cast<int>(exponents.size()));
  std::vector<ulong> raw;
  for (std::size_t v = 0; v < exponents.size(); ++v) {
    if (exponents[v] < impl_->shift[v]) return 0;
    raw.push_back(static_cast<ulong>(exponents[v] - impl_->shift[v]));
  }
  flint::Quotient value;
  fmpq_mpoly_get_coeff_fmpq_ui(value.get(), impl_->poly, raw.data(), impl_->ctx);
  return flint::to_rational(value.get());
}

MultivariatePolynomial::Exponents MultivariatePolynomial::lowest() const {
  require(!is_zero(), "lowest: need a non-zero polynomial, got 0");
  return impl_->shift;
}

MultivariatePolynomial::Exponents MultivariatePolynomial::highest() const {
  require(!is_zero(), "highest: need a non-zero polynomial, got 0");
  Exponents result = impl_->extreme(true);
  for (std::size_t v = 0; v < result.size(); ++v) result[v] += impl_->shift[v];
  return result;
}

Rational MultivariatePolynomial::operator()(const std::vector<Rational>& point) const {
  require_same(variables(), static_cast<int>(point.size()));
  Rational sum = 0;
  for (const Monomial& term : terms()) {
    Rational product = term.coefficient;
    for (std::size_t v = 0; v < point.size(); ++v) product *= power(point[v], term.exponents[v]);
    sum += product;
  }
  return sum;
}

MultivariatePolynomial MultivariatePolynomial::operator-() const {
  MultivariatePolynomial result(*this);
  fmpq_mpoly_neg(result.impl_->poly, result.impl_->poly, result.impl_->ctx);
  return result;
}

MultivariatePolynomial& MultivariatePolynomial::operator+=(const MultivariatePolynomial& other) {
  require_same(variables(), other.variables());
  if (other.is_zero()) return *this;
  if (is_zero()) return *this = other;
  Exponents low = impl_->shift;
  for (std::size_t v = 0; v < low.size(); ++v) low[v] = std::min(low[v], other.impl_->shift[v]);
  auto sum = impl_->with_shift(low);
  const auto summand = other.impl_->with_shift(low);
  fmpq_mpoly_add(sum->poly, sum->poly, summand->poly, sum->ctx);
  sum->canonicalise();
  impl_ = std::move(sum);
  return *this;
}

MultivariatePolynomial& MultivariatePolynomial::operator-=(const MultivariatePolynomial& other) {
  return *this += -other;
}

MultivariatePolynomial& MultivariatePolynomial::operator*=(const MultivariatePolynomial& other) {
  require_same(variables(), other.variables());
  Exponents sum = impl_->shift;
  for (std::size_t v = 0; v < sum.size(); ++v) sum[v] += other.impl_->shift[v];
  fmpq_mpoly_mul(impl_->poly, impl_->poly, other.impl_->poly, impl_->ctx);
  impl_->shift = std::move(sum);
  impl_->canonicalise();
  return *this;
}

bool MultivariatePolynomial::operator==(const MultivariatePolynomial& other) const {
  return variables() == other.variables() && impl_->shift == other.impl_->shift &&
         fmpq_mpoly_equal(impl_->poly, other.impl_->poly, impl_->ctx);
}

MultivariatePolynomial MultivariatePolynomial::shifted(const Exponents& exponents) const {
  require_same(variables(), static_cast<int>(exponents.size()));
  MultivariatePolynomial result(*this);
  if (is_zero()) return result;
  for (std::size_t v = 0; v < exponents.size(); ++v) result.impl_->shift[v] += exponents[v];
  return result;
}

MultivariatePolynomial MultivariatePolynomial::dilated(long factor) const {
  require(factor >= 1, "dilated: need factor >= 1, got {}", factor);
  std::vector<Monomial> result = terms();
  for (Monomial& term : result)
    for (long& e : term.exponents) e *= factor;
  return MultivariatePolynomial(variables(), result);
}

MultivariatePolynomial MultivariatePolynomial::reversed() const {
  std::vector<Monomial> result = terms();
  for (Monomial& term : result)
    for (long& e : term.exponents) e = -e;
  return MultivariatePolynomial(variables(), result);
}

MultivariatePolynomial MultivariatePolynomial::derivative(int index) const {
  if (index < 0 || index >= variables())
    fail(ErrorKind::domain, "derivative: need 0 <= index < {}, got {}", variables(), index);
  std::vector<Monomial> result = terms();
  for (Monomial& term : result) term.coefficient *= term.exponents[static_cast<std::size_t>(index)]--;
  return MultivariatePolynomial(variables(), result);
}

MultivariatePolynomial MultivariatePolynomial::coset(int arity, const Exponents& residue) const {
  require(arity >= 1, "coset: need arity >= 1, got {}", arity);
  require_same(variables(), static_cast<int>(residue.size()));
  std::vector<Monomial> result;
  for (Monomial& term : terms()) {
    bool inside = true;
    for (std::size_t v = 0; v < residue.size(); ++v) {
      const long distance = term.exponents[v] - residue[v];
      inside = inside && distance % arity == 0;
      term.exponents[v] = distance / arity;
    }
    if (inside) result.push_back(std::move(term));
  }
  return MultivariatePolynomial(variables(), result);
}

MultivariatePolynomial::Division MultivariatePolynomial::divided_by(const MultivariatePolynomial& divisor) const {
  require_same(variables(), divisor.variables());
  require(!divisor.is_zero(), "divisor: need a non-zero polynomial, got 0");
  Division result{MultivariatePolynomial(variables()), MultivariatePolynomial(variables())};
  Impl &quotient = *result.quotient.impl_, &remainder = *result.remainder.impl_;
  fmpq_mpoly_divrem(quotient.poly, remainder.poly, impl_->poly, divisor.impl_->poly, impl_->ctx);
  for (std::size_t v = 0; v < quotient.shift.size(); ++v) quotient.shift[v] = impl_->shift[v] - divisor.impl_->shift[v];
  remainder.shift = impl_->shift;
  quotient.canonicalise();
  remainder.canonicalise();
  return result;
}

std::optional<MultivariatePolynomial> MultivariatePolynomial::exact_quotient(
    const MultivariatePolynomial& divisor) const {
  Division division = divided_by(divisor);
  if (!division.remainder.is_zero()) return std::nullopt;
  return std::move(division.quotient);
}

int MultivariatePolynomial::multiplicity(const MultivariatePolynomial& factor) const {
  require(!is_zero(), "multiplicity: need a non-zero polynomial, got 0");
  if (factor.count() < 2) fail(ErrorKind::domain, "multiplicity: need a factor with at least two terms");
  int count = 0;
  for (auto rest = exact_quotient(factor); rest; rest = rest->exact_quotient(factor)) ++count;
  return count;
}

MultivariatePolynomial gcd(const MultivariatePolynomial& a, const MultivariatePolynomial& b) {
  require_same(a.variables(), b.variables());
  MultivariatePolynomial result(a.variables());
  if (!fmpq_mpoly_gcd(result.impl_->poly, a.impl_->poly, b.impl_->poly, result.impl_->ctx))
    fail(ErrorKind::size, "gcd: the exponents are too large");
  result.impl_->canonicalise();
  // canonicalise() keeps the dropped monomial in the shift; it is a unit, and the divisor is made unique without it.
  std::fill(result.impl_->shift.begin(), result.impl_->shift.end(), 0);
  return result;
}

std::string MultivariatePolynomial::to_text() const { return text::print_terms(terms(), text::Style::plain); }
std::string MultivariatePolynomial::to_latex() const { return text::print_terms(terms(), text::Style::latex); }

}  // namespace subcert
