#include "property_range.hpp"

#include "between_zeros.hpp"
#include "family_radius.hpp"
#include "threshold.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/regularity/holder_regularity.hpp>
#include <subcert/analysis/regularity/stability.hpp>
#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/symbol/parallel.hpp>
#include <subcert/analysis/symbol/real_roots.hpp>

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
constexpr double far_below = 0.97;       // of the threshold: quadratic forms may do
constexpr int shortest_share = 16;       // of the width that may stay open: several intervals make a gap
constexpr std::size_t longest_end = 24;  // letters of a product that names an end
constexpr int most_matrices = 64;

/// Open intervals on which all coefficients of the scheme for divided differences are positive, so that it converges
/// [CDM91, thm 3.3].
std::vector<Segment> positive_intervals(const ParametricMask& mask, const Rational& low, const Rational& high) {
  const IndexRange all = mask.support();
  std::set<Rational> ends{low, high};
  std::vector<LaurentPolynomial> coefficients;
  for (long i = all.first; i <= all.last; ++i) {
    coefficients.push_back(mask.coefficient(i));
    if (coefficients.back().is_zero()) return {};
    for (const SpecialValue& zero : zeros_of(coefficients.back(), low, high, high - low, SpecialValue::Why::sign))
      ends.insert({*zero.value.lower, *zero.value.upper});
  }
  std::vector<Segment> result;
  for (auto end = std::next(ends.begin()); end != ends.end(); ++end) {
    const Segment segment{*std::prev(end), *end};
    const bool free = std::ranges::none_of(
        coefficients, [&](const LaurentPolynomial& c) { return count_real_roots(c, segment.low, segment.high) > 0; });
    const Mask inside = mask.at(segment.middle());
    if (free && inside.symbol().length() == all.last - all.first + 1 && has_positive_mask(inside))
      result.push_back(segment);
  }
  return result;
}

struct Node {
  Segment segment;
  Look at_low, at_high;
};

class RangeSearch {
 public:
  RangeSearch(const ParametricMask& mask, int rules, const RangeProperty& property, const Segment& range,
              const std::vector<Segment>& positive, const RangeOptions& options)
      : property_(property),
        positive_(positive),
        options_(options),
        threshold_(property, mask.arity(), rules),
        radius_(transition_matrices(divided_difference_scheme(mask, rules), range.low)),
        range_(range) {
    if (property.kind != RangeProperty::Kind::convergent) unstable_ = unstable_values(mask, options.budget.deadline);
  }

  /// Decided or too short to be halved; an interval with neither proof is not decided.
  std::vector<IntervalProof> intervals() {
    std::vector<IntervalProof> done;
    std::vector<Node> open{{range_, look_if_possible(range_.low), look_if_possible(range_.high)}};
    while (!open.empty()) {
      std::vector<IntervalProof> decided(open.size());
      std::vector<Look> middles(open.size());
      std::vector<double> seconds(open.size());
      parallel_tasks(open.size(), options_.jobs, [&](std::size_t k) {
        const Stopwatch watch;
        decided[k] = decide(open[k], middles[k]);
        seconds[k] = watch.seconds();
      });
      std::vector<Node> next;
      for (std::size_t k = 0; k < open.size(); ++k) {
        Node& node = open[k];
        const Rational width = node.segment.width();
        // Where a proof takes long that for the halves does as well.
        const bool hard = seconds[k] > 0.75 * short_seconds && width <= options_.width;
        if (decided[k].above || decided[k].below || hard || width * shortest_share <= options_.width ||
            is_known(node.segment) || options_.budget.deadline.expired()) {
          done.push_back(std::move(decided[k]));
          continue;
        }
        const Rational middle = node.segment.middle();
        next.push_back({{node.segment.low, middle}, std::move(node.at_low), middles[k]});
        next.push_back({{middle, node.segment.high}, std::move(middles[k]), std::move(node.at_high)});
      }
      open = std::move(next);
    }
    std::sort(done.begin(), done.end(), [](const auto& a, const auto& b) { return a.low < b.low; });
    extend_proved(done);
    return done;
  }

