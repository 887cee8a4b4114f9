#include "different_matrices.hpp"

#include <algorithm>
#include <numeric>
#include <set>

namespace subcert::radius {
namespace {

/// The sign of the first entry that is not 0.
int first_sign(const RationalMatrix& m) {
  for (std::size_t i = 0; i < m.rows(); ++i)
    for (std::size_t j = 0; j < m.columns(); ++j)
      if (m(i, j) != 0) return m(i, j) < 0 ? -1 : 1;
  return 0;
}

bool are_opposite(const RationalMatrix& a, const RationalMatrix& b) {
  for (std::size_t i = 0; i < a.rows(); ++i)
    for (std::size_t j = 0; j < a.columns(); ++j)
      if (a(i, j) != -b(i, j)) return false;
  return true;
}

/// A word over the different matrices in letters of the family.
void rename(std::vector<int>& word, const DifferentMatrices& different) {
  for (int& letter : word) letter = static_cast<int>(different.originals[static_cast<std::size_t>(letter)]);
}

void expand(std::vector<FamilySymmetry>& group, const DifferentMatrices& different) {
  for (FamilySymmetry& element : group) {
    std::vector<std::size_t> letters;
    const std::size_t last = different.places.size() - 1;
    for (std::size_t t = 0; t <= last; ++t) {
      const std::size_t image = element.letters[different.places[t]];
      const auto is_image = [&](std::size_t s) {
        return different.places[s] == image && different.opposite[s] == different.opposite[t];
      };
      // Of equal matrices the one that the flip names, so that it reverses the order of all; of opposite ones, which
      // only the identity keeps, itself.
      letters.push_back(is_image(last - t) ? last - t : is_image(t) ? t : different.originals[image]);
    }
    element.letters = std::move(letters);
  }
}

/// Images under matrices that occur once more are the same vertices.
void expand(AttainedProof& proof, const DifferentMatrices& different) {
  const auto original = [&](std::size_t letter) { return different.originals[letter]; };
  std::vector<AttainedProof::Coincidence> all;
  const auto add = [&](const AttainedProof::Coincidence& image, bool first) {
    for (std::size_t t = 0; t < different.places.size(); ++t)
      if (different.places[t] == image.letter && (first || t != original(image.letter)))
        all.push_back({image.vertex, t, image.target, image.element});
  };
  for (const AttainedProof::Coincidence& image : proof.coincidences) add(image, true);
  for (AttainedProof::Origin& origin : proof.origins) {
    add({origin.parent, origin.letter, origin.vertex, 0}, false);
    origin.letter = original(origin.letter);
  }
  proof.coincidences = std::move(all);
  for (AttainedProof::Cycle& cycle : proof.cycles) rename(cycle.letters, different);
}

}  // namespace

DifferentMatrices different_matrices(const MatrixFamily& family, bool up_to_sign) {
  DifferentMatrices result{&family, std::nullopt, {}, {}, {}};
  auto& [whole, fewer, originals, places, opposite] = result;
  bool any_opposite = false;
  for (std::size_t t = 0; t < family.count(); ++t) {
    auto known = std::ranges::find_if(originals, [&](std::size_t k) { return family[k] == family[t]; });
    if (up_to_sign && known == originals.end()) {
      known = std::ranges::find_if(originals, [&](std::size_t k) { return are_opposite(family[k], family[t]); });
      if (known != originals.end()) {
        any_opposite = true;
        if (first_sign(family[t]) < 0) *known = t;
      }
    }
    places.push_back(static_cast<std::size_t>(known - originals.begin()));
    if (known == originals.end()) originals.push_back(t);
  }
  for (std::size_t t = 0; t < family.count(); ++t) opposite.push_back(family[originals[places[t]]] != family[t]);
  if (!result.are_fewer()) return result;
  std::vector<RationalMatrix> matrices;
  for (const std::size_t t : originals) matrices.push_back(family[t]);
  if (any_opposite) {
    std::vector<std::size_t> letters(matrices.size());
    std::iota(letters.begin(), letters.end(), std::size_t{0});
    fewer.emplace(std::move(matrices), std::vector{FamilySymmetry{SparseMap::identity(family.size()), letters}});
    return result;
  }
  // The flip is kept where it still reverses the order.
  if (family.is_flip_symmetric()) {
    fewer.emplace(std::move(matrices));
    return result;
  }
  std::vector<FamilySymmetry> group;
  for (const FamilySymmetry& element : family.group()) {
    FamilySymmetry one{element.map, {}};
    for (const std::size_t t : originals) one.letters.push_back(places[element.letters[t]]);
    // Elements of equal letters differ by their sign only, or by nothing.
    if (std::none_of(group.begin(), group.end(), [&](const FamilySymmetry& g) { return g.letters == one.letters; }))
      group.push_back(std::move(one));
  }
  fewer.emplace(std::move(matrices), std::move(group));
  return result;
}

void expand(GraphProof& proof, const DifferentMatrices& different) {
  for (GraphProof::State& state : proof.states)
    for (GraphProof::Step& step : state.steps) step.letter = different.originals[step.letter];
  expand(proof.group, different);
  if (!proof.attained) return;
  AttainedGraph attained = *proof.attained;
  expand(attained.graph, different);
  rename(attained.product, different);
  proof.attained = std::make_shared<AttainedGraph>(std::move(attained));
}

void expand(JointSpectralRadius& radius, const DifferentMatrices& different) {
  rename(radius.product.word, different);
  if (auto* form = std::get_if<QuadraticProof>(&radius.proof)) {
    form->letters.clear();  // one of each, also of opposite ones
    std::set<std::pair<std::size_t, bool>> seen;
    for (std::size_t t = 0; t < different.places.size(); ++t)
      if (seen.emplace(different.places[t], different.opposite[t]).second) form->letters.push_back(static_cast<int>(t));
  }
  if (auto* graph = std::get_if<GraphProof>(&radius.proof)) expand(*graph, different);
  auto* polytope = std::get_if<PolytopeProof>(&radius.proof);
  if (!polytope) return;
  const std::size_t count = different.originals.size();
  const auto repeated = [&](auto& of_images) {
    std::remove_reference_t<decltype(of_images)> all;
    for (std::size_t v = 0; v < polytope->vertices.size(); ++v)
      for (const std::size_t place : different.places) all.push_back(of_images[v * count + place]);
    of_images = std::move(all);
  };
  repeated(polytope->images);
  for (std::size_t k = 0; k < polytope->images.size(); ++k)
    if (different.opposite[k % different.places.size()])
      for (WeightedVertex& term : polytope->images[k]) {
        term.weight = -term.weight;
        term.imaginary = -term.imaginary;
      }
  repeated(polytope->moduli);
  repeated(polytope->residuals);
  if (polytope->attained) expand(*polytope->attained, different);
  expand(polytope->group, different);
}

}  // namespace subcert::radius
