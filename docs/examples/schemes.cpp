#include <subcert/schemes/specification.hpp>

#include <iostream>

int main() {
  using namespace subcert;
  for (const char* text : {"primal:n=3", "dual:n=2", "primal-odd:n=1", "dual-odd:n=1", "ary:a=3,points=4,d=1",
                           "regression:stencils=[-1..1;-1..2],at=[0;2/4],weights=[1;2;1|1;2;2;1]"}) {
    const Scheme scheme = make_scheme(text);
    std::cout << scheme.specification << "\n  " << scheme.mask.curve().symbol().to_mask_text() << "\n";
  }
  try {
    make_scheme("primal:n=0");
  } catch (const SpecificationError& error) {
    std::cout << error.what() << "\n";
  }
}
