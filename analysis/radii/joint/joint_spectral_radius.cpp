#include "joint_spectral_radius.hpp"

#include "cost.hpp"
#include "one_block.hpp"
#include "rounds.hpp"
#include "similarity.hpp"

#include <subcert/analysis/radii/polytope_proof/candidate.hpp>
#include <subcert/analysis/radii/polytope_proof/round_family.hpp>
#include <subcert/analysis/radii/quadratic/product_tree.hpp>
#include <subcert/analysis/radii/schedule.hpp>
#include <subcert/analysis/symbol/polynomials/root_modulus.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>

namespace subcert {
namespace {

const Rational rounding = power(Rational(10), -15);
constexpr std::size_t proved_products = 3;  // of each search

void require_small(const MatrixFamily& family) {
  require(FamilyLimits::hold(family.count(), family.size()),
          "joint_spectral_radius: need 1 to {} matrices of size 1 to {} with at most {} entries, got {} of size {}",
          FamilyLimits::matrices, FamilyLimits::size, FamilyLimits::entries, family.count(), family.size());
}

/// Where the block is open.
void try_product(JointSpectralRadius& block, const MatrixFamily& family, const std::vector<int>& word,
                 const Deadline& deadline) {
  if (!block.exact.is_yes() && !block.is_closed())
    radius::try_product(block, prove_product(family, word, deadline), deadline);
}

/// The radii of all diagonal blocks, as sharp as the largest needs them.
class BlockSearch {
 public:
  BlockSearch(const BlockTriangular& triangular, const Budget& budget, const std::optional<Rational>& target)
      : budget_(budget), seconds_(budget.deadline.remaining()), target_(target.value_or(-1)) {
    for (std::size_t k = 0; k < triangular.sizes.size(); ++k) {
      families_.push_back(triangular.block(k));
      const bool number = triangular.sizes[k] == 1;
      radii_.push_back(number ? radius::radius_of_numbers(families_[k])
                              : radius::first_look(families_[k], within(schedule::family::first_look * seconds_)));
      norms_.push_back(std::get<NormProof>(radii_[k].proof));
      best_ = std::max(best_, *radii_[k].radius.lower);
      if (!number) open_.push_back(k);
    }
    // A large lower bound spares work for the others.
    std::sort(open_.begin(), open_.end(),
              [this](std::size_t a, std::size_t b) { return *radii_[a].radius.lower > *radii_[b].radius.lower; });
  }

  void run() {
    double work = 0;
    for (const std::size_t k : open_) work += cost(k);
    for (const std::size_t k : open_) {
      improve(k, std::max(schedule::family::least_of_block * seconds_, budget_.deadline.remaining() * cost(k) / work));
      work -= cost(k);
    }
  }

  /// Whether all radii are known as sharply as the largest needs them.
  bool is_closed() const {
    return std::ranges::all_of(open_, [this](std::size_t k) { return radii_[k].is_closed() || is_settled(k); });
  }
  void try_product(const std::vector<int>& word, const Deadline& deadline) {
    for (const std::size_t k : open_) subcert::try_product(radii_[k], families_[k], word, deadline);
  }

  const std::vector<MatrixFamily>& families() const { return families_; }
  std::vector<JointSpectralRadius>& radii() { return radii_; }

 private:
  double cost(std::size_t k) const { return static_cast<double>(families_[k].size() * families_[k].size()); }
  Budget within(double seconds) const { return {budget_.deadline.at_most(seconds), budget_.memory}; }

