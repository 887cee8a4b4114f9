#include "joint_spectral_subradius.hpp"

#include "certify.hpp"

#include <subcert/analysis/radii/joint/joint_spectral_radius.hpp>
#include <subcert/analysis/radii/joint/similarity.hpp>
#include <subcert/analysis/radii/polytope_proof/round_family.hpp>
#include <subcert/analysis/symbol/numbers/interval.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <set>

namespace subcert {
namespace {

/// A look for products, then one for polytopes of the family and of its transposed matrices: often one of them closes
/// with few vertices and the other one never. Shares are of the time that is left.
struct Look {
  polytope::ProductLook products;
  double products_share, polytope_share;
  std::size_t vertices;  ///< of a polytope
};
constexpr std::array<Look, 4> looks{{{{12, 64}, 0.02, 0.1, 40},
                                     {{40, 128}, 0.05, 0.1, 400},
                                     {{100, 400}, 0.1, 0.2, 4000},
                                     {{200, 2000}, 0.1, 0.6, std::numeric_limits<std::size_t>::max()}}};

constexpr double explanation_share = 0.3;  // of the time that is left then
constexpr std::size_t most_explained = 8;  // times as many vertices
constexpr std::size_t most_products = 4;   // of equal radius

/// One search: products first, then polytopes of the family and of its transposed matrices.
class SubradiusSearch {
 public:
  SubradiusSearch(const MatrixFamily& family, const Budget& budget, const SubradiusTarget& target)
      : family_(family),
        transposed_(transposed(family)),
        budget_(budget),
        target_(target),
        search_family_(radius::to_search_family(family)) {
    start();
  }

  JointSpectralSubradius run() {
    for (const Look& look : looks) {
      if (is_enough() || budget_.deadline.expired()) break;
      look_for_products(look);
      grow(look);
    }
    for (const bool closed : {true, false})
      for (const Growth& growth : growths_)
        if (growth.search.has_closed() == closed && best_.is_closed() && !best_.exact.is_yes())
          explain(growth, budget_.deadline.after(explanation_share));
    if (best_.radius.is_exact()) best_.exact = {Truth::yes, "both ends are this number"};
    return std::move(best_);
  }

 private:
  /// A search for a polytope that starts from a product, of the family or of its transposed matrices.
  struct Growth {
    subradius::LeadingVector leading;  ///< of the product
    bool transposed;
    subradius::AntinormSearch search;
    std::size_t proved = 0;  ///< vertices of the last proof that was tried
  };

  /// From the letters of a product as it is written to those in the order in which the search applies its matrices, and
  /// back: of transposed matrices they are the same.
  static std::vector<int> between_orders(const std::vector<int>& word, bool of_transposed) {
    return of_transposed ? word : polytope::turned(word);
  }

  bool is_enough() const {
    const Rational &lower = *best_.radius.lower, &upper = *best_.radius.upper;
    const auto &least = target_.lower, &most = target_.upper;
    const bool settled = (!least || lower >= *least || upper < *least) && (!most || upper <= *most || lower > *most);
    return best_.is_closed() || ((least || most) && settled);
  }

  /// With a matrix of least norm.
  void start() {
    for (std::size_t t = 0; t < family_.count(); ++t) {
      const Rational norm = one_norm(transposed_[t]);
      if (t > 0 && norm >= *best_.radius.upper) continue;
      best_.product = {{static_cast<int>(t)}, norm, std::vector<Integer>(family_.size(), 1)};
      best_.radius = {0, norm};
      best_.exact = {Truth::unknown, "no polytope closed"};
    }
  }

  void look_for_products(const Look& look) {
    const Budget share{budget_.deadline.after(look.products_share), budget_.memory};
    auto found = polytope::search_products(
        search_family_,
        {.max_length = look.products.length, .width = look.products.width, .budget = share, .least = true});
    found.resize(std::min(polytope::sort_candidates(found, true), most_products));
    for (const polytope::Candidate& candidate : found) try_product(candidate.written());
  }

  /// Whether a product has a smaller radius than the best so far. It is grown from, and with those of equal radius.
  bool try_product(const std::vector<int>& word) {
    if (!tried_.insert(word).second) return false;
    auto leading = subradius::leading_vector(family_, word, target_.bits, budget_.deadline);
    if (!leading) return false;
    const Rational rate = leading->product.radius == 0 ? Rational(0) : leading->rate, slack = power(Rational(2), -40);
    const bool better = !rate_ || rate < *rate_ * (1 - slack);
    if (!better && rate > *rate_ * (1 + slack)) return false;
    if (better) {
      if (rate <= *best_.radius.upper) {
        best_.radius.upper = rate;
        best_.product = leading->product;
      }
      rate_ = rate;
      growths_.clear();
    }
    begin(*leading);
    return better;
  }

  void begin(const subradius::LeadingVector& leading) {
    for (const bool of_transposed : {false, true}) {
      const std::vector<Integer>& first = of_transposed ? leading.left : leading.right;
      if (first.empty()) continue;
      std::vector<int> cycle = between_orders(leading.product.word, of_transposed);
      std::vector<polytope::Matrix> matrices;
      for (const RationalMatrix& matrix : of_transposed ? transposed_ : family_)
        matrices.push_back(radius::to_double(Rational(1) / leading.rate * matrix));
      const Integer largest = *std::max_element(first.begin(), first.end());
      polytope::Vector start;
      for (const Integer& c : first) start.push_back(Rational(c, largest).convert_to<double>());
      growths_.push_back(
          {leading,
           of_transposed,
           {std::move(matrices), std::move(start), std::move(cycle), budget_.memory / (4 * most_products)}});
    }
  }

