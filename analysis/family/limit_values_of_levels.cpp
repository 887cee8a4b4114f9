#include "limit_values_of_levels.hpp"

#include <subcert/analysis/symbol/numbers/balls.hpp>
#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/polynomials/real_roots.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <map>

namespace subcert {
namespace {

constexpr long most_values = 1'000'000;
constexpr slong bits = 256;
constexpr int wanted_bits = 80;
constexpr int most_blocks = 40;  // of levels after that of the points
constexpr long most_classes_of_block = 256;
constexpr int highest_order = 8;

/// Numbers at the indices first, first + 1, ...
template <class Number>
struct Sequence {
  long first;
  std::vector<Number> values;
  long last() const { return first + static_cast<long>(values.size()) - 1; }
  const Number& at(long index) const { return values[static_cast<std::size_t>(index - first)]; }
};

/// sum over j of a_{i - arity*j} f_j.
template <class Number>
Sequence<Number> refined(const Sequence<Number>& f, const Sequence<Number>& a, long arity, const Number& zero) {
  Sequence<Number> result{a.first + arity * f.first, {}};
  result.values.assign((f.values.size() - 1) * static_cast<std::size_t>(arity) + a.values.size(), zero);
  for (std::size_t j = 0; j < f.values.size(); ++j)
    for (std::size_t k = 0; k < a.values.size(); ++k)
      result.values[j * static_cast<std::size_t>(arity) + k] += a.values[k] * f.values[j];
  return result;
}

/// What the row says of refined data, as a row of the data: sum over q of row_q a_{q - arity*p}.
template <class Number>
Sequence<Number> pulled_back(const Sequence<Number>& row, const Sequence<Number>& a, long arity, const Number& zero) {
  const long first = -floor_divide(a.last() - row.first, arity), last = floor_divide(row.last() - a.first, arity);
  Sequence<Number> result{first, {}};
  for (long p = first; p <= last; ++p) {
    Number sum = zero;
    for (long q = std::max(row.first, a.first + arity * p); q <= std::min(row.last(), a.last() + arity * p); ++q)
      sum += row.at(q) * a.at(q - arity * p);
    result.values.push_back(std::move(sum));
  }
  if (result.values.empty()) result.values.push_back(zero);
  return result;
}

/// The row applied to the data about each of the indices.
template <class Number>
std::vector<Number> applied(const Sequence<Number>& row, const Sequence<Number>& data, const IndexRange& indices,
                            const Number& zero) {
  std::vector<Number> result;
  for (long i = indices.first; i <= indices.last; ++i) {
    Number sum = zero;
    for (long p = std::max(row.first, data.first - i); p <= std::min(row.last(), data.last() - i); ++p)
      sum += row.at(p) * data.at(i + p);
    result.push_back(std::move(sum));
  }
  return result;
}

/// Of i / arity^level from low to high.
IndexRange indices_of(const Rational& low, const Rational& high, int arity, int level) {
  require(level >= 0, "limit: need level >= 0, got {}", level);
  const Rational size = power(Rational(arity), level);
  if ((high - low) * size > most_values)
    fail(ErrorKind::size, "limit: need at most {} values, got level {}", most_values, level);
  return {ceil_index(low * size), floor_index(high * size)};
}

Sequence<Rational> coefficients_of(const Mask& mask) {
  const IndexRange range = support(mask);
  Sequence<Rational> result{range.first, {}};
  for (long k = range.first; k <= range.last; ++k) result.values.push_back(mask.symbol().coefficient(k));
  return result;
}

std::vector<Mask> curves(const std::vector<LatticeMask>& masks) {
  std::vector<Mask> result;
  for (const LatticeMask& mask : masks) result.push_back(mask.curve());
  return result;
}

Ball value_at(const LaurentPolynomial& p, const Ball& w) {
  Ball result(bits);
  if (p.is_zero()) return result;
  for (long k = p.highest(); k >= 0; --k) result = result * w + Ball(p.coefficient(k), bits);
  return result;
}

Ball largest_modulus(const std::vector<Ball>& numbers) {
  Ball result(bits);
  for (const Ball& number : numbers) result = max(result, abs(number).upper_end());
  return result;
}

/// The largest sum of moduli over a coset modulo `classes`.
Ball norm_of(const Sequence<Ball>& symbol, std::size_t classes) {
  std::vector<Ball> sums(std::min(classes, symbol.values.size()), Ball(bits));
  for (std::size_t k = 0; k < symbol.values.size(); ++k) sums[k % classes] += abs(symbol.values[k]);
  return largest_modulus(sums);
}

/// Divided by (z - 1)^order; nothing where it leaves a remainder.
std::optional<Sequence<LaurentPolynomial>> quotient(Sequence<LaurentPolynomial> row, int order) {
  for (int m = 0; m < order; ++m) {
    for (std::size_t k = 1; k < row.values.size(); ++k) row.values[k] += row.values[k - 1];
    if (!row.values.back().is_zero()) return std::nullopt;
    row.values.pop_back();
    if (row.values.empty()) row.values.emplace_back();
  }
  return row;
}

/// The value at x of the polynomial through the data at so many integers about x.
Sequence<LaurentPolynomial> interpolation(const Rational& x, int points) {
  Sequence<LaurentPolynomial> result{floor_index(x) - (points - 1) / 2, {}};
  for (long i = 0; i < points; ++i) {
    Rational weight = 1;
    for (long j = 0; j < points; ++j)
      if (j != i) weight *= (x - result.first - j) / Rational(i - j);
    result.values.emplace_back(weight);
  }
  return result;
}

/// Rows that tell the limit at a point from data of a late level, and what is missing.
class Tail {
 public:
  Tail(const ParametricMask& mask, const Recurrence& recurrence) : mask_(mask), recurrence_(recurrence) {
    const int rules = sum_rules(mask);
    if (rules < 1) fail(ErrorKind::undecided, "limit: need a sum rule for all values, got none");
    const IndexRange range = mask.support();
    Sequence<LaurentPolynomial> coefficients{range.first, {}};
    LaurentPolynomial moment;
    for (long k = range.first; k <= range.last; ++k) {
      coefficients.values.push_back(mask.coefficient(k));
      moment += Rational(k) * coefficients.values.back();
    }
    // Where linear polynomials can be kept: at (i - tau)/arity, with one tau for all values.
    const LaurentPolynomial below = mask.denominator();
    const Rational tau = moment.is_zero() ? Rational(0)
                                          : moment.coefficient(moment.highest()) /
                                                (below.coefficient(below.highest()) * Rational(mask.arity()));
    const bool is_constant = moment == tau * Rational(mask.arity()) * below;
    for (order_ = is_constant ? std::min(rules, highest_order) : 1; order_ >= 1; --order_) {
      row_ = interpolation(is_constant ? Rational(-tau / (mask.arity() - 1)) : Rational(0), order_);
      Sequence<LaurentPolynomial> change = pulled_back(row_, coefficients, mask.arity(), LaurentPolynomial());
      // What the row says of the next level and did not say of this one, times the denominator.
      for (long p = row_.first; p <= row_.last(); ++p) {
        if (p < change.first || p > change.last()) change = widened(change, p);
        change.values[static_cast<std::size_t>(p - change.first)] -= row_.at(p) * below;
      }
      if (auto found = quotient(std::move(change), order_)) {
        change_ = std::move(*found);
        break;
      }
    }
    require(order_ >= 1, "limit: need coset sums 1 for all values");
    differences_ = divided_difference_scheme(mask, order_);
    for (long classes = mask.arity(); classes * mask.arity() <= most_classes_of_block; classes *= mask.arity())
      ++block_;
  }

