#pragma once
/// The search for an invariant polytope in floating point: what callers ask and get. Nothing of it is proved;
/// analysis/radii/polytope_proof does that.

#include "incremental_simplex.hpp"
#include "product_search.hpp"

#include <functional>
#include <limits>

namespace subcert::polytope {

/// Products of a family whose averaged radius is near this one or above.
using ProductSource = std::function<std::vector<Candidate>(const SearchFamily&, double radius, const Budget&)>;

inline constexpr int longest_product = 200;
inline constexpr std::size_t most_vertices = 40000;

struct SearchOptions {
  /// Every phase ends soon after the deadline. The memory is that of what grows; a few copies of the family come on
  /// top.
  Budget budget{.deadline = Deadline::in(60)};
  bool cones = true;                 ///< non-negative families may have polytopes of a cone, with fewer vertices
  bool exact = true;                 ///< a polytope of the very radius is looked for; otherwise only of a little more
  ProductSource more_products = {};  ///< asked where the cheaper looks lead to nothing
  double tolerance = 1e-9;           ///< an image is inside when its norm is at most 1 - tolerance
};

/// A vertex in the coordinates of the family (of the transposed family, if SearchResult::transposed).
struct Vertex {
  ComplexVector value;  ///< imaginary parts zero unless kind == complex
  int parent = -1;      ///< value = A_letter vertices[parent] / scale; -1: a root
  int letter = -1;
  int cycle = -1;  ///< roots: index into SearchResult::products, or -1 for an extra vertex
  int place = -1;  ///< roots: letters of that word applied to its first root so far
};

/// What became of A_letter vertices[vertex] / scale.
struct VertexImage {
  int vertex = 0;
  int letter = 0;
  bool identity = false;               ///< the image is terms[0], a vertex up to symmetry, conjugation, sign or phase
  std::vector<CombinationTerm> terms;  ///< the image is the sum of the terms (non-negative kind: is below the sum)
  double norm = 0;                     ///< sum of |coefficient|; above 1 only if not closed
};

struct SearchResult {
  /// Every image is a vertex or strictly inside: the radius is that of the product, up to rounding. Otherwise time,
  /// memory or vertices ran out: `radius` and `upper_bound` enclose, up to rounding.
  bool closed = false;
  std::vector<Candidate> products;  ///< the spectrum maximizing ones (`maximizing` of them) first
  std::size_t maximizing = 0;
  double radius = 0;  ///< rho(product)^(1/length) of the first
  double scale = 0;   ///< what images are divided by: radius if closed, radius (1 + eps) if only enclosed
  double upper_bound = std::numeric_limits<double>::infinity();  ///< scale * largest image norm
  PolytopeKind kind = PolytopeKind::real;
  bool transposed = false;          ///< the polytope belongs to the transposed matrices
  std::vector<Vertex> vertices;     ///< one of each orbit of the symmetry
  std::vector<VertexImage> images;  ///< one for every vertex and letter, ordered by vertex, then letter
};

/// Searches a spectrum maximizing product and an invariant polytope that shows it is one.
/// Meaning: where it closed, the hull P of the vertices (with their images under the symmetry, negatives, phases as
/// `kind` tells) satisfies A_i P within radius * P, so that the joint spectral radius is `radius`. A family all
/// whose long products vanish is closed with radius 0 and no vertices. Domain: at least one matrix, all square of one
/// size >= 1; 0 < tolerance < 1e-2; throws Error otherwise. A symmetry that does not hold to
/// 1e-12 is made no use of. Where the budget is spent before anything closed, or an entry is not finite, what was found
/// so far is returned: one product at least. Error: floating point throughout, nothing is proved; radius good to about
/// 1e-13 times the condition of its eigenvalue. Cost: one small linear program per vertex and matrix, mostly. Ref:
/// [GP13, Alg. 1], [GP16] (balancing), [Mej20].
SearchResult search_polytope(const SearchFamily& family, const SearchOptions& options = {});

}  // namespace subcert::polytope
