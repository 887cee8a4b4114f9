#include "certificate_text.hpp"

#include "exact_radius.hpp"

#include <subcert/analysis/symbol/polynomials/sum_of_squares.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

namespace subcert::certificate_text {
namespace {

constexpr std::size_t least_inverted = 24;  // the size from which on an inverse proves a product
constexpr int inverse_bits = 60;            // of the radius of a product, by an inverse

/// Whether the eigenvalue that the line `product` gives has the modulus of the lower end itself; one that is multiple
/// is a little off. It need not be known to be the largest.
bool is_exactly_given(const ProductEvidence& product) {
  const auto letters = static_cast<long>(product.word.size());
  return product.eigenvalue.squared_modulus() == power(*product.radius.lower, 2 * letters);
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

/// Of a sequence of vectors the component is one more coordinate.
std::string point_text(const LatticePoint& point, std::size_t variables) {
  const auto end = point.begin() + static_cast<std::ptrdiff_t>(variables);
  std::string text = fmt::format("{}", fmt::join(point.begin(), end, ","));
  return end == point.end() ? text : fmt::format("{}.{}", text, *end);
}

}  // namespace

std::string outward(const Rational& value, Rounding rounding) {
  const long bits = value == 0 ? 0 : -binary_exponent(value);
  const int places = bits < 20 ? 15 : 15 + static_cast<int>(bits * 302 / 1000);
  std::string digits = to_fixed(value, places, rounding);
  digits.erase(digits.find('.'), 1);
  const Rational rounded = *parse_rational(digits) * power(Rational(10), -places);
  return to_text(rounded);
}

Integer common_denominator(const std::vector<LatticeSequence>& sequences) {
  Integer common = 1;
  for (const LatticeSequence& sequence : sequences)
    for (const auto& [point, value] : sequence) common = lcm(common, denominator(value));
  return common;
}

std::string terms_text(const LatticeSequence& sequence, const Rational& factor, std::size_t variables,
                       const LatticePoint& first) {
  std::string text;
  const auto append = [&](const LatticePoint& point, const Rational& value) {
    text += " " + point_text(point, variables) + ":" + to_text(Rational(factor * value));
  };
  if (const auto at = sequence.find(first); at != sequence.end()) append(first, at->second);
  for (const auto& [point, value] : sequence)
    if (point != first) append(point, value);
  return text + "\n";
}

std::string vectors_text(const std::vector<LatticeSequence>& basis, const std::vector<LatticePoint>& pivots,
                         std::size_t variables) {
  std::string text = fmt::format("space {}\n", basis.size());
  const Rational factor = common_denominator(basis);
  for (std::size_t c = 0; c < basis.size(); ++c) text += "vector" + terms_text(basis[c], factor, variables, pivots[c]);
  return text;
}

std::string numbers_text(const std::vector<Integer>& numbers) {
  std::string text;
  for (const Integer& number : numbers) text += " " + number.str();
  return text;
}

std::string polynomial_text(const std::string& head, const LaurentPolynomial& p) {
  std::string text = head;
  for (long k = 0; k <= (p.is_zero() ? 0 : p.highest()); ++k) text += " " + to_text(p.coefficient(k));
  return text + "\n";
}

std::string rows_text(const std::string& head, const RationalMatrix& matrix) {
  std::string text;
  for (std::size_t i = 0; i < matrix.rows(); ++i) {
    text += head;
    for (std::size_t j = 0; j < matrix.columns(); ++j) text += " " + to_text(matrix(i, j));
    text += "\n";
  }
  return text;
}

std::string functionals_text(const LatticeMask& mask) {
  RationalMatrix rest = mean_matrix(mask);
  for (std::size_t c = 0; c < rest.rows(); ++c) rest(c, c) -= 1;
  const auto basis = kernel(transposed(power(rest, static_cast<long>(rest.rows()))));
  RationalMatrix rows(basis.size(), rest.rows());
  for (std::size_t r = 0; r < basis.size(); ++r)
    for (std::size_t c = 0; c < rest.rows(); ++c) rows(r, c) = basis[r][c];
  return rows_text("functional", common_denominator(rows) * rows);
}

const ComponentProof* proof_of_component(const FunctionVector& vector) {
  require(vector.solutions == 1,
          "certificate: need a continuous solution that is the only one up to a factor, got up to {}",
          vector.solutions);
  if (vector.components.size() != 1) return nullptr;
  require(!vector.components.front().is_zero, "certificate: need a function that is not 0");
  require(vector.proof.has_value(), "certificate: need a proof of the exponent of the function, got none");
  return &*vector.proof;
}

std::size_t unobservable_blocks(const ComponentProof& proof) {
  std::size_t count = 0;
  for (std::size_t sum = 0; sum < proof.unobservable; ++count) sum += proof.radius.by_blocks()->triangular.sizes[count];
  return count;
}

std::string product_text(std::size_t block, const RationalComplex& eigenvalue, const std::vector<int>& word) {
  return fmt::format("product {} {} {} {}\n", block, to_text(eigenvalue.re), to_text(eigenvalue.im),
                     fmt::join(word, " "));
}

std::string product_text(const MatrixFamily& family, const JointSpectralRadius& radius) {
  const ProductEvidence& product = radius.product;
  const BlockProof* blocks = radius.by_blocks();
  const std::size_t block = blocks ? blocks->leading : 0;
  const MatrixFamily its = blocks ? blocks->triangular.block(block) : family;
  if (its.size() >= least_inverted && !product.exact && !is_exactly_given(product))
    if (const auto inverse = approximate_inverse(its, product))
      return product_text(block, inverse->point, product.word) + inverse_text(inverse->bits, inverse->columns);
  return product_text(block, product.eigenvalue, product.word);
}

Rational proved_lower(const ProductEvidence& product) {
  const Rational& lower = *product.radius.lower;
  return product.exact && !is_exactly_given(product) ? lower - lower * power(Rational(2), -inverse_bits) : lower;
}

std::optional<std::string> claimed_lower(const ProductEvidence& product) {
  const Rational lower = proved_lower(product);
  if (lower <= 0) return std::nullopt;
  return outward(is_exactly_given(product) ? lower : rounded(lower, inverse_bits, Rounding::down), Rounding::down);
}

std::optional<std::string> upper_end_by(const ProductEvidence& product, int order, int arity) {
  const Rational lower = proved_lower(product);
  if (lower <= 1) return std::nullopt;
  return outward(order - *log_ratio(lower, arity).lower, Rounding::up);
}

std::string blocks_text(const JointSpectralRadius& radius) {
  const BlockProof* blocks = radius.by_blocks();
  if (!blocks) return "";
  const RationalMatrix& basis = blocks->triangular.basis;
  return fmt::format("blocks {}\n", fmt::join(blocks->triangular.sizes, " ")) + rows_text("basis", basis) +
         rows_text("inverse", solve(basis, RationalMatrix::identity(basis.rows())));
}

ExactRadius exact_radius(const JointSpectralRadius& radius, std::size_t first_block) {
  if (!radius.exact.is_yes()) return {};
  if (const auto* single = std::get_if<SingleRadiusProof>(&radius.proof)) {
    const auto number = number_of(single->growth);
    const auto lines = number ? number_lines(*number) : std::nullopt;
    return lines ? ExactRadius{lines->number, lines->root, {}, {}, single->growth.power == 0} : ExactRadius{};
  }
  const auto* polytope = std::get_if<PolytopeProof>(&radius.proof);
  if (polytope && polytope->attained && polytope->attained->nearby) {
    const NearbyCycles& nearby = *polytope->attained->nearby;
    const std::string letters = fmt::format("{}", fmt::join(nearby.product, ","));
    const std::string line = fmt::format("attains {} {} {}\n", letters, to_text(*nearby.bounds.lower),
                                         to_text(*nearby.bounds.upper));
    return {letters, line, {}, {true}, true, true};
  }
  const BlockProof* blocks = radius.by_blocks();
  const std::size_t count = blocks ? blocks->blocks.size() : 1, leading = blocks ? blocks->leading : 0;
  const BlockNumber first = number_of(blocks ? blocks->blocks[leading].proof : radius.proof);
  if (!first.lines) return {{}, {}, first.missing};
  ExactRadius exact{first.lines->number, first.lines->root, {}, std::vector<bool>(count), true};
  exact.blocks[leading] = true;
  for (std::size_t i = first_block; i < count; ++i) {
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

Rational upper_end(const JointSpectralRadius& radius, const ExactRadius& exact, std::size_t first) {
  const auto of_block = [&](const JointSpectralRadius& block, std::size_t i) {
    const auto* graph = std::get_if<GraphProof>(&block.proof);
    return graph && i < exact.blocks.size() && exact.blocks[i] ? *graph->attained->radius.upper : block.proved_upper();
  };
  const BlockProof* blocks = radius.by_blocks();
  if (!blocks) return of_block(radius, 0);
  Rational most = 0;
  for (std::size_t i = first; i < blocks->blocks.size(); ++i) most = std::max(most, of_block(blocks->blocks[i], i));
  return most;
}

void claim_exact(Certificate& certificate, const ExactRadius& exact, const std::string& before) {
  certificate.missing = exact.missing;
  if (exact.number.empty()) return;
  if (exact.is_product)
    certificate.claim.attains = exact.number;
  else
    certificate.claim.exact = before + exact.number;
  certificate.sections.push_back({exact.root, ""});
}

void add_sections(Certificate& certificate, const RadiusProof& proof, std::size_t matrix_count,
                  const std::vector<bool>& exact) {
  const auto* blocks = std::get_if<BlockProof>(&proof);
  for (std::size_t i = 0; i < (blocks ? blocks->blocks.size() : 1); ++i) {
    const RadiusProof& own = blocks ? blocks->blocks[i].proof : proof;
    CertificateSection section{std::visit(SectionWriter(matrix_count, i, false), own)};
    if (i < exact.size() && exact[i])
      section = {std::visit(SectionWriter(matrix_count, i, true), own), std::move(section.lines)};
    certificate.sections.push_back(std::move(section));
  }
}

}  // namespace subcert::certificate_text
