#include "mask_list.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/radii/joint/constrained.hpp>
#include <subcert/analysis/radii/polytope_search/product_search.hpp>
#include <subcert/analysis/regularity/stability.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/transition/transition.hpp>

#include <algorithm>
#include <iterator>
#include <set>

namespace subcert {
namespace {

constexpr int most_classes = 64;

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
  require(has_sequence(list), "levels: need a sequence of masks that goes on for ever, got none");
}

/// Of each mask the first one that is equal and that the same sequences may follow: the coarsest partition in which
/// equal masks of one part have successors in the same parts.
std::vector<std::size_t> representatives(const MaskList& list) {
  std::vector<std::size_t> part(list.masks.size(), 0);
  for (std::size_t parts = 0; true;) {
    std::vector<std::set<std::size_t>> next(part.size());
    for (const auto& [before, after] : list.follows) next[before].insert(part[after]);
    std::vector<std::size_t> finer(part.size());
    std::size_t found = 0;
    for (std::size_t i = 0; i < part.size(); ++i) {
      std::size_t j = 0;
      while (part[j] != part[i] || next[j] != next[i] || list.masks[j].symbol() != list.masks[i].symbol()) ++j;
      finer[i] = j;
      found += j == i;
    }
    part = std::move(finer);
    if (found == parts) return part;
    parts = found;
  }
}

/// The same sequences of masks, along a graph without twins; in any order where each mask may follow each. `kept`: the
/// numbers that its masks have in the list.
MaskList with_twins_as_one(const MaskList& list, std::vector<std::size_t>& kept) {
  const std::vector<std::size_t> first = representatives(list);
  MaskList result{{}, {}, {}, list.most_rules};
  std::vector<std::size_t> number(first.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] == i) {
      number[i] = kept.size();
      kept.push_back(i);
      result.masks.push_back(list.masks[i]);
    }
    number[i] = number[first[i]];
  }
  std::set<std::pair<std::size_t, std::size_t>> follows;
  for (const auto& [before, after] : list.follows) follows.insert({number[before], number[after]});
  if (follows.size() < kept.size() * kept.size()) result.follows.assign(follows.begin(), follows.end());
  return result;
}

/// L levels as one; nothing where that has too many classes.
std::optional<Mask> in_one(const std::vector<Mask>& masks, const std::vector<std::size_t>& sequence) {
  std::vector<Mask> levels;
  long classes = 1;
  for (const std::size_t number : sequence) {
    levels.push_back(masks[number]);
    classes *= levels.back().arity();
    if (classes > most_classes) return std::nullopt;
  }
  return levels_as_one(levels);
}

int common_sum_rules(const std::vector<Mask>& masks, const std::optional<int>& most) {
  int rules = most.value_or(sum_rules(masks.front()));
  for (const Mask& mask : masks) rules = std::min(rules, sum_rules(mask));
  return rules;
}

/// T_0, T_1, ... of each mask, for differences of this order, on a window for all of them.
MatrixFamily matrices_of(const std::vector<Mask>& masks, int order) {
  std::vector<Mask> schemes;
  long width = 1;
  for (const Mask& mask : masks) {
    schemes.push_back(divided_difference_scheme(mask, order));
    width = std::max(width, TransitionWindow(schemes.back().symbol().length() - 1, mask.arity()).width);
  }
  std::vector<RationalMatrix> matrices;
  for (const Mask& scheme : schemes)
    std::ranges::move(transition_matrices(scheme, width), std::back_inserter(matrices));
  return MatrixFamily(std::move(matrices));
}

/// Products have the matrix of the first level on their left: paths go back from the last one.
std::vector<Succession> backwards(const MaskList& list, std::size_t arity) {
  std::vector<Succession> graph;
  for (const auto& [before, after] : list.follows)
    for (std::size_t t = 0; t < arity; ++t) graph.push_back({after, before, after * arity + t});
  return graph;
}

/// Of the letters of a product, without what is repeated.
std::vector<std::size_t> masks_of(std::vector<int> word, const std::vector<int>& letters, std::size_t arity) {
  for (int& letter : word) {
    if (!letters.empty()) letter = letters[static_cast<std::size_t>(letter)];
    letter /= static_cast<int>(arity);
  }
  const std::vector<int> sequence = polytope::without_repetitions(std::move(word));
  return {sequence.begin(), sequence.end()};
}

}  // namespace

bool has_sequence(const MaskList& list) {
  // Pairs to masks that nothing follows are left out, until there are none.
  auto pairs = list.follows;
  const auto is_dead = [&](const auto& pair) {
    return std::ranges::none_of(pairs, [&](const auto& next) { return next.first == pair.second; });
  };
  while (true) {
    std::vector<std::pair<std::size_t, std::size_t>> kept;
    std::ranges::remove_copy_if(pairs, std::back_inserter(kept), is_dead);
    if (kept.size() == pairs.size()) return list.follows.empty() || !kept.empty();
    pairs = std::move(kept);
  }
}

MaskList without_twins(const MaskList& list) {
  require_list(list);
  std::vector<std::size_t> kept;
  return list.period.empty() ? with_twins_as_one(list, kept) : list;
}

ExponentOfList exponent_of(const MaskList& list, const Budget& budget) {
  require_list(list);
  std::vector<std::size_t> kept;
  MaskList single = list.period.empty() ? with_twins_as_one(list, kept) : list;
  std::vector<Mask> masks = single.masks;
  if (!list.period.empty()) {
    const std::optional<Mask> one = in_one(list.masks, list.period);
    require(one.has_value(), "levels: need a period with arity^length up to {}, got a length of {}", most_classes,
            list.period.size());
    masks = {*one};
  }
  const auto arity = static_cast<std::size_t>(masks.front().arity());
  const int common = common_sum_rules(masks, list.most_rules);
  ExponentOfList result{common, {}, {}, {}, {}, matrices_of(masks, common), {}, {}};
  std::vector<int> letters;
  if (!single.follows.empty()) {
    LiftedFamily lift = lifted(result.family, backwards(single, arity));
    result.family = std::move(lift.family);
    letters = std::move(lift.letters);
  }
  result.list = std::move(single);
  result.radius = joint_spectral_radius(result.family, budget);
  const Rational rules(result.sum_rules);
  const auto exponent_from = [&](const Rational& radius) {
    const Enclosure logarithm = log_ratio(radius, masks.front().arity());
    return Enclosure{rules - *logarithm.upper, rules - *logarithm.lower};
  };
  const Rational lower = *exponent_from(*result.radius.radius.upper).lower;
  if (lower > 0) result.exponent.lower = lower;
  result.sequence = list.period;
  if (list.period.empty())
    for (const std::size_t mask : masks_of(result.radius.product.word, letters, arity))
      result.sequence.push_back(kept[mask]);
  const auto leading = in_one(list.masks, result.sequence);
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