  void improve(std::size_t k, double seconds) {
    const Deadline end = budget_.deadline.at_most(seconds);
    const bool smaller = *radii_[k].radius.lower < best_ * (1 - rounding);
    // A block that seems smaller only has to get below the best lower bound: ever longer searches.
    for (double slice = smaller ? schedule::family::first_seconds : seconds; !is_settled(k) && !end.expired();
         slice *= 2) {
      if (smaller) {
        lower_by_quadratic_form(k, {end.at_most(slice), budget_.memory});
        if (is_settled(k)) break;
      }
      radii_[k] = radius::better_of(
          std::move(radii_[k]),
          radius::radius_of_one_block(families_[k], {end.at_most(slice), budget_.memory}, norms_[k], target_),
          families_[k], end.later(schedule::family::grace_of_blocks));
      best_ = std::max(best_, *radii_[k].radius.lower);
      if (radii_[k].is_closed()) break;
    }
  }

  void lower_by_quadratic_form(std::size_t k, const Budget& budget) {
    auto proof = radius::quadratic_bound(families_[k], best_, budget);
    if (!proof || proof->bound >= radii_[k].proved_upper()) return;
    radii_[k].radius.upper = proof->bound;
    radii_[k].proof = std::move(*proof);
  }

  bool is_settled(std::size_t k) const {
    const Rational upper = radii_[k].proved_upper();
    return upper < best_ || upper <= target_ || (*radii_[k].radius.lower < best_ && upper <= best_);
  }

