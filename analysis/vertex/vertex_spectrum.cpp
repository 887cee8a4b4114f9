#include "vertex_spectrum.hpp"

#include "diagonal_blocks.hpp"
#include "kernel_vector.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace subcert::vertex {
namespace {

/// The characteristic polynomial of a block of the frequency k over Q(c).
FieldPolynomial polynomial_of(const SectorRules& rules, const ClosedSet& set, long k, const Unknowns& block,
                              const CosineField& field) {
  return characteristic_polynomial(restricted(SectorBlock<CosineField>(rules, set, k, field).matrix(), block), field);
}

/// A polynomial with the same zeros, all simple.
FieldPolynomial squarefree(const FieldPolynomial& p, const CosineField& field) {
  return quotient(p, gcd(p, derivative(p, field)), field);
}

/// Of one block, by its characteristic polynomial, whatever the multiplicities.
std::optional<std::vector<EigenvalueGroup>> exact_eigenvalues(const SectorRules& rules, const ClosedSet& set, long k,
                                                              const Unknowns& block, slong bits) {
  const CosineField field(rules.valence);
  const FieldPolynomial p = polynomial_of(rules, set, k, block, field);
  const FieldPolynomial multiple = gcd(p, derivative(p, field));
  const BallField balls(rules.valence, bits);
  const auto values = zeros(quotient(p, multiple, field), balls);
  if (!values) return std::nullopt;
  std::vector<EigenvalueGroup> groups;
  for (const ComplexBall& value : *values)
    groups.push_back({value, contains_zero(value_at(multiple, value, balls)) ? 2U : 1U});
  return groups;
}

CosineField::Number value_at(const FieldPolynomial& p, const CosineField::Number& x, const CosineField& field) {
  CosineField::Number value = field.number(0);
  for (std::size_t i = p.size(); i-- > 0;) value = value * x + p[i];
  return value;
}

/// Divides by x - zero as often as that is a factor, at most `most` times; how often.
std::size_t take_out(FieldPolynomial& p, const CosineField::Number& zero, const CosineField& field, std::size_t most) {
  std::size_t count = 0;
  for (; count < most && p.size() > 1 && value_at(p, zero, field).is_zero(); ++count)
    p = quotient(p, {-zero, field.number(1)}, field);
  return count;
}

/// The zero in a ball, where it is the only one or the simplest rational number there.
std::optional<CosineField::Number> zero_in(const FieldPolynomial& p, const Ball& ball, const CosineField& field) {
  if (p.size() == 2) return -p[0];
  const Enclosure place = ball.enclosure();
  if (!place.is_bounded()) return std::nullopt;
  const CosineField::Number number = field.number(simplest_between(*place.lower, *place.upper));
  return value_at(p, number, field).is_zero() ? std::optional(number) : std::nullopt;
}

bool are_all_less(const FieldPolynomial& p, const Ball& bound, const CosineField& field, const BallField& balls) {
  if (p.size() == 1) return true;
  const auto values = zeros(squarefree(p, field), balls);
  return values && std::ranges::all_of(*values, [&](const ComplexBall& value) { return abs(value).is_less(bound); });
}

/// Takes out the eigenvalue 1 of the constants. Whether it is alone.
bool take_out_constants(std::vector<FrequencyGroup>& groups, slong bits) {
  const ComplexBall one(Ball(1, bits));
  const auto is_one = [&](const FrequencyGroup& group) { return overlap(group.value, one); };
  const auto constant = std::find_if(groups.begin(), groups.end(), is_one);
  if (constant == groups.end() || constant->count != 1) return false;
  groups.erase(constant);
  return std::none_of(groups.begin(), groups.end(), is_one);
}

}  // namespace

bool VertexSpectrum::has_simple_leader() const {
  if (groups.empty()) return false;
  // The conjugate is an eigenvalue of the real matrix, and no other one has the same modulus.
  const FrequencyGroup& first = groups.front();
  const Ball zero(0, first.value.bits());
  return first.count == 1 && zero.is_less(first.value.real()) &&
         std::all_of(groups.begin() + 1, groups.end(),
                     [&](const FrequencyGroup& other) { return abs(other.value).is_less(abs(first.value)); });
}

