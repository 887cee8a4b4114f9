#include "certificate.hpp"

#include "certificate_text.hpp"
#include "exact_radius.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/difference/level_norms.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/transition/transition.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace subcert {
namespace {

using namespace certificate_text;

constexpr double most_checked = 8e9;  // of the work of all words of a length, of which checkers allow 10^10
constexpr int most_levels = 6;        // of the norms that bound differences

MatrixFamily family_of(const Mask& mask, const HolderRegularity& regularity) {
  return transition_matrices(divided_difference_scheme(mask, regularity.bounds.sum_rules));
}

/// `product`: the lower bound as well.
void add_radius(Certificate& certificate, const Mask& mask, const HolderRegularity& regularity, bool product,
                const std::vector<bool>& exact = {}) {
  const JointSpectralRadius& radius = regularity.radius;
  certificate.sections.push_back(
      {blocks_text(radius) + (product ? product_text(family_of(mask, regularity), radius) : "")});
  add_sections(certificate, radius.proof, static_cast<std::size_t>(mask.arity()), exact);
}

/// The power of the logarithm in the modulus of continuity, and the lines that prove it; nothing where they would not.
std::optional<std::pair<int, std::string>> logarithm_lines(const Mask& mask, const HolderRegularity& regularity,
                                                           const ExactRadius& exact) {
  const LogarithmicFactor& factor = regularity.logarithm;
  const int arity = mask.arity(), rules = regularity.bounds.sum_rules;
  if (factor.at_most != factor.at_least) return std::nullopt;
  std::string line = fmt::format("logarithm {}", factor.at_least);
  const auto& value = regularity.radius.radius;
  int order = rules;
  Rational least = 1;
  for (; least < *value.lower; least *= arity) --order;
  const bool single = std::holds_alternative<SingleRadiusProof>(regularity.radius.proof);
  if (least > *value.upper) {
    if (!single && !exact.grows_like_powers) return std::nullopt;
    return std::pair(factor.at_least, line + "\n");
  }
  const Mask scheme = divided_difference_scheme(mask, order);
  if (single && (rules - order) % 2 == 0) {
    const LaurentPolynomial& symbol = scheme.symbol();
    const CoefficientGrowth growth = central_growth(symbol.shifted(-(symbol.lowest() + symbol.highest()) / 2), arity);
    return std::pair(factor.at_least, line + "\n" + polynomial_text("recurrence", growth.recurrence));
  }
  const auto& norms = level_norms(scheme, most_levels).norms;
  const auto small = std::find_if(norms.begin(), norms.end(), [](const Rational& norm) { return norm <= 1; });
  if (small == norms.end()) return std::nullopt;
  return std::pair(0, fmt::format("{} norm {}\n", line, small - norms.begin() + 1));
}

/// What the certificate proves; the exponent may be known more sharply.
Rational lower_end(const Mask& mask, const HolderRegularity& regularity, const ExactRadius& exact = {}) {
  return regularity.bounds.sum_rules - *log_ratio(upper_end(regularity.radius, exact), mask.arity()).upper;
}

FamilySubject subject_of(const MatrixFamily& family, bool is_subradius) {
  return {is_subradius, std::to_string(family.count()), std::to_string(family.size())};
}

}  // namespace

HolderRegularity certificate_text::checkable(const Mask& mask, HolderRegularity regularity) {
  auto* norms = std::get_if<NormProof>(&regularity.radius.proof);
  if (!norms) return regularity;
  const MatrixFamily family = family_of(mask, regularity);
  const Integer denominator = common_denominator(family);
  long bits = 1;
  for (const RationalMatrix& m : family)
    bits = std::max(bits, binary_exponent(m).value_or(0) + binary_exponent(Rational(denominator)));
  const double size = static_cast<double>(family.size()), limbs = 1 + static_cast<double>(bits) / 64;
  const auto is_short = [&](int level) {
    return std::pow(mask.arity(), level) * size * size * (20 + limbs * limbs * level) <= most_checked;
  };
  if (is_short(norms->level)) return regularity;
  *norms = {1, regularity.bounds.levels.front().norm};
  for (const HolderBound& bound : regularity.bounds.levels)
    if (const NormProof other{bound.levels, bound.norm}; is_short(bound.levels) && other.bound() < norms->bound())
      *norms = other;
  return regularity;
}

