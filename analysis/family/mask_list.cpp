#include "mask_list.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/radii/joint/constrained.hpp>
#include <subcert/analysis/regularity/stability.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/transition/transition.hpp>

#include <algorithm>

namespace subcert {
namespace {

constexpr int most_classes = 64;
constexpr std::size_t longest_sequence = 6;  // of which the shifts are looked at

void require_list(const MaskList& list) {
  require(!list.masks.empty(), "levels: need a mask, got none");
  for (const Mask& mask : list.masks) {
    require(mask.arity() == list.masks.front().arity(), "levels: need masks of one arity, got {} and {}",
            list.masks.front().arity(), mask.arity());
    require(sum_rules(mask) >= 1, "levels: need a sum rule for each mask, got none for {}",
            mask.symbol().to_mask_text());
  }
  const auto is_mask = [&](std::size_t number) { return number < list.masks.size(); };
  require(std::ranges::all_of(list.period, is_mask) &&
              std::ranges::all_of(list.follows, [&](const auto& p) { return is_mask(p.first) && is_mask(p.second); }),
          "levels: need numbers of masks below {}", list.masks.size());
}

/// a_(L-1)(z) a_(L-2)(z^a) ... a_0(z^(a^(L-1))): L levels as one. Nothing where that has too many classes.
std::optional<Mask> in_one(const std::vector<Mask>& masks, const std::vector<std::size_t>& sequence) {
  LaurentPolynomial symbol(1);
  int arity = 1;
  for (std::size_t k = sequence.size(); k-- > 0;) {
    const Mask& mask = masks[sequence[k]];
    symbol *= mask.symbol().dilated(arity);
    arity *= mask.arity();
    if (arity > most_classes) return std::nullopt;
  }
  return Mask(symbol, arity);
}

int common_sum_rules(const std::vector<Mask>& masks) {
  int rules = sum_rules(masks.front());
  for (const Mask& mask : masks) rules = std::min(rules, sum_rules(mask));
  return rules;
}

/// T_0, T_1, ... of each mask, for differences of this order, on a window for all of them.
MatrixFamily matrices_of(const std::vector<Mask>& masks, int order) {
  std::vector<LaurentPolynomial> symbols;
  long width = 1;
  const long arity = masks.front().arity();
  for (const Mask& mask : masks) {
    const LaurentPolynomial b = divided_difference_scheme(mask, order).symbol();
    symbols.push_back(b.shifted(-b.lowest()));
    width = std::max(width, (symbols.back().highest() + arity - 2) / (arity - 1));
  }
  std::vector<RationalMatrix> matrices;
  for (const LaurentPolynomial& symbol : symbols)
    for (long t = 0; t < arity; ++t)
      matrices.push_back(transition_block(symbol, static_cast<int>(arity), t, {0, width - 1}, {0, width - 1}));
  return MatrixFamily(std::move(matrices));
}

/// Products have the matrix of the first level on their left: paths go back from the last one.
std::vector<Succession> backwards(const MaskList& list, std::size_t arity) {
  std::vector<Succession> graph;
  for (const auto& [before, after] : list.follows)
    for (std::size_t t = 0; t < arity; ++t) graph.push_back({after, before, after * arity + t});
  return graph;
}

/// Without what is repeated.
std::vector<std::size_t> shortest_period(std::vector<std::size_t> sequence) {
  for (std::size_t length = 1; length < sequence.size(); ++length) {
    if (sequence.size() % length != 0) continue;
    bool repeats = true;
    for (std::size_t k = length; k < sequence.size(); ++k) repeats = repeats && sequence[k] == sequence[k - length];
    if (!repeats) continue;
    sequence.resize(length);
    break;
  }
  return sequence;
}

}  // namespace

ExponentOfList exponent_of(const MaskList& list, const Budget& budget) {
  require_list(list);
  std::vector<Mask> masks = list.masks;
  if (!list.period.empty()) {
    const std::optional<Mask> one = in_one(list.masks, list.period);
    require(one.has_value(), "levels: need a period with arity^length up to {}, got a length of {}", most_classes,
            list.period.size());
    masks = {*one};
  }
  const auto arity = static_cast<std::size_t>(masks.front().arity());
  const int common = common_sum_rules(masks);
  ExponentOfList result{common, {}, {}, {}, {}, matrices_of(masks, common), {}};
  std::vector<int> letters;
  if (!list.follows.empty()) {
    LiftedFamily lift = lifted(result.family, backwards(list, arity));
    result.family = std::move(lift.family);
    letters = std::move(lift.letters);
  }
  result.radius = joint_spectral_radius(result.family, budget);
  const Rational rules(result.sum_rules);
  const auto exponent_from = [&](const Rational& radius) {
    const Enclosure logarithm = log_ratio(radius, masks.front().arity());
    return Enclosure{rules - *logarithm.upper, rules - *logarithm.lower};
  };
  const Rational lower = *exponent_from(*result.radius.radius.upper).lower;
  if (lower > 0) result.exponent.lower = lower;
  for (const int letter : result.radius.product.word) {
    const auto one = static_cast<std::size_t>(letters.empty() ? letter : letters[static_cast<std::size_t>(letter)]);
    result.sequence.push_back(one / arity);
  }
  result.sequence = list.period.empty() ? shortest_period(std::move(result.sequence)) : list.period;
  const auto leading = list.period.empty() && result.sequence.size() <= longest_sequence
                           ? in_one(list.masks, result.sequence)
                       : list.period.empty() ? std::nullopt
                                             : std::optional(masks.front());
  result.stable = leading ? has_stable_shifts(*leading)
                          : Decision{Truth::unknown, "the sequence is too long for a look at its shifts"};
  const Rational& largest = *result.radius.product.radius.lower;
  if (result.exponent.lower && result.stable.is_yes() && largest > 1)
    result.exponent.upper = *exponent_from(largest).upper;
  result.exact = {Truth::unknown, "no product was proved to attain the radius"};
  if (result.radius.exact.is_yes())
    result.exact = result.exponent.upper
                       ? Decision{Truth::yes, "the product attains the radius, and its shifts are stable"}
                       : Decision{Truth::unknown, "the shifts of its sequence were not proved stable"};
  return result;
}

}  // namespace subcert
