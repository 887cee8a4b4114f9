#include "certificate.hpp"

#include "exact_radius.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/difference/level_norms.hpp>
#include <subcert/analysis/symbol/polynomials/sum_of_squares.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/transition/transition.hpp>
#include <subcert/schemes/specification.hpp>

#include <fmt/format.h>

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace subcert {
namespace {

constexpr std::size_t least_inverted = 24;  // the size from which on an inverse proves a product
constexpr int inverse_bits = 60;            // of the radius of a product, by an inverse
constexpr double most_checked = 8e9;        // of the work of all words of a length, of which checkers allow 10^10
constexpr int most_levels = 6;              // of the norms that bound differences

/// A decimal of 15 places as a fraction in lowest terms; of 15 more than the zeros after the point for tiny numbers.
std::string outward(const Rational& value, Rounding rounding) {
  const long bits = value == 0 ? 0 : -binary_exponent(value);
  const int places = bits < 20 ? 15 : 15 + static_cast<int>(bits * 302 / 1000);
  std::string digits = to_fixed(value, places, rounding);
  digits.erase(digits.find('.'), 1);
  const Rational rounded = *parse_rational(digits) * power(Rational(10), -places);
  return to_text(rounded);
}

std::string terms_text(const std::vector<WeightedVertex>& terms, PolytopeKind kind, const GroupWords& group) {
  std::string text;
  for (const WeightedVertex& term : terms) {
    const Integer sign = group.sign(term.element);
    text += fmt::format(" {}{}{}:{}", term.vertex, group.word(term.element), term.conjugated ? "c" : "",
                        Integer(sign * term.weight).str());
    if (kind == PolytopeKind::complex) text += ":" + Integer(sign * term.imaginary).str();
  }
  return text;
}

std::string numbers_text(const std::vector<Integer>& numbers) {
  std::string text;
  for (const Integer& number : numbers) text += " " + number.str();
  return text;
}

/// The head, and the coefficients from that of z^0 on.
std::string polynomial_text(const std::string& head, const LaurentPolynomial& p) {
  std::string text = head;
  for (long k = 0; k <= (p.is_zero() ? 0 : p.highest()); ++k) text += " " + to_text(p.coefficient(k));
  return text + "\n";
}

std::string group_text(const GroupWords& group) {
  const std::size_t count = group.generators().size() + group.negation().size();
  return count == 0 ? "" : fmt::format(" group:{}", count);
}

std::string properties_text(const PolytopeProof& polytope, const GroupWords& group) {
  std::string text;
  if (polytope.kind == PolytopeKind::complex) text += " complex";
  if (polytope.kind == PolytopeKind::nonnegative) text += " nonnegative";
  if (polytope.is_flip_symmetric() && group.negation().empty()) text += " symmetric";
  if (polytope.transposed) text += " transposed";
  return text + group_text(group);
}

std::string product_text(std::size_t block, const RationalComplex& eigenvalue, const std::vector<int>& word) {
  return fmt::format("product {} {} {} {}\n", block, to_text(eigenvalue.re), to_text(eigenvalue.im),
                     fmt::join(word, " "));
}

/// Whether the eigenvalue that the line `product` gives has the modulus of the lower end itself; one that is multiple
/// is a little off. It need not be known to be the largest.
bool is_exactly_given(const ProductEvidence& product) {
  const auto letters = static_cast<long>(product.word.size());
  return product.eigenvalue.squared_modulus() == power(*product.radius.lower, 2 * letters);
}

/// What the line `product` proves at least.
Rational proved_lower(const ProductEvidence& product) {
  const Rational& lower = *product.radius.lower;
  return product.exact && !is_exactly_given(product) ? lower - lower * power(Rational(2), -inverse_bits) : lower;
}

/// The lines `inverse` and `column`.
std::string inverse_text(const ApproximateInverse& inverse) {
  std::string text = fmt::format("inverse {}\n", inverse.bits);
  for (std::size_t k = 0; k < inverse.columns.size(); ++k)
    text += fmt::format("column {}{}\n", k, numbers_text(inverse.columns[k]));
  return text;
}

/// Large products are proved by an inverse, which is checked by d^3 operations; eigenvalues that are rational numbers
/// by polynomials, exactly. Domain: `family` has the radius.
std::string product_text(const MatrixFamily& family, const JointSpectralRadius& radius) {
  const ProductEvidence& product = radius.product;
  const BlockProof* blocks = radius.by_blocks();
  const std::size_t block = blocks ? blocks->leading : 0;
  const MatrixFamily its = blocks ? blocks->triangular.block(block) : family;
  if (its.size() >= least_inverted && !product.exact && !is_exactly_given(product))
    if (const auto inverse = approximate_inverse(its, product))
      return product_text(block, inverse->point, product.word) + inverse_text(*inverse);
  return product_text(block, product.eigenvalue, product.word);
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

std::string generators_text(const std::vector<FamilySymmetry>& elements, const GroupWords& group) {
  std::string text;
  for (std::size_t g = 0; g < group.generators().size(); ++g)
    text += fmt::format("generator {}\n", fmt::join(elements[group.inverse(g)].letters, " ")) +
            rows_text("map", elements[group.generators()[g]].map.matrix());
  if (group.negation().empty()) return text;
  const FamilySymmetry& identity = elements.front();
  return text + fmt::format("generator {}\n", fmt::join(identity.letters, " ")) +
         rows_text("map", Rational(-1) * identity.map.matrix());
}

/// The same combination of the images under the flip, of a group of two.
std::vector<WeightedVertex> mirrored(std::vector<WeightedVertex> terms) {
  for (WeightedVertex& term : terms) term.element = 1 - term.element;
  return terms;
}

/// The section of one block.
class SectionWriter {
 public:
  /// `exact`: with what says that products attain the radius, which the proof knows.
  SectionWriter(std::size_t matrix_count, std::size_t block, bool exact)
      : matrix_count_(matrix_count), block_(block), exact_(exact) {}

  std::string operator()(const NormProof& norms) const {
    return fmt::format("block {} norm {}\n", block_, norms.level);
  }

  std::string operator()(const PolytopeProof& polytope) const {
    const GroupWords group = words_of(polytope, exact_);
    std::string text = fmt::format("block {} polytope {} {} {}{}\n", block_, polytope.vertices.size(),
                                   polytope.vertex_bits, polytope.weight_bits, properties_text(polytope, group));
    text += generators_text(polytope.group, group);
    for (std::size_t v = 0; v < polytope.vertices.size(); ++v)
      text += "vertex" + numbers_text(polytope.vertices[v]) +
              (polytope.kind == PolytopeKind::complex ? numbers_text(polytope.imaginary[v]) : "") + "\n";
    for (std::size_t k = 0; k < polytope.units.size(); ++k)
      text += fmt::format("unit {}{}\n", k, terms_text(polytope.units[k], polytope.kind, group));
    // Beside a group all are written; those of a flip are half of them, and the others their mirror images.
    const std::size_t size = polytope.vertices.front().size();
    if (!group.negation().empty() && polytope.is_flip_symmetric())
      for (std::size_t k = polytope.units.size(); k < size; ++k)
        text += fmt::format("unit {}{}\n", k, terms_text(mirrored(polytope.units[size - 1 - k]), polytope.kind, group));
    for (std::size_t i = 0; i < polytope.images.size(); ++i)
      text += fmt::format("image {} {}{}\n", i / matrix_count_, i % matrix_count_,
                          terms_text(polytope.images[i], polytope.kind, group));
    return exact_ ? text + cycle_text(*polytope.attained, group) : text;
  }

  std::string operator()(const QuadraticProof& proof) const {
    std::string text = fmt::format("block {} quadratic {} {}\n", block_, proof.letters.size(), to_text(proof.bound));
    for (const std::vector<Integer>& row : proof.form) text += "form" + numbers_text(row) + "\n";
    for (const int letter : proof.letters) text += fmt::format("word {}\n", letter);
    return text;
  }

  std::string operator()(const GraphProof& bound) const {
    const GraphProof& proof = exact_ ? bound.attained->graph : bound;
    const GroupWords group(proof.group, false);
    std::string text = fmt::format("block {} graph {} {} {}{}\n", block_, proof.states.size(), to_text(proof.bound),
                                   proof.bits, group_text(group)) +
                       generators_text(proof.group, group);
    for (const GraphProof::State& state : proof.states) {
      for (const std::vector<Integer>& row : state.coordinates) text += "coordinates" + numbers_text(row) + "\n";
      for (const GraphProof::Step& step : state.steps)
        text += fmt::format("step {} {}{} {} {}\n", step.letter, step.to, group.word(step.element), step.norm,
                            fmt::join(step.matrix, " "));
      text += "tree " + state.ends + "\n";
    }
    return exact_ ? text + cycle_text(*bound.attained) : text;
  }

  std::string operator()(const BlockProof&) const { throw std::logic_error("certificate: blocks within a block"); }

  std::string operator()(const SingleRadiusProof& proof) const {
    const auto squares = sum_of_squares(proof.symbol);
    if (!squares) fail(ErrorKind::size, "certificate: the cosine polynomial is too near to 0 for a sum of squares");
    const LaurentPolynomial factor = squares->factor * LaurentPolynomial(power(Rational(2), squares->bits));
    return fmt::format("block {} single {} {}\n", block_, to_text(proof.growth.radius.upper.value()), squares->bits) +
           polynomial_text("square", squares->square) + polynomial_text("factor", factor) +
           polynomial_text("recurrence", proof.growth.recurrence);
  }

  std::string operator()(const FrequencyProof& proof) const {
    return fmt::format("block {} frequency {} {} {} {} {} {} {}\nweights{}\n", block_, to_text(proof.bound),
                       proof.cells, proof.shells, proof.steps, proof.group, proof.terms, proof.bits,
                       numbers_text(proof.weights));
  }

 private:
  std::size_t matrix_count_, block_;
  bool exact_;
};

/// The sections of a proof, block by block.
void add_sections(Certificate& certificate, const RadiusProof& proof, std::size_t matrix_count,
                  const std::vector<bool>& exact = {}) {
  const auto* blocks = std::get_if<BlockProof>(&proof);
  for (std::size_t i = 0; i < (blocks ? blocks->blocks.size() : 1); ++i) {
    const RadiusProof& own = blocks ? blocks->blocks[i].proof : proof;
    CertificateSection section{std::visit(SectionWriter(matrix_count, i, false), own)};
    if (i < exact.size() && exact[i])
      section = {std::visit(SectionWriter(matrix_count, i, true), own), std::move(section.lines)};
    certificate.sections.push_back(std::move(section));
  }
}

/// What says that the product attains the radius.
struct ExactRadius {
  std::string number = {}, root = {};  // empty where nothing says so,
  std::string missing = {};            // and why
  std::vector<bool> blocks = {};       // those with products that attain the radius
  bool grows_like_powers = false;      // products of length n have norms between multiples of radius^n
};

/// What the radius of one block is, or why nothing says so.
struct BlockNumber {
  std::optional<NumberLines> lines;
  std::string missing = "a hundred decimals do not tell the eigenvalue from others";
};

BlockNumber number_of(const RadiusProof& proof) {
  const auto* graph = std::get_if<GraphProof>(&proof);
  if (graph && graph->attained && graph->attained->number) return {number_lines(*graph->attained->number)};
  if (const auto* form = std::get_if<QuadraticProof>(&proof)) {
    const Rational q(denominator(form->bound));
    return {number_lines({LaurentPolynomial({-form->bound * q, q}, 0), {form->bound, 0}})};
  }
  const auto* polytope = std::get_if<PolytopeProof>(&proof);
  if (polytope && polytope->attained) return {number_lines(polytope->attained->number)};
  return {{}, polytope ? polytope->not_attained : "neither a polytope nor a form names it"};
}

ExactRadius exact_radius(const JointSpectralRadius& radius) {
  if (!radius.exact.is_yes()) return {};
  if (const auto* single = std::get_if<SingleRadiusProof>(&radius.proof)) {
    const auto number = number_of(single->growth);
    const auto lines = number ? number_lines(*number) : std::nullopt;
    return lines ? ExactRadius{lines->number, lines->root, {}, {}, single->growth.power == 0} : ExactRadius{};
  }
  const BlockProof* blocks = radius.by_blocks();
  const std::size_t count = blocks ? blocks->blocks.size() : 1, leading = blocks ? blocks->leading : 0;
  const BlockNumber first = number_of(blocks ? blocks->blocks[leading].proof : radius.proof);
  if (!first.lines) return {{}, {}, first.missing};
  ExactRadius exact{first.lines->number, first.lines->root, {}, std::vector<bool>(count), true};
  exact.blocks[leading] = true;
  for (std::size_t i = 0; i < count; ++i) {
    if (i == leading || blocks->blocks[i].proved_upper() < first.lines->low) continue;
    exact.grows_like_powers = false;
    if (blocks->blocks[i].proved_upper() == first.lines->low) continue;
    const BlockNumber other = number_of(blocks->blocks[i].proof);
    if (!other.lines) return {{}, {}, other.missing};
    if (other.lines->number != exact.number) return {{}, {}, "two blocks have the same radius by two numbers"};
    exact.blocks[i] = true;
  }
  return exact;
}

/// The upper end of the radius that is proved; where letters of a graph are kept, by its product.
Rational upper_end(const JointSpectralRadius& radius, const ExactRadius& exact) {
  const auto of_block = [&](const JointSpectralRadius& block, std::size_t i) {
    const auto* graph = std::get_if<GraphProof>(&block.proof);
    return graph && i < exact.blocks.size() && exact.blocks[i] ? *graph->attained->radius.upper : block.proved_upper();
  };
  const BlockProof* blocks = radius.by_blocks();
  if (!blocks) return of_block(radius, 0);
  Rational most = 0;
  for (std::size_t i = 0; i < blocks->blocks.size(); ++i) most = std::max(most, of_block(blocks->blocks[i], i));
  return most;
}

/// What the number is: `before` the logarithm of the radius, or the radius. Domain: the first section.
void claim_exact(Certificate& certificate, const ExactRadius& exact, const std::string& before = "") {
  certificate.missing = exact.missing;
  if (exact.number.empty()) return;
  certificate.claim.exact = before + exact.number;
  certificate.sections.push_back({exact.root, ""});
}

std::string blocks_text(const JointSpectralRadius& radius) {
  const BlockProof* blocks = radius.by_blocks();
  if (!blocks) return "";
  const RationalMatrix& basis = blocks->triangular.basis;
  return fmt::format("blocks {}\n", fmt::join(blocks->triangular.sizes, " ")) + rows_text("basis", basis) +
         rows_text("inverse", solve(basis, RationalMatrix::identity(basis.rows())));
}

/// On the line of the sum rules: there are no more of them.
const char* full_text(bool full) { return full ? " full" : ""; }

/// Of a sequence of vectors the component is one more coordinate.
std::string point_text(const LatticePoint& point, std::size_t variables) {
  const auto end = point.begin() + static_cast<std::ptrdiff_t>(variables);
  std::string text = fmt::format("{}", fmt::join(point.begin(), end, ","));
  return end == point.end() ? text : fmt::format("{}.{}", text, *end);
}

Integer common_denominator(const std::vector<LatticeSequence>& sequences) {
  Integer common = 1;
  for (const LatticeSequence& sequence : sequences)
    for (const auto& [point, value] : sequence) common = lcm(common, denominator(value));
  return common;
}

/// The sequences times a factor; the point `first` leads, if it is one of them.
std::string terms_text(const LatticeSequence& sequence, const Rational& factor, std::size_t variables,
                       const LatticePoint& first = {}) {
  std::string text;
  const auto append = [&](const LatticePoint& point, const Rational& value) {
    text += " " + point_text(point, variables) + ":" + to_text(Rational(factor * value));
  };
  if (const auto at = sequence.find(first); at != sequence.end()) append(first, at->second);
  for (const auto& [point, value] : sequence)
    if (point != first) append(point, value);
  return text + "\n";
}

/// The vectors of the space, times their common denominator.
std::string vectors_text(const DifferenceSpace& space) {
  std::string text = fmt::format("space {}\n", space.basis.size());
  const Rational factor = common_denominator(space.basis);
  for (std::size_t c = 0; c < space.basis.size(); ++c)
    text += "vector" + terms_text(space.basis[c], factor, space.dilation.variables(), space.pivots[c]);
  return text;
}

/// The lines from the order of the differences to the vectors of the space.
std::string space_text(const DifferenceSpace& space, const Dilation& dilation) {
  std::string text = fmt::format("{} {}\n", space.is_of_values() ? "differences" : "sum-rules", space.order);
  if (space.dilation.rows() != dilation.rows()) text += fmt::format("turned {}\n", space.dilation.to_text());
  text += "digits";
  for (const LatticePoint& digit : space.dilation.digits()) text += " " + point_text(digit, digit.size());
  text += "\n";
  if (space.is_of_values())
    text += "values" + terms_text(space.values, common_denominator({space.values}), dilation.variables());
  return text + vectors_text(space);
}

/// That the scheme converges, after a proof by differences of phi.
void add_shrinking(Certificate& certificate, const ShrinkingDifferences& differences) {
  const DifferenceSpace& space = differences.space;
  certificate.sections.push_back(
      {fmt::format("sum-rules {}\n", space.order) + vectors_text(space) + blocks_text(differences.radius)});
  add_sections(certificate, differences.radius.proof, space.family.count());
}

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

/// With norms of words so short that checkers go through all of them: a mask tells the norms of longer ones at once.
HolderRegularity checkable(const Mask& mask, HolderRegularity regularity) {
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

/// What the certificate proves; the exponent may be known more sharply.
Rational lower_end(const Mask& mask, const HolderRegularity& regularity, const ExactRadius& exact = {}) {
  return regularity.bounds.sum_rules - *log_ratio(upper_end(regularity.radius, exact), mask.arity()).upper;
}

/// What is claimed and proved of a mask: of that of the subject, or of its reduced one, as `reduced` says.
void add_exponent(Certificate& certificate, const Mask& mask, const HolderRegularity& regularity,
                  const std::optional<MaskRounding>& rounding, const std::string& reduced = "") {
  const int rules = regularity.bounds.sum_rules;
  const JointSpectralRadius& radius = regularity.radius;
  CertificateClaim& claim = certificate.claim;
  const Rational product = proved_lower(radius.product);
  const std::string whole = std::to_string(rules),
                    decimal = product > 1 ? outward(rules - *log_ratio(product, mask.arity()).lower, Rounding::up)
                                          : whole;
  // A product that proves no more than the number of sum rules is not needed.
  const bool by_product = decimal != whole;
  // The checker shows stability only where the sub-symbols have no common zero at all.
  if (regularity.stable.is_yes() && (by_product || !rounding) && common_factor_of_cosets(mask).length() == 1)
    claim.upper = decimal;
  ExactRadius exact;
  if (claim.upper && by_product && !rounding) exact = exact_radius(radius);
  claim.lower = outward(lower_end(mask, regularity, exact), Rounding::down);
  certificate.bounds = {outward(lower_end(mask, regularity), Rounding::down), claim.upper};
  claim_exact(certificate, exact, whole + "-log");
  certificate.sections.push_back(
      {fmt::format("{}sum-rules {}{}\n{}", reduced, rules, full_text(claim.upper && !by_product),
                   claim.upper ? "stability\n" : "")});
  add_radius(certificate, mask, regularity, claim.upper && by_product, exact.blocks);
  const auto logarithm = claim.exact ? logarithm_lines(mask, regularity, exact) : std::nullopt;
  if (!logarithm) return;
  claim.logarithm = logarithm->first;
  certificate.sections.push_back({logarithm->second, ""});
}

/// What the proofs of intervals that follow each other say of all values from low to high; without proofs, that the
/// shifts are stable.
Certificate interval_certificate(const ParametricMask& mask, char letter, const Rational& low, const Rational& high,
                                 const ClaimedEnds& ends, const std::vector<IntervalProof>& proofs) {
  const MaskSubject subject{mask.to_text(letter), std::to_string(mask.arity()),
                            fmt::format("{}={}..{}", letter, to_text(low), to_text(high))};
  Certificate certificate{{ends, subject}, {}, ends};
  const bool stable = proofs.empty() || (ends.upper && *ends.upper != "0");
  certificate.sections.push_back(
      {fmt::format("sum-rules {}{}\n{}", sum_rules(mask), full_text(ends.says_rough()), stable ? "stability\n" : "")});
  const std::size_t matrices = static_cast<std::size_t>(mask.arity()) * mask.powers().size();
  for (const IntervalProof& proof : proofs) {
    std::string text = fmt::format("to {}\n", to_text(proof.high));
    if (proof.above) text += blocks_text(*proof.above);
    if (const auto& below = proof.below) text += product_text(0, {below->re, below->im}, below->word);
    certificate.sections.push_back({std::move(text)});
    if (proof.above) add_sections(certificate, proof.above->proof, matrices);
  }
  return certificate;
}

FamilySubject subject_of(const MatrixFamily& family, bool is_subradius) {
  return {is_subradius, std::to_string(family.count()), std::to_string(family.size())};
}

/// One of each pair k, -k, times the common denominator.
std::string gram_text(const LatticeSequence& gram) {
  LatticeSequence half;
  for (const auto& [point, value] : gram)
    if (LatticePoint(point.size(), 0) - point <= point) half.emplace(point, value);
  return "gram" + terms_text(half, common_denominator({half}), gram.begin()->first.size());
}

}  // namespace

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
  if (rounding) subject.within = fmt::format("{},{}", to_text(rounding->distance), rules);
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
  certificate.sections.push_back({SectionWriter(static_cast<std::size_t>(mask.arity()), 0, false)(bound->proof)});
  return certificate;
}

Certificate surface_certificate(const LatticeMask& mask, const MultivariateRegularity& regularity) {
  require(regularity.radius && regularity.space,
          "certificate: need a joint spectral radius, got none (of a tensor product, certify the factors)");
  const JointSpectralRadius& radius = *regularity.radius;
  const Dilation& dilation = mask.dilation();
  require(dilation.is_isotropic(), "certificate: need an isotropic dilation, got {}", dilation.to_text());
  const DifferenceSpace& space = *regularity.space;
  const FunctionVector* vector = regularity.vector ? &*regularity.vector : nullptr;
  require(
      !vector || (vector->solutions == 1 && vector->components.size() == mask.components()),
      "certificate: of a vector of functions the exponent of the worst is certified, where there is one solution up "
      "to a factor, got {} solutions, and {} of {} functions to be looked at",
      vector ? vector->solutions : 0, vector ? vector->components.size() : 0, mask.components());
  require(!space.is_of_values() || vector || regularity.shrinking,
          "certificate: need differences of the scheme that are proved to shrink, got those of the limit alone (with a "
          "longer budget a proof may be found)");
  const auto exponent = [&](const ExactRadius& exact) {
    Enclosure ends = exponent_of_radius({proved_lower(radius.product), upper_end(radius, exact)}, dilation.classes(),
                                        dilation.variables());
    ends.lower = std::min(ends.lower.value_or(0), Rational(space.order));
    return ends;
  };
  const Enclosure ends = exponent({});
  const std::optional<Rational>&lower = ends.lower, &upper = ends.upper;
  require(*lower > 0, "certificate: need a positive lower bound of the exponent, got {}",
          to_decimal(*lower, 6, Rounding::nearest));
  const bool tells_upper_end = (space.is_of_values() || regularity.stable.is_yes()) && upper && *upper < space.order;
  const ExactRadius exact = tells_upper_end ? exact_radius(radius) : ExactRadius{};
  Certificate certificate{{{}, SurfaceSubject{to_mask_text(mask), dilation.to_text(), vector != nullptr}}, {}};
  certificate.claim.lower = outward(*exponent(exact).lower, Rounding::down);
  if (tells_upper_end) certificate.claim.upper = outward(*upper, Rounding::up);
  certificate.bounds = {outward(*lower, Rounding::down), certificate.claim.upper};
  claim_exact(certificate, exact, "0-log");
  std::string text = space_text(space, dilation);
  if (tells_upper_end && !space.is_of_values()) text += gram_text(*regularity.gram);
  text += blocks_text(radius);
  if (tells_upper_end) text += product_text(space.family, radius);
  certificate.sections.push_back({std::move(text)});
  add_sections(certificate, radius.proof, space.family.count(), exact.blocks);
  if (space.is_of_values() && !vector) add_shrinking(certificate, *regularity.shrinking);
  return certificate;
}

Certificate exponent_certificate(const LatticeMask& mask, const Regularity& regularity,
                                 const std::optional<MaskRounding>& rounding) {
  return regularity.curve ? exponent_certificate(mask.curve(), *regularity.curve, rounding)
                          : surface_certificate(mask, *regularity.surface);
}

namespace {

/// What needs no proofs of intervals, for all values from `low` to `high` but those within `margin` of `away`, in
/// order.
void add_away(std::vector<RangeCertificate>& certificates, const ParametricMask& mask, char letter,
              const ClaimedEnds& ends, Truth holds, Rational low, const Rational& high,
              const std::vector<Enclosure>& away, const Rational& margin) {
  const auto add = [&](const Rational& end) {
    if (low < end) certificates.push_back({low, end, holds, interval_certificate(mask, letter, low, end, ends, {})});
  };
  for (const Enclosure& value : away) {
    if (*value.upper < low || *value.lower > high) continue;
    add(*value.lower - margin);
    low = *value.upper + margin;
  }
  add(high);
}

/// The limits are not C^order.
void add_rough(std::vector<RangeCertificate>& certificates, const ParametricMask& mask, char letter,
               const Rational& order, const Rational& low, const Rational& high, const std::vector<Enclosure>& away,
               const Rational& margin) {
  add_away(certificates, mask, letter, {{}, "C" + to_text(order)}, Truth::no, low, high, away, margin);
}

/// The shifts are stable; where the polynomial vanishes by which a range is proved, value by value.
void add_stable(std::vector<RangeCertificate>& certificates, const ParametricMask& mask, char letter,
                const Rational& low, const Rational& high, const std::vector<SpecialValue>& special,
                const Rational& margin) {
  std::vector<Enclosure> away;
  for (const SpecialValue& one : special) {
    if (one.why != SpecialValue::Why::unstable) continue;
    away.push_back(one.value);
    if (one.holds != Truth::yes || !one.value.is_exact() || *one.value.lower < low || *one.value.lower > high) continue;
    const Rational& value = *one.value.lower;
    const Mask there = mask.at(value);
    const MaskSubject subject{there.symbol().to_mask_text(), std::to_string(there.arity())};
    certificates.push_back(
        {value, value, Truth::yes, {{{}, subject}, {{fmt::format("sum-rules {}\nstability\n", sum_rules(there))}}}});
  }
  add_away(certificates, mask, letter, {}, Truth::yes, low, high, away, margin);
}

}  // namespace

std::vector<RangeCertificate> range_certificates(const ParametricMask& mask, char letter, const RangeProperty& property,
                                                 const PropertyRange& range, const Rational& margin) {
  using Kind = RangeProperty::Kind;
  const bool stable = property.kind == Kind::stable,
             rough = property.kind == Kind::smooth && property.order >= range.sum_rules;
  if (!stable && !rough && range.proofs.empty()) return {};
  std::vector<RangeCertificate> certificates;
  std::vector<Enclosure> special;  // looked at on their own
  for (const SpecialValue& value : range.special) special.push_back(value.value);
  auto proof = range.proofs.begin();
  const auto add = [&](const Rational& low, const Rational& high, Truth holds, const ClaimedEnds& ends,
                       const std::vector<IntervalProof>& proofs) {
    if (low < high)
      certificates.push_back({low, high, holds, interval_certificate(mask, letter, low, high, ends, proofs)});
  };
  for (const RangePiece& piece : range.pieces) {
    if (piece.holds == Truth::unknown || (stable && piece.holds == Truth::no)) continue;
    const Rational low = piece.low_included ? piece.low : Rational(piece.low + margin);
    const Rational high = piece.high_included ? piece.high : Rational(piece.high - margin);
    ClaimedEnds ends;
    if (rough) {
      if (piece.holds == Truth::no) add_rough(certificates, mask, letter, property.order, low, high, special, margin);
      continue;
    }
    if (stable) {
      add_stable(certificates, mask, letter, low, high, range.special, margin);
      continue;
    }
    (piece.holds == Truth::yes ? ends.lower : ends.upper) = to_text(property.order);
    // What is known by positive coefficients has no proof of its own.
    std::vector<IntervalProof> proofs;
    const auto add_run = [&] {
      if (!proofs.empty()) add(proofs.front().low, proofs.back().high, piece.holds, ends, proofs);
      proofs.clear();
    };
    for (; proof != range.proofs.end() && proof->low < piece.high; ++proof) {
      if (!proofs.empty() && proofs.back().high < proof->low) add_run();
      proofs.push_back(*proof);
    }
    add_run();
  }
  return certificates;
}

std::vector<RangeCertificate> curve_certificates(const ParametricMask& mask, char letter, const ExponentCurve& curve) {
  const Rational strictly = power(Rational(10), -12);
  std::vector<Enclosure> special;  // with more sum rules
  for (const CurvePoint& point : curve.special) special.push_back(point.at.value);
  std::vector<RangeCertificate> certificates;
  const auto add = [&](const IntervalProof& proof, const ClaimedEnds& ends) {
    certificates.push_back({proof.low, proof.high, ends.lower ? Truth::yes : Truth::unknown,
                            interval_certificate(mask, letter, proof.low, proof.high, ends, {proof})});
  };
  for (const CurvePiece& piece : curve.pieces) {
    IntervalProof above{piece.proof.low, piece.proof.high, std::nullopt, std::nullopt}, below = above;
    ClaimedEnds lower, upper;
    if (piece.exponent.lower && *piece.exponent.lower > strictly) {
      above.above = piece.proof.above;
      lower.lower = outward(*piece.exponent.lower - strictly, Rounding::down);
    }
    if (piece.exponent.upper) {
      below.below = piece.proof.below;
      upper.upper = outward(std::max(Rational(0), *piece.exponent.upper), Rounding::up);
    }
    // A product of diagonal blocks is not that of the whole matrices.
    if (above.above && below.below && !above.above->by_blocks()) {
      add(piece.proof, {lower.lower, upper.upper});
      continue;
    }
    if (above.above) add(above, lower);
    if (below.below) add(below, upper);
    if (piece.exponent.upper && !piece.proof.below)
      add_rough(certificates, mask, letter, curve.sum_rules, piece.proof.low, piece.proof.high, special, strictly);
  }
  return certificates;
}

Certificate radius_certificate(const MatrixFamily& family, const JointSpectralRadius& radius) {
  Certificate certificate{{{}, subject_of(family, false)}, {}};
  CertificateClaim& claim = certificate.claim;
  const ProductEvidence& product = radius.product;
  if (const Rational lower = proved_lower(product); lower > 0)
    claim.lower = outward(is_exactly_given(product) ? lower : rounded(lower, inverse_bits, Rounding::down),
                          Rounding::down);
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
