#include "one_block.hpp"

#include <subcert/analysis/radii/polytope_proof/candidate.hpp>
#include <subcert/analysis/radii/quadratic/product_tree.hpp>
#include <subcert/analysis/radii/schedule.hpp>
#include <subcert/analysis/symbol/polynomials/real_roots.hpp>
#include <subcert/analysis/symbol/polynomials/root_modulus.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>

#include "attains.hpp"
#include "closed_orbit.hpp"
#include "cost.hpp"
#include "different_matrices.hpp"
#include "leading_factor.hpp"
#include "similarity.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <semaphore>

namespace subcert::radius {
namespace {

const Rational rounding = power(Rational(10), -15);
constexpr std::size_t proved_products = 12;
constexpr std::size_t short_word = 8;                // letters
constexpr auto look = std::chrono::milliseconds(2);  // between looks at the time that they have had
constexpr double same_radius = 1e-9;                 // of products, relatively
constexpr std::size_t most_commuting = 64;
constexpr slong eigenvalue_bits = 320;

/// When proofs of products end: short ones are proved in any case.
struct ProductDeadline {
  explicit ProductDeadline(const Deadline& end) : of_long(end), of_short(end.later(schedule::block::grace_of_short)) {}
  const Deadline& operator()(const std::vector<int>& word) const {
    return word.size() <= short_word ? of_short : of_long;
  }
  Deadline of_long, of_short;
};

/// Whether all maximizing products have the radius of the first, exactly.
bool have_equal_radii(const MatrixFamily& family, const PolytopeCandidate& candidate, const ProductEvidence& first,
                      const Deadline& deadline) {
  for (std::size_t k = 1; k < candidate.maximizing; ++k) {
    const ProductEvidence other = prove_product(family, candidate.word(k), deadline);
    if (!is_dominated(family, first, family, other, deadline) || !is_dominated(family, other, family, first, deadline))
      return false;
  }
  return true;
}

/// Whether the product attains the radius, for a polytope whose bound is above the lower end of the product.
Decision attains(const MatrixFamily& family, const PolytopeCandidate& candidate, PolytopeProof& polytope,
                 const ProductEvidence& product, const Deadline& deadline) {
  if (candidate.closed && !have_equal_radii(family, candidate, product, deadline))
    return {Truth::unknown, "several products seem to attain the radius, but their radii were not proved equal"};
  return product_attains_radius(family, candidate, polytope, *product.radius.lower, deadline);
}

/// A search for a polytope, and what is proved of it.
struct Attempt {
  PolytopeCandidate candidate;
  ProductEvidence product;
  std::optional<PolytopeProof> polytope;
  Decision exact;

