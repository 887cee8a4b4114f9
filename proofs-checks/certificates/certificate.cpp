#include "certificate.hpp"

#include <algorithm>
#include <stdexcept>

namespace subcert {
namespace {

constexpr int places = 15;

/// A decimal of 15 places as a fraction in lowest terms.
std::string outward(const Rational& value, Rounding rounding) {
  std::string digits = to_fixed(value, places, rounding);
  digits.erase(digits.find('.'), 1);
  const Rational rounded = *parse_rational(digits) * power(Rational(10), -places);
  return to_text(rounded);
}

std::string terms_text(const std::vector<WeightedVertex>& terms, PolytopeKind kind) {
  std::string text;
  for (const WeightedVertex& term : terms) {
    text += " " + std::to_string(term.vertex) + (term.flipped ? "f" : "") + (term.conjugated ? "c" : "") + ":" +
            term.weight.str();
    if (kind == PolytopeKind::complex) text += ":" + term.imaginary.str();
  }
  return text;
}

std::string numbers_text(const std::vector<Integer>& numbers) {
  std::string text;
  for (const Integer& number : numbers) text += " " + number.str();
  return text;
}

std::string properties_text(const CertifiedPolytope& polytope) {
  std::string text;
  if (polytope.kind == PolytopeKind::complex) text += " complex";
  if (polytope.kind == PolytopeKind::nonnegative) text += " nonnegative";
  if (polytope.symmetric) text += " symmetric";
  if (polytope.transposed) text += " transposed";
  return text;
}

std::string polytope_text(const CertifiedPolytope& polytope, std::size_t block, std::size_t matrix_count) {
  const bool complex = polytope.kind == PolytopeKind::complex;
  std::string text = "block " + std::to_string(block) + " polytope " + std::to_string(polytope.vertices.size()) + " " +
                     std::to_string(polytope.vertex_bits) + " " + std::to_string(polytope.weight_bits) +
                     properties_text(polytope) + "\n";
  for (std::size_t v = 0; v < polytope.vertices.size(); ++v)
    text += "vertex" + numbers_text(polytope.vertices[v]) + (complex ? numbers_text(polytope.imaginary[v]) : "") + "\n";
  for (std::size_t k = 0; k < polytope.units.size(); ++k)
    text += "unit " + std::to_string(k) + terms_text(polytope.units[k], polytope.kind) + "\n";
  for (std::size_t i = 0; i < polytope.images.size(); ++i)
    text += "image " + std::to_string(i / matrix_count) + " " + std::to_string(i % matrix_count) +
            terms_text(polytope.images[i], polytope.kind) + "\n";
  return text;
}

std::string product_text(const JointSpectralRadius& radius) {
  const ProductEvidence& product = radius.product;
  std::string text = "product " + std::to_string(radius.leading_block) + " " + to_text(product.re) + " " +
                     to_text(product.im);
  for (int letter : product.word) text += " " + std::to_string(letter);
  return text + "\n";
}

std::string section_text(const JointSpectralRadius& radius, std::size_t block, std::size_t matrix_count) {
  if (radius.polytope) return polytope_text(*radius.polytope, block, matrix_count);
  return "block " + std::to_string(block) + " norm " + std::to_string(radius.norm_level) + "\n";
}

std::string sections_text(const JointSpectralRadius& radius, std::size_t matrix_count) {
  if (!radius.triangular) return section_text(radius, 0, matrix_count);
  std::string text;
  for (std::size_t k = 0; k < radius.blocks.size(); ++k) text += section_text(radius.blocks[k], k, matrix_count);
  return text;
}

/// A line for each row, after the head.
std::string rows_text(const std::string& head, const RationalMatrix& matrix) {
  std::string text;
  for (std::size_t i = 0; i < matrix.rows(); ++i) {
    text += head;
    for (std::size_t j = 0; j < matrix.columns(); ++j) text += " " + to_text(matrix(i, j));
    text += "\n";
  }
  return text;
}

std::string blocks_text(const JointSpectralRadius& radius) {
  if (!radius.triangular) return "";
  const RationalMatrix& basis = radius.triangular->basis;
  std::string text = "blocks";
  for (const std::size_t size : radius.triangular->sizes) text += " " + std::to_string(size);
  return text + "\n" + rows_text("basis", basis) +
         rows_text("inverse", solve(basis, RationalMatrix::identity(basis.rows())));
}

std::string bounds_text(const CertificateClaim& claim) {
  return "bounds " + claim.lower.value_or("-") + " " + claim.upper.value_or("-") + "\n";
}

}  // namespace

Certificate exponent_certificate(const Mask& mask, const HolderRegularity& regularity) {
  // What the rational numbers prove; the exponent may be known more sharply by other arguments.
  const int rules = regularity.bounds.sum_rules, arity = mask.arity();
  const JointSpectralRadius& radius = regularity.radius;
  const Rational lower = rules - *log_ratio(radius.certified_upper, arity).upper;
  if (!(lower > 0))
    throw std::domain_error("exponent_certificate: need a positive lower bound of the exponent, got " +
                            to_decimal(lower, 6, Rounding::nearest));
  Certificate certificate;
  certificate.claim.lower = outward(lower, Rounding::down);
  // The checker shows stability only where the sub-symbols have no common zero at all.
  if (regularity.stable.is_yes() && radius.product.radius.lower && *radius.product.radius.lower > 1 &&
      common_factor_of_cosets(mask).length() == 1)
    certificate.claim.upper = outward(rules - *log_ratio(*radius.product.radius.lower, arity).lower, Rounding::up);
  certificate.text = "subcert-certificate 2\nexponent " + mask.symbol().to_mask_text() + " " +
                     std::to_string(mask.arity()) + "\n" + bounds_text(certificate.claim) + "sum-rules " +
                     std::to_string(regularity.bounds.sum_rules) + "\n";
  if (certificate.claim.upper) certificate.text += "stability\n";
  certificate.text += blocks_text(radius);
  if (certificate.claim.upper) certificate.text += product_text(radius);
  certificate.text += sections_text(radius, static_cast<std::size_t>(arity)) + "end\n";
  return certificate;
}

Certificate radius_certificate(const std::vector<RationalMatrix>& matrices, const JointSpectralRadius& radius) {
  Certificate certificate;
  if (*radius.product.radius.lower > 0) certificate.claim.lower = outward(*radius.product.radius.lower, Rounding::down);
  certificate.claim.upper = outward(radius.certified_upper, Rounding::up);
  certificate.text = "subcert-certificate 2\nradius " + std::to_string(matrices.size()) + " " +
                     std::to_string(matrices.front().rows()) + "\n" + bounds_text(certificate.claim);
  certificate.text += blocks_text(radius);
  if (certificate.claim.lower) certificate.text += product_text(radius);
  certificate.text += sections_text(radius, matrices.size()) + "end\n";
  return certificate;
}

std::string matrices_text(const std::vector<RationalMatrix>& matrices) {
  std::string text = "matrices " + std::to_string(matrices.size()) + " " + std::to_string(matrices.front().rows()) +
                     "\n";
  for (const RationalMatrix& m : matrices) text += rows_text("row", m);
  return text;
}

}  // namespace subcert
