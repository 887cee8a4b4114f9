#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/schemes/specification.hpp>

#include <iostream>

int main() {
  const subcert::Scheme chaikin = subcert::make_scheme("dual:n=1");
  const subcert::SmoothnessProof smoothness = subcert::proved_smoothness(chaikin.mask);
  const subcert::LimitValues values = subcert::limit_values(chaikin.mask.curve(), 0);
  std::cout << chaikin.mask.curve().symbol().to_mask_text() << " is C^" << smoothness.order
            << ", phi(0) = " << subcert::to_text(values.at(0)) << "\n";
}
