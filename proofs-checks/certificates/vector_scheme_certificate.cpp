#include "certificate_text.hpp"

#include <subcert/analysis/family/parametric_family.hpp>
#include <subcert/analysis/radii/schedule.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <fmt/format.h>

namespace subcert {
namespace {

using namespace certificate_text;

/// The largest integer k from `least` on with radius < arity^(order - k), of which k is below; nothing where there is
/// none.
std::optional<long> proved_derivatives(const Rational& radius, long arity, long order, long least) {
  std::optional<long> result;
  for (long k = least; k < order && radius < power(Rational(arity), order - k); ++k) result = k;
  return result;
}

}  // namespace

std::string certificate_text::space_of_vectors_text(const ParametricMask& mask, bool hermite) {
  const AnnihilatingSpace space = annihilating_space(mask);
  std::string text = fmt::format("sum-rules {}\n", space.polynomials.data.size());
  for (const Values& y : space.polynomials.data) {
    if (hermite) break;
    text += "data";
    for (const Rational& number : y) text += " " + to_text(number);
    text += "\n";
  }
  text += "digits";
  for (int d = 0; d < mask.arity(); ++d) text += fmt::format(" {}", d);
  text += "\n";
  for (const LatticeSequence& reading : space.readings)
    text += "reading" + terms_text(reading, common_denominator({reading}), 1);
  return text + vectors_text(space.basis, space.pivots, 1);
}

Certificate vector_scheme_certificate(const LatticeMask& given, bool hermite, const Budget& budget) {
  const std::string scheme = hermite ? "Hermite scheme" : "vector scheme";
  require(given.components() > 1 && given.dimension() == 1 && given.dilation().factor().value_or(0) > 1,
          "certificate: need a {} of one variable with an arity, got the dilation {}", scheme,
          given.dilation().to_text());
  const ParametricMask mask = without_letters(given);
  const PolynomialData kept = kept_polynomials(mask);
  require(!kept.data.empty() && (!hermite || kept.hermite), "certificate: need a {} that keeps {}, got another", scheme,
          hermite
              ? "values and derivatives of polynomials up to the degree of the derivatives in its data (the spectral "
                "condition)"
              : "one vector of constants up to a factor");
  const MatrixFamily family = difference_matrices(mask).at({0});
  const auto order = static_cast<long>(kept.data.size()),
             least = hermite ? static_cast<long>(given.components()) - 1 : 0;
  const NormProof norms = norm_of_products(family, {budget.deadline.after(schedule::vector::norms), budget.memory});
  const JointSpectralRadius radius = joint_spectral_radius(family, budget, norms);
  const auto derivatives = proved_derivatives(radius.proved_upper(), mask.arity(), order, least);
  const bool refuted = !derivatives && (!hermite || kept.interpolating) &&
                       proved_lower(radius.product) >= power(Rational(mask.arity()), order - least);
  require(derivatives || refuted, "certificate: {} of the {} is not decided",
          hermite ? fmt::format("HC^{}", least) : "convergence", scheme);
  ClaimedEnds ends;
  (refuted ? ends.upper : ends.lower) = std::to_string(hermite ? derivatives.value_or(least) : 0);
  Certificate certificate{
      {ends,
       MaskSubject{mask.to_text('w'), std::to_string(mask.arity()), {}, false, {}, hermite ? "hermite" : "vectors"}},
      {},
      ends};
  certificate.sections.push_back(
      {space_of_vectors_text(mask, hermite) + blocks_text(radius) + (refuted ? product_text(family, radius) : "")});
  if (!refuted) add_sections(certificate, radius.proof, family.count());
  return certificate;
}

}  // namespace subcert
