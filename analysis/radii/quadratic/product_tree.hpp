#pragma once
/// Complete trees of products that are contractions, in floating point. Inner header. Nothing of it is proved.

#include "context_forms.hpp"

#include <subcert/analysis/radii/polytope_search/product_search.hpp>

#include <string>

namespace subcert::quadratic {

/// Whether 1 - m^T m is positive definite.
bool is_contraction(const polytope::Matrix& m);

struct ProductTree {
  /// Words that lead away from each state, in the letters that states read, least letters first: `+` for those that go
  /// on with a letter, followed by the same for the state they come to; end_character(0) for one that ends by this
  /// step, end_character(k) for the end k-1 instead. Every infinite word begins with exactly one. kept_character for a
  /// letter of the product that the forms are round.
  std::vector<std::string> ends;
  double bound = 0;  ///< products of k letters that end are contractions, divided by bound^k
  double work = 0;   ///< multiplications that an exact proof takes
};

/// 0, ..., 9, A, ..., Z, a, ..., z. Domain: k < 62.
char end_character(std::size_t k);
std::size_t end_number(char character);
constexpr char kept_character = '*';

struct TreeLimits {
  double work = 0;  ///< of the proof
  Deadline deadline;
  bool keep = false;  ///< not to look at the letters of the product that the forms are round
};

/// The words that go on until they are contractions; nothing where a limit is reached, or the norms of the steps of a
/// word have too large a product. Domain: bound > 0. Cost: a product and a Cholesky decomposition for each node, on all
/// cores. Ref: [Gri96]; [MR14] for trees.
std::optional<ProductTree> product_tree(const StateForms& forms, double bound, const TreeLimits& limits);

/// Products whose averaged radius is near `radius` or above, best first: a letter with a run of another one, and parts
/// of the ways on which images of a vector become longest. All words move it, and of the images by words of the same
/// last letters the longest ones go on. There may be none. Domain: radius > 0, that of a product. Cost: for each of a
/// few looks a matrix times some thousand vectors, for each of 600 letters, and a product of matrices for each of
/// 20,000 words.
std::vector<polytope::Candidate> long_products(const polytope::SearchFamily& family, double radius,
                                               const Budget& budget);

}  // namespace subcert::quadratic