  /// The polynomial that vanishes where the eigenvalue of the bound is the power of the threshold; zero where the
  /// product would be long.
  LaurentPolynomial crossing(const EigenvalueBound& like) {
    // As often as makes the power of the threshold rational.
    const long times = threshold_.rational_power(static_cast<long>(like.word.size()));
    EigenvalueBound bound;
    for (long k = 0; k < times; ++k) bound.word.insert(bound.word.end(), like.word.begin(), like.word.end());
    if (bound.word.size() > longest_end) return {};
    const Rational modulus = std::max(Rational(1), threshold_.exact_power(static_cast<long>(bound.word.size())));
    (like.re == 0 ? bound.im : bound.re) = like.re < 0 && times % 2 == 1 ? Rational(-modulus) : modulus;
    return radius_.characteristic(bound, options_.budget.deadline);
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
                        property_.kind != RangeProperty::Kind::holder && is_stable_on({gap.low, gap.high})
                            ? Truth::no
                            : Truth::unknown};
    return std::nullopt;
  }

  /// Values in a gap between two pieces of one verdict, or at an end of the range: where shifts may be unstable, or
  /// where the radius of a product meets the threshold.
  std::vector<SpecialValue> inside(const RangePiece& gap) {
    if (auto values = zeros_of(unstable_, gap.low, gap.high, options_.width, SpecialValue::Why::unstable);
        !values.empty())
      return values;
    const std::vector<int> word = look_if_possible((gap.low + gap.high) / 2).word;
    if (word.empty() || options_.budget.deadline.expired()) return {};
    for (const EigenvalueBound& kind : {EigenvalueBound{word, 1, 0}, {word, -1, 0}, {word, 0, 1}})
      if (auto values = zeros_of(crossing(kind), gap.low, gap.high, options_.width, SpecialValue::Why::threshold);
          !values.empty())
        return values;
    return {};
  }

 private:
  /// Short, and inside of what is decided without a search.
  bool is_known(const Segment& segment) const {
    return segment.width() * short_share < range_.width() && std::ranges::any_of(positive_, [&](const Segment& one) {
             return one.low <= segment.low && segment.high <= one.high;
           });
  }

  Look look(const Rational& w) const { return radius_.look(w, options_.budget.deadline); }
  /// Where a search fails nothing is known of the value.
  Look look_if_possible(const Rational& w) const {
    try {
      return look(w);
    } catch (const Error&) {
      return {};
    }
  }

  /// What took too long beside a proved interval gets more time, as long as that helps: a busy machine leaves no
  /// slivers.
  void extend_proved(std::vector<IntervalProof>& intervals) const {
    const Deadline end = options_.budget.deadline.at_most(extending_seconds);
    const auto extend = [&](const IntervalProof& beside, IntervalProof& next) {
      if (!beside.above || next.above || next.below || !threshold_.is_reachable() || end.expired()) return;
      try {
        next.above = radius_.from_above({next.low, next.high}, threshold_.below(), false,
                                        {end.at_most(radius_seconds), options_.budget.memory});
      } catch (const Error&) {  // the reason is there already
      }
      if (next.above) next.reason.clear();
    };
    for (std::size_t k = 1; k < intervals.size(); ++k) extend(intervals[k - 1], intervals[k]);
    for (std::size_t k = intervals.size(); k-- > 1;) extend(intervals[k], intervals[k - 1]);
  }

  /// An interval that a search cannot treat is not decided: the others are.
  IntervalProof decide(const Node& node, Look& middle) {
    IntervalProof proof{node.segment.low, node.segment.high, std::nullopt, std::nullopt};
    try {
      if (!options_.budget.deadline.expired()) {
        middle = look(node.segment.middle());
        proof.reason = search(node, middle, proof);
      }
    } catch (const Error& error) {
      proof.reason = std::string("a search failed (") + error.what() + ")";
    }
    if (proof.above || proof.below)
      proof.reason.clear();
    else if (options_.budget.deadline.expired())
      proof.reason = spent;
    return proof;
  }

  /// Why no proof was found, where none was.
  std::string search(const Node& node, const Look& middle, IntervalProof& proof) {
    const Segment& interval = node.segment;
    const double limit = threshold_.value();
    if (middle.radius > std::max(limit, 1.0)) {
      if (!is_stable_on(interval))
        return unstable_.is_zero() ? why_stability_is_open(options_.budget.deadline)
                                   : "the shifts may be unstable at a value there";
      for (const std::vector<int>& word : {middle.word, node.at_low.word, node.at_high.word})
        if (!proof.below && !word.empty())
          proof.below = radius_.from_below(interval, word, power_of_threshold(word), false, options_.budget.deadline);
      return "no product was proved to be too large for all values there";
    }
    if (!threshold_.is_reachable()) return "only orders below the number of sum rules are proved";
    const double largest = std::max(node.at_low.radius, node.at_high.radius);
    if (largest >= limit) return "the radius comes near to the threshold";
    const double seconds = interval.width() * short_share < range_.width() ? short_seconds : radius_seconds;
    proof.above = radius_.from_above(interval, threshold_.below(), largest < far_below * limit,
                                     {options_.budget.deadline.at_most(seconds), options_.budget.memory});
    return "the radius was not proved to be below the threshold in the time for one interval";
  }

  bool is_stable_on(const Segment& interval) const {
    if (property_.kind == RangeProperty::Kind::convergent) return true;
    return has_no_real_root(unstable_, interval.low, interval.high, options_.budget.deadline);
  }

  Rational power_of_threshold(const std::vector<int>& word) const {
    return std::max(Rational(1), threshold_.power_above(static_cast<long>(word.size())));
  }

  RangeProperty property_;
  const std::vector<Segment>& positive_;
  const RangeOptions& options_;
  Threshold threshold_;
  FamilyRadius radius_;
  LaurentPolynomial unstable_;
  Segment range_;  // what is asked for
};

