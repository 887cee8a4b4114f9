#include "candidate.hpp"

#include "../polytope/decompositions.hpp"
#include "../polytope/polytope_search.hpp"

#include <algorithm>

namespace subcert::radius {
namespace {

constexpr int quick_length = 8, quick_width = 12;  // of the words of find_product, and how many are kept per length
constexpr double quick_nearness = 5e-3;

Eigen::MatrixXd to_double(const RationalMatrix& m) {
  Eigen::MatrixXd result(static_cast<Eigen::Index>(m.rows()), static_cast<Eigen::Index>(m.columns()));
  for (std::size_t i = 0; i < m.rows(); ++i)
    for (std::size_t j = 0; j < m.columns(); ++j)
      result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = m(i, j).convert_to<double>();
  return result;
}

HullKind hull_kind(PolytopeKind kind) {
  switch (kind) {
    case PolytopeKind::nonnegative: return HullKind::nonnegative;
    case PolytopeKind::complex: return HullKind::complex;
    default: return HullKind::real;
  }
}

/// The search writes the letter applied first first, also where it applies transposed matrices.
std::vector<int> from_left_to_right(std::vector<int> cycle, bool transposed) {
  if (!transposed) std::reverse(cycle.begin(), cycle.end());
  return cycle;
}

}  // namespace

PolytopeCandidate find_polytope(const MatrixFamily& family, const Budget& budget) {
  SearchFamily floating;
  for (const RationalMatrix& m : family) floating.matrices.push_back(to_double(m));
  floating.flip_symmetric = family.is_flip_symmetric();
  SearchOptions options;
  options.seconds = std::max(budget.deadline.remaining(), 1e-3);
  const SearchResult found = search_polytope(floating, options);

  PolytopeCandidate result;
  result.kind = hull_kind(found.kind);
  result.symmetric = family.is_flip_symmetric();
  result.transposed = found.transposed;
  result.closed = found.status == SearchStatus::closed;
  result.scale = found.scale;
  result.scale_is_radius = found.scale == found.radius;
  result.maximizing = found.maximizing;
  for (const subcert::Candidate& product : found.products)
    result.products.push_back({from_left_to_right(product.word, found.transposed), product.word});
  for (const Vertex& v : found.vertices)
    result.vertices.push_back({{v.value.begin(), v.value.end()}, v.parent, v.letter, v.cycle, v.place});
  for (const ImageProof& image : found.images) {
    result.images.push_back({image.vertex, image.letter, image.identity, {}});
    for (const Term& term : image.terms)
      result.images.back().terms.push_back({term.vertex, term.flipped, term.conjugated, term.coefficient});
  }
  return result;
}

std::vector<int> find_product(const MatrixFamily& family, const Deadline& deadline) {
  SearchFamily floating;
  for (const RationalMatrix& m : family) floating.matrices.push_back(to_double(m));
  const auto found = search_products(floating, {quick_length, quick_width, deadline.remaining(), quick_nearness});
  return from_left_to_right(found.front().word, false);
}

FloatingEigenvalue leading_eigenvalue(const RationalMatrix& matrix) {
  const auto exponent = binary_exponent(matrix);
  if (!exponent) return {};
  const Eigen::VectorXcd eigenvalues = detail::eigenvalues(to_double(power(Rational(2), -*exponent) * matrix));
  Eigen::Index leading = 0;
  for (Eigen::Index k = 0; k < eigenvalues.size(); ++k)
    if (std::abs(eigenvalues[k]) > std::abs(eigenvalues[leading]) * (1 + 1e-12)) leading = k;
  return {eigenvalues[leading], *exponent};
}

}  // namespace subcert::radius
