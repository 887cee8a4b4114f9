#include "property_range.hpp"

#include "between_zeros.hpp"
#include "box_search.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/regularity/holder_regularity.hpp>
#include <subcert/analysis/regularity/stability.hpp>
#include <subcert/analysis/symbol/polynomials/real_roots.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <set>

namespace subcert {
namespace {

using namespace family;

constexpr double radius_seconds = 2;     // for one interval
constexpr double short_seconds = 0.8;    // for one that is short: its neighbours are as hard
constexpr int short_share = 64;          // of the range
constexpr double extending_seconds = 6;  // for all that took too long
constexpr int shortest_share = 16;       // of the width that may stay open: several intervals make a gap
constexpr std::size_t longest_end = 24;  // letters of a product that names an end

/// Open intervals on which all coefficients of the scheme for divided differences are positive, so that it converges
/// [CDM91, thm 3.3].
std::vector<Box> positive_intervals(const ParametricMask& mask, const Rational& low, const Rational& high) {
  const IndexRange all = mask.support();
  std::set<Rational> ends{low, high};
  std::vector<LaurentPolynomial> coefficients;
  for (long i = all.first; i <= all.last; ++i) {
    coefficients.push_back(mask.coefficient(i));
    if (coefficients.back().is_zero()) return {};
    for (const SpecialValue& zero : zeros_of(coefficients.back(), low, high, high - low, SpecialValue::Why::sign))
      ends.insert({*zero.value.lower, *zero.value.upper});
  }
  std::vector<Box> result;
  for (auto end = std::next(ends.begin()); end != ends.end(); ++end) {
    const Box segment{{*std::prev(end)}, {*end}};
    const bool free = std::ranges::none_of(coefficients, [&](const LaurentPolynomial& c) {
      return count_real_roots(c, segment.low[0], segment.high[0]) > 0;
    });
    const Mask inside = mask.at(segment.middle());
    if (free && inside.symbol().length() == all.last - all.first + 1 && has_positive_mask(inside))
      result.push_back(segment);
  }
  return result;
}

class RangeSearch {
 public:
  RangeSearch(const ParametricMask& mask, const RangeProperty& property, const Box& range,
              const std::vector<Box>& positive, const RangeOptions& options)
      : property_(property),
        positive_(positive),
        options_(options),
        range_(range),
        search_(mask, property, range, options.budget) {}

  /// Decided or too short to be halved; an interval with neither proof is not decided.
  std::vector<IntervalProof> intervals() {
    std::vector<IntervalProof> done;
    const auto is_short = [&](const Box& box) { return box.width() * short_share < range_.width(); };
    const auto is_last = [&](const Box& box, double seconds) {
      // Where a proof takes long that for the halves does as well.
      const bool hard = seconds > 0.75 * short_seconds && box.width() <= options_.width;
      return hard || box.width() * shortest_share <= options_.width || (is_short(box) && is_known(box));
    };
    search_.run({options_.jobs,
                 {search_.look_if_possible(range_.low), search_.look_if_possible(range_.high)},
                 [&](const Box& box) { return is_short(box) ? short_seconds : radius_seconds; },
                 is_last},
                [&](BoxProof proof) {
                  done.push_back({proof.box.low[0], proof.box.high[0], std::move(proof.above), std::move(proof.below),
                                  std::move(proof.reason)});
                });
    std::sort(done.begin(), done.end(), [](const auto& a, const auto& b) { return a.low < b.low; });
    extend_proved(done);
    return done;
  }

  /// The polynomial that vanishes where the eigenvalue of the bound is the power of the threshold; zero where the
  /// product would be long.
  LaurentPolynomial crossing(const EigenvalueBound& like) {
    // As often as makes the power of the threshold rational.
    const Threshold& threshold = search_.threshold();
    const long times = threshold.rational_power(static_cast<long>(like.word.size()));
    EigenvalueBound bound;
    for (long k = 0; k < times; ++k) bound.word.insert(bound.word.end(), like.word.begin(), like.word.end());
    if (bound.word.size() > longest_end) return {};
    const Rational modulus = std::max(Rational(1), threshold.exact_power(static_cast<long>(bound.word.size())));
    (like.re == 0 ? bound.im : bound.re) = like.re < 0 && times % 2 == 1 ? Rational(-modulus) : modulus;
    return in_one_letter(search_.radius().characteristic(bound, options_.budget.deadline));
  }

