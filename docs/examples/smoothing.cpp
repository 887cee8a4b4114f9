#include <subcert/schemes/data/l1/l1_refinement.hpp>
#include <subcert/schemes/data/smooth/expected_error.hpp>
#include <subcert/schemes/data/smooth/scheme_smoother.hpp>
#include <subcert/schemes/specification.hpp>

#include <cmath>
#include <iostream>

int main() {
  using namespace subcert;
  const Scheme scheme = make_scheme("primal:n=2");
  const data::SchemeSmoother smoother(scheme.mask.curve(), 9, {data::Boundary::regression});
  for (const std::size_t i : {0, 4}) {
    const data::SmoothingRow row = smoother.row(i);
    std::cout << "s(" << i << ") =";
    for (std::size_t k = 0; k < row.weights.size(); ++k)
      if (row.weights[k] != 0) std::cout << " + " << row.weights[k] << " y_" << row.first + k;
    std::cout << "\n  variance " << row.variance << "\n";
  }
  // The samples i^2 with noise of variance 4.
  std::vector<Rational> squares;
  for (int i = 0; i < 9; ++i) squares.emplace_back(i * i);
  const data::ExpectedError error = data::expected_error(smoother.row(4), squares, 16, 4);
  std::cout << "bias " << error.bias << ", expected squared error " << error.total() << "\n";

  L1Scheme l1{{6}, 1};
  l1.options.iterations = 100;
  const data::GridData<double> fine = refine(data::curve_data<double>({0, 1, 2, 3, 40, 5, 6, 7, 8}), l1,
                                             {1, data::Boundary::shrink});
  for (const double value : fine.values) std::cout << std::round(1000 * value) / 1000 << " ";
  std::cout << "\n";
}
