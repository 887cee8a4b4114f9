#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/variance/variance.hpp>
#include <subcert/schemes/specification.hpp>

#include <iostream>

int main() {
  using namespace subcert;
  const Mask mask = make_scheme("primal:n=2").mask.curve();
  const LimitValues phi = limit_values(mask, 0);
  for (std::size_t i = 0; i < phi.values.size(); ++i)
    std::cout << "phi(" << phi.point(i) << ") = " << phi.values[i] << "\n";
  std::cout << "phi(1/2) = " << limit_values(mask, 1).at(1) << "\n";
  std::cout << "phi'(1) = " << limit_values(mask, 0, 1).at(1) << "\n";
  std::cout << "integral of phi^2 = " << squared_l2_norm(mask) << "\n";

  const VarianceGrid psi = variance_grid(mask, 1, true);
  std::cout << "psi(0) = " << psi.values[0] << ", psi(1/2) = " << psi.values[1] << ", psi'(1/2) = " << psi.slopes[1]
            << ", psi >= " << variance_floor(mask) << "\n";
}
