#include "joint_spectral_subradius.hpp"

#include "attained_subradius.hpp"
#include "certify.hpp"

#include <subcert/analysis/regularity/polytope_proof/round_family.hpp>
#include <subcert/analysis/regularity/radius/joint_spectral_radius.hpp>
#include <subcert/analysis/regularity/radius/scaling.hpp>
#include <subcert/analysis/symbol/error.hpp>

#include <algorithm>
#include <array>
#include <limits>

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
                                     {{200, 2000}, 0.1, 0.3, std::numeric_limits<std::size_t>::max()}}};

constexpr double explanation_share = 0.3;  // of the time that is left then
constexpr std::size_t most_explained = 8;  // times as many vertices

/// One search: products first, then polytopes of the family and of its transposed matrices.
class SubradiusSearch {
 public:
  SubradiusSearch(const MatrixFamily& family, const Budget& budget, const SubradiusTarget& target)
      : family_(family),
        transposed_(transposed(family)),
        budget_(budget),
        target_(target),
        scaled_(radius::to_search_family(power(Rational(2), -radius::scaling_exponent(family)) * family)) {
    start();
  }

  JointSpectralSubradius run() {
    for (const Look& look : looks) {
      if (is_enough() || budget_.deadline.expired()) break;
      const Budget share{budget_.deadline.after(look.products_share), budget_.memory};
      const auto found = polytope::search_products(
          scaled_, {.max_length = look.products.length, .width = look.products.width, .budget = share, .least = true});
      // The letter applied first stands at the end of a word.
      try_product({found.front().word.rbegin(), found.front().word.rend()});
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

  /// Whether a product has a smaller radius than the best so far.
  bool try_product(const std::vector<int>& word) {
    auto found = subradius::leading_vector(family_, word, target_.bits, budget_.deadline);
    if (!found) return false;
    const Rational upper = found->product.radius == 0 ? Rational(0) : found->rate;
    if (is_led_ && *best_.radius.upper * (1 - power(Rational(2), -40)) <= upper) return false;
    if (upper <= *best_.radius.upper) {
      best_.radius.upper = upper;
      best_.product = found->product;
    }
    is_led_ = true;
    leading_ = std::move(*found);
    growths_ = begun();
    return true;
  }

  /// A search for a polytope, of the family or of its transposed matrices.
  struct Growth {
    bool transposed;
    std::vector<Integer> first;  ///< the vertex it begins with
    subradius::AntinormSearch search;
    std::size_t proved = 0;  ///< vertices of the last proof that was tried
  };

  /// Polytopes for the best product, and for better ones that they meet.
  void grow(const Look& look) {
    for (std::size_t k = 0; k < growths_.size() && !is_enough(); ++k) {
      const Deadline deadline = budget_.deadline.after(look.polytope_share * static_cast<double>(k + 1));
      if (advance(growths_[k], look.vertices, deadline)) return grow(look);
    }
  }

  std::vector<Growth> begun() const {
    std::vector<Growth> result;
    for (const bool of_transposed : {false, true}) {
      const MatrixFamily& family = of_transposed ? transposed_ : family_;
      std::vector<int> word = leading_.product.word;
      std::optional<subradius::LeadingVector> own = leading_;
      if (of_transposed) {
        std::reverse(word.begin(), word.end());
        own = subradius::leading_vector(family, word, target_.bits, budget_.deadline);
      }
      if (!own || own->vector.empty()) continue;
      std::vector<polytope::Matrix> matrices;
      for (const RationalMatrix& matrix : family)
        matrices.push_back(radius::to_double(Rational(1) / leading_.rate * matrix));
      const Integer largest = *std::max_element(own->vector.begin(), own->vector.end());
      polytope::Vector start;
      for (const Integer& c : own->vector) start.push_back(Rational(c, largest).convert_to<double>());
      result.push_back({of_transposed,
                        own->vector,
                        {std::move(matrices), std::move(start), {word.rbegin(), word.rend()}, budget_.memory / 4}});
    }
    return result;
  }

  /// Whether a better product was met.
  bool advance(Growth& growth, std::size_t vertices, const Deadline& deadline) {
    const subradius::AntinormCandidate& found = growth.search.advance(vertices, deadline);
    if (found.kept != growth.proved) {
      growth.proved = found.kept;
      auto proof = certified(growth, found);
      if (proof && proof->bound > *best_.radius.lower) {
        best_.radius.lower = proof->bound;
        if (found.closed) best_.exact = settled(growth, *proof);
        best_.antinorm = std::move(proof);
      }
    }
    std::vector<int> word = found.smaller;  // the letter applied first in front
    if (!growth.transposed) std::reverse(word.begin(), word.end());
    return !word.empty() && try_product(word);
  }

  /// Once more with vertices in place of images on the boundary, so that the product is seen to attain the subradius.
  void explain(const Growth& growth, const Deadline& deadline) {
    subradius::AntinormSearch search = growth.search.explained();
    const subradius::AntinormCandidate& found = search.advance(most_explained * growth.search.count(), deadline);
    auto proof = found.closed ? certified(growth, found) : std::nullopt;
    if (!proof) return;
    const Decision exact = settled(growth, *proof);
    if (!exact.is_yes()) return;
    best_.exact = exact;
    best_.antinorm = std::move(proof);
  }

  std::optional<AntinormProof> certified(const Growth& growth, const subradius::AntinormCandidate& found) const {
    auto proof = subradius::certify_antinorm(family_of(growth), found, growth.search.cycle(), growth.first,
                                             leading_.rate, target_.bits, budget_.deadline);
    if (proof) proof->transposed = growth.transposed;
    return proof;
  }

  /// Whether the product of a closed polytope attains the subradius, which is then enclosed by its radius.
  Decision settled(const Growth& growth, AntinormProof& proof) {
    const Decision exact = subradius::product_attains_subradius(family_of(growth), proof, leading_.radius,
                                                                budget_.deadline);
    if (exact.is_yes()) best_.radius = leading_.radius;
    return exact;
  }

  const MatrixFamily& family_of(const Growth& growth) const { return growth.transposed ? transposed_ : family_; }

  const MatrixFamily& family_;
  MatrixFamily transposed_;
  const Budget& budget_;
  const SubradiusTarget& target_;
  polytope::SearchFamily scaled_;
  JointSpectralSubradius best_;
  bool is_led_ = false;  // by the vector of a product
  subradius::LeadingVector leading_;
  std::vector<Growth> growths_;
};

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
  return SubradiusSearch(family, budget, target).run();
}

}  // namespace subcert
