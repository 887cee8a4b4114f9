#include "certificate_text.hpp"
#include "exact_radius.hpp"

#include <subcert/analysis/family/field_scheme.hpp>
#include <subcert/analysis/radii/joint/leading_factor.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/specification.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

// Of matrices P + sqrt(D) Q: SPEC.md, section 5.13. Rational matrices of twice the size are in a basis e_1, J e_1, e_2,
// J e_2, ..., J the product with the root.

namespace subcert {
namespace {

using namespace certificate_text;

constexpr slong zero_bits = 320;               // of the balls of zeros
constexpr std::size_t smallest_inverted = 24;  // the size from which on an inverse proves a product
constexpr std::size_t taken_bits = 512;        // of the root in the matrices near by
constexpr int weight_bits_of_numbers = 64;     // of a polytope in one dimension
constexpr const char* no_name = "the radius has no name of this kind that was found";

/// Matrices X + sqrt(D) Y.
struct OverField {
  RationalMatrix x, y;
};

OverField parts_of(const RationalMatrix& pairs, std::size_t first, std::size_t size) {
  OverField result{{size, size}, {size, size}};
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t k = 0; k < size; ++k) {
      result.x(i, k) = pairs(2 * (first + i), 2 * (first + k));
      result.y(i, k) = pairs(2 * (first + i) + 1, 2 * (first + k));
    }
  return result;
}

/// On vectors that hold the rational parts of their coordinates, and then the others: [x, D y; y, x].
RationalMatrix on_halves(const OverField& matrix, long root) {
  const std::size_t n = matrix.x.rows();
  RationalMatrix result(2 * n, 2 * n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k) {
      result(i, k) = result(n + i, n + k) = matrix.x(i, k);
      result(n + i, k) = matrix.y(i, k);
      result(i, n + k) = root * matrix.y(i, k);
    }
  return result;
}

/// The space of the differences in a basis over the field.
struct FieldSpace {
  std::vector<LatticeSequence> basis;
  std::vector<LatticePoint> pivots;
  RationalMatrix coordinates;  ///< of the basis of the space in this one and its multiples by the root
};

FieldSpace space_over_field(const std::vector<LatticeSequence>& basis, std::size_t components) {
  std::map<LatticePoint, std::size_t> places;  // of both parts, with the component of the rational one
  const auto of_rational = [&](LatticePoint point) {
    point.back() %= static_cast<long>(components);
    return point;
  };
  for (const LatticeSequence& vector : basis)
    for (const auto& [point, value] : vector) places.emplace(of_rational(point), 0);
  std::vector<LatticePoint> points;
  for (auto& [point, index] : places) index = points.size(), points.push_back(point);
  const std::size_t size = basis.size();
  RationalMatrix values(size, 2 * points.size());  // a row for each vector of the basis
  for (std::size_t c = 0; c < size; ++c)
    for (const auto& [point, value] : basis[c])
      values(c, 2 * places.at(of_rational(point)) + (point.back() < static_cast<long>(components) ? 0 : 1)) = value;
  const std::vector<std::size_t> pivots = pivot_columns(values);  // both parts of each place
  FieldSpace result{{}, {}, {size, size}};
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t c = 0; c < size; ++c) result.coordinates(i, c) = values(c, pivots[i]);
  const RationalMatrix reduced = solve(transposed(result.coordinates), values);
  for (std::size_t i = 0; i < size; i += 2) {
    result.pivots.push_back(points[pivots[i] / 2]);
    LatticeSequence& vector = result.basis.emplace_back();
    for (std::size_t k = 0; k < reduced.columns(); ++k) {
      if (reduced(i, k) == 0) continue;
      LatticePoint point = points[k / 2];
      if (k % 2 == 1) point.back() += static_cast<long>(components);
      vector.emplace(std::move(point), reduced(i, k));
    }
  }
  return result;
}

/// Rows of the rational parts and then the others.
std::string rows_over_field(const std::string& head, const OverField& matrix) {
  const std::size_t n = matrix.x.rows();
  RationalMatrix both(n, 2 * n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k) {
      both(i, k) = matrix.x(i, k);
      both(i, n + k) = matrix.y(i, k);
    }
  return rows_text(head, both);
}

/// A diagonal block, letter by letter.
using FieldBlock = std::vector<OverField>;

bool is_rational(const FieldBlock& block) {
  return std::ranges::all_of(block, [](const OverField& matrix) { return !binary_exponent(matrix.y); });
}

