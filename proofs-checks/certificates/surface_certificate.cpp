#include "certificate_text.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/specification.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace subcert {
namespace {

using namespace certificate_text;

/// The lines from the order of the differences to the vectors of the space; `functionals` are among them.
std::string space_text(const DifferenceSpace& space, const Dilation& dilation, const std::string& functionals) {
  std::string text = fmt::format("{} {}\n", space.is_of_values() ? "differences" : "sum-rules", space.order);
  if (space.dilation.rows() != dilation.rows()) text += fmt::format("turned {}\n", space.dilation.to_text());
  text += "digits";
  for (const LatticePoint& digit : space.dilation.digits()) text += fmt::format(" {}", fmt::join(digit, ","));
  text += "\n";
  if (space.is_of_values())
    text += "values" + terms_text(space.values, common_denominator({space.values}), dilation.variables());
  text += functionals;
  return text + vectors_text(space.basis, space.pivots, space.dilation.variables());
}

/// That the scheme converges, after a proof by differences of phi.
void add_shrinking(Certificate& certificate, const ShrinkingDifferences& differences) {
  const DifferenceSpace& space = differences.space;
  certificate.sections.push_back({fmt::format("sum-rules {}\n", space.order) +
                                  vectors_text(space.basis, space.pivots, space.dilation.variables()) +
                                  blocks_text(differences.radius)});
  add_sections(certificate, differences.radius.proof, space.family.count());
}

/// One of each pair k, -k, times the common denominator.
std::string gram_text(const LatticeSequence& gram) {
  LatticeSequence half;
  for (const auto& [point, value] : gram)
    if (LatticePoint(point.size(), 0) - point <= point) half.emplace(point, value);
  return "gram" + terms_text(half, common_denominator({half}), gram.begin()->first.size());
}

}  // namespace

Certificate surface_certificate(const LatticeMask& mask, const MultivariateRegularity& regularity) {
  require(regularity.radius && regularity.space,
          "certificate: need a joint spectral radius, got none (of a tensor product, certify the factors)");
  const Dilation& dilation = mask.dilation();
  require(dilation.is_isotropic(), "certificate: need an isotropic dilation, got {}", dilation.to_text());
  const FunctionVector* vector = regularity.vector ? &*regularity.vector : nullptr;
  const ComponentProof* component = vector ? proof_of_component(*vector) : nullptr;
  const JointSpectralRadius& radius = component ? component->radius : *regularity.radius;
  const DifferenceSpace& space = component ? component->space : *regularity.space;
  require(!space.is_of_values() || vector || regularity.shrinking,
          "certificate: need differences of the scheme that are proved to shrink, got those of the limit alone (with a "
          "longer budget a proof may be found)");
  const std::size_t first_block = component ? unobservable_blocks(*component) : 0;
  const auto exponent = [&](const ExactRadius& exact) {
    Enclosure ends = exponent_of_radius({proved_lower(radius.product), upper_end(radius, exact, first_block)},
                                        dilation.classes(), dilation.variables());
    ends.lower = std::min(ends.lower.value_or(0), Rational(space.order));
    return ends;
  };
  const Enclosure ends = exponent({});
  const std::optional<Rational>&lower = ends.lower, &upper = ends.upper;
  require(*lower > 0, "certificate: need a positive lower bound of the exponent, got {}",
          to_decimal(*lower, 6, Rounding::nearest));
  const bool tells_upper_end = (space.is_of_values() || regularity.stable.is_yes()) && upper && *upper < space.order;
  const ExactRadius exact = tells_upper_end ? exact_radius(radius, first_block) : ExactRadius{};
  Certificate certificate{{{},
                           SurfaceSubject{to_mask_text(mask), dilation.to_text(), vector != nullptr,
                                          component ? std::to_string(vector->components.front().component) : "",
                                          vector ? integral_text(vector->integral) : ""}},
                          {}};
  certificate.claim.lower = outward(*exponent(exact).lower, Rounding::down);
  if (tells_upper_end) certificate.claim.upper = outward(*upper, Rounding::up);
  certificate.bounds = {outward(*lower, Rounding::down), certificate.claim.upper};
  claim_exact(certificate, exact, "0-log");
  std::string text = space_text(space, dilation, vector && vector->integral ? functionals_text(mask) : "");
  if (tells_upper_end && !space.is_of_values()) text += gram_text(*regularity.gram);
  if (component) text += fmt::format("unobservable {}\n", component->unobservable);
  text += blocks_text(radius);
  if (tells_upper_end) text += product_text(space.family, radius);
  certificate.sections.push_back({std::move(text)});
  add_sections(certificate, radius.proof, space.family.count(), exact.blocks);
  if (space.is_of_values() && !vector) add_shrinking(certificate, *regularity.shrinking);
  return certificate;
}

}  // namespace subcert
