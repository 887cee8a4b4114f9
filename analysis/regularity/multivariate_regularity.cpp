#include "multivariate_regularity.hpp"

#include "regularity.hpp"
#include "scheme_convergence.hpp"
#include "sobolev.hpp"
#include "value_space.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/radii/joint/one_block.hpp>
#include <subcert/analysis/radii/schedule.hpp>
#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/masks/lattice_symmetry.hpp>
#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <numeric>

namespace subcert {
namespace {

constexpr int levels = 16;  // of norms, where they decide convergence
constexpr std::size_t largest_space = 256;

/// Provided that the scheme converges.
void decide_stability(const LatticeMask& mask, const Budget& budget, MultivariateRegularity& result) {
  try {
    result.gram = gram_function(mask, budget.deadline);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::size) throw;
    result.stable = {Truth::unknown, error.what()};
    return;
  }
  result.stable = result.gram ? has_stable_shifts(*result.gram, budget)
                              : Decision{Truth::unknown, "the inner products of the shifts were not found in time"};
}

/// Provided that phi is continuous.
std::optional<MultivariateSobolev> decide_sobolev(const LatticeMask& mask, const Deadline& deadline,
                                                  const MultivariateRegularity& result) {
  auto found = sobolev_regularity(mask, result.sum_rules, deadline);
  if (result.stable.is_yes()) return found;
  if (found) found->exponent.upper.reset();
  if (result.gram)
    if (auto exact = sobolev_regularity(mask, *result.gram, deadline)) return exact;
  return found;
}

/// The mask, and where the dilation M is no multiple of the identity with the dilations g M for symmetries g of the
/// mask, which refine the same functions. First those that turn least; of those that symmetries exchange, one.
std::vector<LatticeMask> with_turned_dilations(const LatticeMask& mask) {
  std::vector<LatticeMask> result{mask};
  if (mask.dilation().factor()) return result;
  const auto group = symmetries_along(lattice_symmetries(mask.symbol()), mask.dilation());
  std::vector<std::vector<LatticePoint>> seen{mask.dilation().rows()};
  std::vector<std::pair<long, LatticeMask>> turned;
  for (const LatticeMap& element : group) {
    const auto rows = times(element.linear, mask.dilation().rows());
    const auto is_like = [&](const std::vector<LatticePoint>& other) {
      return std::any_of(group.begin(), group.end(),
                         [&](const LatticeMap& g) { return times(g.linear, other) == times(rows, g.linear); });
    };
    if (std::any_of(seen.begin(), seen.end(), is_like)) continue;
    seen.push_back(rows);
    long trace = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) trace += rows[i][i];
    turned.emplace_back(trace, LatticeMask(mask.symbol(), Dilation(rows)));
  }
  std::sort(turned.begin(), turned.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  for (auto& [trace, other] : turned) result.push_back(std::move(other));
  return result;
}

/// Where the shifts are not proved stable the differences of phi, as those of the scheme give no upper end. A Sobolev
/// exponent below 0 is that of no continuous phi. Errors: throws Error, a size error where the space is too large.
DifferenceSpace space_of_differences(const LatticeMask& mask, const MultivariateRegularity& result,
                                     const std::optional<MultivariateSobolev>& sobolev) {
  if (!result.stable.is_yes() && sobolev && sobolev->exponent.upper && *sobolev->exponent.upper >= 0) {
    // The exponent is at most the Sobolev exponent.
    const int order = static_cast<int>(floor_index(*sobolev->exponent.upper)) + 1;
    if (auto space = value_space(mask, order); space && space->family.size() <= largest_space) return std::move(*space);
  }
  return difference_space(mask, result.sum_rules, largest_space);
}

/// Differences of the first order, or of that of the sum rules. `briefly`: by norms alone.
std::optional<ShrinkingDifferences> shrinking_differences(const LatticeMask& mask, int sum_rules, const Budget& budget,
                                                          bool briefly) {
  const Rational target = 1 - power(Rational(2), -20);
  for (const int order : sum_rules > 1 ? std::vector{1, sum_rules} : std::vector{1}) {
    DifferenceSpace space = difference_space(mask, order, largest_space);
    const Budget share{budget.deadline.after(schedule::surface::convergence), budget.memory};
    const NormProof norms = norm_of_products(space.family,
                                             {share.deadline.after(schedule::surface::norms), share.memory});
    JointSpectralRadius radius;
    if (norms.norm < 1) {
      radius.radius = Enclosure{std::nullopt, norms.bound()};
      radius.proof = norms;
    } else if (briefly) {
      continue;
    } else {
      radius = joint_spectral_radius(space.family, share, norms, target);
    }
    if (radius.proved_upper() < 1) return ShrinkingDifferences{std::move(space), std::move(radius)};
  }
  return std::nullopt;
}

/// With an upper end up to the target, if possible: what is found soon, as proofs that take long are long.
JointSpectralRadius radius_up_to(const MatrixFamily& family, const Rational& target, const Budget& budget) {
  constexpr double soon = 1.5, form_seconds = 6;
  JointSpectralRadius radius = joint_spectral_radius(family, {budget.deadline.at_most(soon), budget.memory},
                                                     std::nullopt, target);
  if (radius.proved_upper() <= target) return radius;
  if (auto form = radius::quadratic_bound(family, target, {budget.deadline.at_most(form_seconds), budget.memory});
      form && form->bound <= target) {
    radius.radius.upper = form->bound;
    radius.proof = *std::move(form);
    return radius;
  }
  return joint_spectral_radius(family, budget, std::nullopt, target);
}

/// Whether the differences of the scheme shrink. With `shrinking` that is looked for in any case, for a certificate.
Decision prove_convergence(const LatticeMask& mask, const Budget& budget, int sum_rules,
                           std::optional<ShrinkingDifferences>* shrinking = nullptr) {
  const bool in_grace = budget.deadline.expired();
  const Deadline end = budget.deadline.later(schedule::surface::convergence_grace);
  Decision decision = converges(mask, {levels, end.after(schedule::surface::convergence)});
  if (decision.is_no() || (decision.is_yes() && !shrinking)) return decision;
  try {
    const Deadline searching = shrinking ? end : end.at_most(schedule::surface::convergence_seconds);
    auto found = shrinking_differences(mask, sum_rules, {searching, budget.memory}, in_grace);
    if (found && !decision.is_yes())
      decision = {Truth::yes, found->space.order == 1 ? "the first differences of the scheme shrink"
                                                      : "the differences of the scheme shrink"};
    if (shrinking) *shrinking = std::move(found);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::size) throw;
  }
  return decision;
}