std::optional<VertexSpectrum> vertex_spectrum(const SectorRules& rules, const ClosedSet& set, slong bits) {
  const BallField field(rules.valence, bits);
  VertexSpectrum result;
  for (long k = 0; 2 * k <= rules.valence; ++k) {
    const auto matrix = SectorBlock<BallField>(rules, set, k, field).matrix();
    const auto is_zero = [](const Ball& entry) { return arb_is_zero(entry.get()) != 0; };
    for (const Unknowns& block : diagonal_blocks(matrix, is_zero)) {
      auto groups = eigenvalues(restricted(matrix, block), bits);
      if (!groups) groups = exact_eigenvalues(rules, set, k, block, bits);
      if (!groups) return std::nullopt;
      for (EigenvalueGroup& group : *groups) result.groups.push_back({k, block, std::move(group.value), group.count});
    }
    if (k == 0 && !take_out_constants(result.groups, bits)) return std::nullopt;
  }
  std::stable_sort(result.groups.begin(), result.groups.end(), [](const FrequencyGroup& a, const FrequencyGroup& b) {
    return b.value.magnitude() < a.value.magnitude();
  });
  return result;
}

std::vector<Leader::Share> Leader::largest() const {
  std::size_t size = 0;
  for (const Share& share : shares) size = std::max(size, share.size);
  std::vector<Share> result;
  std::ranges::copy_if(shares, std::back_inserter(result), [&](const Share& share) { return share.size == size; });
  return result;
}

std::optional<Leader> leader_of(const VertexSpectrum& spectrum, const SectorRules& rules, const ClosedSet& set) {
  if (spectrum.groups.empty()) return std::nullopt;
  const FrequencyGroup& first = spectrum.groups.front();
  if (spectrum.has_simple_leader()) return Leader{first.value.real(), {{first.frequency, 1}}};
  const CosineField field(rules.valence);
  const BallField balls(rules.valence, first.value.bits());
  std::map<std::pair<long, Unknowns>, FieldPolynomial> rivals;
  FieldPolynomial common;
  for (const FrequencyGroup& group : spectrum.groups) {
    if (abs(group.value).is_less(abs(first.value))) continue;
    const auto [rival, fresh] = rivals.try_emplace({group.frequency, group.block});
    FieldPolynomial& p = rival->second;
    if (fresh) p = polynomial_of(rules, set, group.frequency, group.block, field);
    // Zeros that this eigenvalue is one of.
    common = gcd(squarefree(group.count > 1 ? gcd(p, derivative(p, field)) : p, field), common);
  }
  const auto known = zero_in(common, first.value.real(), field);
  if (!known) return std::nullopt;
  const CosineField::Number& value = *known;
  Leader result{balls.number(value.polynomial()), {}};
  if (!Ball(0, balls.bits()).is_less(result.value)) return std::nullopt;
  for (const FrequencyGroup& group : spectrum.groups)
    if (rivals.count({group.frequency, group.block}) == 0 && !abs(group.value).is_less(result.value))
      return std::nullopt;
  std::set<long> frequencies;
  for (auto& [key, p] : rivals) {
    if (key.first == 0) take_out(p, field.number(1), field, 1);
    if (take_out(p, value, field, p.size()) > 0) frequencies.insert(key.first);
    if (!are_all_less(p, result.value, field, balls)) return std::nullopt;
  }
  for (const long frequency : frequencies) {
    auto matrix = SectorBlock<CosineField>(rules, set, frequency, field).matrix();
    for (std::size_t i = 0; i < matrix.size(); ++i) matrix[i][i] = matrix[i][i] - value;
    NilpotentPart part = nilpotent_part(matrix, field);
    result.shares.push_back({frequency, part.size, std::move(part.last)});
  }
  const auto is_alone = [](const Leader::Share& share) { return !share.vector.empty(); };
  return std::ranges::all_of(result.largest(), is_alone) ? std::optional(std::move(result)) : std::nullopt;
}

SquareTest::SquareTest(FrequencyGroup root, const SectorRules& rules, const ClosedSet& set)
    : root_(std::move(root)),
      rules_(rules),
      set_(set),
      field_(rules.valence),
      polynomial_(polynomial_of(rules, set, root_.frequency, root_.block, field_)) {}

bool SquareTest::operator()(const FrequencyGroup& square) const {
  const FieldPolynomial of_square = polynomial_of(rules_, set_, square.frequency, square.block, field_),
                        common = gcd(polynomial_, in_squares(of_square, field_));
  if (common.size() == 1) return false;
  // The eigenvalue is the only zero of its polynomial in its ball. Where the rest of that has none there, it is one of
  // the common factor, and its square is an eigenvalue of the other block, the one whose ball it meets.
  const BallField balls(rules_.valence, root_.value.bits());
  return !contains_zero(value_at(quotient(polynomial_, common, field_), root_.value, balls)) &&
         overlap(root_.value * root_.value, square.value);
}

}  // namespace subcert::vertex