  Budget budget_;
  double seconds_;
  std::vector<MatrixFamily> families_;
  std::vector<JointSpectralRadius> radii_;
  std::vector<NormProof> norms_;  // of the first looks
  std::vector<std::size_t> open_;
  Rational best_ = 0, target_;
};

/// The block with the largest product, of equal ones one whose product attains its radius.
std::size_t leading_block(const std::vector<JointSpectralRadius>& blocks) {
  std::size_t leading = 0;
  for (std::size_t k = 1; k < blocks.size(); ++k) {
    const Rational &own = *blocks[k].radius.lower, &best = *blocks[leading].radius.lower;
    if (own > best || (own == best && blocks[k].exact.is_yes() && !blocks[leading].exact.is_yes())) leading = k;
  }
  return leading;
}

/// Whether the product of the leading block attains the radius of the family, and how fast its products grow.
void settle_exactness(JointSpectralRadius& result, const MatrixFamily& family,
                      const std::vector<MatrixFamily>& families, const Deadline& deadline) {
  const BlockProof& proof = *result.by_blocks();
  const JointSpectralRadius& leader = proof.blocks[proof.leading];
  result.exact = leader.exact;
  if (!leader.exact.is_yes()) return;
  int equal = 1;
  bool growth_known = leader.growth.at_most == 0, compared = true;
  for (std::size_t k = 0; k < families.size(); ++k) {
    const JointSpectralRadius& other = proof.blocks[k];
    if (k == proof.leading || *other.radius.upper < *leader.radius.lower) continue;
    const bool both_exact = leader.radius.is_exact() && *other.radius.upper <= *leader.radius.lower;
    const bool similar = !both_exact && radius::are_similar(families[proof.leading], families[k], deadline);
    const bool dominated = both_exact || similar ||
                           (other.exact.is_yes() && radius::is_dominated(families[proof.leading], leader.product,
                                                                         families[k], other.product, deadline));
    // One product that attains both radii attains the larger, whichever that is.
    if (!dominated && !(other.exact.is_yes() && other.product.word == leader.product.word)) {
      result.exact = {Truth::unknown, "two blocks have radii that could not be compared exactly"};
      return;
    }
    compared = compared && dominated;
    ++equal;
    growth_known = growth_known && (similar || other.growth.at_most == 0);
  }
  if (!compared) {
    result.product.exact.reset();
    result.product.radius.upper = result.radius.upper;
  } else if (leader.radius.is_exact()) {
    result.radius = leader.radius;
  }
  if (growth_known) result.growth.at_most = equal - 1;
  if (equal > 1 && *leader.radius.lower > 0)
    result.growth.at_least = radius::jordan_power(family, leader.product.word, deadline);
}

JointSpectralRadius radius_by_blocks(const MatrixFamily& family, BlockTriangular triangular, const Budget& budget,
                                     const std::optional<NormProof>& known, const std::optional<Rational>& target) {
  BlockSearch search(triangular, budget, target);
  search.run();
  const Deadline proving = budget.deadline.later(schedule::family::grace_of_blocks);
  std::optional<NormProof> norms = known;
  if (!search.is_closed()) {
    // Norms may be smaller in the given basis, and doubles may find in one basis what they miss in another.
    if (!norms) norms = norm_of_products(family, {proving.after(schedule::family::norms_beside_blocks), budget.memory});
    search.try_product(radius::find_product(family, proving).written(), proving);
  }
  JointSpectralRadius result;
  const std::size_t leading = leading_block(search.radii());
  result.proof = BlockProof{std::move(triangular), std::move(search.radii()), leading};
  const JointSpectralRadius& leader = result.by_blocks()->blocks[leading];
  result.product = leader.product;
  result.radius = {*leader.radius.lower, Rational(0)};
  for (const JointSpectralRadius& block : result.by_blocks()->blocks)
    result.radius.upper = std::max(*result.radius.upper, *block.radius.upper);
  settle_exactness(result, family, search.families(), proving);
  if (result.exact.is_yes() || !norms || norms->bound() >= result.proved_upper()) return result;
  JointSpectralRadius whole;
  whole.radius = {Rational(0), norms->bound()};
  whole.exact = {Truth::unknown, "no polytope closed"};
  whole.proof = *norms;
  whole = radius::better_of(std::move(whole), result, family, proving);
  return whole.product.word.empty() ? result : whole;
}

/// One search, with all of the budget.
JointSpectralRadius searched(const MatrixFamily& family, const Budget& budget, const std::optional<NormProof>& known,
                             const std::optional<Rational>& target) {
  BlockTriangular triangular = radius::with_symmetries(
      radius::balanced(block_triangularise(family, budget.deadline.after(schedule::family::triangular_form)),
                       budget.deadline.after(schedule::family::symmetries)),
      budget.deadline.after(schedule::family::symmetries));
  const bool one_block = triangular.sizes.size() == 1 && triangular.basis == RationalMatrix::identity(family.size());
  return one_block ? radius::radius_of_one_block(family, budget, known, target)
                   : radius_by_blocks(family, std::move(triangular), budget, known, target);
}

/// Where there is one matrix, up to signs: the largest modulus of its eigenvalues.
std::optional<Enclosure> radius_of_one_matrix(const MatrixFamily& family, const Deadline& deadline) {
  const RationalMatrix &first = family[0], opposite = Rational(-1) * first;
  if (std::ranges::any_of(family, [&](const RationalMatrix& m) { return m != first && m != opposite; }))
    return std::nullopt;
  const auto characteristic = characteristic_polynomial(first, deadline);
  const auto found = characteristic ? largest_root_modulus(*characteristic, default_bits, deadline) : std::nullopt;
  return found ? std::optional(found->largest) : std::nullopt;
}

/// What the search left open, where that is known.
void settle_one_matrix(JointSpectralRadius& radius, const MatrixFamily& family, const Enclosure& known,
                       const Budget& budget) {
  if (radius.exact.is_yes()) return;
  if (*radius.product.radius.lower < *known.lower * (1 - 1000 * rounding)) {
    radius.product = prove_product(family, {0}, budget.deadline);
    // The product of blocks is one of the leading block.
    if (radius.by_blocks()) radius.proof = norm_of_products(family, budget);
  }
  radius.radius = radius.product.exact ? Enclosure::exactly(*radius.product.exact) : known;
  radius.exact = {Truth::yes, "the only matrix, up to its sign, has this spectral radius"};
}

/// That of factor times the matrices.
JointSpectralRadius scaled(JointSpectralRadius radius, const Rational& factor) {
  const auto scaled_proof = [&](auto& proof) { proof = scaled(std::move(proof), factor); };
  radius.radius = scaled(radius.radius, factor);
  radius.product = radius::scaled(std::move(radius.product), factor);
  if (auto* norms = std::get_if<NormProof>(&radius.proof)) norms->norm *= power(factor, norms->level);
  if (auto* polytope = std::get_if<PolytopeProof>(&radius.proof)) scaled_proof(*polytope);
  if (auto* form = std::get_if<QuadraticProof>(&radius.proof)) scaled_proof(*form);
  if (auto* graph = std::get_if<GraphProof>(&radius.proof)) scaled_proof(*graph);
  if (auto* blocks = std::get_if<BlockProof>(&radius.proof)) {
    for (RationalMatrix& matrix : blocks->triangular.triangular) matrix = factor * matrix;
    for (JointSpectralRadius& block : blocks->blocks) block = scaled(std::move(block), factor);
  }
  return radius;
}

/// The sum over its proofs of this kind.
template <class Proof, class Count>
std::size_t total(const JointSpectralRadius& radius, Count count) {
  if (const auto* proof = std::get_if<Proof>(&radius.proof)) return count(*proof);
  std::size_t sum = 0;
  if (const BlockProof* blocks = radius.by_blocks())
    for (const JointSpectralRadius& block : blocks->blocks) sum += total<Proof>(block, count);
  return sum;
}

}  // namespace

void BlockProof::try_product(const std::vector<int>& word, const Deadline& deadline) {
  for (std::size_t k = 0; k < blocks.size(); ++k) subcert::try_product(blocks[k], triangular.block(k), word, deadline);
  leading = leading_block(blocks);
}

bool JointSpectralRadius::is_closed() const {
  return radius.is_bounded() && *radius.upper <= *radius.lower * (1 + 1000 * rounding);
}

Rational JointSpectralRadius::proved_upper() const {
  if (const auto* norms = std::get_if<NormProof>(&proof)) return norms->bound();
  if (const auto* polytope = std::get_if<PolytopeProof>(&proof)) return polytope->bound;
  if (const auto* form = std::get_if<QuadraticProof>(&proof)) return form->bound;
  if (const auto* graph = std::get_if<GraphProof>(&proof)) return graph->bound;
  if (const auto* single = std::get_if<SingleRadiusProof>(&proof)) return *single->growth.radius.upper;
  if (const auto* frequencies = std::get_if<FrequencyProof>(&proof)) return frequencies->bound;
  Rational most = 0;
  for (const JointSpectralRadius& block : by_blocks()->blocks) most = std::max(most, block.proved_upper());
  return most;
}

std::string to_text(JsrMethod method) {
  switch (method) {
    case JsrMethod::invariant_polytope: return "invariant polytope";
    case JsrMethod::quadratic_form: return "quadratic form";
    case JsrMethod::single_spectral_radius: return "single spectral radius";
    case JsrMethod::frequencies: return "frequencies";
    default: return "norms of products";
  }
}

JsrMethod JointSpectralRadius::method() const {
  if (const BlockProof* blocks = by_blocks()) return blocks->blocks[blocks->leading].method();
  if (std::holds_alternative<PolytopeProof>(proof)) return JsrMethod::invariant_polytope;
  if (std::holds_alternative<QuadraticProof>(proof) || std::holds_alternative<GraphProof>(proof))
    return JsrMethod::quadratic_form;
  if (std::holds_alternative<FrequencyProof>(proof)) return JsrMethod::frequencies;
  return std::holds_alternative<NormProof>(proof) ? JsrMethod::norm_of_products : JsrMethod::single_spectral_radius;
}

std::size_t JointSpectralRadius::vertices() const {
  return total<PolytopeProof>(*this, [](const PolytopeProof& polytope) { return polytope.vertices.size(); });
}

std::size_t JointSpectralRadius::words() const {
  return total<QuadraticProof>(*this, [](const QuadraticProof& form) { return form.letters.size(); }) +
         total<GraphProof>(*this, [](const GraphProof& graph) { return graph.words(); });
}

int bits_for_width(const Rational& width) {
  constexpr int most_places = 1000;
  require(width <= 1 && width >= power(Rational(10), -most_places), "width: need 1e-{} <= width <= 1, got {}",
          most_places, width);
  // 10 < 2^(10/3); the rest is for radii up to 2^32.
  return std::max(default_bits, 10 * decimal_places(width) / 3 + 32);
}

void sharpen(JointSpectralRadius& radius, const MatrixFamily& family, int bits, const Deadline& deadline) {
  Enclosure& ends = radius.radius;
  const std::vector<int>& word = radius.product.word;
  if (!radius.exact.is_yes() || word.empty() || *ends.upper - *ends.lower <= *ends.lower * power(Rational(2), -bits))
    return;
  const auto product = family.product(word, deadline);
  const auto characteristic = product ? characteristic_polynomial(*product, deadline) : std::nullopt;
  if (!characteristic || !radius::has_time_for_roots(*characteristic, deadline)) return;
  const Enclosure modulus = largest_root_modulus(*characteristic, bits).largest;
  const int length = static_cast<int>(word.size());
  ends.lower = std::max(*ends.lower, *root_enclosure(*modulus.lower, length, bits).lower);
  ends.upper = std::min(*ends.upper, *root_enclosure(*modulus.upper, length, bits).upper);
}

ProductEvidence find_product_above(const MatrixFamily& family, const Rational& least, const Budget& budget) {
  require_small(family);
  const Rational unit = radius::unit_of(family);
  const MatrixFamily scaled_family = unit == 1 ? family : 1 / unit * family;
  const polytope::SearchFamily search = radius::to_search_family(scaled_family);
  ProductEvidence best;
  double largest = 0;
  // Whether one of them is large enough.
  const auto enough = [&](const std::vector<polytope::Candidate>& found) {
    for (std::size_t k = 0; k < std::min(found.size(), proved_products); ++k) {
      largest = std::max(largest, found[k].radius);
      ProductEvidence evidence = radius::scaled(prove_product(scaled_family, found[k].written(), budget.deadline),
                                                unit);
      const Rational& lower = evidence.exact ? *evidence.exact : *evidence.radius.lower;
      if (best.word.empty() || lower > *best.radius.lower) best = std::move(evidence);
      if (*best.radius.lower >= least || (best.exact && *best.exact >= least)) return true;
    }
    return false;
  };
  for (const auto& [length, width] : polytope::product_looks)
    if (enough(polytope::search_products(search, {.max_length = length, .width = width, .budget = budget})) ||
        budget.deadline.expired())
      return best;
  if (largest > 0) enough(quadratic::long_products(search, largest, budget));
  return best;
}

JointSpectralRadius joint_spectral_radius(const MatrixFamily& family, const Budget& budget,
                                          const std::optional<NormProof>& known,
                                          const std::optional<Rational>& target) {
  require_small(family);
  if (family.size() == 1) return radius::radius_of_numbers(family);
  if (const Rational unit = radius::unit_of(family); unit != 1) {
    const auto in_units = [&](NormProof norms) {
      norms.norm /= power(unit, norms.level);
      return norms;
    };
    return scaled(
        joint_spectral_radius(1 / unit * family, budget, known ? std::optional(in_units(*known)) : std::nullopt,
                              target ? std::optional(*target / unit) : std::nullopt),
        unit);
  }
  const Budget later{budget.deadline.later(schedule::family::grace_of_one_matrix), budget.memory};
  const auto of_one_matrix = target ? std::nullopt : radius_of_one_matrix(family, later.deadline);
  // Who asks for a bound asks for no narrow enclosure.
  JointSpectralRadius result = target ? searched(family, budget, known, target)
                                      : radius::best_of_rounds(family, budget, [&](const Budget& round) {
                                          return searched(family, round, known, target);
                                        });
  if (of_one_matrix) settle_one_matrix(result, family, *of_one_matrix, later);
  return result;
}

}  // namespace subcert
