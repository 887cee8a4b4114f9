#include <subcert/analysis/symbol/masks/mask.hpp>

#include <iostream>

int main() {
  using namespace subcert;
  const LaurentPolynomial chaikin({Rational(1, 4), Rational(3, 4), Rational(3, 4), Rational(1, 4)}, -2);
  std::cout << chaikin.to_text() << "\n" << chaikin.to_mask_text() << "\n";

  const LaurentPolynomial factor = LaurentPolynomial::all_ones(2);  // 1 + z
  std::cout << "multiplicity of " << factor.to_text() << ": " << chaikin.multiplicity(factor) << "\n";
  std::cout << "quotient: " << chaikin.exact_quotient(factor.pow(3))->to_text() << "\n";
  std::cout << "even coset: " << chaikin.coset(2, 0).to_text() << "\n";
  std::cout << "value at 2: " << chaikin(2) << "\n";

  const Mask mask(chaikin, 2);
  std::cout << "coset sums: " << coset_sums(mask)[0] << " " << coset_sums(mask)[1] << "\n";
  std::cout << "centre of symmetry: " << symmetry(mask).centre << "\n";

  const LatticeMask surface = tensor_product({mask, mask});
  std::cout << "tensor product: " << surface.symbol().count() << " terms, corner "
            << surface.symbol().coefficient({-2, -2}) << "\n";
}