  /// Polytopes for the best products, and for better ones that they meet.
  void grow(const Look& look) {
    for (std::size_t k = 0; k < growths_.size() && !is_enough(); ++k) {
      const double parts = static_cast<double>(growths_.size() - k);
      if (advance(growths_[k], look.vertices, budget_.deadline.after(look.polytope_share / parts))) return grow(look);
    }
  }

  /// Whether a better product was met.
  bool advance(Growth& growth, std::size_t vertices, const Deadline& deadline) {
    const subradius::AntinormCandidate& found = growth.search.advance(vertices, deadline);
    if (found.kept != growth.proved) {
      growth.proved = found.kept;
      auto proof = certified(growth, found);
      if (proof && proof->bound > *best_.radius.lower) {
        best_.radius.lower = proof->bound;
        if (!found.closed || !settle(growth, *proof)) best_.antinorm = std::move(proof);
      }
    }
    return !found.smaller.empty() && try_product(between_orders(found.smaller, growth.transposed));
  }

  /// Once more with vertices in place of images on the boundary, so that the product is seen to attain the subradius.
  void explain(const Growth& growth, const Deadline& deadline) {
    subradius::AntinormSearch search = growth.search.explained();
    const subradius::AntinormCandidate& found = search.advance(most_explained * growth.search.count(), deadline);
    if (!found.closed) return;
    if (auto proof = certified(growth, found)) settle(growth, *proof);
  }

  std::optional<AntinormProof> certified(const Growth& growth, const subradius::AntinormCandidate& found) const {
    auto proof = subradius::certify_antinorm(family_of(growth), found, growth.search.cycle(),
                                             growth.transposed ? growth.leading.left : growth.leading.right,
                                             growth.leading.rate, target_.bits, budget_.deadline);
    if (proof) proof->transposed = growth.transposed;
    return proof;
  }

  /// Takes the radius of the product of a closed polytope and its proof, if the product attains the subradius; whether
  /// it does.
  bool settle(const Growth& growth, AntinormProof& proof) {
    best_.exact = subradius::product_attains_subradius(family_of(growth), proof, growth.leading.radius,
                                                       budget_.deadline);
    if (!best_.exact.is_yes()) return false;
    best_.radius = growth.leading.radius;
    best_.product = growth.leading.product;
    best_.antinorm = std::move(proof);
    return true;
  }

  const MatrixFamily& family_of(const Growth& growth) const { return growth.transposed ? transposed_ : family_; }

  const MatrixFamily& family_;
  MatrixFamily transposed_;
  const Budget& budget_;
  const SubradiusTarget& target_;
  polytope::SearchFamily search_family_;
  JointSpectralSubradius best_;
  std::optional<Rational> rate_;  // of the best product with a proof
  std::set<std::vector<int>> tried_;
  std::vector<Growth> growths_;
};

/// For 2^exponent times the matrices.
JointSpectralSubradius scaled(JointSpectralSubradius result, long exponent) {
  const auto factor = [](long bits) { return power(Rational(2), bits); };
  result.radius = scaled(result.radius, factor(exponent));
  result.product.radius *= factor(exponent * static_cast<long>(result.product.word.size()));
  if (result.antinorm) {
    AntinormProof& proof = *result.antinorm;
    proof.bound *= factor(exponent);
    const long bits = proof.weight_bits - exponent;
    for (std::vector<AntinormProof::Term>& terms : proof.images)
      for (AntinormProof::Term& term : terms) term.weight <<= static_cast<std::size_t>(std::max(0L, -bits));
    proof.weight_bits = static_cast<int>(std::max(0L, bits));
  }
  return result;
}

}  // namespace

bool JointSpectralSubradius::is_closed() const {
  return *radius.upper <= *radius.lower * (1 + power(Rational(10), -12));
}

JointSpectralSubradius joint_spectral_subradius(const MatrixFamily& family, const Budget& budget,
                                                const SubradiusTarget& target) {
  require(FamilyLimits::hold(family.count(), family.size()),
          "joint_spectral_subradius: need 1 to {} matrices of size 1 to {} with at most {} entries, got {} of size {}",
          FamilyLimits::matrices, FamilyLimits::size, FamilyLimits::entries, family.count(), family.size());
  require(is_nonnegative(family), "joint_spectral_subradius: need matrices without negative entries, got {} of size {}",
          family.count(), family.size());
  const long exponent = radius::scaling_exponent(family);
  if (exponent == 0) return SubradiusSearch(family, budget, target).run();
  const Rational unit = power(Rational(2), -exponent);
  const MatrixFamily scaled_family = unit * family;
  SubradiusTarget near = target;
  if (near.lower) *near.lower *= unit;
  if (near.upper) *near.upper *= unit;
  return scaled(SubradiusSearch(scaled_family, budget, near).run(), exponent);
}

}  // namespace subcert