std::vector<FieldBlock> blocks_of(const MatrixFamily& family, const BlockTriangular& triangular) {
  std::vector<FieldBlock> blocks(triangular.sizes.size());
  for (const RationalMatrix& matrix : family) {
    const RationalMatrix moved = solve(triangular.basis, matrix * triangular.basis);
    for (std::size_t i = 0, first = 0; i < blocks.size(); first += triangular.sizes[i++])
      blocks[i].push_back(parts_of(moved, first, triangular.sizes[i]));
  }
  return blocks;
}

/// The lines from `blocks` to `inverse`.
std::string blocks_over_field(const FieldSpace& space, const BlockTriangular& triangular) {
  const std::size_t size = space.basis.size();
  const RationalMatrix basis = space.coordinates * triangular.basis,
                       inverse = solve(basis, RationalMatrix::identity(2 * size));
  return fmt::format("blocks {}\n", fmt::join(triangular.sizes, " ")) +
         rows_over_field("basis", parts_of(basis, 0, size)) + rows_over_field("inverse", parts_of(inverse, 0, size));
}

/// Names the number that a polytope over the field has for its radius, with what proves it; empty, or what is missing.
std::string name_radius(PolytopeProof& polytope, const FieldBlock& block, long root) {
  AttainedProof& proof = *polytope.attained;
  const bool rational = is_rational(block);
  const auto acting = [&](const OverField& m) { return rational ? m.x : on_halves(m, root); };
  std::vector<RationalMatrix> matrices;
  for (const OverField& m : block)
    matrices.push_back(acting(polytope.transposed ? OverField{transposed(m.x), transposed(m.y)} : m));
  const std::size_t n = block.front().x.rows();
  for (std::size_t k = 0; k < proof.cycles.size(); ++k) {
    AttainedProof::Cycle& cycle = proof.cycles[k];
    const auto length = static_cast<long>(cycle.letters.size());
    RationalMatrix product = acting({polytope.group[cycle.element].map.matrix(), {n, n}});
    for (auto letter = cycle.letters.rbegin(); letter != cycle.letters.rend(); ++letter)
      product = product * matrices[static_cast<std::size_t>(*letter)];
    // Zeros that are about as large as 1 are found fast.
    const Rational& near = proof.nearby->eigenvectors[k].eigenvalue;
    const Rational unit = power(Rational(2), binary_exponent(near) / length), less = power(unit, -length);
    const auto factor = radius::leading_factor(less * product, {less * near, 0}, zero_bits, {});
    ComplexVector start(product.rows(), RationalComplex{0, 0});
    const ComplexVector vertex = polytope.vertex(cycle.vertex);
    std::copy(vertex.begin(), vertex.end(), start.begin());
    const auto seed = factor ? radius::seed_of(less * product, *factor, start) : std::nullopt;
    if (!seed) return no_name;
    const AttainedNumber number = scaled(factor->number(cycle.letters.size()), unit);
    if (k > 0 && !(number.polynomial == proof.number.polynomial && number.length == proof.number.length))
      return no_name;
    proof.number = number;
    cycle.seed = *seed;
  }
  proof.nearby.reset();
  return {};
}

/// The polytope [-1, 1] of numbers of the field, of which that of the letter is the largest.
PolytopeProof polytope_of_numbers(const FieldBlock& block, const JointSpectralRadius& radius, long root) {
  const auto best = static_cast<std::size_t>(radius.product.word.front());
  const Rational value = rounded_root(root, taken_bits);
  PolytopeProof polytope{PolytopeKind::real, false, {}, 0, weight_bits_of_numbers, {{1}}, {}, {}, {}, 0, 2, {}, {}};
  polytope.group = {MatrixFamily({RationalMatrix::identity(1)}).group().front()};
  const Rational one = power(Rational(2), weight_bits_of_numbers);
  polytope.units.push_back({WeightedVertex{0, 0, false, numerator(one), 0, numerator(one)}});
  AttainedProof proof;
  for (std::size_t t = 0; t < block.size(); ++t) {
    const Rational number = block[t].x(0, 0) + value * block[t].y(0, 0);
    const Integer weight = to_integer(number * one, Rounding::nearest);
    std::vector<WeightedVertex>& image = polytope.images.emplace_back();
    if (weight != 0) image.push_back({0, 0, false, weight, 0, abs(weight)});
    const bool is_best = (block[t].x == block[best].x && block[t].y == block[best].y) ||
                         (Rational(-1) * block[t].x == block[best].x && Rational(-1) * block[t].y == block[best].y);
    if (is_best && t != best) proof.coincidences.push_back({0, t, 0, 0});
    if (t == best) proof.nearby = NearbyCycles{{{number, 0, {}}}, {}, {}, {}};
  }
  proof.cycles = {{0, 0, 1, {static_cast<int>(best)}, {}, 0}};
  polytope.attained = std::move(proof);
  polytope.bound = *radius.radius.upper + power(Rational(2), 4 - weight_bits_of_numbers);
  return polytope;
}