  int order() const { return order_; }
  int block() const { return block_; }

  Sequence<Ball> row() const {
    Sequence<Ball> result{row_.first, {}};
    for (const LaurentPolynomial& weight : row_.values) result.values.emplace_back(weight.coefficient(0), bits);
    return result;
  }

  /// The coefficients at values in w; not finite where there may be none.
  static Sequence<Ball> coefficients(const ParametricMask& mask, const Interval& w, const Rational& scale = 1) {
    const Ball values = Ball::containing(w.enclosure(), bits),
               factor = Ball(scale, bits) / value_at(mask.denominator(), values);
    const IndexRange range = mask.support();
    Sequence<Ball> result{range.first, {}};
    for (long k = range.first; k <= range.last; ++k)
      result.values.push_back(value_at(mask.coefficient(k), values) * factor);
    return result;
  }

  /// Of the differences of order order(): those of levels with these values, as one operator, for each number of them.
  std::vector<Ball> norms(const std::vector<Interval>& levels) const {
    std::vector<Ball> result{Ball(1, bits)};
    const auto arity = static_cast<std::size_t>(mask_.arity());
    Sequence<Ball> symbol{0, {Ball(1, bits)}};
    std::size_t classes = 1;
    for (const Interval& w : levels) {
      const Rational scale = power(Rational(mask_.arity()), -order_);
      symbol = refined(symbol, coefficients(*differences_, w, scale), mask_.arity(), Ball(bits));
      classes *= arity;
      result.push_back(norm_of(symbol, classes));
    }
    return result;
  }