void certificate_text::add_exponent(Certificate& certificate, const Mask& mask, const HolderRegularity& regularity,
                                    const std::optional<MaskRounding>& rounding, const std::string& reduced,
                                    bool in_limit) {
  const int rules = regularity.bounds.sum_rules;
  const JointSpectralRadius& radius = regularity.radius;
  CertificateClaim& claim = certificate.claim;
  const std::string whole = std::to_string(rules),
                    decimal = upper_end_by(radius.product, rules, mask.arity()).value_or(whole);
  // A product that proves no more than the number of sum rules is not needed.
  const bool by_product = decimal != whole;
  // The checker shows stability only where the sub-symbols have no common zero at all.
  if (regularity.stable.is_yes() && (by_product || !(rounding || in_limit)) &&
      common_factor_of_cosets(mask).length() == 1)
    claim.upper = decimal;
  ExactRadius exact;
  if (claim.upper && by_product) exact = exact_radius(radius);
  claim.lower = outward(lower_end(mask, regularity, exact), Rounding::down);
  certificate.bounds = {outward(lower_end(mask, regularity), Rounding::down), claim.upper};
  claim_exact(certificate, exact, whole + "-log");
  certificate.sections.push_back(
      {fmt::format("{}sum-rules {}{}\n{}", reduced, rules, full_text(claim.upper && !by_product),
                   claim.upper ? "stability\n" : "")});
  add_radius(certificate, mask, regularity, claim.upper && by_product, exact.blocks);
  const auto logarithm = claim.exact || claim.attains ? logarithm_lines(mask, regularity, exact) : std::nullopt;
  if (!logarithm || in_limit) return;
  claim.logarithm = logarithm->first;
  certificate.sections.push_back({logarithm->second, ""});
}

std::string Certificate::text() const {
  std::string text = head_text(claim);
  for (const CertificateSection& section : sections) text += section.lines;
  return text + "end\n";
}

Certificate Certificate::of_bounds() const {
  Certificate result{{bounds, claim.subject}, {}, bounds};
  for (const CertificateSection& section : sections)
    result.sections.push_back({section.of_bounds.value_or(section.lines)});
  return result;
}

Certificate exponent_certificate(const Mask& mask, const HolderRegularity& found,
                                 const std::optional<MaskRounding>& rounding) {
  const HolderRegularity regularity = checkable(mask, found);
  std::optional<ReducedRegularity> other;
  if (found.reduced) other = {found.reduced->mask, checkable(found.reduced->mask.mask, found.reduced->regularity)};
  if (other && !(lower_end(other->mask.mask, other->regularity) > 0)) other.reset();
  const int rules = regularity.bounds.sum_rules;
  const Rational lower = lower_end(mask, regularity);
  require(lower > 0, "certificate: need a positive lower bound of the exponent, got {}",
          to_decimal(lower, 6, Rounding::nearest));
  MaskSubject subject{mask.symbol().to_mask_text(), std::to_string(mask.arity())};
  if (rounding)
    subject.within = fmt::format("{},{}{}", to_text(rounding->distance), rules,
                                 rounding->symmetric ? ",symmetric" : "");
  Certificate certificate{{{}, subject}, {}};
  if (!other) {
    add_exponent(certificate, mask, regularity, rounding);
    return certificate;
  }
  add_exponent(
      certificate, other->mask.mask, other->regularity, std::nullopt,
      fmt::format("reduced {} {}\n", other->mask.factor.to_mask_text(), other->mask.mask.symbol().to_mask_text()));
  certificate.sections.push_back({fmt::format("sum-rules {}\n", rules)});
  add_radius(certificate, mask, regularity, false);
  return certificate;
}

