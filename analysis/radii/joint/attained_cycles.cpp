#include "attains.hpp"

#include <subcert/analysis/radii/polytope_proof/candidate.hpp>

#include <algorithm>

namespace subcert::radius {
namespace {

constexpr slong root_bits = 320;
constexpr std::size_t longest_cycle = 1000;

bool is_near(const ComplexVector& v, const RationalComplex& factor, const ComplexVector& w) {
  ComplexVector difference;
  for (std::size_t i = 0; i < v.size(); ++i) difference.push_back(w[i] - factor * v[i]);
  return one_norm(difference) < power(Rational(10), -20) * one_norm(w);
}

class Cycles {
 public:
  Cycles(const MatrixFamily& family, const PolytopeCandidate& candidate, const PolytopeProof& polytope,
         const CycleFactors* known, const std::vector<bool>& inside, const Deadline& deadline)
      : candidate_(candidate), polytope_(polytope), known_(known), inside_(inside), deadline_(deadline) {
    for (const RationalMatrix& m : family) matrices_.push_back(polytope.transposed ? transposed(m) : m);
  }

  /// The reason why there is no proof, empty where there is one.
  std::string run() {
    for (std::size_t v = 0; v < candidate_.vertices.size(); ++v) {
      const PolytopeCandidate::Vertex& vertex = candidate_.vertices[v];
      std::optional<Image> parent;
      if (vertex.parent >= 0)
        parent = {static_cast<std::size_t>(vertex.parent), static_cast<std::size_t>(vertex.letter)};
      else if (vertex.cycle >= 0 && !(parent = place_before(v)))
        if (std::string missing = start_cycle(v); !missing.empty()) return missing;
      if (!parent) continue;
      children_.emplace(*parent, v);
      proof_.origins.push_back({v, parent->first, parent->second});
    }
    if (proof_.cycles.empty()) return "no vertex of the polytope stems from an eigenvector";
    for (AttainedProof::Cycle& cycle : proof_.cycles)
      if (!find_last(cycle)) return "an image of the first vertex of a cycle is no vertex";
    for (std::size_t i = 0; i < candidate_.images.size(); ++i) {
      const PolytopeCandidate::Image& image = candidate_.images[i];
      const bool lies_inside = i < inside_.size() && inside_[i];
      if (image.identity && !lies_inside && !image.terms.front().conjugated) add_coincidence(image);
    }
    if (common_) proof_.number = common_->first.number(common_->second);
    return "";
  }

  AttainedProof& proof() { return proof_; }

 private:
  using Image = std::pair<std::size_t, std::size_t>;  // of a vertex under a matrix

  const RationalMatrix& matrix(int letter) const { return matrices_[static_cast<std::size_t>(letter)]; }

  /// The vertex on the same cycle of which this one is the image, if it comes before.
  std::optional<Image> place_before(std::size_t v) const {
    const PolytopeCandidate::Vertex& vertex = candidate_.vertices[v];
    const std::vector<int>& word = candidate_.products[static_cast<std::size_t>(vertex.cycle)].word;
    const int length = static_cast<int>(word.size()), place = (vertex.place + length - 1) % length;
    const int letter = word[static_cast<std::size_t>(place)];
    const ComplexVector goal = polytope_.vertex(v);
    for (std::size_t u = 0; u < v; ++u) {
      const PolytopeCandidate::Vertex& other = candidate_.vertices[u];
      if (other.parent >= 0 || other.cycle != vertex.cycle || other.place != place) continue;
      const ComplexVector image = matrix(letter) * polytope_.vertex(u);
      if (one_norm(image) > 0 && is_near(goal, rayleigh_quotient(goal, image), image))
        return Image{u, static_cast<std::size_t>(letter)};
    }
    return std::nullopt;
  }

