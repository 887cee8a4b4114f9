#include "recurrence.hpp"

#include "levels.hpp"
#include "surfaces/torus.hpp"

#include <algorithm>
#include <numeric>

namespace subcert_check {
namespace {

constexpr std::size_t most_levels = 1000, most_multiples = 8;

/// Whether that is shown to be nowhere negative: a form that may be 0 at the ends of an interval.
void check_not_negative(Vector form, const std::string& what, Arithmetic& arithmetic) {
  while (!form.empty() && form.back() == 0) form.pop_back();
  form.erase(form.begin(), std::ranges::find_if(form, [](const mpz_class& c) { return c != 0; }));
  if (!form.empty()) check_positive_form(form, what, arithmetic);
}

/// The sign of a form that is shown to have no zero.
int check_one_sign(Vector form, const std::string& what, Arithmetic& arithmetic) {
  const int sign = sgn(form[0]);
  for (mpz_class& c : form) c *= sign;
  check_positive_form(form, what, arithmetic);
  return sign;
}

Vector derivative(const Vector& polynomial) {
  Vector result(std::max<std::size_t>(polynomial.size() - 1, 1));
  for (std::size_t k = 1; k < polynomial.size(); ++k) result[k - 1] = polynomial[k] * k;
  return result;
}

mpq_class value_of(const Vector& polynomial, const mpq_class& at) {
  mpq_class value = 0;
  for (std::size_t k = polynomial.size(); k-- > 0;) value = value * at + polynomial[k];
  return value;
}

/// The numerator and the denominator of a recurrence as polynomials, and what is shown of them on intervals.
class Steps {
 public:
  Steps(const Recurrence& recurrence, Arithmetic& arithmetic)
      : numerator_(recurrence.step.coefficients), is_root_(recurrence.is_root), arithmetic_(arithmetic) {
    for (const mpz_class& q : recurrence.step.divisor) denominator_.push_back(q * recurrence.step.denominator);
  }

  /// Rejects unless all values from `from` lead to `to`.
  void check(const Range& from, const Range& to) {
    check_denominator(from);
    check_at_least(from, to.low);
    // HIGH, or HIGH^2, times the denominator less the numerator
    require(!is_root_ || to.high >= 0, "a root may be above the values of the next level");
    check_difference(from, {is_root_ ? mpq_class(to.high * to.high) : to.high}, 1, "above");
  }

  /// Rejects unless values from `range.high` on lead to at most nine tenths of them, and not below the range.
  void check_descent(const Range& range) {
    require(range.high > 0, "an unbounded start needs a range with a positive upper end");
    const Range beyond{range.letter, range.high, range.high, true};
    check_denominator(beyond);
    check_at_least(beyond, range.low);
    check_difference(beyond, is_root_ ? Rationals{0, 0, ratio(81, 100)} : Rationals{0, ratio(9, 10)}, 1,
                     "above nine tenths of");
  }

  /// Rejects unless all sequences of values in `range` stay there and tend to the limit.
  void check_limit(const Range& range, const mpq_class& limit) {
    check(range, range);
    require(range.low <= limit && limit <= range.high, "the limit is not among the values that come near to it");
    const mpq_class p = value_of(numerator_, limit), q = value_of(denominator_, limit);
    require(is_root_ ? limit >= 0 && p == limit * limit * q : p == limit * q, "the recurrence moves the limit");
    // (p/q)' q^2, and what that has to be below
    Vector slope = product_of_symbols(derivative(numerator_), denominator_, 1, arithmetic_),
           square = product_of_symbols(denominator_, denominator_, 1, arithmetic_);
    const Vector minus = product_of_symbols(numerator_, derivative(denominator_), 1, arithmetic_);
    for (std::size_t k = 0; k < minus.size(); ++k) slope[k] -= minus[k];
    if (!is_root_) {
      for (const int sign : {1, -1}) check_steepness(range, square, slope, sign);
      return;
    }
    Vector most = product_of_symbols(product_of_symbols(numerator_, denominator_, 1, arithmetic_), square, 1,
                                     arithmetic_);
    for (mpz_class& c : most) c *= 4;
    check_steepness(range, most, product_of_symbols(slope, slope, 1, arithmetic_), 1);
  }

  /// Whether it is w -> sqrt((1 + w)/2).
  bool halves_angles() const {
    Vector twice = numerator_;
    for (mpz_class& c : twice) c *= 2;
    twice.emplace_back(0);
    return is_root_ && twice == product_of_symbols(denominator_, {1, 1}, 1, arithmetic_);
  }

