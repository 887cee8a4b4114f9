#include "rounded_family.hpp"

#include "attained_nearby.hpp"
#include "one_block.hpp"
#include "similarity.hpp"

#include <subcert/analysis/radii/polytope_proof/candidate.hpp>
#include <subcert/analysis/radii/quadratic/product_tree.hpp>
#include <subcert/analysis/radii/schedule.hpp>

#include <algorithm>
#include <utility>

namespace subcert::radius {
namespace {

/// The largest 1-norm of a vertex.
Rational longest_vertex(const PolytopeProof& proof) {
  Integer longest = 0;
  for (std::size_t k = 0; k < proof.vertices.size(); ++k) {
    Integer sum = 0;
    for (const Integer& x : proof.vertices[k]) sum += abs(x);
    if (!proof.imaginary.empty())
      for (const Integer& y : proof.imaginary[k]) sum += abs(y);
    longest = std::max(longest, sum);
  }
  return Rational(longest) * power(Rational(2), -proof.vertex_bits);
}

/// The candidate and, of two products, those in which the orbit of one is a little smaller: then what coincides with a
/// vertex of the other lies inside.
std::vector<PolytopeCandidate> with_smaller_orbits(const PolytopeCandidate& candidate) {
  constexpr double smaller = 1 - 0x1p-20;
  std::vector<PolytopeCandidate> result{candidate};
  std::vector<int> cycles;  // from which the vertices stem
  for (const PolytopeCandidate::Vertex& vertex : candidate.vertices)
    cycles.push_back(vertex.parent >= 0 ? cycles[static_cast<std::size_t>(vertex.parent)] : vertex.cycle);
  const int last = *std::ranges::max_element(cycles);
  for (int cycle = last; last == 1 && cycle >= 0; --cycle) {
    PolytopeCandidate& other = result.emplace_back(candidate);
    const auto factor = [&](int vertex) { return cycles[static_cast<std::size_t>(vertex)] == cycle ? smaller : 1; };
    for (std::size_t v = 0; v < cycles.size(); ++v)
      for (auto& c : other.vertices[v].value) c *= factor(static_cast<int>(v));
    for (PolytopeCandidate::Image& image : other.images)
      for (PolytopeCandidate::Term& term : image.terms) term.coefficient *= factor(image.vertex) / factor(term.vertex);
  }
  return result;
}

}  // namespace

Rational change_of_product(const Rational& norm, const Rational& error, long factors) {
  return power(norm + error, factors) - power(norm, factors);
}

RoundedFamily::RoundedFamily(MatrixFamily family, const Rational& distance, const NearbyFamilies& known)
    : family_(std::move(family)),
      distance_(distance),
      known_(known),
      norm_(0),
      error_(static_cast<long>(family_.size()) * distance) {
  for (const RationalMatrix& matrix : family_) norm_ = std::max(norm_, one_norm(matrix));
}

void RoundedFamily::include_errors(PolytopeProof& polytope) const {
  // What an image moves by is one more residual.
  const Rational moved = error_ * longest_vertex(polytope);
  for (Rational& residual : polytope.residuals) residual += moved;
  polytope.bound += Rational(polytope.unit_norm) * moved;
}

JointSpectralRadius RoundedFamily::attained(const Budget& budget, int bits) const {
  JointSpectralRadius result;
  result.exact = {Truth::unknown, "the polytope did not close"};
  const MatrixFamily family = known_.have_symmetries ? family_
                                                     : MatrixFamily(family_.matrices(), {family_.group().front()});
  const Rational unit = power(Rational(2), scaling_exponent(family));
  const MatrixFamily scaled_family = unit == 1 ? family : 1 / unit * family;
  // Of families near by no cone is kept by all.
  const PolytopeCandidate found = find_polytope(scaled_family,
                                                {budget.deadline.after(schedule::rounded::search), budget.memory},
                                                false, true, quadratic::long_products);
  for (const PolytopeCandidate& candidate : found.closed ? with_smaller_orbits(found) : std::vector{found}) {
    auto polytope = candidate.closed ? certify_polytope(scaled_family, candidate, budget) : std::nullopt;
    if (!polytope) break;
    polytope = scaled(std::move(*polytope), unit);
    include_errors(*polytope);
    result.exact = product_attains_nearby(family, error_, candidate, *polytope, known_.are_transitions, bits);
    result.proof = std::move(*polytope);
    if (result.exact.is_yes()) break;
  }
  if (!result.exact.is_yes()) return result;
  const NearbyCycles& nearby = *std::get<PolytopeProof>(result.proof).attained->nearby;
  result.product = prove_product(family_, nearby.product, budget.deadline.later(schedule::rounded::grace), distance_);
  result.radius = nearby.radius;
  result.growth.at_most = 0;
  return result;
}

JointSpectralRadius RoundedFamily::radius(const NormProof& known, const Budget& budget, int bits) const {
  const JointSpectralRadius exact = attained({budget.deadline.after(schedule::rounded::exact), budget.memory}, bits);
  if (exact.exact.is_yes()) return exact;
  // Any bound will do.
  JointSpectralRadius result = family_.size() == 1 ? radius_of_numbers(family_)
                                                   : radius_of_one_block(family_, budget, known, known.bound());
  auto* polytope = std::get_if<PolytopeProof>(&result.proof);
  if (polytope && (polytope->group.size() <= 1 || polytope->is_flip_symmetric())) {
    include_errors(*polytope);
    result.radius.upper = polytope->bound;
  } else {
    result.proof = known;
    result.radius.upper = known.bound();
  }
  result.product = prove_product(family_, result.product.word, budget.deadline, distance_);
  result.radius.lower = result.product.radius.lower;
  result.exact = exact.exact;
  return result;
}

}  // namespace subcert::radius