/// Nothing where it is too large, with the reason in `result`.
std::optional<DifferenceSpace> searchable_space(const LatticeMask& mask,
                                                const std::optional<MultivariateSobolev>& sobolev,
                                                MultivariateRegularity& result) {
  try {
    return space_of_differences(mask, result, sobolev);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::size) throw;
    if (!result.radius) result.exact = {Truth::unknown, error.what()};
    return std::nullopt;
  }
}

/// Fills in what the differences tell: by the dilation with which a polytope closes, in slices of time that grow. After
/// the first of them the dilations have their turns by how near the ends of the radius came.
void search_radius(const LatticeMask& mask, const std::optional<MultivariateSobolev>& sobolev, const Budget& budget,
                   MultivariateRegularity& result) {
  const std::vector<LatticeMask> masks = with_turned_dilations(mask);
  std::vector<std::optional<DifferenceSpace>>
      spaces;  // of the masks that had their turn; nothing where it is too large
  std::vector<Rational> gaps(masks.size());
  std::vector<std::size_t> turns(masks.size());
  std::iota(turns.begin(), turns.end(), std::size_t{0});
  for (double slice = masks.size() > 1 ? schedule::surface::first_slice : budget.deadline.remaining();;
       slice *= schedule::surface::slice_factor) {
    std::stable_sort(turns.begin(), turns.end(), [&](std::size_t a, std::size_t b) { return gaps[a] < gaps[b]; });
    for (const std::size_t k : turns) {
      if (k == spaces.size()) spaces.push_back(searchable_space(masks[k], sobolev, result));
      if (!spaces[k]) continue;
      const DifferenceSpace& space = *spaces[k];
      if (result.radius && result.space->is_of_values() && !space.is_of_values()) continue;
      const double turns_left = spaces.size() < masks.size() ? static_cast<double>(masks.size() - k) : 1;
      const Budget share{budget.deadline.after(1 / turns_left).at_most(slice), budget.memory};
      const NormProof norms = norm_of_products(space.family,
                                               {share.deadline.after(schedule::surface::norms), share.memory});
      JointSpectralRadius radius = joint_spectral_radius(space.family, share, norms);
      gaps[k] = radius.proved_upper() - radius.radius.lower.value_or(0);
      if (result.radius && !radius.exact.is_yes() && radius.proved_upper() >= result.radius->proved_upper()) continue;
      result.space = space;
      result.bound = HolderBound{norms.level, norms.norm,
                                 exponent_of_radius(root_enclosure(norms.norm, norms.level), mask.dilation().classes(),
                                                    mask.dilation().variables())};
      result.radius = std::move(radius);
      result.exact = result.radius->exact;
      if (result.exact.is_yes()) return;
    }
    if (masks.size() == 1 || (result.radius && result.radius->is_closed()) || budget.deadline.expired()) return;
  }
}