  /// Between a proved and a refuted piece, by the bound that refutes beside the gap.
  std::optional<RangeEnd> end_between(const RangePiece& gap, const EigenvalueBound& beside) {
    const LaurentPolynomial polynomial = crossing(beside);
    if (polynomial.is_zero() || polynomial(gap.low) == 0 || polynomial(gap.high) == 0 ||
        count_real_roots(polynomial, gap.low, gap.high, options_.budget.deadline) != 1)
      return std::nullopt;
    for (const PolynomialFactor& factor : irreducible_factors(polynomial))
      if (count_real_roots(factor.polynomial, gap.low, gap.high, options_.budget.deadline) == 1)
        // At the end itself the radius is at least the threshold.
        return RangeEnd{gap.low, gap.high, factor.polynomial, beside.word,
                        property_.kind != RangeProperty::Kind::holder && search_.refutes_on({{gap.low}, {gap.high}})
                            ? Truth::no
                            : Truth::unknown};
    return std::nullopt;
  }

  /// Values in a gap between two pieces of one verdict, or at an end of the range: where shifts may be unstable, or
  /// where the radius of a product meets the threshold.
  std::vector<SpecialValue> inside(const RangePiece& gap) {
    if (auto values = zeros_of(search_.unstable(), gap.low, gap.high, options_.width, SpecialValue::Why::unstable);
        !values.empty())
      return values;
    const std::vector<int> word = search_.look_if_possible({(gap.low + gap.high) / 2}).word;
    if (word.empty() || options_.budget.deadline.expired()) return {};
    for (const EigenvalueBound& kind : {EigenvalueBound{word, 1, 0}, {word, -1, 0}, {word, 0, 1}})
      if (auto values = zeros_of(crossing(kind), gap.low, gap.high, options_.width, SpecialValue::Why::threshold);
          !values.empty())
        return values;
    return {};
  }

 private:
  /// Inside of what is decided without a search.
  bool is_known(const Box& box) const {
    return std::ranges::any_of(positive_, [&](const Box& one) { return one.low <= box.low && box.high <= one.high; });
  }

  /// What took too long beside a proved interval gets more time, as long as that helps: a busy machine leaves no
  /// slivers.
  void extend_proved(std::vector<IntervalProof>& intervals) {
    const Deadline end = options_.budget.deadline.at_most(extending_seconds);
    const auto extend = [&](const IntervalProof& beside, IntervalProof& next) {
      if (!beside.above || next.above || next.below || !search_.threshold().is_reachable() || end.expired()) return;
      try {
        next.above = search_.radius().from_above({{next.low}, {next.high}}, search_.threshold().below(), false,
                                                 {end.at_most(radius_seconds), options_.budget.memory});
      } catch (const Error&) {  // the reason is there already
      }
      if (next.above) next.reason.clear();
    };
    for (std::size_t k = 1; k < intervals.size(); ++k) extend(intervals[k - 1], intervals[k]);
    for (std::size_t k = intervals.size(); k-- > 1;) extend(intervals[k], intervals[k - 1]);
  }

