#include "constrained.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <set>

namespace subcert {

LiftedFamily lifted(const MatrixFamily& family, const std::vector<Succession>& graph) {
  require(!graph.empty(), "lifted: need at least one succession, got none");
  std::size_t nodes = 0;
  for (const Succession& edge : graph) {
    require(edge.matrix < family.count(), "lifted: need matrices 0 to {}, got {}", family.count() - 1, edge.matrix);
    nodes = std::max({nodes, edge.from + 1, edge.to + 1});
  }
  const std::size_t n = family.size();
  struct Sum {
    std::size_t letter;
    std::set<std::size_t> left;  // nodes
    RationalMatrix matrix;
  };
  std::vector<Sum> sums;
  for (const Succession& edge : graph) {
    auto sum = std::find_if(sums.begin(), sums.end(),
                            [&](const Sum& one) { return one.letter == edge.matrix && !one.left.contains(edge.from); });
    if (sum == sums.end()) sum = sums.insert(sums.end(), {edge.matrix, {}, RationalMatrix(n * nodes, n * nodes)});
    sum->left.insert(edge.from);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) sum->matrix(edge.to * n + i, edge.from * n + j) = family[edge.matrix](i, j);
  }
  std::vector<RationalMatrix> matrices;
  std::vector<int> letters;
  for (Sum& sum : sums) {
    matrices.push_back(std::move(sum.matrix));
    letters.push_back(static_cast<int>(sum.letter));
  }
  return {MatrixFamily(std::move(matrices)), std::move(letters)};
}

}  // namespace subcert
