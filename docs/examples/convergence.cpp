#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/schemes/specification.hpp>

#include <iostream>

int main() {
  using namespace subcert;
  for (const char* text : {"primal:n=3", "four-point:w=1/16", "mask:[1,1]", "mask:[1,2,1,2,4,2,1,2,1]/8"}) {
    const Mask mask = make_scheme(text).mask.curve();
    const Decision decision = converges(mask);
    const SmoothnessProof proof = proved_smoothness(mask);
    std::cout << text << "\n  converges: " << to_text(decision.truth) << ", " << decision.reason
              << "\n  proved order: " << proof.order << "; then: " << proof.obstacle << "\n";
  }
}
