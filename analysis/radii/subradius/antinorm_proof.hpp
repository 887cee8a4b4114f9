#pragma once
/// Rational proofs of both ends of a joint spectral subradius.

#include <subcert/analysis/symbol/matrices/matrix_family.hpp>

#include <optional>

namespace subcert {

/// A product N with N x <= radius x for a positive vector x: its spectral radius is at most `radius`.
struct SlowProduct {
  std::vector<int> word;  ///< A_{word[0]} A_{word[1]} ..., from left to right
  Rational radius;
  std::vector<Integer> weights;  ///< x
};

/// Non-negative vertices, and for the image of each under each matrix a combination of vertices that is at most the
/// image in each coordinate: each product of k matrices has at least the norm c bound^k.
struct AntinormProof {
  struct Term {
    std::size_t vertex;
    Integer weight;  ///< over 2^weight_bits
  };
  /// Which image a vertex is, rounded down.
  struct Origin {
    std::size_t parent, letter;
  };
  bool transposed = false;  ///< the matrices are the transposed ones
  int weight_bits = 0;
  std::vector<std::vector<Integer>> vertices;
  std::vector<std::vector<Term>> images;  ///< vertex by vertex, matrix by matrix
  Rational bound;                         ///< the least sum of weights of an image
  std::vector<std::size_t> cycle;  ///< letters after which vertex 0 comes back, nearly, the first applied in front
  std::vector<Origin> origins;     ///< of vertex 1, 2, ...
  /// An image that is at least a vertex times the radius of the cycle, by equations and clear inequalities.
  struct Coincidence {
    std::size_t vertex, letter, target;
  };
  std::vector<Coincidence> coincidences;

  /// Of the image of a vertex under a matrix: the index in `images`. Domain: `letters` matrices.
  static std::size_t image_index(std::size_t vertex, std::size_t letter, std::size_t letters) {
    return vertex * letters + letter;
  }
};

}  // namespace subcert