 private:
  /// That most - sign slope is positive.
  void check_steepness(const Range& range, const Vector& most, const Vector& slope, int sign) {
    Vector difference = most;
    difference.resize(std::max(most.size(), slope.size()));
    for (std::size_t k = 0; k < slope.size(); ++k) difference[k] -= sign * slope[k];
    check_positive_form(form_of(difference, range), "1 less the steepness of the recurrence", arithmetic_);
  }

  void check_denominator(const Range& from) {
    Vector q = form_of(denominator_, from);
    while (from.unbounded && q.back() == 0) q.pop_back();  // it is not 0: see the range
    sign_ = check_one_sign(std::move(q), "the denominator of the recurrence", arithmetic_);
  }

  void check_at_least(const Range& from, const mpq_class& low) {
    check_difference(from, {!is_root_ ? low : low > 0 ? mpq_class(low * low) : mpq_class(0)}, -1, "below");
  }

  /// sign (bound * denominator - numerator), in the sign of the denominator.
  void check_difference(const Range& from, const Rationals& bound, int sign, const std::string& side) {
    const Family cleared = clear_denominators(1, bound);
    Vector p(numerator_.size() + bound.size() - 1);
    for (std::size_t k = 0; k < numerator_.size(); ++k) {
      p[k] -= sign * sign_ * numerator_[k] * cleared.denominator;
      for (std::size_t j = 0; j < bound.size(); ++j) p[k + j] += sign * sign_ * denominator_[k] * cleared.entries[j];
    }
    check_not_negative(form_of(p, from), "what keeps the recurrence from being " + side + " the next values",
                       arithmetic_);
  }

  Vector form_of(const Vector& polynomial, const Range& range) {
    arithmetic_.spend(1000 * polynomial.size() * polynomial.size());
    return divisor_form(polynomial, power_forms(range, polynomial.size() - 1));
  }