  RangeProperty property_;
  const std::vector<Box>& positive_;
  const RangeOptions& options_;
  Box range_;  // what is asked for
  BoxSearch search_;
};

std::vector<RangePiece> pieces_of(const std::vector<IntervalProof>& intervals) {
  std::vector<RangePiece> result;
  for (const IntervalProof& proof : intervals)
    result.push_back({proof.low, proof.high, proof.holds(), true, true, proof.reason});
  return merged(result);
}

/// What a search leaves open is decided where coefficients are positive; `at` decides single values beside that.
std::vector<RangePiece> decided_by_positivity(const std::vector<RangePiece>& pieces, const std::vector<Box>& positive,
                                              const std::function<Truth(const Rational&)>& at) {
  std::vector<RangePiece> result;
  for (const RangePiece& piece : pieces) {
    if (piece.holds != Truth::unknown || piece.low == piece.high) {
      result.push_back(piece);
      continue;
    }
    const auto rest = [&](const Rational& begin, const Rational& end) {
      RangePiece left = piece;
      left.low = begin;
      left.high = end;
      if (begin == end) left.holds = at(begin);
      if (left.holds != Truth::unknown) left.reason.clear();
      result.push_back(std::move(left));
    };
    Rational reached = piece.low;
    bool is_open = true;  // whether that value itself is still to be decided
    for (const Box& one : positive) {
      const Rational low = std::max(one.low[0], piece.low), high = std::min(one.high[0], piece.high);
      if (low >= high) continue;
      const bool from = piece.low <= one.low[0], to = one.high[0] <= piece.high;  // ends are no positive ones
      if (from) rest(reached, low);
      result.push_back({low, high, Truth::yes, !from, !to});
      reached = high;
      is_open = to;
    }
    if (is_open) rest(reached, piece.high);
  }
  return merged(result);
}

}  // namespace

void require_family(const ParametricMask& mask, const Rational& low, const Rational& high) {
  require_box("range", mask, {{low}, {high}});
  const LaurentPolynomial q = mask.denominator();
  require(q == LaurentPolynomial(1) || has_no_real_root(q, low, high),
          "range: need a range without zeros of the denominator of the mask, got {} to {}", low, high);
}

std::optional<RangeProperty> parse_range_property(std::string_view text) {
  using Kind = RangeProperty::Kind;
  if (text == "convergent") return RangeProperty{Kind::convergent, 0};
  if (text == "stable") return RangeProperty{Kind::stable, 0};
  for (int order = 0; order < 3; ++order)
    if (text == std::array{"positive", "monotone", "convex"}[static_cast<std::size_t>(order)])
      return RangeProperty{Kind::preserving, order};
  struct Ordered {
    std::string_view name;
    Kind kind;
    int denominator;  // the largest
  };
  for (const Ordered& one : {Ordered{"C", Kind::smooth, 1},
                             {"HC", Kind::hermite, 1},
                             {"holder>=", Kind::holder, 1000},
                             {"sobolev>=", Kind::sobolev, 1000}}) {
    if (!text.starts_with(one.name) || text.size() > 40) continue;
    const auto order = parse_rational(text.substr(one.name.size()));
    if (!order || *order < 0 || *order > 100 || denominator(*order) > one.denominator) return std::nullopt;
    if (one.kind == Kind::smooth && *order == 0) return RangeProperty{Kind::convergent, 0};
    return RangeProperty{one.kind, *order};
  }
  return std::nullopt;
}

PropertyRange property_range(const ParametricMask& mask, const RangeProperty& property, const Rational& low,
                             const Rational& high, const RangeOptions& options) {
  require_family(mask, low, high);
  const int rules = sum_rules(mask);
  require_property("range", mask, property, rules);
  if (changes_at_zeros(property, rules)) return property_between_zeros(mask, rules, property, low, high, options);
  const std::vector<Box> positive = property.kind == RangeProperty::Kind::holder || mask.components() > 1
                                        ? std::vector<Box>()
                                        : positive_intervals(divided_difference_scheme(
                                                                 mask, numerator(property.order).convert_to<int>()),
                                                             low, high);
  RangeSearch search(mask, property, {{low}, {high}}, positive, options);
  PropertyRange result;
  result.sum_rules = rules;
  std::vector<IntervalProof> intervals = search.intervals();
  result.pieces = pieces_of(intervals);
  if (!positive.empty() && !is_complete(result.pieces, 0))
    result.pieces = decided_by_positivity(result.pieces, positive, [&](const Rational& w) {
      return holds_at(mask.at(w), property, options.budget.deadline);
    });
  result.complete = is_complete(result.pieces, options.width);
  for (std::size_t k = 0; k < result.pieces.size(); ++k) {
    const RangePiece& gap = result.pieces[k];
    if (gap.holds != Truth::unknown || gap.low == gap.high) continue;
    const Truth before = k > 0 ? result.pieces[k - 1].holds : Truth::unknown,
                after = k + 1 < result.pieces.size() ? result.pieces[k + 1].holds : Truth::unknown;
    if (before == after || before == Truth::unknown || after == Truth::unknown) {
      for (SpecialValue& value : search.inside(gap)) result.special.push_back(std::move(value));
      continue;
    }
    if (gap.high - gap.low > options.width) continue;
    const auto beside = std::find_if(intervals.begin(), intervals.end(), [&](const IntervalProof& proof) {
      return proof.below && (before == Truth::no ? proof.high == gap.low : proof.low == gap.high);
    });
    if (beside == intervals.end()) continue;
    if (auto end = search.end_between(gap, *beside->below)) result.ends.push_back(std::move(*end));
  }
  std::erase_if(intervals, [](const IntervalProof& proof) { return proof.holds() == Truth::unknown; });
  result.proofs = std::move(intervals);
  for (SpecialValue& value : zeros_of(special_values(mask), low, high, options.width, SpecialValue::Why::sum_rules))
    replace_equal(result.special, std::move(value));
  sort_values(result.special);
  for (SpecialValue& value : result.special) {
    const auto piece = std::find_if(result.pieces.begin(), result.pieces.end(), [&](const RangePiece& candidate) {
      const Rational &from = *value.value.lower, &to = *value.value.upper;
      return (candidate.low < from || (candidate.low_included && candidate.low == from)) &&
             (to < candidate.high || (candidate.high_included && candidate.high == to));
    });
    if (piece != result.pieces.end()) value.holds = piece->holds;
    if (value.holds == Truth::unknown && value.value.is_exact() && mask.components() == 1)
      value.holds = holds_at(mask.at(*value.value.lower), property, options.budget.deadline);
  }
  return result;
}

}  // namespace subcert
