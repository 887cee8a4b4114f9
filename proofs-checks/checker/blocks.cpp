#include "blocks.hpp"

#include <numeric>

namespace subcert_check {

std::vector<std::size_t> read_block_sizes(std::size_t n, Reader& reader) {
  std::vector<std::size_t> sizes;
  for (const std::string_view field : reader.take("blocks", 1, n)) sizes.push_back(parse_size(field, 1, n));
  require(std::accumulate(sizes.begin(), sizes.end(), std::size_t{0}) == n, "the block sizes do not sum to n");
  return sizes;
}

std::size_t unobservable_blocks(const std::vector<std::size_t>& sizes, const Component& component) {
  std::size_t result = 0;
  for (std::size_t sum = 0; sum < component.unobservable; sum += sizes[result++])
    require(sum + sizes[result] <= component.unobservable, "what is unobservable consists of no blocks");
  return result;
}

std::pair<std::vector<Family>, std::size_t> read_blocks(const Family& family, const Component& component,
                                                        Reader& reader, Arithmetic& arithmetic) {
  const std::size_t n = family.size;
  const std::vector<std::size_t> sizes = read_block_sizes(n, reader);
  const std::size_t unobservable = unobservable_blocks(sizes, component);
  const Family basis = read_family(reader, "basis", 1, n);
  check_unobservable(component, basis.entries, n, arithmetic);
  const Family inverse = read_family(reader, "inverse", 1, n);
  const mpz_class denominator = basis.denominator * inverse.denominator;
  const Vector unit = arithmetic.multiply(basis.entries, inverse.entries, n);
  for (std::size_t i = 0; i < n * n; ++i)
    require(unit[i] == (i % (n + 1) == 0 ? denominator : mpz_class(0)), "basis times inverse is not the unit matrix");
  std::vector<Rationals> entries(sizes.size());
  for (std::size_t t = 0; t < family.count(); ++t) {
    const Vector images = arithmetic.multiply(family.matrix(t), basis.entries, n);
    const Vector triangular = arithmetic.multiply(inverse.entries, images, n);
    for (std::size_t block = 0, start = 0; block < sizes.size(); start += sizes[block++])
      for (std::size_t k = start; k < start + sizes[block]; ++k)
        for (std::size_t j = start; j < n; ++j) {
          const mpz_class& entry = triangular[k * n + j];
          const bool inside = j < start + sizes[block];
          require(inside || entry == 0, "not block upper triangular");
          if (inside) entries[block].push_back(ratio(entry, family.denominator * denominator));
        }
  }
  std::vector<Family> blocks;
  for (std::size_t i = 0; i < sizes.size(); ++i) blocks.push_back(clear_denominators(sizes[i], entries[i]));
  return {std::move(blocks), unobservable};
}

}  // namespace subcert_check
