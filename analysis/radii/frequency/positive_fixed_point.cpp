#include "positive_fixed_point.hpp"

#include <subcert/analysis/radii/polytope_search/decompositions.hpp>

#include <algorithm>

namespace subcert::frequency {

std::optional<std::vector<double>> positive_fixed_point(const polytope::Matrix& matrix,
                                                        const std::vector<double>& first) {
  const std::size_t size = matrix.rows();
  polytope::Matrix difference = polytope::Matrix::identity(size), inverse(size, size);
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j) difference(i, j) -= matrix(i, j);
  if (!is_finite(difference) || !polytope::invert(difference.column(0), size, size, &inverse(0, 0)))
    return std::nullopt;
  std::vector<double> w = inverse * first;
  if (!std::all_of(w.begin(), w.end(), [](double one) { return one > 0; })) return std::nullopt;
  return w;
}

}  // namespace subcert::frequency
