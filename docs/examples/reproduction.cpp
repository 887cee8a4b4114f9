#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/schemes/specification.hpp>

#include <iostream>

int main() {
  using namespace subcert;
  for (const char* text : {"dd:n=2", "bspline:degree=3", "dual:n=2", "dual:n=3,d=3", "ary:a=3,points=4,d=3"}) {
    const PolynomialReproduction p = polynomial_reproduction(make_scheme(text).mask);
    std::cout << text << ": generation " << p.generation_degree() << ", reproduction " << p.reproduction_degree
              << ", shift " << p.parametrization.front() << ", approximation order " << p.approximation_order() << "\n";
  }
}