/// The exponent along an isotropic subspace, by differences of the least order that is above it.
struct Along {
  DifferenceSpace space;
  JointSpectralRadius radius;
  Enclosure exponent;
};
std::optional<Along> exponent_along(const LatticeMask& mask, const IsotropicSubspace& subspace, int first_order,
                                    const Budget& budget, int bits) {
  constexpr int most_orders = 4;
  std::optional<Along> result;
  for (int order = first_order; order < first_order + most_orders; ++order) {
    auto space = value_space(mask, order, subspace.basis);
    if (!space || space->family.size() > largest_space) break;
    JointSpectralRadius radius = joint_spectral_radius(
        space->family, {budget.deadline.after(schedule::surface::along), budget.memory});
    sharpen(radius, space->family, bits + bits_of_powers, budget.deadline);
    Enclosure exponent = exponent_of_radius(radius.radius, subspace.classes, subspace.basis.size(),
                                            bits + bits_of_powers);
    const bool decided = exponent.upper && *exponent.upper < order;
    if (!decided) exponent = Enclosure::at_least(std::min(exponent.lower.value_or(0), Rational(order)));
    result = Along{std::move(*space), std::move(radius), exponent};
    if (decided || *exponent.lower < order - 1) break;
  }
  return result;
}

/// Fills in the smallest of the exponents along the subspaces.
void search_along_subspaces(const LatticeMask& mask, const Budget& budget, int bits, MultivariateRegularity& result) {
  result.exact = {Truth::unknown, "no space of differences along a subspace was found"};
  std::optional<Along> roughest;
  Enclosure exponent;
  bool all = true;
  for (const IsotropicSubspace& subspace : mask.dilation().isotropic_subspaces()) {
    auto along = exponent_along(mask, subspace, std::max(result.sum_rules, 1), budget, bits);
    if (!along) {
      all = false;
      continue;
    }
    if (along->exponent.upper && (!exponent.upper || *along->exponent.upper < *exponent.upper))
      exponent.upper = along->exponent.upper;
    if (!roughest || *along->exponent.lower < *roughest->exponent.lower) roughest = std::move(along);
  }
  result.converges = prove_convergence(mask, budget, result.sum_rules);
  if (roughest) exponent.lower = roughest->exponent.lower;
  if (!all || !(*exponent.lower > 0)) {
    if (!result.converges.is_yes()) result.stable = {Truth::unknown, "the scheme is not proved to converge"};
    return;
  }
  result.exponent = exponent;
  result.exact = roughest->radius.exact;
  result.space = std::move(roughest->space);
  result.radius = std::move(roughest->radius);
}

