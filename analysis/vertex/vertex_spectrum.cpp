#include "vertex_spectrum.hpp"

#include <algorithm>

namespace subcert::vertex {
namespace {

/// The one real number in a ball that holds one eigenvalue of a real matrix, apart from the mirror images of the others.
bool is_real(const FrequencyGroup& group, const std::vector<FrequencyGroup>& all) {
  if (group.count != 1 || !contains_zero(ComplexBall(imaginary_part(group.value)))) return false;
  return std::all_of(all.begin(), all.end(), [&](const FrequencyGroup& other) {
    return &other == &group || other.frequency != group.frequency || !overlap(other.value, conj(group.value));
  });
}

/// Without the eigenvalue 1 of the constants; nothing where it is not alone.
std::optional<std::vector<EigenvalueGroup>> without_constants(std::vector<EigenvalueGroup> groups, slong bits) {
  const ComplexBall one(Ball(1, bits));
  const auto constant =
      std::find_if(groups.begin(), groups.end(), [&](const EigenvalueGroup& g) { return overlap(g.value, one); });
  if (constant == groups.end() || constant->count != 1) return std::nullopt;
  groups.erase(constant);
  return groups;
}

}  // namespace

bool VertexSpectrum::has_simple_leader() const {
  if (groups.empty()) return false;
  const FrequencyGroup& first = groups.front();
  const Ball zero(0, first.value.bits());
  return is_real(first, groups) && zero.is_less(first.value.real()) &&
         std::all_of(groups.begin() + 1, groups.end(),
                     [&](const FrequencyGroup& other) { return abs(other.value).is_less(abs(first.value)); });
}

std::optional<VertexSpectrum> vertex_spectrum(const SectorRules& rules, const ClosedSet& set, slong bits) {
  const BallField field(rules.valence, bits);
  VertexSpectrum result;
  for (long k = 0; 2 * k <= rules.valence; ++k) {
    const SectorBlock<BallField> block(rules, set, k, field);
    auto groups = eigenvalues(block.matrix(), bits);
    if (groups && k == 0) groups = without_constants(*std::move(groups), bits);
    if (!groups) return std::nullopt;
    for (EigenvalueGroup& group : *groups) result.groups.push_back({k, std::move(group.value), group.count});
  }
  std::stable_sort(result.groups.begin(), result.groups.end(), [](const FrequencyGroup& a, const FrequencyGroup& b) {
    return b.value.magnitude() < a.value.magnitude();
  });
  return result;
}

bool is_square_of(const FrequencyGroup& square, const FrequencyGroup& root, const SectorRules& rules,
                  const ClosedSet& set) {
  const CosineField field(rules.valence);
  const auto polynomial_of = [&](long frequency) {
    return characteristic_polynomial(SectorBlock<CosineField>(rules, set, frequency, field).matrix(), field);
  };
  const FieldPolynomial p = polynomial_of(root.frequency),
                        common = gcd(p, in_squares(polynomial_of(square.frequency), field));
  if (common.size() == 1) return false;
  // The eigenvalue is the only zero of p in its ball. Where the rest of p has none there, it is one of the common
  // factor, and its square is an eigenvalue of the other frequency, the one whose ball it meets.
  const BallField balls(rules.valence, root.value.bits());
  const Ball rest = value_at(quotient(p, common, field), root.value.real(), balls);
  return !contains_zero(ComplexBall(rest)) && overlap(root.value * root.value, square.value);
}

}  // namespace subcert::vertex