/// With what names radii of blocks that are attained, from the first one on.
JointSpectralRadius with_names(JointSpectralRadius radius, const std::vector<FieldBlock>& blocks, long root,
                               std::size_t first) {
  if (!radius.exact.is_yes()) return radius;
  auto& proof = std::get<BlockProof>(radius.proof);
  const Rational least = *proof.blocks[proof.leading].radius.lower;
  for (std::size_t i = first; i < blocks.size(); ++i) {
    JointSpectralRadius& block = proof.blocks[i];
    if (!block.exact.is_yes() || *block.radius.upper < least) continue;
    if (std::holds_alternative<NormProof>(block.proof) && blocks[i].front().x.rows() == 1)
      block.proof = polytope_of_numbers(blocks[i], block, root);
    auto* polytope = std::get_if<PolytopeProof>(&block.proof);
    if (!polytope || !polytope->attained || !polytope->attained->nearby) continue;
    polytope->not_attained = name_radius(*polytope, blocks[i], root);
    if (!polytope->not_attained.empty()) polytope->attained.reset();
  }
  return radius;
}

std::string product_over_field(const JointSpectralRadius& radius, const FieldBlock& block, std::size_t number,
                               long root) {
  const ProductEvidence& product = radius.product;
  if (block.front().x.rows() >= smallest_inverted) {
    const Rational value = rounded_root(root, taken_bits);
    std::vector<RationalMatrix> near;
    for (const OverField& m : block) {
      RationalMatrix& matrix = near.emplace_back(m.x);
      for (std::size_t i = 0; i < matrix.rows(); ++i)
        for (std::size_t k = 0; k < matrix.rows(); ++k) matrix(i, k) += value * m.y(i, k);
    }
    if (const auto inverse = approximate_inverse(MatrixFamily(std::move(near)), product))
      return product_text(number, inverse->point, product.word) + inverse_text(inverse->bits, inverse->columns);
  }
  return product_text(number, product.eigenvalue, product.word);
}

/// What follows the claim about a scheme: a space, and what is shown of the radius on it.
void add_proof(Certificate& certificate, std::string space, const FieldSpace& own, const MatrixFamily& family,
               const JointSpectralRadius& radius, long root) {
  const BlockProof& proof = *radius.by_blocks();
  space += blocks_over_field(own, proof.triangular);
  if (certificate.bounds.upper)
    space += product_over_field(radius, blocks_of(family, proof.triangular)[proof.leading], proof.leading, root);
  certificate.sections.push_back({std::move(space)});
  if (!certificate.bounds.upper) add_sections(certificate, radius.proof, family.count());
}

}  // namespace

std::string certificate_text::mask_text(const QuadraticMask& mask) {
  const text::MaskText doubled = mask_text_parts(mask.doubled);
  const std::size_t r = mask.components();
  text::MaskTextOf<QuadraticNumber> result{{}, doubled.sizes, doubled.first};
  result.sizes[0] = result.sizes[1] = r;
  for (std::size_t m = 0; m < doubled.coefficients.size(); m += 4 * r * r)
    for (std::size_t i = 0; i < r; ++i)
      for (std::size_t k = 0; k < r; ++k) {
        const Rational &rational = doubled.coefficients[m + i * 2 * r + k],
                       &multiple = doubled.coefficients[m + (r + i) * 2 * r + k];
        result.coefficients.push_back({rational, multiple, multiple == 0 ? 0 : mask.root});
      }
  return text::print_mask_text(result);
}

