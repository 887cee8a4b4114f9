#pragma once
/// Rational proofs of upper bounds for joint spectral radii by polytopes, made from what the floating point search
/// found.

#include <subcert/analysis/radii/polytope_proof/attained_number.hpp>
#include <subcert/analysis/radii/polytope_search/polytope_kind.hpp>

#include <subcert/analysis/symbol/matrices/matrix_family.hpp>
#include <subcert/analysis/symbol/numbers/interval.hpp>
#include <subcert/analysis/symbol/numbers/rational_complex.hpp>
#include <subcert/analysis/symbol/support/budget.hpp>

#include <optional>
#include <string>
#include <vector>

namespace subcert {

namespace radius {
struct PolytopeCandidate;
}

/// (weight + i imaginary) / 2^weight_bits times the image of the vertex under an element of the group, or the complex
/// conjugate of that.
/// Canonical: modulus >= |weight + i imaginary|; imaginary = 0 and conjugated = false unless the polytope is complex.
struct WeightedVertex {
  std::size_t vertex;
  std::size_t element;
  bool conjugated;
  Integer weight;
  Integer imaginary;
  Integer modulus;
};

/// Near the first vertex of a cycle, for all families near one: a number near the eigenvalue of its product, and the
/// columns of an approximate inverse, over 2^bits, of the equations for both. Ref: SPEC.md, 7.1.
struct NearbyEigenvector {
  Rational eigenvalue;
  int bits;
  std::vector<std::vector<Integer>> inverse;
};

/// That one product attains the radii of all families near one.
struct NearbyCycles {
  std::vector<NearbyEigenvector> eigenvectors;  ///< cycle by cycle
  Enclosure bounds, radius;  ///< of the radii of all these families, as the certificate has them and finer
  std::vector<int> product;  ///< from left to right
};

/// That products attain the radius: how true vertices near the rational ones arise from leading eigenvectors, and which
/// images are vertices by that (SPEC.md, 4.10). That all other images lie inside is for those who check the proof to
/// see, by the numbers of the polytope.
struct AttainedProof {
  /// Images of the first vertex, letter by letter, to which sign * an element of the group leads the last one back,
  /// times the leading eigenvalue of this product.
  struct Cycle {
    std::size_t vertex, element;
    int sign;
    std::vector<int> letters;   ///< in the order in which the matrices are applied
    std::vector<Integer> seed;  ///< its images under the product have the eigenvector for a sum
    std::size_t last;           ///< the vertex before the last letter
  };
  /// A vertex that is an image, over the radius.
  struct Origin {
    std::size_t vertex, parent, letter;
  };
  /// An image that is a vertex up to a factor of modulus 1, moved by an element of the group.
  struct Coincidence {
    std::size_t vertex, letter, target, element;
  };
  AttainedNumber number;                    ///< the radius
  std::optional<NearbyCycles> nearby = {};  ///< of all families near one, whose cycles have no seeds, no number
  std::vector<Cycle> cycles;
  std::vector<Origin> origins;  ///< in order
  std::vector<Coincidence> coincidences;
};

/// Vertices and combinations with exact dyadic numbers. With P the hull of the vertices, their negatives and, the
/// images of all these under the group, the combinations prove A_t P within bound * P for all matrices
/// (proofs-checks/certificates/SPEC.md): residuals are small, and `units` bounds the norm of any residual.
/// Kind nonnegative: the cone hull; combinations dominate instead of being equal. Kind complex: the balanced hull of
/// the vertices and their conjugates.
struct PolytopeProof {
  PolytopeKind kind;
  bool transposed;
  std::vector<FamilySymmetry> group;  ///< of the matrices of the polytope, transposed where it says so
  int vertex_bits;
  int weight_bits;
  std::vector<std::vector<Integer>> vertices;
  std::vector<std::vector<Integer>> imaginary;      ///< parts of the vertices; empty unless complex
  std::vector<std::vector<WeightedVertex>> units;   ///< for e_0, e_1, ...; the first half only under the flip
  std::vector<std::vector<WeightedVertex>> images;  ///< vertex by vertex, matrix by matrix; for the unscaled matrices
  Rational bound;                                   ///< proved: joint spectral radius <= bound
  /// What the bound is made of: bound = max over the images of sum of moduli + unit_norm * |residual|_1.
  Integer unit_norm;                ///< bounds the norm of every unit vector
  std::vector<Rational> moduli;     ///< of the weights of each image, added up
  std::vector<Rational> residuals;  ///< 1-norms
  /// That it is the polytope of the very radius; where there is none, why.
  std::optional<AttainedProof> attained = {};
  std::string not_attained = "the polytope is not one of the very radius";

  /// With its denominators. Domain: index < vertices.size().
  ComplexVector vertex(std::size_t index) const;

  /// Whether the group consists of the identity and the reversal of the coordinates.
  bool is_flip_symmetric() const;
};

/// The proof for factor times the matrices: exact for powers of two, otherwise with weights of 64 more bits. Domain:
/// factor > 0.
PolytopeProof scaled(PolytopeProof proof, const Rational& factor);

/// Recomputes the orbit that the search found in high precision, rounds it, refines every combination against exact
/// residuals, and bounds the radius with them; nothing of the search is trusted. Nothing is returned where the vertices
/// do not span, or where the proof would not fit into the budget. Domain: `candidate` belongs to this family. Error:
/// none, the bound is proved. Cost: vertices * matrices * size^2 integer products, and a small factorisation for each
/// image.
std::optional<PolytopeProof> certify_polytope(const MatrixFamily& family, const radius::PolytopeCandidate& candidate,
                                              const Budget& budget);

}  // namespace subcert