std::vector<RangePiece> pieces_of(const std::vector<IntervalProof>& intervals) {
  std::vector<RangePiece> result;
  for (const IntervalProof& proof : intervals)
    result.push_back({proof.low, proof.high,
                      proof.above   ? Truth::yes
                      : proof.below ? Truth::no
                                    : Truth::unknown,
                      true, true, proof.reason});
  return merged(result);
}

/// What a search leaves open is decided where coefficients are positive; `at` decides single values beside that.
std::vector<RangePiece> decided_by_positivity(const std::vector<RangePiece>& pieces,
                                              const std::vector<Segment>& positive,
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
    for (const Segment& segment : positive) {
      const Rational low = std::max(segment.low, piece.low), high = std::min(segment.high, piece.high);
      if (low >= high) continue;
      const bool from = piece.low <= segment.low, to = segment.high <= piece.high;  // ends are no positive ones
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
  require(low < high, "range: need low < high, got {} and {}", low, high);
  require(mask.arity() * (mask.degree() + 1) <= most_matrices, "range: need arity * (degree + 1) up to {}, got {}",
          most_matrices, mask.arity() * (mask.degree() + 1));
  const LaurentPolynomial& q = mask.denominator();
  require(q == LaurentPolynomial(1) || has_no_real_root(q, low, high),
          "range: need a range without zeros of the denominator of the mask, got {} to {}", low, high);
  require(sum_rules(mask) >= 1, "range: need a sum rule for all values of the parameter, got none");
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
  for (const Ordered& one :
       {Ordered{"C", Kind::smooth, 1}, {"holder>=", Kind::holder, 1000}, {"sobolev>=", Kind::sobolev, 1000}}) {
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
  if (changes_at_zeros(property, rules)) return property_between_zeros(mask, rules, property, low, high, options);
  const std::vector<Segment> positive = property.kind == RangeProperty::Kind::holder
                                            ? std::vector<Segment>()
                                            : positive_intervals(divided_difference_scheme(
                                                                     mask, numerator(property.order).convert_to<int>()),
                                                                 low, high);
  RangeSearch search(mask, rules, property, {low, high}, positive, options);
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
  std::erase_if(intervals, [](const IntervalProof& proof) { return !proof.above && !proof.below; });
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
    if (value.holds == Truth::unknown && value.value.is_exact())
      value.holds = holds_at(mask.at(*value.value.lower), property, options.budget.deadline);
  }
  return result;
}

}  // namespace subcert