  /// How far the limit is from what the row says of data at a level with this value whose differences of order order()
  /// are at most 1; nothing where they are not proved to contract.
  std::optional<Ball> error_from(const Interval& w) const {
    const auto all = recurrence_.all_from(w);
    if (!all) return std::nullopt;
    const std::vector<Ball> shrunk = norms(std::vector<Interval>(static_cast<std::size_t>(block_), *all));
    if (!shrunk.back().is_less(Ball(1, bits))) return std::nullopt;
    const Ball values = Ball::containing(all->enclosure(), bits), below = value_at(mask_.denominator(), values);
    Ball change(bits), sum(bits);
    for (const LaurentPolynomial& one : change_.values) change += abs(value_at(one, values) / below);
    for (std::size_t k = 0; k + 1 < shrunk.size(); ++k) sum += shrunk[k];
    const Ball error = change * sum / (Ball(1, bits) - shrunk.back());
    return error.is_finite() ? std::optional(error.upper_end()) : std::nullopt;
  }

 private:
  /// With a zero at an index beyond an end.
  static Sequence<LaurentPolynomial> widened(Sequence<LaurentPolynomial> row, long index) {
    for (; index < row.first; --row.first) row.values.insert(row.values.begin(), LaurentPolynomial());
    while (index > row.last()) row.values.emplace_back();
    return row;
  }