  Vector numerator_, denominator_;
  bool is_root_;
  int sign_ = 1;
  Arithmetic& arithmetic_;
};

/// Divides a mask with a parameter, which is not always 0, by 1 + 2 T z + z^2, T a polynomial of the degree j.
void divide(Mask& mask, const Vector& chebyshev, Arithmetic& arithmetic) {
  const std::size_t points = mask.points(), powers = mask.powers, j = chebyshev.size() - 1;
  const auto at = [&](std::size_t i, std::size_t k) -> mpz_class& { return mask.coefficients[k * points + i]; };
  const auto require_zero = [](const mpz_class& x) { require(x == 0, "the masks have no such exponential factor"); };
  for (std::size_t i = 0; i < points; ++i) {
    // The quotient has a degree that is less by j: the highest power of the parameter is multiplied.
    for (std::size_t k = 0; i >= 1 && k + j < powers; ++k)
      for (std::size_t l = 0; l <= j; ++l) arithmetic.add_product(at(i, k + l), at(i - 1, k), -2 * chebyshev[l]);
    for (std::size_t k = 0; i >= 2 && k < powers; ++k) at(i, k) -= at(i - 2, k);
    for (std::size_t k = powers - std::min(j, powers); k < powers; ++k) require_zero(at(i, k));
  }
  Vector rest;
  for (std::size_t k = 0; k < powers; ++k)
    for (std::size_t i = 0; i < points; ++i)
      if (i + 2 < points)
        rest.push_back(at(i, k));
      else
        require_zero(at(i, k));
  mask.coefficients = std::move(rest);
  mask.sizes = {points - 2};
}

/// Reads lines of this word with intervals to which the values lead one after the other; how many there are.
std::size_t read_way(const char* word, Range& values, Steps& steps, Reader& reader) {
  std::size_t count = 0;
  for (; reader.at(word); ++count) {
    require(count < most_levels, "more levels than the checker allows");
    const Fields fields = reader.take(word, 2, 2);
    const Range next{values.letter, parse_rational(fields[0]), parse_rational(fields[1])};
    require(next.low <= next.high, "the values of a level are an interval");
    steps.check(values, next);
    values = next;
  }
  return count;
}

}  // namespace

Recurrence parse_recurrence(std::string_view step, std::string_view start, std::string_view from, char letter) {
  constexpr std::string_view root = "sqrt";
  Recurrence result{{}, step.starts_with(root), {letter, 0, 0}, std::nullopt};
  result.step = parse_mask(step.substr(result.is_root ? root.size() : 0), letter);
  require(result.step.sizes.size() == 1 && result.step.points() == 1, "a recurrence is [P]/D, [P]/(Q) or sqrt[P]/(Q)");
  const Fields ends = split(start, "..");
  require(ends.size() == 2, "the first values are LOW..HIGH or LOW..inf");
  result.start.low = parse_rational(ends[0]);
  result.start.unbounded = ends[1] == "inf";
  result.start.high = result.start.unbounded ? result.start.low : parse_rational(ends[1]);
  require(result.start.low <= result.start.high, "the first values are LOW..HIGH or LOW..inf");
  require(result.start.unbounded == (from == "some"), "a start has a level if it is bounded, else 'some'");
  if (!result.start.unbounded) result.from = parse_size(from, 0, most_levels);
  return result;
}

void read_recurrence(const Recurrence& recurrence, const Range& range, Reader& reader, Arithmetic& arithmetic) {
  Steps steps(recurrence, arithmetic);
  steps.check(range, range);
  Range values = recurrence.start;
  if (values.unbounded) {
    require(values.low <= range.high, "an unbounded start begins above the range");
    values.high = range.high;
    values.unbounded = false;
    steps.check_descent(range);
  }
  const std::size_t levels = read_way("level", values, steps, reader);
  require(!recurrence.from || levels <= *recurrence.from, "the values come into the range at a later level");
  require(range.low <= values.low && values.high <= range.high, "the values do not come into the range");
}

std::vector<std::size_t> MasksToLimit::read(unsigned arity, Reader& reader, Arithmetic& arithmetic) const {
  read_recurrence(recurrence, range, reader, arithmetic);
  check_one_sign(divisor_form(family.divisor, power_forms(range, family.powers - 1)), "the denominator of the masks",
                 arithmetic);
  Steps steps(recurrence, arithmetic);
  Range values = range;
  read_way("towards", values, steps, reader);
  steps.check_limit(values, limit);
  if (!reader.at("exponentials")) return {};
  require(arity == 2 && steps.halves_angles(), "exponentials need arity 2 and w -> sqrt((1+w)/2)");
  std::vector<std::size_t> exponentials;
  for (const std::string_view field : reader.take("exponentials", 1, most_multiples))
    exponentials.push_back(parse_size(field, 0, 500));
  return exponentials;
}

void MasksToLimit::check_factors(unsigned arity, std::size_t count, const std::vector<std::size_t>& exponentials,
                                 Arithmetic& arithmetic) const {
  check_sum(family, arity);
  const std::size_t twice = 2 * std::accumulate(exponentials.begin(), exponentials.end(), std::size_t{0});
  require(twice < count, "a sum rule is needed beside the exponentials");
  Mask rest = family;
  Vector before{1}, chebyshev{0, 1};
  for (const std::size_t power : exponentials) {
    for (std::size_t k = 0; k < power; ++k) divide(rest, chebyshev, arithmetic);
    Vector next = product_of_symbols({0, 2}, chebyshev, 1, arithmetic);
    for (std::size_t k = 0; k < before.size(); ++k) next[k] -= before[k];
    before = std::exchange(chebyshev, std::move(next));
  }
  transition_family(rest, arity, count - twice);
}

Mask mask_at(const Mask& family, const mpq_class& value) {
  const mpq_class below = value_of(family.divisor, value) * family.denominator;
  require(below != 0, "there is no mask in the limit");
  const std::size_t points = family.points();
  Rationals values;
  for (std::size_t i = 0; i < points; ++i) {
    Vector polynomial;
    for (std::size_t k = 0; k < family.powers; ++k) polynomial.push_back(family.coefficients[k * points + i]);
    values.push_back(value_of(polynomial, value) / below);
  }
  const auto is_zero = [](const mpq_class& x) { return x == 0; };
  while (!values.empty() && is_zero(values.back())) values.pop_back();
  values.erase(values.begin(), std::ranges::find_if_not(values, is_zero));
  require(!values.empty(), "the mask in the limit is 0");
  const Family cleared = clear_denominators(1, values);
  Mask mask = family;
  mask.sizes = {values.size()};
  mask.powers = 1;
  mask.coefficients = cleared.entries;
  mask.denominator = cleared.denominator;
  mask.divisor = {1};
  return mask;
}

}  // namespace subcert_check
