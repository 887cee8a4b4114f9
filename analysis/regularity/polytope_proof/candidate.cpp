#include "candidate.hpp"

#include <subcert/analysis/regularity/polytope_search/decompositions.hpp>
#include <subcert/analysis/regularity/polytope_search/polytope_search.hpp>

#include <algorithm>

namespace subcert::radius {
namespace {

constexpr int quick_length = 8, quick_width = 12;  // of the words of find_product, and how many are kept per length
constexpr double quick_nearness = 5e-3;

polytope::Matrix to_double(const RationalMatrix& m) {
  polytope::Matrix result(m.rows(), m.columns());
  for (std::size_t i = 0; i < m.rows(); ++i)
    for (std::size_t j = 0; j < m.columns(); ++j) result(i, j) = m(i, j).convert_to<double>();
  return result;
}

/// The search writes the letter applied first first, also where it applies transposed matrices.
std::vector<int> from_left_to_right(std::vector<int> cycle, bool transposed) {
  if (!transposed) std::reverse(cycle.begin(), cycle.end());
  return cycle;
}

}  // namespace

polytope::SearchFamily to_search_family(const MatrixFamily& family) {
  polytope::SearchFamily result;
  for (const RationalMatrix& m : family) result.matrices.push_back(to_double(m));
  if (family.is_flip_symmetric()) {
    result.symmetry = polytope::SymmetryGroup::flip();
  } else if (family.group().size() > 1) {
    std::vector<polytope::SymmetryGroup::Element> elements;
    for (const FamilySymmetry& element : family.group())
      elements.push_back({to_double(element.map.matrix()), to_double(element.map.inverse().matrix()),
                          std::vector<int>(element.letters.begin(), element.letters.end())});
    result.symmetry = polytope::SymmetryGroup(std::move(elements));
  }
  return result;
}

PolytopeCandidate find_polytope(const MatrixFamily& family, const Budget& budget, bool cones, bool exact) {
  polytope::SearchOptions options{.budget = budget};
  options.cones = cones;
  options.exact = exact;
  const polytope::SearchResult found = polytope::search_polytope(to_search_family(family), options);

  PolytopeCandidate result;
  result.kind = found.kind;
  result.transposed = found.transposed;
  result.closed = found.status == polytope::SearchStatus::closed;
  result.scale = found.scale;
  result.scale_is_radius = found.scale == found.radius;
  result.maximizing = found.maximizing;
  for (const polytope::Candidate& product : found.products)
    result.products.push_back({from_left_to_right(product.word, found.transposed), product.word});
  for (const polytope::Vertex& v : found.vertices)
    result.vertices.push_back({v.value, v.parent, v.letter, v.cycle, v.place});
  for (const polytope::ImageProof& image : found.images) {
    result.images.push_back({image.vertex, image.letter, image.identity, {}});
    for (const polytope::CombinationTerm& term : image.terms)
      result.images.back().terms.push_back(
          {term.vertex, static_cast<std::size_t>(term.element), term.conjugated, term.coefficient});
  }
  return result;
}

std::vector<int> find_product(const MatrixFamily& family, const Deadline& deadline) {
  const polytope::ProductSearchOptions options{quick_length, quick_width, quick_nearness, {deadline}};
  const auto found = polytope::search_products(to_search_family(family), options);
  return from_left_to_right(found.front().word, false);
}

FloatingEigenvalue leading_eigenvalue(const RationalMatrix& matrix) {
  const auto exponent = binary_exponent(matrix);
  if (!exponent) return {};
  const auto eigenvalues = polytope::eigenvalues(to_double(power(Rational(2), -*exponent) * matrix));
  std::size_t leading = 0;
  for (std::size_t k = 0; k < eigenvalues.size(); ++k)
    if (std::abs(eigenvalues[k]) > std::abs(eigenvalues[leading]) * (1 + 1e-12)) leading = k;
  return {eigenvalues[leading], *exponent};
}

}  // namespace subcert::radius
