#include <subcert/schemes/data/refine/refine.hpp>
#include <subcert/schemes/specification.hpp>

#include <iostream>

int main() {
  using namespace subcert;
  const Mask mask = make_scheme("dual:n=2").mask.curve();
  const data::GridData<Rational> line = data::curve_data<Rational>({1, 3, 5, 7, 9, 11});
  const data::GridData<Rational> finer = refine(line, mask, {1, data::Boundary::regression, 1});
  for (std::size_t i = 0; i < 3; ++i)
    std::cout << "at " << finer.axes[0].parameter(i) << ": " << finer.values[i] << "\n";
  std::cout << finer.axes[0].count << " points\n";

  const data::GridData<Rational> impulse = data::curve_data<Rational>({0, 0, 0, 1, 0, 0, 0}, 1, true);
  for (const Rational& value : data::limit_of_data(impulse, {mask}, {0, data::Boundary::periodic, 1}).values)
    std::cout << value << " ";
  std::cout << "\n";
}