  /// The shortest part of the cycle after which an element of the group leads back.
  std::string start_cycle(std::size_t v) {
    const PolytopeCandidate::Vertex& vertex = candidate_.vertices[v];
    std::vector<int> letters = candidate_.products[static_cast<std::size_t>(vertex.cycle)].word;
    std::rotate(letters.begin(), letters.begin() + vertex.place, letters.end());
    const ComplexVector start = polytope_.vertex(v);
    if (one_norm(start) == 0 || letters.size() > longest_cycle) return "a cycle is too long";
    ComplexVector moved = start;
    RationalMatrix product = RationalMatrix::identity(start.size());
    for (std::size_t length = 1; length <= letters.size(); ++length) {
      moved = matrix(letters[length - 1]) * moved;
      product = matrix(letters[length - 1]) * product;
      if (letters.size() % length != 0 || one_norm(moved) == 0) continue;
      for (std::size_t e = 0; e < polytope_.group.size(); ++e) {
        const RationalMatrix map = polytope_.group[e].map.matrix();
        const ComplexVector image = map * moved;
        const RationalComplex eigenvalue = rayleigh_quotient(start, image);
        if (!is_near(start, eigenvalue, image)) continue;
        const bool whole = length == letters.size() && e == 0;
        letters.resize(length);
        if (!known_) {
          proof_.cycles.push_back({v, e, 1, letters, {}, v});
          return "";
        }
        const auto known = known_->find(v);
        const auto factor = whole && known != known_->end()
                                ? std::optional(known->second)
                                : leading_factor(map * product, eigenvalue, root_bits, deadline_);
        if (!factor) return "no time was left for a cycle";
        return add_cycle({v, e, 1, letters, {}, v}, map * product, *factor, start);
      }
    }
    return "a vertex of a cycle is not led back to itself";
  }

  std::string add_cycle(AttainedProof::Cycle cycle, const RationalMatrix& product, const LeadingFactor& factor,
                        const ComplexVector& start) {
    if (!common_) common_.emplace(factor, cycle.letters.size());
    if (!is_common(factor, cycle)) {
      if (polytope_.kind == PolytopeKind::nonnegative || !is_common(factor.negated(), cycle))
        return "the leading eigenvalues of two cycles are no zeros of one polynomial, up to their signs";
      cycle.sign = -1;
    }
    const auto seed = cycle.sign > 0 ? seed_of(product, factor, start)
                                     : seed_of(Rational(-1) * product, factor.negated(), start);
    if (!seed) return "a leading eigenvalue is no simple zero of the minimal polynomial of its product";
    cycle.seed = *seed;
    proof_.cycles.push_back(std::move(cycle));
    return "";
  }

  /// Whether this is the zero of the cycles before.
  bool is_common(const LeadingFactor& factor, const AttainedProof::Cycle& cycle) const {
    const auto& [other, length] = *common_;
    return length == cycle.letters.size() && other.factor == factor.factor && overlap(other.zero, factor.zero);
  }

  /// Whether all images of its first vertex are vertices.
  bool find_last(AttainedProof::Cycle& cycle) const {
    for (std::size_t k = 0; k + 1 < cycle.letters.size(); ++k) {
      const auto next = children_.find({cycle.last, static_cast<std::size_t>(cycle.letters[k])});
      if (next == children_.end()) return false;
      cycle.last = next->second;
    }
    return true;
  }

  void add_coincidence(const PolytopeCandidate::Image& image) {
    const Image at{static_cast<std::size_t>(image.vertex), static_cast<std::size_t>(image.letter)};
    const auto& term = image.terms.front();
    if (!children_.contains(at))
      proof_.coincidences.push_back(
          {at.first, at.second, static_cast<std::size_t>(term.vertex), static_cast<std::size_t>(term.element)});
  }

  const PolytopeCandidate& candidate_;
  const PolytopeProof& polytope_;
  const CycleFactors* known_;  // or nothing, where eigenvalues are not asked for
  const std::vector<bool>& inside_;
  Deadline deadline_;
  std::vector<RationalMatrix> matrices_;
  std::map<Image, std::size_t> children_;                        // vertices that are images
  std::optional<std::pair<LeadingFactor, std::size_t>> common_;  // and the letters
  AttainedProof proof_;
};

void set_attained(Cycles cycles, PolytopeProof& polytope) {
  polytope.not_attained = cycles.run();
  polytope.attained = polytope.not_attained.empty() ? std::optional(std::move(cycles.proof())) : std::nullopt;
}

}  // namespace

void find_cycles(const MatrixFamily& family, const PolytopeCandidate& candidate, PolytopeProof& polytope,
                 const CycleFactors& known, const std::vector<bool>& inside, const Deadline& deadline) {
  set_attained({family, candidate, polytope, &known, inside, deadline}, polytope);
}

void find_nearby_cycles(const MatrixFamily& family, const PolytopeCandidate& candidate, PolytopeProof& polytope) {
  set_attained({family, candidate, polytope, nullptr, {}, {}}, polytope);
}

}  // namespace subcert::radius
