#include "levels.hpp"

#include "surfaces/torus.hpp"

#include <algorithm>
#include <numeric>

namespace subcert_check {
namespace {

constexpr std::size_t most_masks = 64, most_pairs = 4096, most_levels = 1000;
constexpr unsigned most_classes = 64;
constexpr const char* expected_order = "an order is any, period=0,1,... or follows=0-1,1-0,...";

/// The coefficients of a mask of numbers for the class r.
mpz_class class_sum(const Mask& mask, std::size_t r, unsigned arity) {
  mpz_class sum = 0;
  for (std::size_t i = r; i < mask.points(); i += arity) sum += mask.coefficients[i];
  return sum;
}

/// Whether that is shown to be nowhere negative: a form that may be 0 at the ends of an interval.
void check_not_negative(Vector form, const std::string& what, Arithmetic& arithmetic) {
  while (!form.empty() && form.back() == 0) form.pop_back();
  form.erase(form.begin(), std::ranges::find_if(form, [](const mpz_class& c) { return c != 0; }));
  if (!form.empty()) check_positive_form(form, what, arithmetic);
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

 private:
  void check_denominator(const Range& from) {
    Vector q = form_of(denominator_, from);
    while (from.unbounded && q.back() == 0) q.pop_back();  // it is not 0: see the range
    sign_ = sgn(q[0]);
    for (mpz_class& c : q) c *= sign_;
    check_positive_form(q, "the denominator of the recurrence", arithmetic_);
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

}  // namespace

MaskList parse_mask_list(std::string_view masks, unsigned arity, std::string_view order) {
  MaskList list{{}, arity, {}, {}};
  for (const std::string_view text : split(masks, ";")) {
    const Mask& mask = list.masks.emplace_back(parse_mask(text, '\0'));
    require(mask.sizes.size() == 1 && mask.points() <= 1000 && mask.coefficients.front() != 0 &&
                mask.coefficients.back() != 0,
            "a mask has 1 to 1000 coefficients, the first and the last not zero");
  }
  require(list.masks.size() <= most_masks, "more masks than the checker allows");
  const auto number = [&](std::string_view text) { return parse_size(text, 0, list.masks.size() - 1); };
  constexpr std::string_view period = "period=", follows = "follows=";
  if (order.starts_with(period)) {
    unsigned classes = 1;
    for (const std::string_view text : split(order.substr(period.size()), ",")) {
      list.period.push_back(number(text));
      require((classes *= arity) <= most_classes, "a longer period than the checker allows");
    }
  } else if (order.starts_with(follows)) {
    for (const std::string_view text : split(order.substr(follows.size()), ",")) {
      const Fields pair = split(text, "-");
      require(pair.size() == 2 && list.follows.size() < most_pairs, expected_order);
      list.follows.emplace_back(number(pair[0]), number(pair[1]));
    }
  } else {
    require(order == "any", expected_order);
  }
  return list;
}

Vector product_of_symbols(const Vector& symbol, const Vector& factor, std::size_t step, Arithmetic& arithmetic) {
  Vector result(symbol.size() + step * (factor.size() - 1));
  for (std::size_t i = 0; i < symbol.size(); ++i)
    for (std::size_t j = 0; j < factor.size(); ++j) arithmetic.add_product(result[i + step * j], symbol[i], factor[j]);
  return result;
}

Mask masks_in_one(const MaskList& list, const std::vector<std::size_t>& sequence, Arithmetic& arithmetic) {
  Mask one = list.masks[sequence.front()];
  for (std::size_t level = 1; level < sequence.size(); ++level) {
    const Mask& next = list.masks[sequence[level]];
    one.coefficients = product_of_symbols(next.coefficients, one.coefficients, list.arity, arithmetic);
    one.denominator *= next.denominator;
  }
  one.sizes = {one.coefficients.size()};
  return one;
}

void check_constants(const MaskList& list) {
  for (const Mask& mask : list.masks)
    for (unsigned r = 0; r < list.arity; ++r)
      require(class_sum(mask, r, list.arity) == mask.denominator, "a mask of the list does not keep constant data");
}

Family list_family(const MaskList& list, std::size_t sum_rules) {
  std::vector<Family> families;
  std::size_t width = 1;
  for (const Mask& mask : list.masks) width = std::max(width, transition_family(mask, list.arity, sum_rules).size);
  mpz_class common = 1;
  for (const Mask& mask : list.masks) {
    families.push_back(transition_family(mask, list.arity, sum_rules, width));
    common = lcm(common, families.back().denominator);
  }
  for (Family& family : families)
    for (mpz_class& x : family.entries) x *= common / family.denominator;
  Family result{width, {}, common};
  if (list.follows.empty()) {
    for (const Family& family : families)
      result.entries.insert(result.entries.end(), family.entries.begin(), family.entries.end());
    return result;
  }
  std::size_t nodes = 0;
  for (const auto& [before, after] : list.follows) nodes = std::max({nodes, before + 1, after + 1});
  result.size = nodes * width;
  require(result.size <= 256, "transition matrices larger than 256");
  require(list.follows.size() * list.arity * result.size * result.size <= std::size_t{1} << 22, too_much_work);
  for (const auto& [before, after] : list.follows)
    for (std::size_t t = 0; t < list.arity; ++t) {
      Vector block(result.size * result.size);
      for (std::size_t k = 0; k < width; ++k)
        for (std::size_t i = 0; i < width; ++i)
          block[(after * width + k) * result.size + before * width + i] = families[after].matrix(t)[k * width + i];
      result.entries.insert(result.entries.end(), block.begin(), block.end());
    }
  return result;
}

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
  std::size_t level = 0;
  for (; reader.at("level"); ++level) {
    require(level < most_levels, "more levels than the checker allows");
    const Fields fields = reader.take("level", 2, 2);
    const Range next{range.letter, parse_rational(fields[0]), parse_rational(fields[1])};
    require(next.low <= next.high, "the values of a level are an interval");
    steps.check(values, next);
    values = next;
  }
  require(!recurrence.from || level <= *recurrence.from, "the values come into the range at a later level");
  require(range.low <= values.low && values.high <= range.high, "the values do not come into the range");
}

}  // namespace subcert_check
