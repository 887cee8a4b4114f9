#include "certificate_text.hpp"

#include <subcert/analysis/family/parametric_family.hpp>
#include <subcert/analysis/radii/schedule.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/specification.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

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

std::string scheme_name(bool hermite) { return hermite ? "Hermite scheme" : "vector scheme"; }

}  // namespace

void certificate_text::require_vector_scheme(const LatticeMask& mask, bool hermite) {
  require(mask.components() > 1 && mask.dimension() == 1 && mask.dilation().factor().value_or(0) > 1,
          "certificate: need a {} of one variable with an arity, got the dilation {}", scheme_name(hermite),
          mask.dilation().to_text());
}

std::string certificate_text::space_of_vectors_text(const AnnihilatingSpace& space, int arity, bool hermite) {
  const PolynomialData& polynomials = space.polynomials;
  std::string text = fmt::format("sum-rules {}\n", polynomials.data.size());
  for (Values y : polynomials.data) {
    if (hermite) break;
    if (polynomials.root > 0) std::rotate(y.begin(), y.begin() + static_cast<long>(y.size() / 2), y.end());
    text += "data";
    for (const Rational& number : y) text += " " + to_text(number);
    text += "\n";
  }
  text += "digits";
  for (int d = 0; d < arity; ++d) text += fmt::format(" {}", d);
  text += "\n";
  for (const LatticeSequence& reading : space.readings)
    text += "reading" + terms_text(reading, common_denominator({reading}), 1);
  return text + vectors_text(space.basis, space.pivots, 1);
}

void certificate_text::require_kept(const PolynomialData& kept, bool hermite) {
  require(!kept.data.empty() && (!hermite || kept.hermite), "certificate: need a {} that keeps {}, got another",
          scheme_name(hermite),
          hermite
              ? "values and derivatives of polynomials up to the degree of the derivatives in its data (the spectral "
                "condition)"
              : "one vector of constants up to a factor");
}

ClaimedEnds certificate_text::ends_of_scheme(const PolynomialData& kept, bool hermite, int arity,
                                             const JointSpectralRadius& radius) {
  const auto order = static_cast<long>(kept.data.size()),
             least = hermite ? static_cast<long>(kept.components()) - 1 : 0;
  const auto derivatives = proved_derivatives(radius.proved_upper(), arity, order, least);
  const bool refuted = !derivatives && (!hermite || kept.interpolating) &&
                       proved_lower(radius.product) >= power(Rational(arity), order - least);
  require(derivatives || refuted, "certificate: {} of the {} is not decided",
          hermite ? fmt::format("HC^{}", least) : "convergence", scheme_name(hermite));
  ClaimedEnds ends;
  (refuted ? ends.upper : ends.lower) = std::to_string(hermite ? derivatives.value_or(least) : 0);
  return ends;
}

std::string certificate_text::space_of_constants_text(const Dilation& dilation, const SchemeDifferences& differences,
                                                      const std::vector<LatticeSequence>& basis,
                                                      const std::vector<LatticePoint>& pivots) {
  std::string text = "digits";
  for (const LatticePoint& digit : dilation.digits()) text += fmt::format(" {}", fmt::join(digit, ","));
  text += "\n";
  for (const Values& y : differences.kept) {
    text += "fixed";
    for (const Rational& number : y) text += " " + to_text(number);
    text += "\n";
  }
  return text + (differences.space ? vectors_text(basis, pivots, dilation.variables()) : "");
}

ClaimedEnds certificate_text::ends_of_differences(const SchemeDifferences& differences) {
  const bool converges = differences.space && differences.radius.proved_upper() < 1,
             diverges = !differences.space || proved_lower(differences.radius.product) >= 1;
  require(converges || diverges, "certificate: convergence of the vector scheme is not decided");
  ClaimedEnds ends;
  (converges ? ends.lower : ends.upper) = "0";
  return ends;
}

Certificate convergence_certificate(const LatticeMask& mask, const Budget& budget) {
  require(
      mask.components() > 1 && mask.dilation().is_isotropic(),
      "certificate: need a vector scheme with a dilation that is similar to a multiple of an orthogonal matrix, got "
      "{}",
      mask.dilation().to_text());
  const SchemeDifferences differences = scheme_differences(mask, budget);
  const ClaimedEnds ends = ends_of_differences(differences);
  Certificate certificate{
      {ends, MaskSubject{to_mask_text(mask), mask.dilation().to_text(), {}, false, {}, "vectors"}}, {}, ends};
  if (!differences.space) {
    certificate.sections.push_back({space_of_constants_text(mask.dilation(), differences, {}, {})});
    return certificate;
  }
  const DifferenceSpace& space = *differences.space;
  const JointSpectralRadius& radius = differences.radius;
  certificate.sections.push_back({space_of_constants_text(space.dilation, differences, space.basis, space.pivots) +
                                  blocks_text(radius) + (ends.upper ? product_text(space.family, radius) : "")});
  if (!ends.upper) add_sections(certificate, radius.proof, space.family.count());
  return certificate;
}

bool is_told_by_polynomials(const Scheme& scheme) {
  if (scheme.form == VectorForm::hermite) return true;
  if (scheme.mask.dimension() > 1 || scheme.mask.dilation().factor().value_or(0) < 2) return false;
  return !(scheme.quadratic ? kept_polynomials(without_letters(scheme.quadratic->doubled), scheme.quadratic->root)
                            : kept_polynomials(without_letters(scheme.mask)))
              .data.empty();
}

Certificate vector_scheme_certificate(const LatticeMask& mask, bool hermite, const Budget& budget) {
  require_vector_scheme(mask, hermite);
  const ParametricMask one = without_letters(mask);
  require_kept(kept_polynomials(one), hermite);
  const AnnihilatingSpace space = annihilating_space(one);
  const MatrixFamily family = difference_matrices(one).at({0});
  const NormProof norms = norm_of_products(family, {budget.deadline.after(schedule::vector::norms), budget.memory});
  const JointSpectralRadius radius = joint_spectral_radius(family, budget, norms);
  const ClaimedEnds ends = ends_of_scheme(space.polynomials, hermite, one.arity(), radius);
  Certificate certificate{
      {ends,
       MaskSubject{one.to_text('w'), std::to_string(one.arity()), {}, false, {}, hermite ? "hermite" : "vectors"}},
      {},
      ends};
  certificate.sections.push_back({space_of_vectors_text(space, one.arity(), hermite) + blocks_text(radius) +
                                  (ends.upper ? product_text(family, radius) : "")});
  if (!ends.upper) add_sections(certificate, radius.proof, family.count());
  return certificate;
}

Certificate scheme_certificate(const Scheme& scheme, const Budget& budget) {
  require(scheme.form.has_value(), "certificate: need a scheme of matrices, got {}", scheme.specification);
  const bool hermite = scheme.form == VectorForm::hermite;
  if (!is_told_by_polynomials(scheme))
    return scheme.quadratic ? convergence_certificate(*scheme.quadratic, budget)
                            : convergence_certificate(scheme.mask, budget);
  return scheme.quadratic ? vector_scheme_certificate(*scheme.quadratic, hermite, budget)
                          : vector_scheme_certificate(scheme.mask, hermite, budget);
}

}  // namespace subcert
