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
    if (kind == PolytopeKind::complex) text += "," + term.imaginary.str() + "," + term.modulus.str();
  }
  return text;
}

const char* mode_text(PolytopeKind kind) {
  switch (kind) {
    case PolytopeKind::nonnegative: return "nonnegative";
    case PolytopeKind::complex: return "complex";
    default: return "real";
  }
}

std::string polytope_text(const CertifiedPolytope& polytope, std::size_t block, std::size_t matrix_count) {
  std::string text = "block " + std::to_string(block) + " polytope " + mode_text(polytope.kind) + " " +
                     std::to_string(polytope.vertices.size()) + " " + std::to_string(polytope.vertex_bits) + " " +
                     std::to_string(polytope.weight_bits) + (polytope.symmetric ? " symmetric" : "") +
                     (polytope.transposed ? " transposed" : "") + "\n";
  for (std::size_t v = 0; v < polytope.vertices.size(); ++v) {
    text += "vertex";
    for (std::size_t i = 0; i < polytope.vertices[v].size(); ++i) {
      text += " " + polytope.vertices[v][i].str();
      if (polytope.kind == PolytopeKind::complex) text += "," + polytope.imaginary[v][i].str();
    }
    text += "\n";
  }
  for (std::size_t k = 0; k < polytope.units.size(); ++k)
    text += "unit " + std::to_string(k) + terms_text(polytope.units[k], polytope.kind) + "\n";
  for (std::size_t i = 0; i < polytope.images.size(); ++i)
    text += "image " + std::to_string(i / matrix_count) + " " + std::to_string(i % matrix_count) +
            terms_text(polytope.images[i], polytope.kind) + "\n";
  return text;
}

std::string product_text(const JointSpectralRadius& radius) {
  const ProductEvidence& product = radius.product;
  std::string text =
      "product " + std::to_string(radius.leading_block) + " " + to_text(product.re) + " " + to_text(product.im);
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

std::string rows_text(const RationalMatrix& matrix) {
  std::string text;
  for (std::size_t i = 0; i < matrix.rows(); ++i) {
    text += "row";
    for (std::size_t j = 0; j < matrix.columns(); ++j) text += " " + to_text(matrix(i, j));
    text += "\n";
  }
  return text;
}

std::string blocks_text(const JointSpectralRadius& radius) {
  if (!radius.triangular) return "";
  const BlockTriangular& triangular = *radius.triangular;
  std::string text = "blocks";
  for (const std::size_t size : triangular.sizes) text += " " + std::to_string(size);
  text += "\nbasis\n" + rows_text(triangular.basis);
  for (std::size_t t = 0; t < triangular.triangular.size(); ++t)
    text += "triangular " + std::to_string(t) + "\n" + rows_text(triangular.triangular[t]);
  return text;
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
  certificate.text = "subcert-certificate 1\nexponent " + mask.symbol().to_mask_text() + " " +
                     std::to_string(mask.arity()) + "\n" + bounds_text(certificate.claim) + "sum-rules " +
                     std::to_string(regularity.bounds.sum_rules) + "\n";
  if (certificate.claim.upper)
    certificate.text += "stability\n";
  certificate.text += blocks_text(radius);
  if (certificate.claim.upper) certificate.text += product_text(radius);
  certificate.text += sections_text(radius, static_cast<std::size_t>(arity)) + "end\n";
  return certificate;
}

Certificate radius_certificate(const std::vector<RationalMatrix>& matrices, const JointSpectralRadius& radius) {
  Certificate certificate;
  if (*radius.product.radius.lower > 0) certificate.claim.lower = outward(*radius.product.radius.lower, Rounding::down);
  certificate.claim.upper = outward(radius.certified_upper, Rounding::up);
  certificate.text = "subcert-certificate 1\nradius " + std::to_string(matrices.size()) + " " +
                     std::to_string(matrices.front().rows()) + "\n" + bounds_text(certificate.claim);
  certificate.text += blocks_text(radius);
  if (certificate.claim.lower) certificate.text += product_text(radius);
  certificate.text += sections_text(radius, matrices.size()) + "end\n";
  return certificate;
}

std::string matrices_text(const std::vector<RationalMatrix>& matrices) {
  std::string text =
      "matrices " + std::to_string(matrices.size()) + " " + std::to_string(matrices.front().rows()) + "\n";
  for (const RationalMatrix& m : matrices)
    for (std::size_t i = 0; i < m.rows(); ++i) {
      for (std::size_t j = 0; j < m.columns(); ++j) text += (j ? " " : "") + to_text(m(i, j));
      text += "\n";
    }
  return text;
}

}  // namespace subcert