Certificate field_certificate(const QuadraticMask& mask, const MultivariateRegularity& regularity) {
  require(regularity.radius && regularity.space && regularity.vector,
          "certificate: need a joint spectral radius, got none");
  const FunctionVector& vector = *regularity.vector;
  const ComponentProof* component = proof_of_component(vector);
  const DifferenceSpace& space = component ? component->space : *regularity.space;
  const JointSpectralRadius& found = component ? component->radius : *regularity.radius;
  const Dilation& dilation = mask.doubled.dilation();
  const BlockTriangular& triangular = found.by_blocks()->triangular;
  const std::vector<FieldBlock> blocks = blocks_of(space.family, triangular);
  const std::size_t first_block = component ? unobservable_blocks(*component) : 0;
  const JointSpectralRadius radius = with_names(found, blocks, mask.root, first_block);
  const auto exponent = [&](const ExactRadius& exact) {
    Enclosure ends = exponent_of_radius({proved_lower(radius.product), upper_end(radius, exact, first_block)},
                                        dilation.classes(), dilation.variables());
    ends.lower = std::min(ends.lower.value_or(0), Rational(space.order));
    return ends;
  };
  const Enclosure ends = exponent({});
  require(*ends.lower > 0, "certificate: need a positive lower bound of the exponent, got {}",
          to_decimal(*ends.lower, 6, Rounding::nearest));
  const bool tells_upper_end = ends.upper && *ends.upper < space.order;
  const ExactRadius exact = tells_upper_end ? exact_radius(radius, first_block) : ExactRadius{};
  Certificate certificate{{{},
                           SurfaceSubject{mask_text(mask), dilation.to_text(), true,
                                          component ? std::to_string(vector.components.front().component) : "",
                                          integral_text(vector.integral, mask.root)}},
                          {}};
  certificate.claim.lower = outward(*exponent(exact).lower, Rounding::down);
  if (tells_upper_end) certificate.claim.upper = outward(*ends.upper, Rounding::up);
  certificate.bounds = {outward(*ends.lower, Rounding::down), certificate.claim.upper};
  claim_exact(certificate, exact, "0-log");
  const FieldSpace own = space_over_field(space.basis, mask.components());
  const std::size_t variables = dilation.variables();
  std::string text = fmt::format("differences {}\ndigits", space.order);
  for (const LatticePoint& digit : space.dilation.digits()) text += fmt::format(" {}", fmt::join(digit, ","));
  text += "\nvalues" + terms_text(space.values, common_denominator({space.values}), variables) +
          (vector.integral ? functionals_text(mask.doubled) : "") + vectors_text(own.basis, own.pivots, variables);
  if (component) text += fmt::format("unobservable {}\n", component->unobservable);
  text += blocks_over_field(own, triangular);
  const std::size_t leading = radius.by_blocks()->leading;
  if (tells_upper_end) text += product_over_field(radius, blocks[leading], leading, mask.root);
  certificate.sections.push_back({std::move(text)});
  add_sections(certificate, radius.proof, space.family.count(), exact.blocks);
  return certificate;
}

Certificate vector_scheme_certificate(const QuadraticMask& mask, bool hermite, const Budget& budget) {
  require_vector_scheme(mask.doubled, hermite);
  require_kept(kept_polynomials(without_letters(mask.doubled), mask.root), hermite);
  FieldScheme scheme = field_scheme(mask, budget);
  const JointSpectralRadius& radius = scheme.radius;
  const ClaimedEnds ends = ends_of_scheme(scheme.space.polynomials, hermite, mask.doubled.arity(), radius);
  const FieldSpace own = space_over_field(scheme.space.basis, mask.components());
  scheme.space.basis = own.basis;
  scheme.space.pivots = own.pivots;
  Certificate certificate{
      {ends,
       MaskSubject{
           mask_text(mask), std::to_string(mask.doubled.arity()), {}, false, {}, hermite ? "hermite" : "vectors"}},
      {},
      ends};
  add_proof(certificate, space_of_vectors_text(scheme.space, mask.doubled.arity(), hermite), own, scheme.family, radius,
            mask.root);
  return certificate;
}

Certificate convergence_certificate(const QuadraticMask& mask, const Budget& budget) {
  const Dilation& dilation = mask.doubled.dilation();
  require(
      dilation.is_isotropic(),
      "certificate: need a vector scheme with a dilation that is similar to a multiple of an orthogonal matrix, got "
      "{}",
      dilation.to_text());
  const SchemeDifferences differences = scheme_differences(mask, budget);
  const ClaimedEnds ends = ends_of_differences(differences);
  Certificate certificate{{ends, MaskSubject{mask_text(mask), dilation.to_text(), {}, false, {}, "vectors"}}, {}, ends};
  if (!differences.space) {
    certificate.sections.push_back({space_of_constants_text(dilation, differences, {}, {})});
    return certificate;
  }
  const DifferenceSpace& space = *differences.space;
  const JointSpectralRadius& radius = differences.radius;
  const FieldSpace own = space_over_field(space.basis, mask.components());
  add_proof(certificate, space_of_constants_text(space.dilation, differences, own.basis, own.pivots), own, space.family,
            radius, mask.root);
  return certificate;
}

}  // namespace subcert