  const ParametricMask& mask_;
  const Recurrence& recurrence_;
  int order_ = 0;
  int block_ = 1;                         ///< levels whose norm is taken as one
  Sequence<LaurentPolynomial> row_{};     ///< of numbers
  Sequence<LaurentPolynomial> change_{};  ///< of differences, times the denominator
  std::optional<ParametricMask> differences_;
};

Ball largest_difference(std::vector<Ball> values, int order) {
  for (int m = 0; m < order; ++m) {
    values.push_back(Ball(bits));
    for (std::size_t k = values.size() - 1; k > 0; --k) values[k] = values[k] - values[k - 1];
  }
  return largest_modulus(values);
}

}  // namespace

LevelMasks masks_of_levels(const ParametricMask& mask, const Recurrence& recurrence, const Rational& start,
                           std::size_t levels) {
  const LaurentPolynomial below = mask.denominator();
  LevelMasks result;
  for (const Interval& w : recurrence.values(start, levels)) {
    const std::size_t level = result.first.size();
    if (w.lower < w.upper ? !has_no_real_root(below, w.lower, w.upper) : below(w.lower) == 0)
      fail(ErrorKind::domain, "levels: need a mask for each level, got none for level {}", level);
    result.first.emplace_back(mask.at((w.lower + w.upper) / 2));
  }
  return result;
}

LimitValues limit_values(const LevelMasks& masks, int level, const Deadline& deadline) {
  require(!masks.again.empty(), "limit: need masks for all levels, got {}", masks.first.size());
  const std::vector<Mask> first = curves(masks.first), again = curves(masks.again);
  const Mask last = levels_as_one(masks.again).curve();
  const int arity = again.front().arity();
  Rational low = limit_support(last).lower, high = limit_support(last).upper;
  for (const auto* list : {&first, &again})
    for (const Mask& mask : *list) {
      require(mask.arity() == arity, "limit: need masks of one arity, got {} and {}", arity, mask.arity());
      low = std::min(low, limit_support(mask).lower);
      high = std::max(high, limit_support(mask).upper);
    }
  const IndexRange indices = indices_of(low, high, arity, level);
  std::size_t levels = first.size();
  while (levels < static_cast<std::size_t>(level)) levels += again.size();
  const ShiftedValues integers = limit_values_at(last, 0, deadline);
  Sequence<Rational> row{-(integers.first + static_cast<long>(integers.values.size()) - 1), integers.values};
  std::ranges::reverse(row.values);
  std::map<std::size_t, Sequence<Rational>> coefficients;
  const auto at = [&](std::size_t k) -> const Sequence<Rational>& {
    const std::size_t number = masks.number_at(k);
    const auto found = coefficients.find(number);
    return found != coefficients.end()
               ? found->second
               : coefficients.emplace(number, coefficients_of(masks.mask(number).curve())).first->second;
  };
  for (std::size_t k = levels; k-- > static_cast<std::size_t>(level);)
    row = pulled_back(row, at(k), arity, Rational(0));
  Sequence<Rational> data{0, {1}};
  for (std::size_t k = 0; k < static_cast<std::size_t>(level); ++k) data = refined(data, at(k), arity, Rational(0));
  return {arity, level, 0, indices.first, applied(row, data, indices, Rational(0))};
}

namespace {

/// A(z^stride) V(z), without zeros.
LatticeSequence through(const LatticeMask& mask, long stride, const LatticeSequence& values) {
  std::vector<LatticeMask::Term> terms = mask.terms();
  for (LatticeMask::Term& term : terms) term.exponents[0] *= stride;
  LatticeSequence result = convolution(terms, mask.components(), values);
  std::erase_if(result, [](const auto& entry) { return entry.second == 0; });
  if (result.size() > static_cast<std::size_t>(most_values))
    fail(ErrorKind::size, "limit: need at most {} values, got {}", most_values, result.size());
  return result;
}

/// The values at the indices that the arity divides.
LatticeSequence at_multiples(const LatticeSequence& values, long arity) {
  LatticeSequence result;
  for (const auto& [index, value] : values) {
    if (modulo(index[0], arity) != 0) continue;
    LatticePoint coarse = index;
    coarse[0] /= arity;
    result.emplace(std::move(coarse), value);
  }
  return result;
}

}  // namespace

LatticeSequence limit_values(const LevelMasks& masks, const LatticeSequence& at_integers, int level) {
  require(level >= 0, "limit: need level >= 0, got {}", level);
  require(!masks.again.empty(), "limit: need masks for all levels, got {}", masks.first.size());
  const LatticeMask& model = masks.again.front();
  for (const auto* list : {&masks.first, &masks.again})
    for (const LatticeMask& mask : *list)
      require(mask.dimension() == 1 && mask.components() == model.components() && mask.arity() == model.arity(),
              "limit: need masks of one variable, one arity and one size");
  if (at_integers.empty()) return {};
  // The functions are not 0 on most of the points between those that are known.
  const Rational least(at_integers.rbegin()->first[0] - at_integers.begin()->first[0] + 1, 4);
  if (least * power(Rational(model.arity()), level) > most_values)
    fail(ErrorKind::size, "limit: need at most {} values, got level {}", most_values, level);
  const auto points = static_cast<std::size_t>(level);
  std::size_t levels = masks.first.size();
  while (levels < points) levels += masks.again.size();
  LatticeSequence values = at_integers;
  for (std::size_t k = levels; k-- > points;) values = at_multiples(through(masks.at(k), 1, values), model.arity());
  long stride = 1;
  for (std::size_t k = points; k-- > 0; stride *= model.arity()) values = through(masks.at(k), stride, values);
  return values;
}

EnclosedLimitValues limit_values(const ParametricMask& mask, const Recurrence& recurrence, const Rational& start,
                                 int level) {
  require(mask.letters() == 1 && mask.components() == 1, "limit: need numbers with one letter");
  const IndexRange range = mask.support();
  const int arity = mask.arity();
  const IndexRange indices = indices_of(Rational(range.first, arity - 1), Rational(range.last, arity - 1), arity,
                                        level);
  const Tail tail(mask, recurrence);
  const auto points = static_cast<std::size_t>(level), block = static_cast<std::size_t>(tail.block());
  const std::vector<Interval> values = recurrence.values(start, points + block * most_blocks + 1);
  const auto at = [&](std::size_t k) {
    Sequence<Ball> coefficients = Tail::coefficients(mask, values[k]);
    for (const Ball& one : coefficients.values)
      if (!one.is_finite()) fail(ErrorKind::domain, "limit: need a mask at each level, got none at level {}", k);
    return coefficients;
  };
  Sequence<Ball> data{0, {Ball(1, bits)}};
  for (std::size_t k = 0; k < points; ++k) data = refined(data, at(k), arity, Ball(bits));
  Ball differences = largest_difference(data.values, tail.order());
  const Ball wanted = Ball(1, bits).scaled(-wanted_bits);
  std::optional<Ball> error;
  std::size_t levels = points;
  for (std::size_t k = points; k <= points + block * most_blocks && !(error && error->is_less(wanted)); k += block) {
    if (const auto found = tail.error_from(values[k])) {
      const Ball whole = (*found * differences).upper_end();
      if (!error || whole.is_less(*error)) {
        error = whole;
        levels = k;
      }
    }
    if (k + block < values.size()) {
      const auto from = values.begin() + static_cast<std::ptrdiff_t>(k);
      differences = differences * tail.norms({from, from + static_cast<std::ptrdiff_t>(block)}).back();
    }
  }
  if (!error) fail(ErrorKind::undecided, "limit: differences were not proved to contract at late levels");
  Sequence<Ball> row = tail.row();
  for (std::size_t k = levels; k-- > points;) row = pulled_back(row, at(k), arity, Ball(bits));
  EnclosedLimitValues result{arity, level, indices.first, {}, tail.order(), static_cast<int>(levels)};
  for (const Ball& value : applied(row, data, indices, Ball(bits)))
    result.values.push_back(Interval::of(value.widened(*error).enclosure()));
  return result;
}

}  // namespace subcert