/// Domain: coset sums 1.
MultivariateRegularity regularity_of_whole(const LatticeMask& mask, const Budget& budget, int bits) {
  const Dilation& dilation = mask.dilation();
  require(!dilation.isotropic_subspaces().empty(),
          "regularity: need a dilation without Jordan blocks whose conjugate eigenvalues have one modulus, or a tensor "
          "product, got the dilation {}",
          dilation.to_text());
  MultivariateRegularity result;
  result.stable = {Truth::unknown, "the scheme is not proved to converge"};
  result.sum_rules = polynomial_reproduction(mask).sum_rules;
  decide_stability(mask, {budget.deadline.after(schedule::surface::stability), budget.memory}, result);
  const Budget searching{budget.deadline.after(schedule::surface::search), budget.memory};
  std::optional<MultivariateSobolev> sobolev;
  try {
    if (dilation.is_isotropic()) {
      sobolev = decide_sobolev(mask, budget.deadline.after(schedule::surface::sobolev), result);
      search_radius(mask, sobolev, searching, result);
    } else {
      search_along_subspaces(mask, searching, bits, result);
    }
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::size) throw;
  }
  if (!dilation.is_isotropic()) return result;
  Enclosure exponent;
  if (result.radius) {
    sharpen(*result.radius, result.space->family, bits + bits_of_powers, budget.deadline);
    exponent = exponent_of_radius(result.radius->radius, dilation.classes(), dilation.variables(),
                                  bits + bits_of_powers);
  }
  const bool continuous = exponent.lower && *exponent.lower > 0,
             of_values = result.space && result.space->is_of_values();
  if (continuous && !of_values)
    result.converges = {Truth::yes, "the exponent is positive"};
  else if (of_values)  // the same limits, with the digits of the space
    result.converges = prove_convergence(LatticeMask(mask.symbol(), result.space->dilation), budget, result.sum_rules,
                                         &result.shrinking);
  else
    result.converges = prove_convergence(mask, budget, result.sum_rules);
  if (!continuous && !result.converges.is_yes()) {
    // What comes from the inner products supposes a continuous limit.
    const bool by_sum_rules = sobolev && (result.stable.is_yes() || !sobolev->exponent.upper);
    if (by_sum_rules) result.sobolev = Enclosure::at_least(*sobolev->exponent.lower);
    result.gram.reset();
    result.stable = {Truth::unknown, "the scheme is not proved to converge"};
    return result;
  }
  if (sobolev) result.sobolev = sobolev->exponent;
  // Differences of order m say nothing about exponents from m on.
  const int order = result.space ? result.space->order : 0;
  if (!exponent.upper || *exponent.upper >= order || !(of_values || result.stable.is_yes())) exponent.upper.reset();
  if (exponent.lower && *exponent.lower > order) exponent.lower = order;
  result.exponent = {std::max(Rational(0), exponent.lower.value_or(0)), exponent.upper};
  if (!result.sobolev) return result;
  // H^r lies in the Hoelder space of exponent r - s/2, and functions of compact support and Hoelder exponent r in all
  // H^(r - epsilon).
  result.exponent.lower = std::max(*result.exponent.lower,
                                   Rational(*result.sobolev->lower - Rational(mask.dimension(), 2)));
  if (result.sobolev->upper && (!exponent.upper || *result.sobolev->upper < *exponent.upper))
    result.exponent.upper = result.sobolev->upper;
  return result;
}

/// The smallest of the exponents of the factors. Domain: coset sums 1.
MultivariateRegularity regularity_by_factors(const std::vector<Mask>& factors, const Budget& budget, int bits) {
  MultivariateRegularity result;
  result.converges = {Truth::yes, "every factor converges"};
  result.stable = {Truth::yes, "the shifts of every factor are stable"};
  std::vector<HolderRegularity> regularities;
  std::vector<SobolevRegularity> sobolev;
  for (std::size_t k = 0; k < factors.size(); ++k) {
    const Deadline share = budget.deadline.after(1.0 / static_cast<double>(factors.size() - k));
    regularities.push_back(
        holder_regularity(factors[k], levels, {share, budget.memory}, HolderProof::shortest, std::nullopt, bits));
    const HolderRegularity& one = regularities.back();
    if (!one.stable.is_yes() && !result.stable.is_no()) result.stable = one.stable;
    if (!one.converges.is_yes() && !result.converges.is_no()) result.converges = one.converges;
    const auto found = one.bounds.sum_rules >= 1 ? sobolev_regularity(factors[k], budget.deadline) : std::nullopt;
    if (found) sobolev.push_back(*found);
  }
  const auto by_lower_end = [](const auto& a, const auto& b) { return *a.exponent.lower < *b.exponent.lower; };
  const auto roughest = std::min_element(regularities.begin(), regularities.end(), by_lower_end);
  result.sum_rules = std::min_element(regularities.begin(), regularities.end(), [](const auto& a, const auto& b) {
                       return a.bounds.sum_rules < b.bounds.sum_rules;
                     })->bounds.sum_rules;
  result.exact = roughest->radius.exact;
  if (sobolev.size() == factors.size())
    result.sobolev = std::min_element(sobolev.begin(), sobolev.end(), by_lower_end)->exponent;
  if (!(*roughest->exponent.lower > 0)) return result;
  result.exponent.lower = roughest->exponent.lower;
  // The smallest exponent is at most the upper end of any.
  for (const HolderRegularity& one : regularities)
    if (one.exponent.upper && (!result.exponent.upper || *one.exponent.upper < *result.exponent.upper))
      result.exponent.upper = one.exponent.upper;
  return result;
}

}  // namespace

