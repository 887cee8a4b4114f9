#include "mask_list.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/radii/joint/constrained.hpp>
#include <subcert/analysis/radii/polytope_search/product_search.hpp>
#include <subcert/analysis/regularity/scheme_convergence.hpp>
#include <subcert/analysis/regularity/stability.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/transition/transition.hpp>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>

namespace subcert {
namespace {

constexpr int most_classes = 64;
constexpr double radius_share_of_lists = 0.6;  // of the time: the rest is for the functions of one sequence

bool is_of_matrices(const MaskList& list) { return list.masks.front().components() > 1; }

/// What all masks keep, of matrices.
PolynomialData require_list(const MaskList& list) {
  require(!list.masks.empty(), "levels: need a mask, got none");
  const LatticeMask& first = list.masks.front();
  for (const LatticeMask& mask : list.masks) {
    require(mask.dimension() == 1, "levels: need masks of one variable, got {}", mask.dimension());
    require(mask.arity() == first.arity(), "levels: need masks of one arity, got {} and {}", first.arity(),
            mask.arity());
    require(mask.components() == first.components(), "levels: need matrices of one size, got {} and {} rows",
            first.components(), mask.components());
    require(mask.components() > 1 || sum_rules(mask.curve()) >= 1, "levels: need a sum rule for each mask, got none");
  }
  PolynomialData polynomials = is_of_matrices(list) ? kept_polynomials(list) : PolynomialData{};
  require(!is_of_matrices(list) || !polynomials.data.empty(),
          "levels: need constant data that all masks of matrices keep, one vector up to a factor, got none");
  const auto is_mask = [&](std::size_t number) { return number < list.masks.size(); };
  require(std::ranges::all_of(list.period, is_mask) &&
              std::ranges::all_of(list.follows, [&](const auto& p) { return is_mask(p.first) && is_mask(p.second); }),
          "levels: need numbers of masks below {}", list.masks.size());
  require(has_sequence(list), "levels: need a sequence of masks that goes on for ever, got none");
  return polynomials;
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
      while (part[j] != part[i] || next[j] != next[i] || !(list.masks[j] == list.masks[i])) ++j;
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
  MaskList result{{}, {}, {}, list.most_rules, list.hermite};
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
std::optional<LatticeMask> in_one(const std::vector<LatticeMask>& masks, const std::vector<std::size_t>& sequence) {
  std::vector<LatticeMask> levels;
  long classes = 1;
  for (const std::size_t number : sequence) {
    levels.push_back(masks[number]);
    classes *= levels.back().arity();
    if (classes > most_classes) return std::nullopt;
  }
  return levels_as_one(levels);
}

std::vector<ParametricMask> parametric(const std::vector<LatticeMask>& masks) {
  std::vector<ParametricMask> result;
  for (const LatticeMask& mask : masks) result.push_back(without_letters(mask));
  return result;
}

/// So many sum rules, and T_0, T_1, ... of each mask on one space for all of them.
struct CommonMatrices {
  int sum_rules;
  MatrixFamily family;
};

/// For the divided differences of the order of the sum rules.
CommonMatrices matrices_of_numbers(const std::vector<LatticeMask>& masks, const std::optional<int>& most) {
  int rules = most.value_or(sum_rules(masks.front().curve()));
  for (const LatticeMask& mask : masks) rules = std::min(rules, sum_rules(mask.curve()));
  std::vector<Mask> schemes;
  long width = 1;
  for (const LatticeMask& mask : masks) {
    schemes.push_back(divided_difference_scheme(mask.curve(), rules));
    width = std::max(width, TransitionWindow(schemes.back().symbol().length() - 1, mask.arity()).width);
  }
  std::vector<RationalMatrix> matrices;
  for (const Mask& scheme : schemes)
    std::ranges::move(transition_matrices(scheme, width), std::back_inserter(matrices));
  return {rules, MatrixFamily(std::move(matrices))};
}

/// For what annihilates these data, which all keep.
CommonMatrices matrices_of_vectors(const std::vector<LatticeMask>& masks, const PolynomialData& polynomials) {
  std::vector<RationalMatrix> matrices;
  for (const ParametricFamily& one : difference_matrices(parametric(masks), polynomials))
    std::ranges::move(one.matrices_of(one.mask.powers().front()), std::back_inserter(matrices));
  return {static_cast<int>(polynomials.data.size()), MatrixFamily(std::move(matrices))};
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

Enclosure exponent_from(const Enclosure& radius, int rules, int arity) {
  Enclosure result;
  if (radius.upper && *radius.upper > 0) result.lower = rules - *log_ratio(*radius.upper, arity).upper;
  if (radius.lower && *radius.lower > 0) result.upper = rules - *log_ratio(*radius.lower, arity).lower;
  return result;
}

/// The upper end by the stable shifts of the leading sequence.
void tell_of_numbers(ExponentOfList& result, const std::optional<LatticeMask>& leading, int arity) {
  const Enclosure found = exponent_from(result.radius.radius, result.sum_rules, arity);
  if (found.lower && *found.lower > 0) result.exponent.lower = found.lower;
  result.stable = leading ? has_stable_shifts(leading->curve())
                          : Decision{Truth::unknown, "the sequence is too long for a look at its shifts"};
  const Rational& largest = *result.radius.product.radius.lower;
  if (result.exponent.lower && result.stable.is_yes() && largest > 1)
    result.exponent.upper = exponent_from(result.radius.product.radius, result.sum_rules, arity).upper;
  result.exact = {Truth::unknown, "no product was proved to attain the radius"};
  if (result.radius.exact.is_yes())
    result.exact = result.exponent.upper
                       ? Decision{Truth::yes, "the product attains the radius, and its shifts are stable"}
                       : Decision{Truth::unknown, "the shifts of its sequence were not proved stable"};
}

/// Whether the functions of the leading sequence show all of the radius, exactly: their leading product, of levels of
/// `arity` each, has the spectral radius of that of the list.
bool functions_show(const ExponentOfList& result, int arity, const Deadline& deadline) {
  const MultivariateRegularity& functions = *result.vectors->functions;
  if (!result.radius.exact.is_yes() || !functions.exact.is_yes() || !functions.space) return false;
  std::size_t levels = 0;
  for (long classes = 1; classes < functions.space->dilation.classes(); classes *= arity) ++levels;
  const std::vector<int>&whole = result.radius.product.word, &own = functions.radius->product.word;
  const std::size_t own_levels = levels * own.size(), common = std::lcm(whole.size(), own_levels);
  const auto repeated = [&](const MatrixFamily& family, const std::vector<int>& word, std::size_t times) {
    return power(family.product(word), static_cast<long>(times));
  };
  const RationalMatrix of_list = repeated(result.family, whole, common / whole.size());
  RationalMatrix of_functions = repeated(functions.space->family, own, common / own_levels);
  const Rational scale = power(Rational(arity), result.sum_rules * static_cast<long>(common));
  for (std::size_t i = 0; i < of_functions.rows(); ++i)
    for (std::size_t j = 0; j < of_functions.columns(); ++j) of_functions(i, j) *= scale;
  const MatrixFamily first({of_functions}), second({of_list});
  const ProductEvidence above = prove_product(first, {0}, deadline), below = prove_product(second, {0}, deadline);
  return above.exact && below.exact ? *above.exact >= *below.exact
                                    : radius::is_dominated(first, above, second, below, deadline);
}

/// The upper end by the functions of the leading sequence; one sequence has their exponent.
void tell_of_vectors(ExponentOfList& result, std::optional<LatticeMask> leading, int arity, int arity_of_level,
                     const Budget& budget) {
  VectorList& vectors = *result.vectors;
  const Enclosure found = exponent_from(result.radius.radius, result.sum_rules, arity);
  result.exact = result.stable = {Truth::unknown, "no convergence is proved"};
  // All products of some length are 0 where the radius is.
  vectors.decay = found.lower ? *found.lower : Rational(result.sum_rules);
  if (*vectors.decay <= 0) {
    vectors.decay.reset();
    return;
  }
  result.exponent.lower = std::min(*vectors.decay, Rational(result.sum_rules));
  result.exact = {Truth::unknown, "the sequence is too long for a look at its functions"};
  if (!leading) return;
  vectors.one = std::move(leading);
  vectors.functions = vector_regularity(*vectors.one, budget);
  const MultivariateRegularity& functions = *vectors.functions;
  if (result.list.hermite && vectors.keeps_derivatives)
    vectors.hermite = hermite_order(functions, hermite_scheme_converges(*vectors.one, budget),
                                    vectors.one->components());
  result.exact = {Truth::unknown, "the functions of its sequence have an equation with several solutions"};
  if (functions.vector->solutions != 1) return;
  result.exponent.upper = functions.exponent.upper;
  const Enclosure& own = functions.exponent;
  if (result.is_one_sequence() && own.lower && *own.lower >= *result.exponent.lower) {
    result.exponent.lower = own.lower;
    result.exact = functions.exact.is_yes() && own.is_bounded()
                       ? Decision{Truth::yes, "a product attains the radius of its functions"}
                       : Decision{Truth::unknown, "no product was proved to attain the radius of its functions"};
    return;
  }
  result.exact = {Truth::unknown, "no product was proved to attain the radius"};
  if (result.radius.exact.is_yes())
    result.exact = own.upper && functions_show(result, arity_of_level, budget.deadline)
                       ? Decision{Truth::yes, "the product attains the radius, also of the functions of its sequence"}
                       : Decision{Truth::unknown, "the functions of its sequence were not proved to show that radius"};
}

}  // namespace

PolynomialData kept_polynomials(const MaskList& list) { return kept_polynomials(parametric(list.masks)); }

AnnihilatingSpace annihilating_space(const MaskList& list) { return annihilating_space(parametric(list.masks)); }

MatrixFamily matrices_along(const MaskList& list) {
  CommonMatrices common = matrices_of_vectors(list.masks, kept_polynomials(list));
  if (list.follows.empty()) return std::move(common.family);
  return lifted(common.family, backwards(list, static_cast<std::size_t>(list.masks.front().arity()))).family;
}

MaskList in_turn(const MaskList& list) {
  MaskList result{{}, {}, {}, list.most_rules, list.hermite};
  for (std::size_t k = 0; k < list.period.size(); ++k) {
    result.masks.push_back(list.masks.at(list.period[k]));
    result.follows.emplace_back(k, (k + 1) % list.period.size());
  }
  return result;
}

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
  const PolynomialData polynomials = require_list(list);
  std::vector<std::size_t> kept;
  MaskList single = list.period.empty() ? with_twins_as_one(list, kept) : list;
  std::vector<LatticeMask> masks = single.masks;
  if (!list.period.empty()) {
    const std::optional<LatticeMask> one = in_one(list.masks, list.period);
    require(one.has_value(), "levels: need a period with arity^length up to {}, got a length of {}", most_classes,
            list.period.size());
    masks = {*one};
  }
  const int arity_of_level = list.masks.front().arity(), arity = masks.front().arity();
  const bool of_matrices = is_of_matrices(list);
  PolynomialData used = polynomials;
  if (of_matrices && !list.period.empty())  // as one mask they may keep more
    if (PolynomialData own = kept_polynomials(parametric(masks)); own.data.size() >= used.data.size())
      used = std::move(own);
  CommonMatrices common = of_matrices ? matrices_of_vectors(masks, used) : matrices_of_numbers(masks, list.most_rules);
  ExponentOfList result{common.sum_rules, {}, {}, {}, {}, std::move(common.family), {}, {}};
  std::vector<int> letters;
  if (!single.follows.empty()) {
    LiftedFamily lift = lifted(result.family, backwards(single, static_cast<std::size_t>(arity)));
    result.family = std::move(lift.family);
    letters = std::move(lift.letters);
  }
  result.list = std::move(single);
  result.radius = joint_spectral_radius(
      result.family, of_matrices ? Budget{budget.deadline.after(radius_share_of_lists), budget.memory} : budget);
  result.sequence = list.period;
  if (list.period.empty())
    for (const std::size_t mask : masks_of(result.radius.product.word, letters, static_cast<std::size_t>(arity)))
      result.sequence.push_back(kept[mask]);
  const auto leading = in_one(list.masks, result.sequence);
  if (of_matrices) {
    result.vectors.emplace().keeps_derivatives = polynomials.hermite;
    for (const LatticeMask& mask : list.masks) result.vectors->alone.push_back(sum_rules(without_letters(mask)));
    tell_of_vectors(result, leading, arity, arity_of_level, budget);
  } else {
    tell_of_numbers(result, leading, arity);
  }
  return result;
}

}  // namespace subcert