Certificate frequency_certificate(const Mask& mask, const std::optional<FrequencyBound>& bound) {
  require(bound && bound->exponent > 0, "certificate: need a positive lower bound of the exponent, got none");
  const long length = mask.symbol().length() - bound->sum_rules * (mask.arity() - 1);
  const long most = static_cast<long>(FamilyLimits::size) * (mask.arity() - 1) + 1;
  require(length <= most, "certificate: the checkers read up to {} coefficients of the difference scheme, got {}", most,
          length);
  Certificate certificate{{{}, MaskSubject{mask.symbol().to_mask_text(), std::to_string(mask.arity())}}, {}};
  certificate.claim.lower = outward(bound->exponent, Rounding::down);
  certificate.bounds = certificate.claim;
  certificate.sections.push_back({fmt::format("sum-rules {}\n", bound->sum_rules)});
  add_sections(certificate, bound->proof, static_cast<std::size_t>(mask.arity()));
  return certificate;
}

Certificate exponent_certificate(const LatticeMask& mask, const Regularity& regularity,
                                 const std::optional<MaskRounding>& rounding,
                                 const std::optional<QuadraticMask>& quadratic) {
  if (quadratic) return field_certificate(*quadratic, *regularity.surface);
  require(regularity.curve || !rounding, "certificate: need matrices with rational entries");
  return regularity.curve ? exponent_certificate(mask.curve(), *regularity.curve, rounding)
                          : surface_certificate(mask, *regularity.surface);
}

Certificate radius_certificate(const MatrixFamily& family, const JointSpectralRadius& radius) {
  Certificate certificate{{{}, subject_of(family, false)}, {}};
  CertificateClaim& claim = certificate.claim;
  claim.lower = claimed_lower(radius.product);
  const ExactRadius exact = exact_radius(radius);
  claim.upper = outward(upper_end(radius, exact), Rounding::up);
  certificate.bounds = {claim.lower, outward(upper_end(radius, {}), Rounding::up)};
  claim_exact(certificate, exact);
  certificate.sections.push_back({blocks_text(radius) + (claim.lower ? product_text(family, radius) : "")});
  add_sections(certificate, radius.proof, family.count(), exact.blocks);
  return certificate;
}

Certificate subradius_certificate(const MatrixFamily& family, const JointSpectralSubradius& radius) {
  const SlowProduct& product = radius.product;
  Certificate certificate{{{}, subject_of(family, true)}, {}};
  CertificateClaim& claim = certificate.claim;
  claim.upper = outward(*root_enclosure(product.radius, static_cast<int>(product.word.size())).upper, Rounding::up);
  std::string proofs = product_text(0, {product.radius, 0}, product.word) + "weights" + numbers_text(product.weights) +
                       "\n";
  std::optional<SubradiusLines> lines;
  if (const std::optional<AntinormProof>& proof = radius.antinorm) {
    claim.lower = outward(proof->bound, Rounding::down);
    if (radius.exact.is_yes()) lines = exact_subradius_lines(family, *proof);
    proofs += fmt::format("block 0 polytope {} 0 {}{}\n", proof->vertices.size(), proof->weight_bits,
                          proof->transposed ? " transposed" : "");
    for (const std::vector<Integer>& vertex : proof->vertices) proofs += "vertex" + numbers_text(vertex) + "\n";
    for (std::size_t i = 0; i < proof->images.size(); ++i) {
      proofs += fmt::format("image {} {}", i / family.count(), i % family.count());
      for (const AntinormProof::Term& term : proof->images[i])
        proofs += fmt::format(" {}:{}", term.vertex, term.weight.str());
      proofs += "\n";
    }
  }
  certificate.bounds = claim;
  if (lines) claim_exact(certificate, {lines->number.number, lines->number.root});
  certificate.sections.push_back({std::move(proofs)});
  if (lines) certificate.sections.push_back({lines->cycles, ""});
  return certificate;
}

std::string matrices_text(const MatrixFamily& family) {
  std::string text = fmt::format("matrices {} {}\n", family.count(), family.size());
  for (const RationalMatrix& m : family) text += rows_text("row", m);
  return text;
}

}  // namespace subcert
