#include <subcert/analysis/regularity/holder_bound.hpp>
#include <subcert/schemes/specification.hpp>

#include <iostream>

int main() {
  using namespace subcert;
  const HolderBounds bounds = holder_bounds(make_scheme("dual:n=2").mask.curve(), 16);
  for (const HolderBound& bound : bounds.levels)
    if (bound.levels == 1 || bound.levels == 4 || bound.levels == 5 || bound.levels == 16)
      std::cout << bound.levels << " levels: at least " << bound.exponent.lower_text(8) << "\n";
  std::cout << "norm of two levels: " << bounds.levels[1].norm << "\n";
}