Enclosure exponent_of_radius(const Enclosure& radius, long classes, std::size_t dimension, int bits) {
  const auto root = static_cast<long>(dimension);
  const int base = static_cast<int>(classes);
  Enclosure result;
  if (radius.upper && *radius.upper > 0) result.lower = -*log_ratio(power(*radius.upper, root), base, bits).upper;
  if (radius.lower && *radius.lower > 0) result.upper = -*log_ratio(power(*radius.lower, root), base, bits).lower;
  return result;
}

MultivariateRegularity multivariate_regularity(const LatticeMask& mask, const Budget& budget, int bits) {
  if (mask.components() > 1) return vector_regularity(mask, budget, {bits});
  const std::vector<Rational> sums = coset_sums(mask);
  if (!std::all_of(sums.begin(), sums.end(), [](const Rational& sum) { return sum == 1; })) {
    MultivariateRegularity result;
    result.stable = {Truth::unknown, "the scheme is not proved to converge"};
    result.converges = converges(mask);
    return result;
  }
  return mask.has_factors() ? regularity_by_factors(mask.factors(), budget, bits)
                            : regularity_of_whole(mask, budget, bits);
}

namespace {

/// Of the solutions of the refinement equation, and whether the scheme itself converges.
MultivariateRegularity vector_scheme_regularity(const LatticeMask& mask, const Budget& budget,
                                                const RegularityOptions& options) {
  const Budget share{budget.deadline.after(schedule::vector::scheme), budget.memory};
  const auto converge = [&](const auto& meant) {
    return options.hermite ? hermite_scheme_converges(meant, share) : vector_scheme_converges(meant, share);
  };
  const Decision converges = options.quadratic ? converge(*options.quadratic) : converge(mask);
  const VectorQuestion question{options.bits, options.component, options.integral};
  MultivariateRegularity result = vector_regularity(mask, options.quadratic, budget, question);
  result.converges = converges;
  if (options.hermite && !options.component)
    result.vector->hermite = hermite_order(result, converges, mask.components());
  return result;
}

}  // namespace

Regularity regularity_of(const LatticeMask& mask, const Budget& budget, const RegularityOptions& options) {
  Regularity result;
  if (mask.factors().size() == 1)
    result.curve = holder_regularity(mask.curve(), options.levels, budget, options.proof, options.rounding,
                                     options.bits);
  else if (mask.components() > 1) {
    require(!options.rounding || options.quadratic, "regularity: need the matrices that are meant, not rounded ones");
    result.surface = vector_scheme_regularity(mask, budget, options);
  } else
    result.surface = multivariate_regularity(mask, budget, options.bits);
  return result;
}

std::optional<MultivariateRegularity> regularity_of_at_least(const LatticeMask& mask, const Rational& exponent,
                                                             const Budget& budget) {
  const Dilation& dilation = mask.dilation();
  require(dilation.is_isotropic() && exponent > 0,
          "regularity: need an isotropic dilation and an exponent > 0, got {} and {}", dilation.to_text(),
          to_text(exponent));
  const auto end = [&](const Rational& radius) {
    return exponent_of_radius({std::nullopt, radius}, dilation.classes(), dilation.variables()).lower.value_or(0);
  };
  Rational target = 0;  // the largest radius with it, nearly
  for (Rational step = Rational(1) / 2; step > power(Rational(2), -12); step /= 2)
    if (end(target + step) >= exponent) target += step;
  if (target == 0) return std::nullopt;
  MultivariateRegularity result;
  result.sum_rules = polynomial_reproduction(mask).sum_rules;
  for (int order = 1; order <= result.sum_rules; ++order) {
    if (Rational(order) <= exponent) continue;
    result.space = difference_space(mask, order, largest_space);
    result.radius = radius_up_to(result.space->family, target, budget);
    result.exponent = Enclosure::at_least(std::min(end(result.radius->proved_upper()), Rational(order)));
    if (*result.exponent.lower >= exponent) return result;
  }
  return std::nullopt;
}

bool MultivariateRegularity::is_closed() const {
  if (radius) return radius->is_closed();
  return exponent.is_bounded() && *exponent.upper - *exponent.lower < power(Rational(10), -12);
}

}  // namespace subcert
