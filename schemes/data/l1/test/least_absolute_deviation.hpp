#pragma once
// The exact least absolute deviation fit, by enumeration: some optimal fit interpolates as many data as there are basis
// polynomials [BR73].

#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>
#include <subcert/schemes/data/l1/l1_regression.hpp>

#include <algorithm>
#include <optional>

namespace subcert::testing {

struct LeastAbsoluteDeviation {
  Rational objective;
  std::vector<Rational> fitted;  // at the nodes, of one optimal fit
  bool unique;                   // no other vertex of the enumeration is optimal
};

inline LeastAbsoluteDeviation least_absolute_deviation(const data::RegressionWindow& window,
                                                       const std::vector<Rational>& data) {
  const std::size_t m = window.nodes(), terms = window.terms();
  std::vector<bool> chosen(m, false);
  std::fill_n(chosen.begin(), terms, true);
  std::optional<LeastAbsoluteDeviation> best;
  do {
    RationalMatrix a(terms, terms), b(terms, 1);
    std::size_t row = 0;
    for (std::size_t i = 0; i < m; ++i) {
      if (!chosen[i]) continue;
      for (std::size_t k = 0; k < terms; ++k) a(row, k) = window.at_nodes()[k][i];
      b(row++, 0) = data[i];
    }
    if (!kernel(a).empty()) continue;
    const RationalMatrix x = solve(a, b);
    Rational sum = 0;
    std::vector<Rational> fitted(m, 0);
    for (std::size_t i = 0; i < m; ++i) {
      for (std::size_t k = 0; k < terms; ++k) fitted[i] += window.at_nodes()[k][i] * x(k, 0);
      sum += abs(data[i] - fitted[i]);
    }
    if (!best || sum < best->objective)
      best = {sum, fitted, true};
    else if (sum == best->objective && fitted != best->fitted)
      best->unique = false;
  } while (std::prev_permutation(chosen.begin(), chosen.end()));
  return *best;
}

}  // namespace subcert::testing
