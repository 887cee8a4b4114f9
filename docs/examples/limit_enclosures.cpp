#include <subcert/analysis/limit/limit_range.hpp>
#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/variance/variance_order.hpp>
#include <subcert/analysis/variance/variance_range.hpp>
#include <subcert/schemes/specification.hpp>

#include <iostream>

int main() {
  using namespace subcert;
  for (const char* text : {"primal:n=3", "primal:n=20", "dd:n=2"}) {
    const VarianceRange psi = variance_range(make_scheme(text).mask.curve());
    std::cout << text << ": max psi <= " << psi.maximum.upper_text(5) << ", min psi >= " << psi.minimum.lower_text(5)
              << ", max |psi'| in [" << psi.slope->lower_text(5) << ", " << psi.slope->upper_text(5) << "]\n";
  }
  const VarianceOrder order = compare_variance(make_scheme("primal:n=3").mask.curve(),
                                               make_scheme("primal:n=2").mask.curve());
  std::cout << "psi of primal:n=3 below psi of primal:n=2: " << to_text(order.below) << "; " << order.reason << "\n";

  const Mask four_point = make_scheme("dd:n=2").mask.curve();
  const LimitRange phi = limit_range(four_point);
  std::cout << "dd:n=2: min phi in [" << phi.minimum.lower_text(5) << ", " << phi.minimum.upper_text(5)
            << "], integral of |phi| <= " << phi.l1_norm.upper_text(5) << "\n"
            << "phi > 0 on [-3/2, 0]: " << is_positive(four_point, Rational(-3, 2), 0).reason << "\n"
            << "integral of phi(x) phi(x+1) = " << l2_inner_products(four_point).at(1) << "\n";
}
