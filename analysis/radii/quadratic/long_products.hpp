#pragma once
/// Products of many letters whose spectral radius is large, in floating point. Inner header. Nothing of it is proved.

#include <subcert/analysis/radii/polytope_search/product_search.hpp>

namespace subcert::quadratic {

/// Products whose averaged radius is near `radius` or above, best first: a letter with a run of another one, and parts
/// of the ways on which images of a vector become longest. All words move it, and of the images by words of the same
/// last letters the longest ones go on. There may be none. Domain: radius > 0, that of a product. Cost: for each of a
/// few looks a matrix times some thousand vectors, for each of 600 letters, and a product of matrices for each of
/// 20,000 words.
std::vector<polytope::Candidate> long_products(const polytope::SearchFamily& family, double radius,
                                               const Budget& budget);

}  // namespace subcert::quadratic