  bool reaches(const std::optional<Rational>& target) const { return target && polytope && polytope->bound <= *target; }
  bool is_better_than(const Attempt& other) const {
    if (exact.is_yes() || other.exact.is_yes()) return exact.is_yes() && !other.exact.is_yes();
    return polytope && (!other.polytope || polytope->bound < other.polytope->bound);
  }
};

/// `target`: of an upper bound, which is all that is asked for.
Attempt attempt(const MatrixFamily& family, const Budget& searching, const Budget& budget,
                const std::optional<Rational>& target, bool cones) {
  Attempt result{{}, {}, std::nullopt, {Truth::unknown, "no polytope closed"}};
  result.candidate = find_polytope(family, searching, cones, true, quadratic::long_products);
  const auto proving = [&](double share) {
    return Budget{budget.deadline.after(share).later(schedule::block::grace), budget.memory};
  };
  result.product = prove_product(family, result.candidate.word(0), proving(1).deadline);
  result.polytope = certify_polytope(family, result.candidate,
                                     proving(result.candidate.closed ? schedule::block::closed_proof : 1));
  const bool is_done = result.polytope && (result.candidate.closed || result.reaches(target));
  if (!is_done && !budget.deadline.expired()) {
    // Too many vertices for a proof in this time, or the search ended too early to enclose well: a polytope of a little
    // more than the radius, with time that the proof left.
    PolytopeCandidate larger = find_polytope(
        family, {budget.deadline.after(schedule::block::larger_polytope), budget.memory}, cones, false);
    // It may have found a better product.
    if (larger.word(0) != result.product.word) {
      ProductEvidence other = prove_product(family, larger.word(0), proving(1).deadline);
      if (*other.radius.lower > *result.product.radius.lower) result.product = std::move(other);
    }
    auto proof = larger.vertices.empty() ? std::nullopt : certify_polytope(family, larger, proving(1));
    if (proof && (!result.polytope || proof->bound < result.polytope->bound)) {
      result.polytope = std::move(proof);
      result.candidate = std::move(larger);
    }
  }
  if (result.reaches(target))
    result.exact.reason = "a bound was asked for, and nothing else";
  else if (result.polytope && *result.product.radius.lower > 0)
    result.exact = attains(family, result.candidate, *result.polytope, result.product, proving(1).deadline);
  return result;
}

/// The better polytope and, where it is not exact, the larger product of both.
Attempt better_of(Attempt first, Attempt second) {
  if (second.is_better_than(first)) std::swap(first, second);
  if (!first.exact.is_yes() && *second.product.radius.lower > *first.product.radius.lower)
    first.product = std::move(second.product);
  return first;
}

/// Cones need fewer vertices, but an image that lies only a little below a vertex is beyond them; other polytopes may
/// have extra vertices.
Attempt best_attempt(const MatrixFamily& family, const Budget& budget, const std::optional<Rational>& target) {
  const Budget searching{budget.deadline.after(schedule::block::polytopes), budget.memory};
  Attempt first = attempt(family, searching, budget, target, true);
  if (first.candidate.kind != PolytopeKind::nonnegative || first.exact.is_yes() || first.reaches(target)) return first;
  return better_of(std::move(first), attempt(family, searching, budget, target, false));
}

/// The search for quadratic forms, and the product that they are to keep.
struct FormAttempt {
  ProductEvidence product;
  std::optional<GraphProof> proof;
  bool is_exact() const { return proof && proof->attained; }
};

/// The best product of a quick look, and of the words along which a vector becomes longest.
std::vector<int> find_long_product(const MatrixFamily& family, const Budget& budget) {
  const polytope::SearchFamily search = round_family(family, budget.deadline).family;
  const auto [length, width] = polytope::product_looks[1];
  auto found = polytope::search_products(search, {.max_length = length, .width = width, .budget = budget});
  if (found.front().radius > 0)
    std::ranges::move(quadratic::long_products(search, found.front().radius, budget), std::back_inserter(found));
  polytope::sort_candidates(found);
  return found.front().written();
}

struct Attempts {
  Attempt polytopes;
  std::optional<FormAttempt> forms;  ///< nothing where they were not sought, or are of no use
};

/// Searches polytopes and, where none closes soon, quadratic forms beside them, until one of them proves that a product
/// attains the radius, or a polytope has the target for its bound. `known`: an upper bound.
Attempts attempt_both(const MatrixFamily& family, const Budget& budget, const std::optional<Rational>& target,
                      const Rational& known) {
  Attempts result;
  StopFlag polytopes_end, forms_end;
  std::binary_semaphore forms_begin(0);
  std::atomic<double> radius_of_forms = 0;  // of the product, once there is one
  const std::size_t memory = budget.memory / 2;
  const auto seek_polytopes = [&] {
    const StopScope scope(&polytopes_end);
    const Deadline end = budget.deadline.after(1);
    result.polytopes = best_attempt(family, {end, memory}, target);
    const Attempt& found = result.polytopes;
    const double radius = found.product.radius.lower->convert_to<double>(), other = radius_of_forms;
    if ((found.candidate.closed && found.polytope) || *found.product.radius.lower >= known || found.reaches(target) ||
        (other > 0 && other < radius * (1 - same_radius)))
      forms_end.set();
    forms_begin.release();
  };
  const auto seek_forms = [&] {
    const StopScope scope(&forms_end);
    const Budget its{budget.deadline.after(1), memory};
    const double seconds = its.deadline.remaining(),
                 least = std::min(schedule::block::alone_least, schedule::block::alone_share * seconds);
    const Deadline alone = its.deadline.at_most(
        std::clamp(schedule::block::alone * seconds, least, schedule::block::alone_seconds));
    while (!alone.expired() && !forms_begin.try_acquire_for(look)) continue;
    if (its.deadline.expired()) return;
    FormAttempt forms;
    const std::vector<int> word = find_long_product(family, its);
    forms.product = prove_product(family, word, ProductDeadline(its.deadline)(word));
    radius_of_forms = forms.product.radius.lower->convert_to<double>();
    forms.proof = prove_by_forms(family, *forms.product.radius.lower, its, forms.product);
    // What is exact is kept: the polytopes that it ends may have set the flag since.
    if (forms.is_exact()) polytopes_end.set();
    if (forms.is_exact() || !forms_end.is_set()) result.forms = std::move(forms);
  };
  parallel_for_each(2, all_cores(), [&](std::size_t which) { which == 0 ? seek_polytopes() : seek_forms(); });
  return result;
}

/// Of unit times matrices that are a number times isometries: no polytope has finitely many vertices there.
JointSpectralRadius radius_of_isometries(const MatrixFamily& family, QuadraticProof proof, const Rational& unit,
                                         const Deadline& deadline) {
  JointSpectralRadius result;
  result.product = prove_product(family, {0}, deadline);
  result.product.exact = proof.bound;
  result.product = scaled(std::move(result.product), unit);
  result.radius = Enclosure::exactly(*result.product.exact);
  result.exact = {Truth::yes, "the matrices are isometries of a quadratic form, times the radius"};
  result.growth.at_most = 0;
  result.proof = scaled(std::move(proof), unit);
  return result;
}

bool commute(const MatrixFamily& family) {
  std::vector<Rational> x;  // most do not, which one vector shows
  for (std::size_t i = 0; i < family.size(); ++i) x.emplace_back(static_cast<long>(i * i + 1));
  const auto all_pairs = [&](const auto& holds) {
    for (std::size_t s = 0; s < family.count(); ++s)
      for (std::size_t t = 0; t < s; ++t)
        if (!holds(family[s], family[t])) return false;
    return true;
  };
  return all_pairs([&](const auto& a, const auto& b) { return a * (b * x) == b * (a * x); }) &&
         all_pairs([](const auto& a, const auto& b) { return a * b == b * a; });
}

/// Matrices that commute are triangular in one basis over the complex numbers, so that the radius is the largest
/// spectral radius of one of them. Nothing where they do not commute, or where these are not compared in time.
std::optional<ProductEvidence> largest_of_commuting(const MatrixFamily& family, const Deadline& deadline) {
  if (family.count() > most_commuting || !commute(family)) return std::nullopt;
  std::vector<ProductEvidence> letters;
  std::size_t best = 0;
  for (std::size_t t = 0; t < family.count(); ++t) {
    letters.push_back(prove_product(family, {static_cast<int>(t)}, deadline));
    const auto p = characteristic_polynomial(family[t], deadline);
    if (!p || !has_time_for_roots(*p, deadline)) return std::nullopt;
    ProductEvidence& own = letters.back();
    own.radius = own.exact ? Enclosure::exactly(*own.exact) : largest_root_modulus(*p, default_bits).largest;
    if (*own.radius.lower > *letters[best].radius.lower) best = t;
  }
  for (const ProductEvidence& other : letters)
    if (*other.radius.upper >= *letters[best].radius.lower && other.word != letters[best].word &&
        !(letters[best].radius.is_exact() && *other.radius.upper <= *letters[best].radius.lower) &&
        !is_dominated(family, letters[best], family, other, deadline))
      return std::nullopt;
  return letters[best];
}

/// From the products that the search for a polytope took for maximizing.
std::optional<ClosedOrbit> closed_orbit_of(const MatrixFamily& family, const PolytopeCandidate& candidate,
                                           const Budget& budget) {
  std::vector<std::vector<int>> words;
  for (std::size_t k = 0; k < candidate.maximizing; ++k) words.push_back(candidate.word(k));
  return closed_orbit(family, words, {budget.deadline.later(schedule::block::grace), budget.memory});
}

/// Words of one letter, of those that symmetries exchange one, if they are few; then the others that may attain the
/// radius: doubles may not tell which does, and whatever else is found each budget knows these.
std::vector<std::vector<int>> words_to_compare(const MatrixFamily& family, const PolytopeCandidate& candidate) {
  std::vector<std::vector<int>> words;
  for (std::size_t t = 0; t < family.count() && family.count() <= proved_products; ++t)
    if (std::ranges::none_of(family.group(), [&](const FamilySymmetry& g) { return g.letters[t] < t; }))
      words.push_back({static_cast<int>(t)});
  for (std::size_t k = 1; k < std::min(candidate.products.size(), proved_products); ++k)
    words.push_back(candidate.word(k));
  return words;
}

/// `count`: of the matrices whose different ones these are.
JointSpectralRadius radius_of_different(const MatrixFamily& family, std::size_t count, const Budget& budget,
                                        const std::optional<NormProof>& known, const std::optional<Rational>& target) {
  const Rational unit = power(Rational(2), scaling_exponent(family));
  const MatrixFamily scaled_family = unit == 1 ? family : 1 / unit * family;
  if (auto isometries = prove_isometries(scaled_family, budget.deadline))
    return radius_of_isometries(scaled_family, std::move(*isometries), unit, budget.deadline);
  const NormProof norms = known ? *known
                                : norm_of_products(
                                      family, {budget.deadline.after(schedule::block::norms), budget.memory}, count);
  auto [found, forms] = attempt_both(scaled_family, budget, target ? std::optional(*target / unit) : std::nullopt,
                                     norms.bound() / unit);
  const PolytopeCandidate& candidate = found.candidate;
  std::optional<PolytopeProof>& polytope = found.polytope;
  ProductEvidence& product = found.product;

  const ProductDeadline end(budget.deadline);
  if (!found.exact.is_yes() && !(forms && forms->is_exact()))
    for (const std::vector<int>& word : words_to_compare(family, candidate)) {
      if (word == product.word) continue;
      ProductEvidence other = prove_product(scaled_family, word, end(word));
      if (*other.radius.lower > *product.radius.lower) product = std::move(other);
    }
  if (forms && (forms->is_exact() || *forms->product.radius.lower > *product.radius.lower))
    product = std::move(forms->product);

  JointSpectralRadius result;
  const Rational lower = *product.radius.lower * unit;
  Rational upper = norms.bound();
  // Of two bounds that differ by rounding only, the polytope is the shorter proof.
  const bool by_polytope = polytope && polytope->bound * unit < upper * (1 + rounding);
  if (by_polytope) upper = polytope->bound * unit;
  std::optional<GraphProof> form = forms ? std::move(forms->proof) : std::nullopt;
  const bool enough = target && upper <= *target;
  // A polytope that closed in floating point may have no proof.
  const bool closed = candidate.closed && by_polytope;
  if (!forms && !closed && lower < upper && !enough && !budget.deadline.expired())
    form = prove_by_forms(scaled_family, lower / unit, budget, product);
  const bool attained = form && form->attained && !found.exact.is_yes(),
             by_form = form && (attained || form->bound * unit < upper);
  if (by_form) upper = form->bound * unit;
  result.radius = {lower, upper};
  if (attained) {
    result.exact = {Truth::yes,
                    "a norm that knows its eigenvector is kept by the product, and all other words contract"};
    result.radius.upper = *form->attained->radius.upper * unit;
  } else if (result.radius.is_exact())
    result.exact = {Truth::yes, "both ends of the enclosure are the same number"};
  else if (enough)
    result.exact = {Truth::unknown, "a bound was asked for, and nothing else"};
  else if (!by_polytope || lower <= 0)
    result.exact = {Truth::unknown, "no polytope closed"};
  else
    result.exact = found.exact;
  // Cycles whose eigenvalues have no common polynomial have no certificate, but perhaps an orbit has one.
  const bool unsaid = closed && !polytope->attained && !attained && !result.radius.is_exact();
  auto orbit = (result.exact.is_yes() && !unsaid) || enough || lower <= 0
                   ? std::nullopt
                   : closed_orbit_of(scaled_family, candidate, budget);
  if (orbit && !result.exact.is_yes()) {
    const Rational power_of_unit = power(unit, orbit->length) * orbit->power;
    result.radius = root_enclosure(power_of_unit, orbit->length, default_bits);
    product = prove_product(scaled_family, orbit->word, budget.deadline);
    result.exact = {Truth::yes,
                    "finitely many rational vectors stay in their hull, and the product attains the radius"};
  }
  if (orbit && orbit->proof && orbit->proof->bound * unit <= upper * (1 + rounding))
    result.proof = scaled(std::move(*orbit->proof), unit);
  else if (by_form)
    result.proof = scaled(std::move(*form), unit);
  else if (by_polytope)
    result.proof = scaled(std::move(*polytope), unit);
  else
    result.proof = norms;
  result.product = scaled(std::move(product), unit);
  if (result.exact.is_yes()) {
    if (result.product.exact) result.radius = Enclosure::exactly(*result.product.exact);
    // A norm that no matrix expands by more than the radius.
    result.growth.at_most = 0;
  }
  return result;
}

/// By the different matrices.
JointSpectralRadius radius_of_merged(const DifferentMatrices& different, const Budget& budget,
                                     const std::optional<NormProof>& known, const std::optional<Rational>& target) {
  const auto largest = largest_of_commuting(different.family(), budget.deadline.after(schedule::block::commuting));
  const Deadline end = largest ? budget.deadline.after(schedule::block::commuting)
                                     .at_most(schedule::block::commuting_seconds)
                               : budget.deadline;
  JointSpectralRadius result = radius_of_different(different.family(), different.places.size(), {end, budget.memory},
                                                   known, target);
  if (largest && !result.exact.is_yes()) {
    result.product = *largest;
    result.radius = largest->radius;
    result.exact = {Truth::yes, "the matrices commute, and this one has the largest spectral radius"};
  }
  if (different.are_fewer()) expand(result, different);
  return result;
}

/// Of another search of the same family.
void take_larger_product(JointSpectralRadius& radius, JointSpectralRadius other) {
  if (radius.exact.is_yes() || *other.radius.lower <= *radius.radius.lower) return;
  radius.product = std::move(other.product);
  radius.radius.lower = other.radius.lower;
}

}  // namespace

JointSpectralRadius radius_of_one_block(const MatrixFamily& family, const Budget& budget,
                                        const std::optional<NormProof>& known, const std::optional<Rational>& target) {
  const DifferentMatrices equal = different_matrices(family), up_to_sign = different_matrices(family, true);
  if (up_to_sign.originals.size() == equal.originals.size()) return radius_of_merged(equal, budget, known, target);
  JointSpectralRadius merged = radius_of_merged(
      up_to_sign, {budget.deadline.after(schedule::block::opposite_as_one), budget.memory}, known, target);
  if (!std::holds_alternative<GraphProof>(merged.proof)) return merged;
  // A graph tells opposite letters apart, so it has to be found once more; what is exact remains so.
  JointSpectralRadius result = radius_of_merged(equal, budget, known, target);
  if (merged.exact.is_yes() && !result.exact.is_yes()) {
    merged.proof = std::move(result.proof);
    return merged;
  }
  take_larger_product(result, std::move(merged));
  return result;
}

std::optional<GraphProof> prove_by_forms(const MatrixFamily& family, const Rational& target, const Budget& budget,
                                         const ProductEvidence& product) {
  auto proof = prove_by_quadratic_forms(family, target, budget, {product.word, product.eigenvalue});
  if (!proof || !proof->attained) return proof;
  AttainedGraph attained = *proof->attained;
  const RationalMatrix matrix = transposed(family.product(attained.product));
  const auto factor = leading_factor(matrix, product.eigenvalue, eigenvalue_bits,
                                     Deadline::in(budget.deadline.remaining() + schedule::block::grace));
  if (const auto seed = factor ? seed_of(matrix, *factor, {}) : std::nullopt) {
    attained.number = factor->number(attained.product.size());
    attained.seed = *seed;
    proof->attained = std::make_shared<AttainedGraph>(std::move(attained));
  }
  return proof;
}

std::optional<GraphProof> quadratic_bound(const MatrixFamily& family, const Rational& target, const Budget& budget) {
  const DifferentMatrices different = different_matrices(family);
  const Rational unit = power(Rational(2), scaling_exponent(different.family()));
  auto proof = prove_by_quadratic_forms(unit == 1 ? different.family() : 1 / unit * different.family(), target / unit,
                                        budget);
  if (!proof) return std::nullopt;
  expand(*proof, different);
  return scaled(std::move(*proof), unit);
}

JointSpectralRadius radius_of_numbers(const MatrixFamily& family) {
  std::size_t best = 0;
  for (std::size_t t = 1; t < family.count(); ++t)
    if (abs(family[t](0, 0)) > abs(family[best](0, 0))) best = t;
  const Rational& number = family[best](0, 0);
  JointSpectralRadius result;
  result.radius = Enclosure::exactly(abs(number));
  result.product = {{static_cast<int>(best)}, {number, 0}, result.radius, abs(number)};
  result.exact = {Truth::yes, "the largest modulus of numbers"};
  result.growth.at_most = 0;
  result.proof = NormProof{1, abs(number)};
  return result;
}

JointSpectralRadius first_look(const MatrixFamily& family, const Budget& budget) {
  const Rational unit = power(Rational(2), scaling_exponent(family));
  const MatrixFamily scaled_family = unit == 1 ? family : 1 / unit * family;
  const NormProof norms = norm_of_products(family, budget);
  JointSpectralRadius result;
  result.product = scaled(prove_product(scaled_family, find_product(scaled_family, budget.deadline).written(),
                                        budget.deadline.later(schedule::block::grace)),
                          unit);
  result.radius = {*result.product.radius.lower, norms.bound()};
  result.exact = {Truth::unknown, "only norms were computed"};
  result.proof = norms;
  return result;
}

}  // namespace subcert::radius
