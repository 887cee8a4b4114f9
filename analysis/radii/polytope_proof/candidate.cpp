#include "candidate.hpp"
#include "round_family.hpp"

#include <subcert/analysis/radii/polytope_search/decompositions.hpp>
#include <subcert/analysis/radii/polytope_search/polytope_search.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace subcert::radius {
namespace {

constexpr int quick_length = 8, quick_width = 12;  // of the words of find_product, and how many are kept per length
constexpr double quick_nearness = 5e-3;

bool is_finite(std::complex<double> z) { return std::isfinite(z.real()) && std::isfinite(z.imag()); }

/// Whether the search kept its footing: what it proposes consists of numbers.
bool is_finite(const polytope::SearchResult& found) {
  return std::isfinite(found.scale) &&
         std::ranges::all_of(
             found.vertices,
             [](const auto& v) { return std::ranges::all_of(v.value, [](auto z) { return is_finite(z); }); }) &&
         std::ranges::all_of(found.images, [](const auto& image) {
           return std::ranges::all_of(image.terms, [](const auto& term) { return is_finite(term.coefficient); });
         });
}

}  // namespace

std::vector<int> PolytopeCandidate::word(std::size_t index) const {
  return transposed ? products[index].word : products[index].written();
}

PolytopeCandidate find_polytope(const MatrixFamily& family, const Budget& budget, bool cones, bool exact,
                                const polytope::ProductSource& more_products) {
  polytope::SearchOptions options{.budget = budget};
  // In other coordinates doubles may lose the sign of a small entry; cones keep those in which none is negative.
  options.cones = cones && is_nonnegative(family);
  options.exact = exact;
  options.more_products = more_products;
  const RoundFamily round = options.cones ? RoundFamily{to_search_family(family)}
                                          : round_family(family, budget.deadline);
  PolytopeCandidate result{polytope::search_polytope(round.family, options), round.coordinates};
  if (round.coordinates.differ() && result.transposed)
    result.coordinates = {transposed(round.coordinates.from), transposed(round.coordinates.to)};
  if (!is_finite(result)) {
    result.closed = false;
    result.vertices.clear();
    result.images.clear();
  }
  return result;
}

polytope::Candidate find_product(const MatrixFamily& family, const Deadline& deadline) {
  const polytope::ProductSearchOptions options{quick_length, quick_width, quick_nearness, {deadline}};
  return polytope::search_products(to_search_family(family), options).front();
}

FloatingEigenvalue leading_eigenvalue(const RationalMatrix& matrix) {
  const auto exponent = binary_exponent(matrix);
  if (!exponent) return {};
  const auto eigenvalues = polytope::eigenvalues(to_double(power(Rational(2), -*exponent) * matrix));
  std::size_t leading = 0;
  for (std::size_t k = 0; k < eigenvalues.size(); ++k)
    if (std::abs(eigenvalues[k]) > std::abs(eigenvalues[leading]) * (1 + 1e-12)) leading = k;
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < eigenvalues.size(); ++k)
    if (k != leading) distance = std::min(distance, std::abs(eigenvalues[k] - eigenvalues[leading]));
  return {eigenvalues[leading], *exponent, distance / std::abs(eigenvalues[leading])};
}

}  // namespace subcert::radius
